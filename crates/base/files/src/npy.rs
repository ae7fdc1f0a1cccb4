//! Arrays in numpy's NPY format.

use std::io::{self, Write};
use std::path::Path;

use crate::atomic::write_atomic;
use crate::error::FileError;
use crate::npy_error::{NpyError, NpyFileError};
use crate::npy_header::{self as header, Header};
use crate::pieces::{FilePieces, Pieces, PiecesError};
use crate::read::Most;

/// An array in C order (last index fastest); the number of values is the product of the shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Npy {
    shape: Vec<usize>,
    data: NpyData,
}

macro_rules! data_types {
    ($($variant:ident $number:ty, $descr:literal;)*) => {
        /// The values of an array.
        #[derive(Clone, Debug, PartialEq)]
        pub enum NpyData {
            $(
                #[doc = concat!("`", stringify!($number), "`, written as `", $descr, "`.")]
                $variant(Vec<$number>),
            )*
        }

        impl NpyData {
            /// How many values there are.
            pub fn len(&self) -> usize {
                match self { $( Self::$variant(values) => values.len(), )* }
            }

            /// All values as f64; whole numbers above 2^53 are rounded.
            pub fn to_f64(&self) -> Vec<f64> {
                match self { $( Self::$variant(values) => values.iter().map(|value| *value as f64).collect(), )* }
            }

            /// The type in numpy's notation.
            pub(crate) fn descr(&self) -> &'static str {
                match self { $( Self::$variant(_) => $descr, )* }
            }

            fn write(&self, out: &mut dyn Write) -> io::Result<()> {
                match self { $( Self::$variant(values) => write_values(values, out, <$number>::to_le_bytes), )* }
            }

            fn reordered(self, order: impl Iterator<Item = usize>) -> Self {
                match self { $( Self::$variant(values) => Self::$variant(order.map(|from| values[from]).collect()), )* }
            }

            /// So many values of the type `descr`; `fill` reads their bytes to where they stay.
            fn read<E>(
                descr: &str,
                count: usize,
                fill: impl FnOnce(&mut [u8]) -> Result<(), E>,
            ) -> Option<Result<Self, E>> {
                let (order, kind) = descr.split_at_checked(1)?;
                $(
                    if kind == &$descr[1..] {
                        let mut values = vec![0 as $number; count];
                        let filled = fill(bytemuck::cast_slice_mut(&mut values));
                        for value in &mut values {
                            *value = match order {
                                ">" => <$number>::from_be_bytes(value.to_ne_bytes()),
                                _ => <$number>::from_le_bytes(value.to_ne_bytes()),
                            };
                        }
                        return Some(filled.map(|()| Self::$variant(values)));
                    }
                )*
                None
            }
        }

        $(
            impl From<Vec<$number>> for NpyData {
                fn from(values: Vec<$number>) -> Self {
                    Self::$variant(values)
                }
            }
        )*

        /// Bytes of one value of type `descr`, where the type is one of ours.
        fn size_of_value(descr: &str) -> Option<usize> {
            let (order, kind) = descr.split_at_checked(1)?;
            $(
                if kind == &$descr[1..] {
                    let size = size_of::<$number>();
                    return (matches!(order, "<" | ">") || (order == "|" && size == 1)).then_some(size);
                }
            )*
            None
        }
    };
}

data_types! {
    U8 u8, "|u1";
    I8 i8, "|i1";
    U16 u16, "<u2";
    I16 i16, "<i2";
    U32 u32, "<u4";
    I32 i32, "<i4";
    U64 u64, "<u8";
    I64 i64, "<i8";
    F32 f32, "<f4";
    F64 f64, "<f8";
}

impl NpyData {
    /// True when there is no value.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

fn write_values<T: Copy, const N: usize>(
    values: &[T],
    out: &mut dyn Write,
    bytes: impl Fn(T) -> [u8; N],
) -> io::Result<()> {
    const BLOCK: usize = 4096;
    let mut block = Vec::with_capacity(BLOCK * N);
    for values in values.chunks(BLOCK) {
        block.clear();
        values.iter().for_each(|value| block.extend_from_slice(&bytes(*value)));
        out.write_all(&block)?;
    }
    Ok(())
}

impl Npy {
    /// An array of this shape.
    ///
    /// # Errors
    /// [`NpyError::Shape`] when the product of the shape is not the number of values.
    pub fn new(shape: Vec<usize>, data: impl Into<NpyData>) -> Result<Self, NpyError> {
        let data = data.into();
        match count(&shape) {
            Some(values) if values == data.len() => Ok(Self { shape, data }),
            _ => Err(NpyError::Shape { shape, values: data.len() }),
        }
    }

    /// Sizes of the dimensions, the last index fastest.
    pub fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// Returns the values, in C order.
    pub fn data(&self) -> &NpyData {
        &self.data
    }

    /// Returns the shape and the values of the array.
    pub fn into_parts(self) -> (Vec<usize>, NpyData) {
        (self.shape, self.data)
    }

    /// Reads the bytes of an NPY file: versions 1 to 3, either byte order, C or Fortran order (which is
    /// turned into C order). Header and shape are checked against the number of bytes before anything is
    /// allocated.
    ///
    /// # Errors
    /// [`NpyError`] with what was found and what was expected.
    pub fn parse(mut bytes: &[u8]) -> Result<Self, NpyError> {
        Self::of(&mut bytes).map_err(PiecesError::of_format)
    }

