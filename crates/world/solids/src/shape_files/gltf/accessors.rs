//! Numbers that a glTF file keeps in buffers.

use diagnostics::ProblemList;

use super::buffers::Buffers;
use super::json::Json;

/// Accessors and views of a file.
pub(super) struct Accessors<'a> {
    accessors: Vec<Json<'a>>,
    views: Vec<Json<'a>>,
}

/// Type of a component, by the codes of OpenGL.
#[derive(Debug, Clone, Copy)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    const CODES: [(usize, Self, usize); 6] = [
        (5120, Self::I8, 1),
        (5121, Self::U8, 1),
        (5122, Self::I16, 2),
        (5123, Self::U16, 2),
        (5125, Self::U32, 4),
        (5126, Self::F32, 4),
    ];

    /// Reads a component. The second number stands for 1 where numbers are normalized.
    fn number(self, bytes: &[u8]) -> (f64, f64) {
        let mut word = [0; 4];
        word[..bytes.len()].copy_from_slice(bytes);
        let [a, b, ..] = word;
        match self {
            Self::I8 => (f64::from(i8::from_le_bytes([a])), f64::from(i8::MAX)),
            Self::U8 => (f64::from(a), f64::from(u8::MAX)),
            Self::I16 => (f64::from(i16::from_le_bytes([a, b])), f64::from(i16::MAX)),
            Self::U16 => (f64::from(u16::from_le_bytes([a, b])), f64::from(u16::MAX)),
            Self::U32 => (f64::from(u32::from_le_bytes(word)), f64::from(u32::MAX)),
            Self::F32 => (f64::from(f32::from_le_bytes(word)), 1.0),
        }
    }
}

/// Names of types and how many components they have.
const TYPES: [(&str, usize); 3] = [("SCALAR", 1), ("VEC3", 3), ("VEC4", 4)];

/// Elements of an accessor: numbers side by side.
pub(super) struct Elements {
    pub numbers: Vec<f64>,
    /// Components of an element.
    pub width: usize,
}

impl Elements {
    pub fn len(&self) -> usize {
        self.numbers.len() / self.width
    }

    /// The first three components of an element.
    pub fn triple(&self, number: usize) -> [f64; 3] {
        let from = number * self.width;
        std::array::from_fn(|component| self.numbers[from + component])
    }
}

impl<'a> Accessors<'a> {
    /// Those of a file.
    ///
    /// # Errors
    /// If a list cannot be read.
    pub fn new(root: &Json<'a>) -> Result<Self, ProblemList> {
        Ok(Self { accessors: root.list("accessors")?, views: root.list("bufferViews")? })
    }

    /// The elements of the accessor that `asked` numbers, whose type is one of `types`.
    ///
    /// # Errors
    /// If it is of another type, or its bytes are not there.
    pub fn elements(
        &self,
        asked: &Json,
        types: &[&str],
        buffers: &mut Buffers,
    ) -> Result<Elements, ProblemList> {
        let number = asked.whole()?;
        let Some(accessor) = self.accessors.get(number) else {
            return Err(asked
                .problem(format!("accessor {number} does not exist"), "the number of an accessor")
                .into());
        };
        if let Some(sparse) = accessor.get("sparse") {
            return Err(sparse
                .problem("sparse accessors are not read", "plain accessors")
                .help("export without them")
                .into());
        }
        accessor.expect_known(
            &["bufferView", "byteOffset", "componentType", "normalized", "count", "type"],
            &["min", "max"],
        )?;
        let kind = accessor.required("type")?;
        let width = TYPES
            .iter()
            .find(|(name, _)| types.contains(name) && kind.text().is_ok_and(|text| text == *name));
        let Some(&(_, width)) = width else {
            return Err(kind.problem(format!("wrong type for {}", asked.path()), types.join(" or ")).into());
        };
        let code = accessor.required("componentType")?;
        let whole = code.whole()?;
        let component = Component::CODES.iter().find(|(known, ..)| *known == whole);
        let Some(&(_, component, size)) = component else {
            return Err(code
                .problem(format!("{whole} is no type of component"), "5120, 5121, 5122, 5123, 5125 or 5126")
                .into());
        };
        let is_normalized = accessor.get("normalized").is_some_and(|normalized| normalized.is_true());
        let number = |bytes: &[u8]| match component.number(bytes) {
            (number, one) if is_normalized => (number / one).max(-1.0),
            (number, _) => number,
        };
        let mut numbers = Vec::new();
        self.each(accessor, width * size, buffers, |element| {
            numbers.extend(element.chunks(size).map(number))
        })?;
        Ok(Elements { numbers, width })
    }

    /// Hands on the bytes of each element of an accessor, `size` bytes each.
    fn each(
        &self,
        accessor: &Json,
        size: usize,
        buffers: &mut Buffers,
        mut hear: impl FnMut(&[u8]),
    ) -> Result<(), ProblemList> {
        let count = accessor.required("count")?.whole()?;
        let asked = accessor.required("bufferView")?;
        let number = asked.whole()?;
        let Some(view) = self.views.get(number) else {
            return Err(asked
                .problem(format!("view {number} does not exist"), "the number of a view")
                .into());
        };
        view.expect_known(&["buffer", "byteOffset", "byteLength", "byteStride"], &["target"])?;
        let buffer = view.required("buffer")?;
        let (from, length) = (view.whole_or("byteOffset", 0)?, view.required("byteLength")?.whole()?);
        let stride = view.whole_or("byteStride", size)?;
        let first = accessor.whole_or("byteOffset", 0)?;
        let bytes = buffers.bytes(buffer.whole()?, &buffer)?;
        let bytes = from.checked_add(length).and_then(|end| bytes.get(from..end));
        let bytes = bytes.ok_or_else(|| view.problem("reaches beyond its buffer", "bytes of the buffer"))?;
        if stride < size {
            return Err(view
                .problem(format!("a stride of {stride} bytes"), format!("{size} bytes or more"))
                .into());
        }
        let last = count
            .checked_sub(1)
            .and_then(|last| last.checked_mul(stride)?.checked_add(first)?.checked_add(size));
        if last.unwrap_or(first) > bytes.len() || count > 0 && last.is_none() {
            return Err(accessor
                .problem(format!("{count} elements reach beyond their view"), "bytes of the view")
                .into());
        }
        (0..count).for_each(|number| hear(&bytes[first + number * stride..][..size]));
        Ok(())
    }
}
