//! The first directory of a TIFF, held against the size of its file before anything of it is read into memory.

use std::io::{Read, Result, Seek, SeekFrom};

/// A value that the file cannot hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TooLarge {
    /// Whose it is; the directory itself if none.
    pub tag: Option<u16>,
    /// Bytes that it would take.
    pub bytes: u64,
}

/// The first value of the first directory that is larger than the whole file of `size` bytes. A directory that cannot be
/// read to its end is left to who decodes it.
pub fn too_large(file: &mut (impl Read + Seek), size: u64) -> Option<TooLarge> {
    found(file, size).unwrap_or(None)
}

fn found(file: &mut (impl Read + Seek), size: u64) -> Result<Option<TooLarge>> {
    file.seek(SeekFrom::Start(0))?;
    let head: [u8; 8] = array(file)?;
    let is_little = head[0] == b'I';
    let is_big = number(&head[2..4], is_little) == 43;
    let first = if is_big { number(&array::<8>(file)?, is_little) } else { number(&head[4..8], is_little) };
    file.seek(SeekFrom::Start(first))?;
    let (count, entry) = match is_big {
        true => (number(&array::<8>(file)?, is_little), 20),
        false => (number(&array::<2>(file)?, is_little), 12),
    };
    let bytes = count.saturating_mul(entry);
    if bytes > size {
        return Ok(Some(TooLarge { tag: None, bytes }));
    }
    for _ in 0..count {
        let start: [u8; 4] = array(file)?;
        let [tag, kind] = [&start[..2], &start[2..]].map(|word| number(word, is_little) as u16);
        let values = match is_big {
            true => number(&array::<16>(file)?[..8], is_little),
            false => number(&array::<8>(file)?[..4], is_little),
        };
        let bytes = values.saturating_mul(width(kind));
        if bytes > size {
            return Ok(Some(TooLarge { tag: Some(tag), bytes }));
        }
    }
    Ok(None)
}

/// Bytes of a value of a kind; 1 of one that is not known.
fn width(kind: u16) -> u64 {
    match kind {
        3 | 8 => 2,
        4 | 9 | 11 | 13 => 4,
        5 | 10 | 12 | 16..=18 => 8,
        _ => 1,
    }
}

fn array<const N: usize>(file: &mut impl Read) -> Result<[u8; N]> {
    let mut bytes = [0; N];
    file.read_exact(&mut bytes)?;
    Ok(bytes)
}

fn number(bytes: &[u8], is_little: bool) -> u64 {
    let add = |sum: u64, byte: &u8| sum << 8 | u64::from(*byte);
    if is_little { bytes.iter().rev().fold(0, add) } else { bytes.iter().fold(0, add) }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::{TooLarge, too_large};

    /// A directory of one entry, as large as it says.
    fn tiff(big: bool, little: bool, count: u64) -> Vec<u8> {
        let word = |value: u64, width: usize| {
            let all = if little { value.to_le_bytes() } else { value.to_be_bytes() };
            if little { all[..width].to_vec() } else { all[8 - width..].to_vec() }
        };
        let order = if little { b"II" } else { b"MM" };
        let (version, first) =
            if big { (43, [word(8, 2), word(0, 2), word(16, 8)].concat()) } else { (42, word(8, 4)) };
        let entry = [
            word(273, 2),
            word(4, 2),
            word(count, if big { 8 } else { 4 }),
            word(0, if big { 8 } else { 4 }),
        ];
        let entries = word(1, if big { 8 } else { 2 });
        [order.to_vec(), word(version, 2), first, entries, entry.concat()].concat()
    }

    #[test]
    fn values_are_no_larger_than_their_file() {
        for (big, little) in [(false, false), (false, true), (true, false), (true, true)] {
            let of = |count: u64| {
                let bytes = tiff(big, little, count);
                too_large(&mut Cursor::new(&bytes), bytes.len() as u64)
            };
            assert_eq!(of(5), None, "{big} {little}");
            assert_eq!(of(1 << 30), Some(TooLarge { tag: Some(273), bytes: 1 << 32 }), "{big} {little}");
        }
        let cut = tiff(true, true, 9);
        assert_eq!(too_large(&mut Cursor::new(&cut[..20]), 20), None);
        let mut many = tiff(true, true, 9);
        many[16..24].fill(0xff);
        assert_eq!(too_large(&mut Cursor::new(&many), 44), Some(TooLarge { tag: None, bytes: u64::MAX }));
    }
}
