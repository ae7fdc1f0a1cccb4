//! `kind = "texture"`: a picture over the ground.

use std::collections::BTreeMap;
use std::path::Path;

use diagnostics::Reader;
use picture::Curve;

use crate::description::{Feature, Kind};
use crate::grid::Grid;
use crate::texture::TextureWish;

/// Largest start or end of a picture (chosen): so often does it repeat at most.
const MOST_REPEATS: f64 = 10_000.0;

/// Reads the keys of a texture. Its file lies in `folder`.
pub fn texture(table: &Reader, grid: &Grid, folder: &Path) -> Option<TextureWish> {
    let file = table.string("file").required();
    let tile = if table.has("tile") { tile(table, grid).map(Some) } else { Some(None) };
    let span = |key| {
        let ends = table.f64_array::<2>(key).between(-MOST_REPEATS, MOST_REPEATS).default([0.0, 1.0])?;
        if ends[0] == ends[1] {
            let title = format!("`{}` starts where it ends", table.path(key));
            let problem = table.problem(key, title).found(format!("{ends:?}"));
            table.report(problem.expected("two numbers that differ, as [0, 1]"));
            return None;
        }
        Some(ends)
    };
    let (across, upwards) = (span("u"), span("v"));
    let share = |key, usual| table.f64(key).between(0.0, 1.0).default(usual);
    let (black, white) = (share("black", 0.0), share("white", 1.0));
    let curves = [("srgb", photographs::CURVE), ("linear", Curve::Power(1.0))];
    let curve = table.one_of("curve", &curves).default(photographs::CURVE);
    Some(TextureWish {
        path: folder.join(file?),
        tile: tile?,
        across: across?,
        upwards: upwards?,
        ends: [black?, white?],
        curve: curve?,
    })
}

/// Row and column of a tile of the grid.
fn tile(table: &Reader, grid: &Grid) -> Option<[usize; 2]> {
    let found = table.u64_list("tile").required()?;
    let counts = [grid.north.tiles(), grid.east.tiles()];
    let tile: Option<[u64; 2]> = found.clone().try_into().ok();
    let tile = tile.filter(|tile| (0..2).all(|axis| tile[axis] < counts[axis] as u64));
    if tile.is_none() {
        let title = format!("`{}` is {found:?}", table.path("tile"));
        let expected = format!(
            "row and column from the south-western tile, as [0, 0], below [{}, {}]",
            counts[0], counts[1]
        );
        table.report(table.problem("tile", title).found(format!("{found:?}")).expected(expected));
    }
    tile.map(|tile| tile.map(|at| at as usize))
}

/// What textures cover so far, each with the name of its texture: a tile, or the whole ground.
#[derive(Debug, Default)]
pub struct Covered(BTreeMap<Option<[usize; 2]>, String>);

impl Covered {
    /// Takes a feature in. It is a problem if a texture before it lies in the same place and both are enabled.
    pub fn take(&mut self, table: &Reader, feature: &Feature) -> bool {
        let Kind::Texture(wish) = &feature.kind else { return true };
        if !feature.is_enabled {
            return true;
        }
        let Some(before) = self.0.get(&wish.tile) else {
            self.0.insert(wish.tile, feature.id.clone());
            return true;
        };
        let place =
            wish.tile.map_or("the whole ground".into(), |[row, column]| format!("tile [{row}, {column}]"));
        let title = format!("textures {before:?} and {:?} both cover {place}", feature.id);
        let problem = table.problem("tile", title).found(place);
        table.report(problem.expected("one texture for a place; remove one, or write `enabled = false`"));
        false
    }
}
