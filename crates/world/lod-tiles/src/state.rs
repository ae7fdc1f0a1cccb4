//! Level and fraction of every tile of a frame.

use std::cmp::Ordering;

use crate::{Levels, Terrain, Tile};

/// What a tile is drawn as.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TileState {
    /// Its level, from 0, the finest.
    pub level: usize,
    /// How far it has become the next level, 0 to 1.
    pub fraction: f64,
}

/// States of all tiles, in the order of the terrain.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    tiles: Vec<TileState>,
    visits: u64,
}

impl State {
    /// The state for an eye (m): levels by distance, neighbours one level apart at most. A tile that is refined for a neighbour has fraction 1: it looks
    /// like the level that it had.
    pub fn new(terrain: &Terrain, levels: &Levels, eye: [f64; 3]) -> Self {
        let tiles = terrain.tiles().map(|tile| {
            let distance = distance(terrain.middle(tile), eye);
            let level = levels.at(distance);
            TileState { level, fraction: levels.fraction(level, distance) }
        });
        Self::of(terrain, tiles.collect())
    }

    /// The state for an eye (m) at the moment when levels change: each tile has the level that it has for the eye `held`. Where that is another one
    /// for the eye `other`, the tile is at that end of its level at which the other one begins.
    pub fn at_change(
        terrain: &Terrain,
        levels: &Levels,
        eye: [f64; 3],
        [held, other]: [[f64; 3]; 2],
    ) -> Self {
        let (Self { mut tiles, visits }, other) =
            (Self::new(terrain, levels, held), Self::new(terrain, levels, other));
        for ((own, other), tile) in tiles.iter_mut().zip(&other.tiles).zip(terrain.tiles()) {
            own.fraction = match own.level.cmp(&other.level) {
                Ordering::Less => 1.0,
                Ordering::Equal => levels.fraction(own.level, distance(terrain.middle(tile), eye)),
                Ordering::Greater => 0.0,
            };
        }
        Self { tiles, visits }
    }

    /// Tiles of given states, refined where neighbours are more than a level apart.
    pub fn of(terrain: &Terrain, tiles: Vec<TileState>) -> Self {
        let mut state = Self { tiles, visits: 0 };
        while state.refine(terrain) {}
        state
    }

    /// The same without morphing: every tile is whole.
    pub fn switched(&self) -> Self {
        self.with_fractions(|_, _| 0.0)
    }

    /// The same with other fractions, 0 to 1, of the tiles with a number and a state.
    pub fn with_fractions(&self, fraction: impl Fn(usize, TileState) -> f64) -> Self {
        let with =
            |(number, tile): (usize, &TileState)| TileState { fraction: fraction(number, *tile), ..*tile };
        Self { tiles: self.tiles.iter().enumerate().map(with).collect(), visits: self.visits }
    }

    /// Tiles that have another level than in the state before: number, level before, level now.
    pub fn changes(&self, before: &Self) -> impl Iterator<Item = (usize, usize, usize)> {
        let pairs = before.tiles.iter().zip(&self.tiles).enumerate();
        pairs
            .filter(|(_, (old, new))| old.level != new.level)
            .map(|(at, (old, new))| (at, old.level, new.level))
    }

    /// State of the tile with a number.
    pub fn tile(&self, number: usize) -> TileState {
        self.tiles[number]
    }

    /// States of all tiles, in their order.
    pub fn tiles(&self) -> &[TileState] {
        &self.tiles
    }

    /// Visits to tiles that the neighbour rule took.
    pub fn visits(&self) -> u64 {
        self.visits
    }

    /// One pass of the neighbour rule; whether it refined a tile.
    fn refine(&mut self, terrain: &Terrain) -> bool {
        let mut is_refined = false;
        for tile in terrain.tiles() {
            self.visits += 1;
            let around = around(terrain, tile).map(|other| self.tiles[terrain.number(other)].level);
            let most = around.min().map_or(usize::MAX, |finest| finest + 1);
            let own = &mut self.tiles[terrain.number(tile)];
            if own.level > most {
                *own = TileState { level: most, fraction: 1.0 };
                is_refined = true;
            }
        }
        is_refined
    }
}

/// Tiles that share a side with a tile.
fn around(terrain: &Terrain, tile: Tile) -> impl Iterator<Item = Tile> + use<> {
    let [columns, rows] = terrain.counts();
    let Tile { column, row } = tile;
    let left = (column > 0).then(|| Tile { column: column - 1, row });
    let right = (column + 1 < columns).then_some(Tile { column: column + 1, row });
    let bottom = (row > 0).then(|| Tile { column, row: row - 1 });
    let top = (row + 1 < rows).then_some(Tile { column, row: row + 1 });
    [left, right, bottom, top].into_iter().flatten()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| (a[axis] - b[axis]) * (a[axis] - b[axis])).sum::<f64>().sqrt()
}
