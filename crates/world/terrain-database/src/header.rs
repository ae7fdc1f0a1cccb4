//! The header of a file, and its table of blocks.
//!
//! | bytes | what |
//! |---|---|
//! | 8, 4 | magic, version |
//! | 4 | units: 1 is metres and radians |
//! | 5 x 8 | radius, latitude, longitude, origin east, origin north |
//! | 8 | step of the heights, 0 for every bit |
//! | 3 x 4 | order, columns, rows |
//! | 3 x 1 | bits of the light, bits of the albedo (0, 8, 16), number of ranges |
//! | 16 a range | end, share |
//! | 40 a block | length, hash |
//! | 32 | hash of all bytes before |

use crate::blocks::Block;
use crate::bytes::{Numbers, put};
use crate::check::{check_frame, check_ranges, check_step};
use crate::contents::{Contents, Frame, Map, Range};
use crate::error::{Unfit, expect};
use crate::tiling::{MOST_ORDER, Tiling};

/// Version of the format that is written and read.
pub const VERSION: u32 = 1;
/// First bytes of every file.
pub(crate) const MAGIC: [u8; 8] = *b"\x89LODGRND";
/// Number that stands for metres and radians.
const UNITS: u32 = 1;
/// Bytes of a hash.
pub(crate) const HASH: usize = 32;

/// A block's row of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Row {
    /// Block of the row.
    pub block: Block,
    /// Bytes of the block.
    pub length: u64,
    /// Hash of these bytes.
    pub hash: [u8; HASH],
}

/// Bits of a map's numbers; 0 where there is no map.
pub(crate) type Bits = u8;

/// All that stands before the blocks.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Header {
    /// Body and axes of the terrain.
    pub frame: Frame,
    /// Step of the heights (m).
    pub step: Option<f64>,
    /// Tiles of the terrain.
    pub tiling: Tiling,
    /// Bits of light and of albedo.
    pub maps: [Bits; 2],
    /// Suggested ranges of levels.
    pub ranges: Vec<Range>,
}

/// Why bytes are no header.
#[derive(Debug, PartialEq)]
pub(crate) enum NoHeader {
    /// The first bytes are others.
    Magic,
    /// It has another version.
    Version(u32),
    /// The bytes end; at least so many are needed.
    Short(u64),
    /// The hash is another one.
    Damaged,
    /// A value that cannot be.
    Unfit(Unfit),
}

impl From<Unfit> for NoHeader {
    fn from(unfit: Unfit) -> Self {
        Self::Unfit(unfit)
    }
}

impl Header {
    /// Header of contents in tiles.
    pub fn of(contents: &Contents, tiling: Tiling) -> Self {
        let bits = |map: &Option<Map>| match map {
            None => 0,
            Some(Map::U8(_)) => 8,
            Some(Map::U16(_)) => 16,
        };
        Self {
            frame: contents.frame,
            step: contents.step,
            tiling,
            maps: [&contents.light, &contents.albedo].map(bits),
            ranges: contents.ranges.clone(),
        }
    }

    /// All blocks behind the header, in their order.
    pub fn blocks(&self) -> Vec<Block> {
        let [light, albedo] = self.maps.map(|bits| bits > 0);
        Block::all(self.tiling, light, albedo)
    }

    /// Bytes of the header with its table and its hash.
    pub fn bytes(&self, table: &[Row]) -> Vec<u8> {
        let mut bytes = MAGIC.to_vec();
        bytes.extend([VERSION, UNITS].iter().flat_map(|number| number.to_le_bytes()));
        let Frame { radius, latitude, longitude, origin: [east, north] } = self.frame;
        put(&mut bytes, [radius, latitude, longitude, east, north, self.step.unwrap_or(0.0)]);
        let [columns, rows] = self.tiling.counts.map(|count| count as u32);
        bytes.extend([self.tiling.order, columns, rows].iter().flat_map(|number| number.to_le_bytes()));
        bytes.extend([self.maps[0], self.maps[1], self.ranges.len() as u8]);
        put(&mut bytes, self.ranges.iter().flat_map(|range| [range.end, range.share]));
        for row in table {
            bytes.extend(row.length.to_le_bytes());
            bytes.extend(row.hash);
        }
        let hash = blake3::hash(&bytes);
        bytes.extend(hash.as_bytes());
        bytes
    }

