//! A plane: numbers of one type in a row, with a name and a shape.

/// Type of the numbers of a plane. All of them are little-endian on the wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dtype {
    /// Whole numbers from 0 to 255; also plain bytes.
    U8,
    /// Whole numbers of 16 bits, from 0.
    U16,
    /// Whole numbers of 32 bits, from 0.
    U32,
    /// Whole numbers of 32 bits with a sign.
    I32,
    /// IEEE numbers of 32 bits.
    F32,
    /// IEEE numbers of 64 bits.
    F64,
}

impl Dtype {
    /// All types, in the order of their sizes.
    pub const ALL: [Self; 6] = [Self::U8, Self::U16, Self::U32, Self::I32, Self::F32, Self::F64];

    /// Word in a header.
    pub fn name(self) -> &'static str {
        match self {
            Self::U8 => "u8",
            Self::U16 => "u16",
            Self::U32 => "u32",
            Self::I32 => "i32",
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }

    /// Bytes of one number.
    pub fn size(self) -> usize {
        match self {
            Self::U8 => 1,
            Self::U16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// The type of a word in a header.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|dtype| dtype.name() == name)
    }
}

/// A number that a plane can hold.
pub trait Element: Copy {
    /// Its type on the wire.
    const DTYPE: Dtype;

    /// Adds its bytes, the lowest first.
    fn put(self, bytes: &mut Vec<u8>);

    /// The number of `bytes`, which are as many as the type has.
    fn take(bytes: &[u8]) -> Self;
}

macro_rules! element {
    ($($number:ty => $dtype:ident),*) => {
        $(impl Element for $number {
            const DTYPE: Dtype = Dtype::$dtype;

            fn put(self, bytes: &mut Vec<u8>) {
                bytes.extend_from_slice(&self.to_le_bytes());
            }

            fn take(bytes: &[u8]) -> Self {
                let mut own = [0; size_of::<Self>()];
                own.copy_from_slice(bytes);
                Self::from_le_bytes(own)
            }
        })*
    };
}

element!(u8 => U8, u16 => U16, u32 => U32, i32 => I32, f32 => F32, f64 => F64);

/// Numbers with a name and a shape. Their count is the product of the shape.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Plane {
    name: String,
    dtype: Dtype,
    shape: Vec<usize>,
    bytes: Vec<u8>,
}

impl Plane {
    /// A plane of `values`, the last axis of `shape` fastest.
    ///
    /// # Panics
    /// If there are not as many values as the shape says.
    pub fn of<T: Element>(name: impl Into<String>, shape: &[usize], values: &[T]) -> Self {
        let mut bytes = Vec::with_capacity(size_of_val(values));
        values.iter().for_each(|value| value.put(&mut bytes));
        Self::of_bytes(name, T::DTYPE, shape, bytes)
    }

    /// A plane of bytes without any further shape.
    pub fn of_file(name: impl Into<String>, bytes: Vec<u8>) -> Self {
        let shape = [bytes.len()];
        Self::of_bytes(name, Dtype::U8, &shape, bytes)
    }

    /// A plane whose numbers are there as little-endian `bytes`.
    ///
    /// # Panics
    /// If there are not as many bytes as type and shape say.
    pub fn of_bytes(name: impl Into<String>, dtype: Dtype, shape: &[usize], bytes: Vec<u8>) -> Self {
        let plane = Self { name: name.into(), dtype, shape: shape.to_vec(), bytes };
        assert_eq!(byte_count(dtype, shape), Some(plane.bytes.len() as u64), "{}: {shape:?}", plane.name);
        plane
    }

    /// Name, which no other plane of the message has.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Type of the numbers.
    pub fn dtype(&self) -> Dtype {
        self.dtype
    }

    /// Length of each axis, the slowest first.
    pub fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// The numbers as little-endian bytes.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The numbers as `T`; `None` if the plane has another type.
    pub fn values<T: Element>(&self) -> Option<Vec<T>> {
        let values = || self.bytes.chunks_exact(self.dtype.size()).map(T::take).collect();
        (self.dtype == T::DTYPE).then(values)
    }
}

/// Bytes of a plane; `None` if no number counts them.
pub(crate) fn byte_count(dtype: Dtype, shape: &[usize]) -> Option<u64> {
    let axes = shape.iter().try_fold(1_u64, |count, axis| count.checked_mul(*axis as u64));
    axes?.checked_mul(dtype.size() as u64)
}