    /// The same of bytes that are read piece by piece.
    fn of<B: Pieces>(bytes: &mut B) -> Result<Self, Fault<B::Error>> {
        let (header, count) = held(bytes)?;
        let offset = header.data_offset as u64;
        let data = NpyData::read(&header.descr, count, |values| bytes.fill(offset, values));
        let data = data.ok_or_else(|| wrong_type(&header))?.map_err(PiecesError::Read)?;
        let data = if header.fortran_order { data.reordered(fortran_indices(&header.shape)) } else { data };
        Ok(Self { shape: header.shape, data })
    }

    /// Writes the array as NPY version 1, little-endian, C order.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        out.write_all(&header::write(self.data.descr(), &self.shape))?;
        self.data.write(out)
    }
}

/// Why there is no array.
type Fault<E> = PiecesError<E, NpyError>;

impl<E> From<NpyError> for Fault<E> {
    fn from(error: NpyError) -> Self {
        Self::Format(error)
    }
}

/// Bytes in which most headers end.
const FRONT: u64 = 4096;

fn header_of<B: Pieces>(bytes: &mut B) -> Result<Header, Fault<B::Error>> {
    let length = bytes.length();
    let front = bytes.take(0, length.min(FRONT) as usize).map_err(PiecesError::Read)?;
    match header::parse(&front) {
        // It ends farther on, if the bytes do.
        Err(NpyError::Truncated { expected, .. }) if length > FRONT => {
            let front = bytes.take(0, length.min(expected) as usize).map_err(PiecesError::Read)?;
            Ok(header::parse(&front)?)
        }
        header => Ok(header?),
    }
}

/// The header of an array and the number of its values, where the bytes hold just these.
fn held<B: Pieces>(bytes: &mut B) -> Result<(Header, usize), Fault<B::Error>> {
    let header = header_of(bytes)?;
    let size = size_of_value(&header.descr).ok_or_else(|| wrong_type(&header))?;
    let overflow = || NpyError::Overflow { shape: header.shape.clone() };
    let count = count(&header.shape).ok_or_else(overflow)?;
    let expected = count.checked_mul(size).ok_or_else(overflow)? as u64;
    let (offset, found) = (header.data_offset, bytes.length() - header.data_offset as u64);
    if expected != found {
        return Err(NpyError::Size { shape: header.shape, offset, expected, found }.into());
    }
    Ok((header, count))
}

fn wrong_type(header: &Header) -> NpyError {
    NpyError::Type { found: header.descr.clone() }
}

fn count(shape: &[usize]) -> Option<usize> {
    shape.iter().try_fold(1_usize, |product, size| product.checked_mul(*size))
}

/// For each value in C order its place in Fortran order.
fn fortran_indices(shape: &[usize]) -> impl Iterator<Item = usize> + '_ {
    let total: usize = shape.iter().product();
    (0..total).map(move |place| {
        let (mut rest, mut stride, mut from) = (place, total, 0);
        for size in shape.iter().rev() {
            stride /= size;
            from += rest % size * stride;
            rest /= size;
        }
        from
    })
}

/// Reads an NPY file of at most so many bytes.
///
/// # Errors
/// [`NpyFileError`], which names the file.
pub fn read_npy(path: impl AsRef<Path>, most: impl Into<Most>) -> Result<Npy, NpyFileError> {
    let path = path.as_ref();
    Npy::of(&mut FilePieces::open(path, most)?).map_err(|fault| of_file(path, fault))
}

fn of_file(path: &Path, fault: Fault<FileError>) -> NpyFileError {
    match fault {
        PiecesError::Read(error) => NpyFileError::File(error),
        PiecesError::Format(source) => NpyFileError::Format { path: path.to_owned(), source },
    }
}

/// How the values of an NPY file stand in it, for readers that need a part of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NpyLayout {
    /// Sizes of the dimensions.
    pub shape: Vec<usize>,
    /// Whether the first index is the fastest; else the last one is.
    pub fortran_order: bool,
    /// Byte of the file where the values begin.
    pub offset: u64,
    /// Bytes of a value: 1, 2, 4 or 8.
    pub value_bytes: usize,
    /// Whether values are floats.
    pub is_real: bool,
    /// Whether values can be negative.
    pub is_signed: bool,
    /// Whether the lowest byte of a value stands first.
    pub is_little: bool,
}

/// Looks at the header of an NPY file, whose values stay where they are: it may be of any size.
///
/// # Errors
/// [`NpyFileError`], which names the file.
pub fn npy_layout(path: impl AsRef<Path>) -> Result<NpyLayout, NpyFileError> {
    let path = path.as_ref();
    let (header, _) = held(&mut FilePieces::open(path, u64::MAX)?).map_err(|fault| of_file(path, fault))?;
    let value_bytes = size_of_value(&header.descr).unwrap_or_default();
    let kind = |letter: char| header.descr[1..].starts_with(letter);
    Ok(NpyLayout {
        fortran_order: header.fortran_order,
        offset: header.data_offset as u64,
        value_bytes,
        is_real: kind('f'),
        is_signed: !kind('u'),
        is_little: !header.descr.starts_with('>'),
        shape: header.shape,
    })
}

/// Writes an NPY file, whole or not at all.
///
/// # Errors
/// [`FileError`].
pub fn write_npy(path: impl AsRef<Path>, array: &Npy) -> Result<(), FileError> {
    write_atomic(path, |out| array.write(out))
}