    /// Reads a header, its table, and how many bytes they take. Nothing is believed before the hash is checked, but for the sizes
    /// that say where the hash stands; these must fit the file.
    pub fn parse(file: &[u8]) -> Result<(Self, Vec<Row>, usize), NoHeader> {
        if !file.starts_with(&MAGIC) {
            return Err(NoHeader::Magic);
        }
        let mut numbers = Numbers::new(&file[MAGIC.len()..]);
        let short = || NoHeader::Short(file.len() as u64 + 1);
        let version = numbers.u32().ok_or_else(short)?;
        if version != VERSION {
            return Err(NoHeader::Version(version));
        }
        let (units, header) = fixed(&mut numbers).ok_or_else(short)?;
        // Sizes up to the hash are bounded by the file.
        let blocks = blocks(&header);
        let length = (file.len() - numbers.left()) as u128 + blocks * (8 + HASH as u128);
        let end = length + HASH as u128;
        if end > file.len() as u128 {
            return Err(NoHeader::Short(u64::try_from(end).unwrap_or(u64::MAX)));
        }
        let (length, end) = (length as usize, end as usize);
        if blake3::hash(&file[..length]).as_bytes() != &file[length..end] {
            return Err(NoHeader::Damaged);
        }
        header.check(units)?;
        let row = |block| Some(Row { block, length: numbers.u64()?, hash: numbers.bytes()? });
        let table = header.blocks().into_iter().map(row).collect::<Option<_>>().ok_or_else(short)?;
        Ok((header, table, end))
    }

    fn check(&self, units: u32) -> Result<(), Unfit> {
        expect(units == UNITS, "units", units, "1, metres and radians")?;
        let Tiling { order, counts } = self.tiling;
        expect((1..=MOST_ORDER).contains(&order), "order", order, "a whole number from 1 to 12")?;
        let is_some = counts.iter().all(|count| *count > 0);
        expect(is_some, "number of tiles", format_args!("{counts:?}"), "at least one along each axis")?;
        for (key, bits) in [("bits of the light", self.maps[0]), ("bits of the albedo", self.maps[1])] {
            expect([0, 8, 16].contains(&bits), key, bits, "0, 8 or 16")?;
        }
        check_frame(&self.frame)?;
        check_step(self.step)?;
        check_ranges(&self.ranges, order)
    }
}

/// What stands before the table: units, and a header that is not checked yet.
fn fixed(numbers: &mut Numbers) -> Option<(u32, Header)> {
    let units = numbers.u32()?;
    let [radius, latitude, longitude, east, north, step] = numbers.f64s()?;
    let [order, columns, rows] = [numbers.u32()?, numbers.u32()?, numbers.u32()?];
    let [light, albedo, count] = numbers.bytes()?;
    let range = |_| numbers.f64s().map(|[end, share]| Range { end, share });
    let ranges = (0..count).map(range).collect::<Option<_>>()?;
    let frame = Frame { radius, latitude, longitude, origin: [east, north] };
    let tiling = Tiling { order, counts: [columns, rows].map(|count| count as usize) };
    let step = (step.to_bits() != 0).then_some(step);
    Some((units, Header { frame, step, tiling, maps: [light, albedo], ranges }))
}

/// Number of blocks of a header, whatever it says.
fn blocks(header: &Header) -> u128 {
    let tiles: u128 = header.tiling.counts.iter().map(|count| *count as u128).product();
    let maps = header.maps.iter().filter(|bits| **bits > 0).count() as u128;
    4 + tiles * (1 + maps)
}
