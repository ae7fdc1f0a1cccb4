//! Files damaged at random: a function of the seed and the number alone.

use lunoid_tests::Dice;

/// What stands where a number should.
const NUMBERS: [&str; 16] = [
    "0",
    "-1",
    "1e309",
    "-1e308",
    "nan",
    "inf",
    "1e-320",
    "0x10",
    "18446744073709551616",
    "4294967296",
    "-0",
    "1.5",
    "",
    "99999999",
    "1e9",
    "'",
];

/// Pieces that mean something to some format.
const WORDS: [&str; 16] = [
    "\n",
    ",",
    ",,",
    "\"",
    "'''",
    "[",
    "]]",
    "{",
    "=",
    "../",
    "/etc/passwd",
    "\u{0}",
    "\u{feff}",
    "f 1 2 3",
    "END",
    "//",
];

/// `seed` with one to four pieces of damage; `other` lends pieces.
pub fn damaged(dice: &mut Dice, seed: &[u8], other: &[u8]) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..dice.count(1, 4) {
        damage(dice, &mut bytes, other);
    }
    bytes
}

fn damage(dice: &mut Dice, bytes: &mut Vec<u8>, other: &[u8]) {
    if bytes.is_empty() {
        bytes.extend_from_slice(other);
        return;
    }
    let at = dice.count(0, bytes.len() - 1);
    let end = (at + dice.count(1, 40)).min(bytes.len());
    match dice.count(0, 10) {
        0 => bytes[at] ^= 1 << dice.count(0, 7),
        1 => bytes[at] = dice.choose(&[0, 1, 0x7f, 0x80, 0xff, b'\n', b' ']),
        2 => overwrite(dice, bytes, at),
        3 => drop(bytes.drain(at..end)),
        4 => {
            let piece = bytes[at..end].to_vec();
            bytes.splice(at..at, piece);
        }
        5 => bytes.truncate(at),
        6 | 7 => number(dice, bytes, at),
        8 => {
            bytes.splice(at..at, dice.choose(&WORDS).bytes());
        }
        9 => {
            let from = dice.count(0, other.len().saturating_sub(1));
            let to = (from + dice.count(1, 60)).min(other.len());
            bytes.splice(at..end, other[from..to].iter().copied());
        }
        _ => line(dice, bytes, at),
    }
}

/// A word of two, four or eight bytes that sizes do not have.
fn overwrite(dice: &mut Dice, bytes: &mut [u8], at: usize) {
    let word: u64 = dice.choose(&[
        0,
        1,
        0x7fff,
        0xffff,
        0x7fff_ffff,
        0xffff_ffff,
        1 << 34,
        u64::MAX,
        i64::MAX as u64,
        65_537,
    ]);
    let width = dice.choose(&[2, 4, 8]);
    let all = if dice.count(0, 1) == 0 {
        word.to_le_bytes()
    } else {
        word.rotate_left(64 - 8 * width as u32 % 64).to_be_bytes()
    };
    let width = width.min(bytes.len() - at);
    bytes[at..at + width].copy_from_slice(&all[..width]);
}

/// Another number in place of the next one.
fn number(dice: &mut Dice, bytes: &mut Vec<u8>, at: usize) {
    let Some(start) = (at..bytes.len()).find(|&place| bytes[place].is_ascii_digit()) else { return };
    let is_part = |byte: &u8| byte.is_ascii_digit() || *byte == b'.';
    let end = (start..bytes.len()).find(|&place| !is_part(&bytes[place])).unwrap_or(bytes.len());
    bytes.splice(start..end, dice.choose(&NUMBERS).bytes());
}

/// `text` with one to three of its numbers changed, most of them by so much that it may still be drawn.
pub fn renumbered(dice: &mut Dice, text: &str) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for _ in 0..dice.count(1, 3) {
        let with_number: Vec<usize> = (1..lines.len()).filter(|&at| value_of(&lines[at]).is_some()).collect();
        let at = dice.choose(&with_number);
        let Some((start, end, value)) = value_of(&lines[at]) else { continue };
        let factor = dice.choose(&[0.0, -1.0, 0.1, 0.5, 0.9, 1.0001, 1.1, 2.0, 7.0, 100.0, 1e-3, 1e6]);
        let whole = value.fract() == 0.0 && (value * factor).fract() == 0.0;
        let changed = if whole { format!("{:.0}", value * factor) } else { format!("{:?}", value * factor) };
        lines[at].replace_range(start..end, &changed);
    }
    lines.join("\n") + "\n"
}

/// The first number behind an equals sign.
fn value_of(line: &str) -> Option<(usize, usize, f64)> {
    let from = line.find('=')? + 1;
    let start = from + line[from..].find(|c: char| c.is_ascii_digit())?;
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let end = line[start..].find(|c| !is_part(c)).map_or(line.len(), |place| start + place);
    Some((start, end, line[start..end].parse().ok()?))
}

/// A line twice, or no more.
fn line(dice: &mut Dice, bytes: &mut Vec<u8>, at: usize) {
    let start = bytes[..at].iter().rposition(|&byte| byte == b'\n').map_or(0, |place| place + 1);
    let end = bytes[at..].iter().position(|&byte| byte == b'\n').map_or(bytes.len(), |place| at + place + 1);
    if dice.count(0, 1) == 0 {
        bytes.drain(start..end);
    } else {
        let copy = bytes[start..end].to_vec();
        bytes.splice(start..start, copy);
    }
}

/// A bank whose length and checksums are right again (docs/bank-format.md): what is behind them is read.
pub fn resealed(mut bytes: Vec<u8>) -> Vec<u8> {
    const BLOCK: usize = 64;
    let word = |bytes: &[u8], at: usize| {
        bytes
            .get(at..at + 8)
            .map_or(0, |word| u64::from_le_bytes(word.try_into().expect("eight bytes")) as usize)
    };
    if bytes.len() < 2 * BLOCK {
        return bytes;
    }
    let length = bytes.len() as u64;
    bytes[16..24].copy_from_slice(&length.to_le_bytes());
    let count = u32::from_le_bytes(bytes[12..16].try_into().expect("four bytes")) as usize;
    let end = BLOCK.saturating_mul(count.saturating_add(1));
    if end > bytes.len() {
        return bytes;
    }
    for entry in (BLOCK..end).step_by(BLOCK) {
        let (from, size) = (word(&bytes, entry + 8), word(&bytes, entry + 16));
        let payload = from.checked_add(size).and_then(|to| bytes.get(from..to));
        if let Some(hash) = payload.map(blake3::hash) {
            bytes[entry + 32..entry + 64].copy_from_slice(hash.as_bytes());
        }
    }
    let table = blake3::hash(&bytes[BLOCK..end]);
    bytes[32..64].copy_from_slice(table.as_bytes());
    bytes
}

/// A state of a machine whose length and checksum are right again (docs/state-format.md).
pub fn resealed_state(mut bytes: Vec<u8>) -> Vec<u8> {
    if bytes.len() < 64 {
        return bytes;
    }
    let length = bytes.len() as u64;
    bytes[16..24].copy_from_slice(&length.to_le_bytes());
    let mut hasher = blake3::Hasher::new();
    hasher.update(&bytes[..32]).update(&bytes[64..]);
    bytes[32..64].copy_from_slice(hasher.finalize().as_bytes());
    bytes
}
