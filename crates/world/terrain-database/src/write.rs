//! Writing a database.

use std::io::{self, Write};
use std::path::Path;

use files::{FileError, write_atomic};
use rayon::prelude::*;

use crate::blocks::Block;
use crate::boulders;
use crate::bytes::put;
use crate::contents::Map;
use crate::database::Database;
use crate::header::{Header, Row};
use crate::heights::Coding;
use crate::rows;

impl Database {
    /// Writes the database. A process that is killed leaves the old file.
    ///
    /// # Errors
    /// Those of the system.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), FileError> {
        write_atomic(path, |file| self.write_to(file))
    }

    /// Bytes of the file.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        // Writing into memory does not fail.
        let _ = self.write_to(&mut bytes);
        bytes
    }

    fn write_to(&self, to: &mut dyn Write) -> io::Result<()> {
        let header = Header::of(&self.contents, self.tiling);
        let blocks = header.blocks();
        let coded: Vec<_> = blocks.par_iter().map(|block| self.block(*block)).collect();
        let row = |(block, bytes): (&Block, &Vec<u8>)| Row {
            block: *block,
            length: bytes.len() as u64,
            hash: *blake3::hash(bytes).as_bytes(),
        };
        let table: Vec<_> = blocks.par_iter().zip(&coded).map(row).collect();
        to.write_all(&header.bytes(&table))?;
        coded.iter().try_for_each(|bytes| to.write_all(bytes))
    }

    fn block(&self, block: Block) -> Vec<u8> {
        let coding = Coding::new(self.contents.step);
        let contents = &self.contents;
        let map = |map: &Option<Map>, at| match map {
            None => Vec::new(),
            Some(Map::U8(values)) => self.coded(at, |post| values[post].into()),
            Some(Map::U16(values)) => self.coded(at, |post| values[post].into()),
        };
        match block {
            Block::Header => Vec::new(),
            Block::Places => numbers(contents.places.iter().flatten().copied()),
            Block::Tiles => {
                let tile = self.tiles.iter().flat_map(|tile| tile.errors.iter().chain(&tile.bounds));
                numbers(tile.copied())
            }
            Block::Heights(at) => self.coded(at, |post| coding.number(contents.heights[post])),
            Block::Light(at) => map(&contents.light, at),
            Block::Albedo(at) => map(&contents.albedo, at),
            Block::Boulders => boulders::encoded(&contents.boulders),
            Block::Sidecar => contents.sidecar.clone().into_bytes(),
        }
    }

    /// Numbers of the posts of a tile.
    fn coded(&self, [column, row]: [usize; 2], number: impl Fn(usize) -> i64) -> Vec<u8> {
        let width = self.tiling.posts()[0];
        let columns = self.tiling.own(0, column);
        let of_row = |row: usize| columns.clone().map(|column| number(row * width + column)).collect();
        rows::encoded(self.tiling.own(1, row).map(of_row))
    }
}

fn numbers(numbers: impl Iterator<Item = f64>) -> Vec<u8> {
    let mut bytes = Vec::new();
    put(&mut bytes, numbers);
    bytes
}
