//! The surface of a frame: morphed vertices, stitched triangles.

use crate::edges::{beyond, fraction};
use crate::{Edges, Side, State, Terrain, Tile, TileState};

/// How tiles of different levels are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stitch {
    /// The finer tile leaves out the vertices that its neighbour lacks.
    FineSide,
    /// Tiles abut, and there are holes where heights differ.
    None,
}

/// The ground as it is drawn in one frame.
#[derive(Debug, Clone, Copy)]
pub struct Surface<'a> {
    /// Ground of the frame.
    pub terrain: &'a Terrain,
    /// Levels and fractions of its tiles.
    pub state: &'a State,
    /// Levels that there are: the coarsest of them becomes nothing.
    pub levels: usize,
    /// Who decides on edges.
    pub edges: Edges,
    /// How tiles are joined.
    pub stitch: Stitch,
}

/// Corners of a triangle in a block of two by two cells, each from 0 to 2 along x and y.
type BlockTriangle = [[usize; 2]; 3];

impl Surface<'_> {
    /// Height (m) of vertex i, j of a tile at its level, as it is drawn.
    pub fn height(&self, tile: Tile, at: [usize; 2]) -> f64 {
        let own = self.own(tile);
        self.morphed(tile, own.level, at, self.fraction_at(tile, at))
    }

    /// Triangles of a tile as places of their corners (m), counter-clockwise seen from above.
    pub fn triangles(&self, tile: Tile) -> Vec<[[f64; 3]; 3]> {
        let level = self.own(tile).level;
        let vertex = |at: [usize; 2]| {
            let [x, y] = self.terrain.place(tile, level, at);
            [x, y, self.height(tile, at)]
        };
        let block = |[a, b]: [usize; 2]| {
            let corners = move |[i, j]: [usize; 2]| [a + i, b + j];
            self.block(tile, [a, b]).into_iter().map(move |triangle| triangle.map(corners).map(vertex))
        };
        self.blocks(tile).flat_map(block).collect()
    }

    /// Height (m) of the surface under a place (m); that of the nearest border beyond the terrain.
    pub fn under(&self, place: [f64; 2]) -> f64 {
        let (tile, within) = self.terrain.locate(place);
        let level = self.own(tile).level;
        let cells = self.terrain.cells(level);
        let scaled = within.map(|cell| cell / (1 << level) as f64);
        let size = cells.min(2);
        let block =
            scaled.map(|cell| (cell / size as f64) as usize * size).map(|cell| cell.min(cells - size));
        let local = [0, 1].map(|axis| scaled[axis] - block[axis] as f64);
        let vertex = |[i, j]: [usize; 2]| self.height(tile, [block[0] + i, block[1] + j]);
        let held = self.block(tile, block).into_iter().map(|triangle| (triangle, weights(&triangle, local)));
        // A place on an edge may be outside of both triangles by rounding: the one that it is least outside of holds it.
        let best = held.max_by(|(_, a), (_, b)| least(a).total_cmp(&least(b)));
        best.map_or(f64::NAN, |(triangle, weights)| {
            (0..3).map(|corner| weights[corner] * vertex(triangle[corner])).sum()
        })
    }

    fn own(&self, tile: Tile) -> TileState {
        self.state.tile(self.terrain.number(tile))
    }

    /// How far a vertex of a tile has morphed.
    fn fraction_at(&self, tile: Tile, at: [usize; 2]) -> f64 {
        let own = self.own(tile);
        let cells = self.terrain.cells(own.level);
        match Side::ALL.into_iter().find(|side| side.holds(at, cells)) {
            Some(side) => fraction(self.edges, own, beyond(self.terrain, self.state, tile, side)),
            None => own.fraction,
        }
    }

    /// Height of a vertex that has become the next level's by a fraction.
    fn morphed(&self, tile: Tile, level: usize, [i, j]: [usize; 2], fraction: f64) -> f64 {
        let height = |at| self.terrain.height(tile, level, at);
        let whole = height([i, j]);
        let between = match (i % 2, j % 2) {
            (0, 0) => return whole,
            (_, 0) => [[i - 1, j], [i + 1, j]],
            (0, _) => [[i, j + 1], [i, j - 1]],
            _ => [[i - 1, j + 1], [i + 1, j - 1]],
        };
        // The coarsest level has nothing to become, and its cells may have no vertex beyond.
        if fraction == 0.0 || level + 1 >= self.levels {
            return whole;
        }
        let mean = (height(between[0]) + height(between[1])) / 2.0;
        mean + (1.0 - fraction) * (whole - mean)
    }

    /// First vertices of the blocks of a tile: two by two cells, or its only cell.
    fn blocks(&self, tile: Tile) -> impl Iterator<Item = [usize; 2]> + use<> {
        let cells = self.terrain.cells(self.own(tile).level);
        let step = cells.min(2);
        (0..cells).step_by(step).flat_map(move |b| (0..cells).step_by(step).map(move |a| [a, b]))
    }

    /// Triangles of the block that begins at a vertex.
    fn block(&self, tile: Tile, [a, b]: [usize; 2]) -> Vec<BlockTriangle> {
        let cells = self.terrain.cells(self.own(tile).level);
        let mut triangles = cells_of(cells.min(2));
        for side in Side::ALL {
            let (odd, even) = match side {
                Side::Left => ([0, 1], [0, 0]),
                Side::Right => ([2, 1], [2, 0]),
                Side::Bottom => ([1, 0], [0, 0]),
                Side::Top => ([1, 2], [0, 2]),
            };
            let is_on_side = cells > 1 && side.holds([a + odd[0], b + odd[1]], cells);
            if is_on_side && self.is_stitched(tile, side) {
                collapse(&mut triangles, odd, even);
            }
        }
        triangles
    }

    /// Whether a side lacks the vertices that the neighbour lacks.
    fn is_stitched(&self, tile: Tile, side: Side) -> bool {
        let other = beyond(self.terrain, self.state, tile, side);
        self.stitch == Stitch::FineSide && other.is_some_and(|other| other.level > self.own(tile).level)
    }
}

/// Triangles of one cell, or of two by two: each cell is cut from top left to bottom right.
fn cells_of(side: usize) -> Vec<BlockTriangle> {
    let cells = (0..side).flat_map(|b| (0..side).map(move |a| [a, b]));
    let cut = |[a, b]: [usize; 2]| {
        let [bottom_left, bottom_right] = [[a, b], [a + 1, b]];
        let [top_left, top_right] = [[a, b + 1], [a + 1, b + 1]];
        [[top_left, bottom_left, bottom_right], [top_left, bottom_right, top_right]]
    };
    cells.flat_map(cut).collect()
}

/// Moves a vertex into another; triangles that lose their area go.
fn collapse(triangles: &mut Vec<BlockTriangle>, from: [usize; 2], into: [usize; 2]) {
    for triangle in triangles.iter_mut() {
        *triangle = triangle.map(|corner| if corner == from { into } else { corner });
    }
    triangles.retain(|[p, q, r]| p != q && q != r && r != p);
}

/// Weights of the corners of a triangle at a place in its block, with the sum 1.
fn weights(triangle: &BlockTriangle, at: [f64; 2]) -> [f64; 3] {
    let [p, q, r] = triangle.map(|corner| corner.map(|index| index as f64));
    let cross =
        |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    let whole = cross(p, q, r);
    [cross(at, q, r) / whole, cross(p, at, r) / whole, cross(p, q, at) / whole]
}

fn least(weights: &[f64; 3]) -> f64 {
    weights.iter().copied().fold(f64::INFINITY, f64::min)
}
