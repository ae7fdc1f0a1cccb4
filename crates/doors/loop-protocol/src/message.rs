//! A message: a header in JSON, and planes.

use serde_json::{Map, Value, json};

use crate::Plane;

/// Key of the header that lists the planes on the wire. In a request without planes it names those that the answer is to have.
pub(crate) const PLANES: &str = "planes";

/// First bytes of every message.
pub const MAGIC: [u8; 8] = *b"lunoid.1";

/// Bytes before the header: the magic, the bytes of the header, the bytes of all planes.
pub const PREFIX: usize = 24;

/// A request or a reply.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Message {
    /// Keys of the header, without the list of planes.
    pub header: Map<String, Value>,
    /// Planes in the order of their bytes. No two have one name.
    pub planes: Vec<Plane>,
}

impl Message {
    /// A message without planes. Of a value that is no object the header is empty.
    pub fn new(header: Value) -> Self {
        let header = if let Value::Object(header) = header { header } else { Map::new() };
        Self { header, planes: Vec::new() }
    }

    /// The same with planes.
    pub fn with(self, planes: Vec<Plane>) -> Self {
        Self { planes, ..self }
    }

    /// The number of the message under `id`; null if it has none.
    pub(crate) fn id(&self) -> Value {
        self.header.get("id").filter(|id| id.is_u64()).cloned().unwrap_or_default()
    }

    /// The plane of a name.
    pub fn plane(&self, name: &str) -> Option<&Plane> {
        self.planes.iter().find(|plane| plane.name() == name)
    }

    /// The bytes of the message.
    pub fn encode(&self) -> Vec<u8> {
        let mut bytes = self.head();
        self.planes.iter().for_each(|plane| bytes.extend_from_slice(plane.bytes()));
        bytes
    }

    /// Prefix and header: everything before the planes.
    pub(crate) fn head(&self) -> Vec<u8> {
        let mut header = self.header.clone();
        if !self.planes.is_empty() {
            let listed = |plane: &Plane| json!({ "name": plane.name(), "dtype": plane.dtype().name(), "shape": plane.shape() });
            header.insert(PLANES.into(), self.planes.iter().map(listed).collect());
        }
        let header = Value::Object(header).to_string();
        let planes: u64 = self.planes.iter().map(|plane| plane.bytes().len() as u64).sum();
        let mut head = Vec::with_capacity(PREFIX + header.len());
        head.extend_from_slice(&MAGIC);
        head.extend_from_slice(&(header.len() as u64).to_le_bytes());
        head.extend_from_slice(&planes.to_le_bytes());
        head.extend_from_slice(header.as_bytes());
        head
    }
}
