//! Blocks whose hashes are checked become a database.

use std::mem::discriminant;
use std::path::Path;

use limits::Limit;
use rayon::prelude::*;

use crate::blocks::Block;
use crate::boulders;
use crate::bytes::Numbers;
use crate::check::check;
use crate::contents::{Contents, Map};
use crate::database::{Database, Tile};
use crate::error::{DatabaseError, Unfit, UnfitBlock, expect};
use crate::header::{Header, Row};
use crate::heights::Coding;
use crate::rows;
use crate::tiling::Tiling;

/// A file whose hashes are checked.
pub(crate) struct Reading<'p, 't, 'b> {
    /// Path of the file, for errors.
    pub path: &'p Path,
    /// Tiles of the header.
    pub tiling: Tiling,
    /// All blocks in the order of the file.
    pub blocks: Vec<(&'t Row, &'b [u8])>,
}

impl Reading<'_, '_, '_> {
    /// Whether the posts have room in memory, and bytes in their blocks: a post takes a bit at least.
    pub fn expect_room(&self) -> Result<(), DatabaseError> {
        let posts = self.tiling.counts.map(|count| ((count as u128) << self.tiling.order) + 1);
        let bits: u128 =
            self.of(|block| matches!(block, Block::Heights(_))).map(|bytes| 8 * bytes.len() as u128).sum();
        let posts: u128 = posts.iter().product();
        let expected = format!("at most {bits}, the bits of the heights");
        expect(posts <= bits, "number of posts", posts, expected)
            .map_err(|unfit| self.unfit(Block::Header, unfit))?;
        let (posts, limit) = (posts as u64, Limit::ElevationBytes);
        let bytes = posts.saturating_mul(8);
        if limit.allows(bytes) {
            return Ok(());
        }
        Err(DatabaseError::TooLarge { path: self.path.into(), posts, bytes, limit })
    }

    /// Bytes of some blocks, in their order.
    fn of(&self, is_asked: impl Fn(Block) -> bool) -> impl Iterator<Item = &[u8]> {
        self.blocks.iter().filter(move |(row, _)| is_asked(row.block)).map(|(_, bytes)| *bytes)
    }

    fn unfit(&self, block: Block, unfit: Unfit) -> DatabaseError {
        DatabaseError::Unfit { path: self.path.into(), block, unfit }
    }

    fn malformed(&self, block: Block) -> DatabaseError {
        let unfit = Unfit {
            key: "its content".into(),
            found: "of another form".into(),
            expected: "what is written there".into(),
        };
        self.unfit(block, unfit)
    }

    /// The database of the blocks.
    pub fn database(&self, header: Header) -> Result<Database, DatabaseError> {
        let Header { frame, step, tiling, maps, ranges } = header;
        let only = |block| self.of(move |other| other == block).next().unwrap_or_default();
        let boulders =
            boulders::decoded(only(Block::Boulders)).ok_or_else(|| self.malformed(Block::Boulders))?;
        let sidecar =
            String::from_utf8(only(Block::Sidecar).to_vec()).map_err(|_| self.malformed(Block::Sidecar))?;
        let coding = Coding::new(step);
        let heights = self.grid(0.0, Block::Heights, |number| Some(coding.height(number)))?;
        let contents = Contents {
            frame,
            order: tiling.order,
            places: self.places(only(Block::Places))?,
            heights,
            step,
            ranges,
            light: self.map(maps[0], Block::Light)?,
            albedo: self.map(maps[1], Block::Albedo)?,
            boulders,
            sidecar,
        };
        check(&contents, tiling).map_err(|UnfitBlock { block, unfit }| self.unfit(block, unfit))?;
        let tiles = self.tiles(only(Block::Tiles))?;
        Ok(Database { contents, tiling, tiles })
    }

    fn places(&self, bytes: &[u8]) -> Result<[Vec<f64>; 2], DatabaseError> {
        let [columns, rows] = self.tiling.posts();
        let mut numbers = Numbers::new(bytes);
        if bytes.len() != 8 * (columns + rows) {
            return Err(self.malformed(Block::Places));
        }
        Ok([columns, rows].map(|count| (0..count).map_while(|_| numbers.f64()).collect()))
    }

    fn tiles(&self, bytes: &[u8]) -> Result<Vec<Tile>, DatabaseError> {
        let levels = self.tiling.order as usize + 1;
        let length = self.tiling.tiles().checked_mul(8 * (levels + 2));
        let mut numbers = Numbers::new(bytes);
        let mut tile = || {
            let errors: Vec<_> = (0..levels).map_while(|_| numbers.f64()).collect();
            Some(Tile { errors, bounds: numbers.f64s()? }).filter(is_tile)
        };
        let tiles = if length == Some(bytes.len()) {
            (0..self.tiling.tiles()).map(|_| tile()).collect()
        } else {
            None
        };
        tiles.ok_or_else(|| self.malformed(Block::Tiles))
    }

    fn map(&self, bits: u8, of: fn([usize; 2]) -> Block) -> Result<Option<Map>, DatabaseError> {
        Ok(match bits {
            0 => None,
            8 => Some(Map::U8(self.grid(0, of, |number| u8::try_from(number).ok())?)),
            _ => Some(Map::U16(self.grid(0, of, |number| u16::try_from(number).ok())?)),
        })
    }

    /// Numbers of all posts. Threads have one row of tiles each, whose posts stand together.
    fn grid<T: Copy + Send + Sync>(
        &self,
        empty: T,
        of: fn([usize; 2]) -> Block,
        value: impl Fn(i64) -> Option<T> + Sync,
    ) -> Result<Vec<T>, DatabaseError> {
        let [width, height] = self.tiling.posts();
        let mut values = vec![empty; width * height];
        let [_, rows] = self.tiling.counts;
        let blocks: Vec<&[u8]> = self.of(|block| discriminant(&block) == discriminant(&of([0; 2]))).collect();
        let mut bands = Vec::new();
        let mut rest = values.as_mut_slice();
        for row in 0..rows {
            let (band, next) = rest.split_at_mut(self.tiling.own(1, row).len() * width);
            bands.push(band);
            rest = next;
        }
        let columns = self.tiling.counts[0];
        let decoded =
            bands.into_par_iter().zip(blocks.par_chunks(columns)).enumerate().map(|(row, (band, blocks))| {
                blocks.iter().enumerate().try_for_each(|(column, bytes)| {
                    self.decode(band, [column, row], bytes, &value)
                        .ok_or_else(|| self.malformed(of([column, row])))
                })
            });
        decoded.collect::<Result<(), _>>()?;
        Ok(values)
    }

    /// Puts the numbers of a tile into the posts of its row of tiles.
    fn decode<T: Copy>(
        &self,
        band: &mut [T],
        [column, row]: [usize; 2],
        bytes: &[u8],
        value: impl Fn(i64) -> Option<T>,
    ) -> Option<()> {
        let width = self.tiling.posts()[0];
        let columns = self.tiling.own(0, column);
        let size = [columns.len(), self.tiling.own(1, row).len()];
        let mut is_sound = true;
        rows::decode(bytes, size, |number, numbers| {
            let to = &mut band[number * width..][columns.clone()];
            for (to, number) in to.iter_mut().zip(numbers) {
                match value(*number) {
                    Some(value) => *to = value,
                    None => is_sound = false,
                }
            }
        })?;
        is_sound.then_some(())
    }
}

fn is_tile(tile: &Tile) -> bool {
    let is_error = |error: &f64| *error >= 0.0 && error.is_finite();
    tile.errors.iter().all(is_error)
        && tile.bounds[0] <= tile.bounds[1]
        && tile.bounds.iter().all(|height| height.is_finite())
}
