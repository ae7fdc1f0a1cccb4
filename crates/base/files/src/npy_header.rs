//! The header of an NPY file: magic, version, and a dictionary in Python's notation.

use crate::npy_error::NpyError;

pub(crate) const MAGIC: &[u8] = b"\x93NUMPY";
/// Most dimensions of an array: numpy's own limit.
const MOST_DIMENSIONS: usize = 64;

/// What the header says.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Header {
    /// Type of the values in numpy's notation, as `<f8`.
    pub descr: String,
    pub fortran_order: bool,
    pub shape: Vec<usize>,
    /// Where the values begin.
    pub data_offset: usize,
}

/// Reads the header at the front of `bytes`.
pub(crate) fn parse(bytes: &[u8]) -> Result<Header, NpyError> {
    if !bytes.starts_with(MAGIC) {
        return Err(NpyError::NotNpy);
    }
    let (start, length) = match bytes.get(6..8) {
        Some([1, _]) => (10, little_endian(bytes, 8, 2)?),
        Some([2 | 3, _]) => (12, little_endian(bytes, 8, 4)?),
        Some([major, minor]) => return Err(NpyError::Version { major: *major, minor: *minor }),
        _ => return Err(NpyError::Truncated { expected: 10, found: bytes.len() as u64 }),
    };
    let expected = start as u64 + length as u64;
    let dictionary = bytes
        .get(start..start + length)
        .ok_or(NpyError::Truncated { expected, found: bytes.len() as u64 })?;
    Dictionary { text: dictionary, at: 0, offset: start }.read(start + length)
}

fn little_endian(bytes: &[u8], at: usize, count: usize) -> Result<usize, NpyError> {
    let truncated = NpyError::Truncated { expected: (at + count) as u64, found: bytes.len() as u64 };
    let field = bytes.get(at..at + count).ok_or(truncated)?;
    Ok(field.iter().rev().fold(0, |value, byte| value << 8 | usize::from(*byte)))
}

/// The header that numpy itself would write: version 1, padded with spaces so that the values begin at a
/// multiple of 64 bytes.
pub(crate) fn write(descr: &str, shape: &[usize]) -> Vec<u8> {
    let sizes: Vec<String> = shape.iter().map(usize::to_string).collect();
    let comma = if shape.len() == 1 { "," } else { "" };
    let shape = format!("({}{comma})", sizes.join(", "));
    let dictionary = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}");
    let unpadded = MAGIC.len() + 4 + dictionary.len() + 1;
    let padding = unpadded.next_multiple_of(64) - unpadded;
    let length = (dictionary.len() + padding + 1) as u16;
    let mut header = [MAGIC, &[1, 0], &length.to_le_bytes(), dictionary.as_bytes()].concat();
    header.resize(header.len() + padding, b' ');
    header.push(b'\n');
    header
}

/// A cursor over the dictionary's text.
struct Dictionary<'a> {
    text: &'a [u8],
    at: usize,
    offset: usize,
}

impl Dictionary<'_> {
    fn read(mut self, data_offset: usize) -> Result<Header, NpyError> {
        let (mut descr, mut fortran_order, mut shape) = (None, None, None);
        self.expect(b'{')?;
        while self.peek() != Some(b'}') {
            let key = self.string()?;
            self.expect(b':')?;
            match key.as_str() {
                "descr" => descr = Some(self.string()?),
                "fortran_order" => fortran_order = Some(self.boolean()?),
                "shape" => shape = Some(self.tuple()?),
                _ => return Err(self.fault("one of 'descr', 'fortran_order', 'shape'")),
            }
            if self.peek() != Some(b'}') {
                self.expect(b',')?;
            }
        }
        let missing = self.fault("the keys 'descr', 'fortran_order' and 'shape'");
        match (descr, fortran_order, shape) {
            (Some(descr), Some(fortran_order), Some(shape)) => {
                Ok(Header { descr, fortran_order, shape, data_offset })
            }
            _ => Err(missing),
        }
    }

    fn fault(&self, expected: &'static str) -> NpyError {
        NpyError::Header { offset: self.offset + self.at, expected }
    }

    fn peek(&mut self) -> Option<u8> {
        while self.text.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
        self.text.get(self.at).copied()
    }

    fn expect(&mut self, wanted: u8) -> Result<(), NpyError> {
        if self.peek() != Some(wanted) {
            return Err(self.fault(match wanted {
                b'{' => "'{'",
                b':' => "':'",
                b'(' => "'('",
                _ => "','",
            }));
        }
        self.at += 1;
        Ok(())
    }

    fn string(&mut self) -> Result<String, NpyError> {
        // A list here is a table of named columns.
        const EXPECTED: &str = "a text in quotes (tables of named columns are not read)";
        let quote = self.peek().filter(|byte| matches!(byte, b'\'' | b'"')).ok_or(self.fault(EXPECTED))?;
        let rest = &self.text[self.at + 1..];
        let length = rest.iter().position(|byte| *byte == quote).ok_or(self.fault("a closing quote"))?;
        let text = String::from_utf8_lossy(&rest[..length]).into_owned();
        self.at += length + 2;
        Ok(text)
    }

    fn boolean(&mut self) -> Result<bool, NpyError> {
        self.peek();
        for (word, value) in [("True", true), ("False", false)] {
            if self.text[self.at..].starts_with(word.as_bytes()) {
                self.at += word.len();
                return Ok(value);
            }
        }
        Err(self.fault("True or False"))
    }

    fn tuple(&mut self) -> Result<Vec<usize>, NpyError> {
        let mut sizes = Vec::new();
        self.expect(b'(')?;
        while self.peek() != Some(b')') {
            sizes.push(self.number()?);
            if sizes.len() > MOST_DIMENSIONS {
                return Err(self.fault("at most 64 dimensions"));
            }
            if self.peek() != Some(b')') {
                self.expect(b',')?;
            }
        }
        self.at += 1;
        Ok(sizes)
    }

    fn number(&mut self) -> Result<usize, NpyError> {
        self.peek();
        let digits = self.text[self.at..].iter().take_while(|byte| byte.is_ascii_digit()).count();
        let text = String::from_utf8_lossy(&self.text[self.at..self.at + digits]);
        let number = text.parse().map_err(|_| self.fault("a whole number that fits this machine"))?;
        self.at += digits;
        // Python 2 wrote long numbers as 100L.
        self.at += usize::from(self.text.get(self.at) == Some(&b'L'));
        Ok(number)
    }
}
