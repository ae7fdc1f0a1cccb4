//! The blocks of a file, in their order.

use std::fmt;

use crate::tiling::Tiling;

/// A block of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Block {
    /// Header and table of blocks.
    Header,
    /// Places of the posts along both axes.
    Places,
    /// Errors of levels and bounds of every tile.
    Tiles,
    /// Heights of a tile, by its column and row.
    Heights([usize; 2]),
    /// Light on a tile, by its column and row.
    Light([usize; 2]),
    /// Albedo of a tile, by its column and row.
    Albedo([usize; 2]),
    /// Boulders on the terrain.
    Boulders,
    /// Text of the landscape file.
    Sidecar,
}

impl Block {
    /// All blocks behind the header, in the order of the file.
    pub(crate) fn all(tiling: Tiling, has_light: bool, has_albedo: bool) -> Vec<Self> {
        let tiles = |of: fn([usize; 2]) -> Self, is_there: bool| {
            let count = if is_there { tiling.tiles() } else { 0 };
            (0..count).map(move |tile| of(tiling.place(tile)))
        };
        [Self::Places, Self::Tiles]
            .into_iter()
            .chain(tiles(Self::Heights, true))
            .chain(tiles(Self::Light, has_light))
            .chain(tiles(Self::Albedo, has_albedo))
            .chain([Self::Boulders, Self::Sidecar])
            .collect()
    }
}

impl fmt::Display for Block {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let tile = |f: &mut fmt::Formatter<'_>, what: &str, [column, row]: [usize; 2]| {
            write!(f, "{what} of tile (column {column}, row {row})")
        };
        match *self {
            Self::Header => f.write_str("the header"),
            Self::Places => f.write_str("the places of posts"),
            Self::Tiles => f.write_str("the errors and bounds of tiles"),
            Self::Heights(at) => tile(f, "the heights", at),
            Self::Light(at) => tile(f, "the light", at),
            Self::Albedo(at) => tile(f, "the albedo", at),
            Self::Boulders => f.write_str("the boulders"),
            Self::Sidecar => f.write_str("the text of the landscape"),
        }
    }
}
