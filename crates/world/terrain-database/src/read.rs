//! Reading a database: every hash is checked before a block is believed.

use std::path::Path;

use files::read_all;
use limits::Limit;
use rayon::prelude::*;

use crate::blocks::Block;
use crate::database::Database;
use crate::error::DatabaseError;
use crate::header::{Header, MAGIC, NoHeader, Row};
use crate::reading::Reading;

impl Database {
    /// Opens a file: all hashes are checked and all blocks are read, by the threads of the caller's pool.
    ///
    /// # Errors
    /// If the file cannot be read, is no database of this version, is cut off or damaged, or is larger than is allowed.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, DatabaseError> {
        let path = path.as_ref();
        Self::parse(path, &read_all(path, Limit::BankBytes)?)
    }

    /// The same of bytes at hand; `path` names them in errors.
    ///
    /// # Errors
    /// As those of [`open`](Self::open).
    pub fn parse(path: &Path, bytes: &[u8]) -> Result<Self, DatabaseError> {
        let found = bytes.len() as u64;
        let (header, table, start) = Header::parse(bytes).map_err(|wrong| of_header(path, bytes, wrong))?;
        let lengths: u128 = table.iter().map(|row| u128::from(row.length)).sum();
        let expected = start as u128 + lengths;
        if expected != u128::from(found) {
            return Err(DatabaseError::Length { path: path.into(), found, expected: expected.to_string() });
        }
        let blocks = cut(&table, &bytes[start..]);
        let is_damaged = |(row, bytes): &&(&Row, &[u8])| blake3::hash(bytes) != row.hash;
        if let Some((row, _)) = blocks.par_iter().find_first(is_damaged) {
            return Err(DatabaseError::Damaged { path: path.into(), block: row.block });
        }
        let reading = Reading { path, tiling: header.tiling, blocks };
        reading.expect_room()?;
        reading.database(header)
    }
}

fn of_header(path: &Path, bytes: &[u8], wrong: NoHeader) -> DatabaseError {
    let path = path.to_owned();
    match wrong {
        NoHeader::Magic => {
            DatabaseError::Magic { path, found: bytes[..MAGIC.len().min(bytes.len())].to_vec() }
        }
        NoHeader::Version(found) => DatabaseError::Version { path, found },
        NoHeader::Short(least) => {
            let expected = format!("at least {least}");
            DatabaseError::Length { path, found: bytes.len() as u64, expected }
        }
        NoHeader::Damaged => DatabaseError::Damaged { path, block: Block::Header },
        NoHeader::Unfit(unfit) => DatabaseError::Unfit { path, block: Block::Header, unfit },
    }
}

/// The bytes of each block; the lengths add up to those of `bytes`.
fn cut<'t, 'b>(table: &'t [Row], mut bytes: &'b [u8]) -> Vec<(&'t Row, &'b [u8])> {
    let block = |row: &'t Row| {
        let (block, rest) = bytes.split_at(row.length as usize);
        bytes = rest;
        (row, block)
    };
    table.iter().map(block).collect()
}
