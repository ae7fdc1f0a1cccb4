//! The header of a PLY file: its coding, its elements and their properties.

use std::sync::Arc;

use diagnostics::{Place, Problem, ProblemList, Source};

use crate::shape_files::text::{Word, extent, words};

/// Types of numbers, by both of their names.
const KINDS: [(&str, &str, Kind); 8] = [
    ("char", "int8", Kind::I8),
    ("uchar", "uint8", Kind::U8),
    ("short", "int16", Kind::I16),
    ("ushort", "uint16", Kind::U16),
    ("int", "int32", Kind::I32),
    ("uint", "uint32", Kind::U32),
    ("float", "float32", Kind::F32),
    ("double", "float64", Kind::F64),
];

/// Type of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

/// How numbers behind the header are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Coding {
    Text,
    LittleEndian,
    BigEndian,
}

/// A property of an element.
#[derive(Debug)]
pub(super) struct Property {
    pub name: String,
    /// Type of its number, or of the numbers of its list.
    pub kind: Kind,
    /// Type of the length, if it is a list.
    pub length: Option<Kind>,
    pub place: Place,
}

/// Rows of one kind.
#[derive(Debug)]
pub(super) struct Element {
    pub name: String,
    pub count: u64,
    pub properties: Vec<Property>,
    pub place: Place,
}

/// What a header says.
#[derive(Debug)]
pub(super) struct Header {
    pub coding: Coding,
    pub elements: Vec<Element>,
}

impl Header {
    /// The header of a file, and the number of its bytes.
    ///
    /// # Errors
    /// At the first statement that is none.
    pub fn read(name: &str, bytes: &[u8]) -> Result<(Self, usize), ProblemList> {
        let end = end_of(bytes).ok_or_else(|| {
            Problem::of_file(name, "the header does not end").expected("a line `end_header`")
        })?;
        // Names and comments in Latin-1 do no harm.
        let text = bytes[..end].iter().map(|&byte| char::from(byte)).collect();
        let source = Arc::new(Source { name: name.into(), text });
        let mut reading = Reading { source: Arc::clone(&source), coding: None, elements: Vec::new() };
        for line in source.text.split(['\n', '\r']) {
            reading.statement(&words(&source.text, line).collect::<Vec<_>>())?;
        }
        let missing = || Problem::of_file(name, "the header has no statement `format`").expected(CODINGS);
        Ok((Self { coding: reading.coding.ok_or_else(missing)?, elements: reading.elements }, end))
    }
}

/// What can stand in `format`.
const CODINGS: &str = "format ascii, binary_little_endian or binary_big_endian 1.0";

/// Number of bytes up to the end of the line `end_header`.
fn end_of(bytes: &[u8]) -> Option<usize> {
    const LAST: &[u8] = b"end_header";
    let begins_line = |at: usize| at > 0 && matches!(bytes[at - 1], b'\n' | b'\r');
    let at = (0..bytes.len()).find(|&at| bytes[at..].starts_with(LAST) && begins_line(at))? + LAST.len();
    let at = at + bytes[at..].iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
    match bytes[at..] {
        [b'\r', b'\n', ..] => Some(at + 2),
        [b'\r' | b'\n', ..] => Some(at + 1),
        [] => Some(at),
        _ => None,
    }
}

struct Reading {
    source: Arc<Source>,
    coding: Option<Coding>,
    elements: Vec<Element>,
}

impl Reading {
    fn statement(&mut self, words: &[Word]) -> Result<(), ProblemList> {
        let said: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        let place = Place { source: self.source.clone(), span: extent(words) };
        let wrong =
            |title: &str, expected: &str| Problem::at(&place, title).found(said.join(" ")).expected(expected);
        match said[..] {
            [] | ["ply" | "end_header"] | ["comment" | "obj_info", ..] => {}
            ["format", coding, "1.0"] => {
                let coding = match coding {
                    "ascii" => Coding::Text,
                    "binary_little_endian" => Coding::LittleEndian,
                    "binary_big_endian" => Coding::BigEndian,
                    _ => return Err(wrong("this coding is not read", CODINGS).into()),
                };
                self.coding = Some(coding);
            }
            ["format", ..] => return Err(wrong("this format is not read", CODINGS).into()),
            ["element", name, count] => {
                let count = count.parse().map_err(|_| wrong("this count is no whole number", "0 or more"))?;
                if self.elements.iter().any(|other| other.name == name) {
                    return Err(wrong("this element stands twice", "one element of a name").into());
                }
                self.elements.push(Element { name: name.into(), count, properties: Vec::new(), place });
            }
            ["property", "list", length, kind, name] => {
                let kinds = (kind_of(kind), kind_of(length).filter(|length| length.is_whole()));
                let (Some(kind), length @ Some(_)) = kinds else {
                    return Err(wrong("unknown type", &all_kinds()).into());
                };
                self.add(Property { name: name.into(), kind, length, place })?;
            }
            ["property", kind, name] => {
                let kind = kind_of(kind).ok_or_else(|| wrong("unknown type", &all_kinds()))?;
                self.add(Property { name: name.into(), kind, length: None, place })?;
            }
            _ => {
                return Err(wrong(
                    "this statement is not read",
                    "format, element, property, comment or obj_info",
                )
                .into());
            }
        }
        Ok(())
    }

    fn add(&mut self, property: Property) -> Result<(), ProblemList> {
        let Some(element) = self.elements.last_mut() else {
            return Err(Problem::at(&property.place, "a property of no element")
                .expected("`element` before it")
                .into());
        };
        if element.properties.iter().any(|other| other.name == property.name) {
            let title = format!("element `{}` has property `{}` twice", element.name, property.name);
            return Err(Problem::at(&property.place, title).expected("one property of a name").into());
        }
        element.properties.push(property);
        Ok(())
    }
}

fn kind_of(word: &str) -> Option<Kind> {
    KINDS.iter().find(|(old, new, _)| [*old, *new].contains(&word)).map(|(_, _, kind)| *kind)
}

fn all_kinds() -> String {
    let names: Vec<&str> = KINDS.iter().flat_map(|(old, new, _)| [*old, *new]).collect();
    format!("one of {}; whole numbers for a length", names.join(", "))
}

impl Kind {
    /// Whether it has whole numbers only.
    pub fn is_whole(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }

    /// Bytes of a number.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// The number in as many bytes as it has, the lowest first.
    pub fn number(self, little: [u8; 8]) -> f64 {
        let [a, b, c, d, ..] = little;
        match self {
            Self::I8 => f64::from(i8::from_le_bytes([a])),
            Self::U8 => f64::from(a),
            Self::I16 => f64::from(i16::from_le_bytes([a, b])),
            Self::U16 => f64::from(u16::from_le_bytes([a, b])),
            Self::I32 => f64::from(i32::from_le_bytes([a, b, c, d])),
            Self::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
            Self::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
            Self::F64 => f64::from_le_bytes(little),
        }
    }

    /// The value of a colour that stands for full light.
    pub fn full(self) -> Option<f64> {
        match self {
            Self::U8 => Some(255.0),
            Self::U16 => Some(65_535.0),
            Self::F32 | Self::F64 => Some(1.0),
            _ => None,
        }
    }
}
