//! Waveforms along a row of the picture: what the tile that a pixel shows is drawn as.

use std::cell::RefCell;
use std::collections::BTreeMap;

use lod_tiles::{Surface, Tile, TilePieces, TileState};
use scenario::View;
use signal::{Signal, Unit, Wire};

const SOURCE: &str = "none: ours, of the thesis's viewer";

/// Place of a pixel in its row.
pub const COLUMN: &str = "lod.column";

/// What can be looked at; a row stands for a sweep, its pixels for samples.
pub static SIGNALS: [Signal; 6] = [
    Signal::ground(COLUMN, Unit::Number, "column of the pixel, from 0", SOURCE),
    Signal::ground(
        "lod.distance",
        Unit::Metre,
        "distance from the eye to the middle of the tile; 0 where none is seen",
        SOURCE,
    ),
    Signal::ground(
        "lod.level",
        Unit::Number,
        "level of the tile, 0 the finest; -1 where none is seen",
        SOURCE,
    ),
    Signal::ground(
        "lod.fraction",
        Unit::Number,
        "how far the tile has become the next level, 0 to 1",
        SOURCE,
    ),
    Signal::ground("lod.triangles", Unit::Number, "triangles of the tile", SOURCE),
    Signal::ground(
        "lod.delta",
        Unit::Metre,
        "height that the tile has still to go at most, until it is the next level",
        SOURCE,
    ),
];

/// What a tile is drawn as.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TileSample {
    /// Level and fraction of the tile.
    state: TileState,
    /// Distance (m) of its middle from the eye.
    distance: f64,
    /// Number of its triangles.
    triangles: u64,
    /// Largest height (m) that a vertex has still to go.
    delta: f64,
}

impl TileSample {
    /// The sample of a tile of a surface, whose middle is so far (m) away.
    fn of(surface: &Surface<'_>, tile: Tile, distance: f64) -> Self {
        let state = surface.tile_state(tile);
        let TilePieces { inner, border, .. } = surface.pieces(tile);
        let cells = surface.terrain.cells(state.level);
        let delta = if state.level + 1 < surface.levels {
            let vertices = (0..=cells).flat_map(|j| (0..=cells).map(move |i| [i, j]));
            let left = |at: [usize; 2]| surface.terrain.delta(tile, state.level, at).abs();
            (1.0 - state.fraction) * vertices.map(left).fold(0.0, f64::max)
        } else {
            0.0
        };
        Self { state, distance, triangles: inner + border, delta }
    }
}

/// Value of a signal in a pixel that shows a tile, or none.
pub fn value(sample: &Option<TileSample>, name: &str) -> f64 {
    match (sample, name) {
        (None, "lod.level") => -1.0,
        (None, _) => 0.0,
        (Some(sample), "lod.distance") => sample.distance,
        (Some(sample), "lod.level") => sample.state.level as f64,
        (Some(sample), "lod.fraction") => sample.state.fraction,
        (Some(sample), "lod.triangles") => sample.triangles as f64,
        (Some(sample), _) => sample.delta,
    }
}

/// The samples of a surface's tiles, each worked out once.
pub struct Samples<'a> {
    surface: Surface<'a>,
    known: RefCell<BTreeMap<usize, TileSample>>,
}

impl<'a> Samples<'a> {
    /// Those of a surface.
    pub fn of(surface: Surface<'a>) -> Self {
        Self { surface, known: RefCell::default() }
    }

    /// The sample of a tile, whose middle is so far (m) away.
    pub fn tile(&self, tile: Tile, distance: f64) -> TileSample {
        let number = self.surface.terrain.number(tile);
        let mut known = self.known.borrow_mut();
        *known.entry(number).or_insert_with(|| TileSample::of(&self.surface, tile, distance))
    }
}

/// The wires of a view. Numbers of a program have no voltage.
pub fn wires(view: &View, levels: usize, tile_triangles: usize) -> Vec<Wire> {
    let wire = |signal: &Signal| {
        let full_scale = match signal.name {
            COLUMN => f64::from(view.columns),
            "lod.distance" => view.ranges[1],
            "lod.level" => levels as f64,
            "lod.triangles" => tile_triangles as f64,
            "lod.delta" => 100.0,
            _ => 1.0,
        };
        Wire { signal: *signal, full_scale, volts: 0.0, datum: 0.0 }
    };
    SIGNALS.iter().map(wire).collect()
}
