//! The surface of a frame: morphed vertices, stitched triangles.

use crate::edges::{beyond, fraction};
use crate::inserted::Inserted;
use crate::terrain::parents;
use crate::{Edges, Side, State, Terrain, Tile, TileState};

/// How tiles of different levels are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stitch {
    /// The finer tile leaves out the vertices that its neighbour lacks. Its triangles there are others, so ground inside it moves a little when the
    /// neighbour changes its level.
    FineSide,
    /// The coarser tile has the vertices of its neighbour too, on its own edges: nothing moves.
    CoarseSide,
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

/// A tile as it is drawn, with the height of every vertex morphed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TileMesh {
    /// Vertices (x, y, z; m): those of the tile row by row, then those of finer neighbours on its edges. One that stitching leaves out belongs to
    /// no triangle.
    pub vertices: Vec<[f64; 3]>,
    /// Where each vertex comes from: whatever else it has moves in the same way.
    pub origins: Vec<Origin>,
    /// Numbers of the corners of each triangle, counter-clockwise seen from above.
    pub triangles: Vec<[u32; 3]>,
}

/// How far a vertex has gone to the middle of two others, which stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Origin {
    /// Numbers of the two.
    pub between: [u32; 2],
    /// Share of the way, 0 to 1.
    pub share: f64,
}

/// Corners of a triangle in a block of two by two cells, each from 0 to 2 along x and y.
type BlockTriangle = [[usize; 2]; 3];

impl Surface<'_> {
    /// Height (m) of vertex i, j of a tile at its level, as it is drawn.
    pub fn height(&self, tile: Tile, at: [usize; 2]) -> f64 {
        let own = self.own(tile);
        self.morphed(tile, own.level, at, self.fraction_at(tile, at))
    }

    /// Level and fraction of a tile.
    pub fn tile_state(&self, tile: Tile) -> TileState {
        self.own(tile)
    }

    /// Sides (m) of a cell of a tile at its level.
    pub fn cell(&self, tile: Tile) -> [f64; 2] {
        let level = self.own(tile).level;
        let [from, to] = [[0, 0], [1, 1]].map(|at| self.terrain.place(tile, level, at));
        [to[0] - from[0], to[1] - from[1]]
    }

    /// A tile as it is drawn.
    pub fn mesh(&self, tile: Tile) -> TileMesh {
        let level = self.own(tile).level;
        let cells = self.terrain.cells(level);
        let all = (0..=cells).flat_map(|j| (0..=cells).map(move |i| [i, j]));
        let number = |[i, j]: [usize; 2]| (j * (cells + 1) + i) as u32;
        let vertex = |at: [usize; 2]| {
            let [x, y] = self.terrain.place(tile, level, at);
            [x, y, self.height(tile, at)]
        };
        let origin = |at: [usize; 2]| match parents(at).filter(|_| level + 1 < self.levels) {
            Some(between) => Origin { between: between.map(number), share: self.fraction_at(tile, at) },
            None => Origin { between: [number(at); 2], share: 0.0 },
        };
        let mesh = TileMesh {
            vertices: all.clone().map(vertex).collect(),
            origins: all.map(origin).collect(),
            triangles: Vec::with_capacity(2 * cells * cells),
        };
        let (stitched, split) = (self.stitched(tile), self.split(tile));
        let mut inserted = Inserted::new(self, tile, mesh);
        for [a, b] in blocks(cells) {
            for corners in block(cells, [a, b], stitched) {
                inserted.add(corners.map(|[i, j]| [a + i, b + j]), &split);
            }
        }
        inserted.mesh
    }

    /// Triangles of a tile as places of their corners (m), counter-clockwise seen from above.
    pub fn triangles(&self, tile: Tile) -> Vec<[[f64; 3]; 3]> {
        let TileMesh { vertices, triangles, .. } = self.mesh(tile);
        triangles.into_iter().map(|corners| corners.map(|corner| vertices[corner as usize])).collect()
    }

    /// Height (m) of the surface under a place (m); that of the nearest border beyond the terrain.
    pub fn under(&self, place: [f64; 2]) -> f64 {
        let (tile, within) = self.terrain.locate(place);
        let level = self.own(tile).level;
        let cells = self.terrain.cells(level);
        let scaled = within.map(|cell| cell / (1 << level) as f64);
        let size = cells.min(2);
        let first =
            scaled.map(|cell| (cell / size as f64) as usize * size).map(|cell| cell.min(cells - size));
        let local = [0, 1].map(|axis| scaled[axis] - first[axis] as f64);
        let vertex = |[i, j]: [usize; 2]| self.height(tile, [first[0] + i, first[1] + j]);
        let triangles = block(cells, first, self.stitched(tile));
        let held = triangles.map(|triangle| (triangle, weights(&triangle, local)));
        // A place on an edge may be outside of both triangles by rounding: the one that it is least outside of holds it.
        let best = held.max_by(|(_, a), (_, b)| least(a).total_cmp(&least(b)));
        best.map_or(f64::NAN, |(triangle, weights)| {
            (0..3).map(|corner| weights[corner] * vertex(triangle[corner])).sum()
        })
    }

    /// The same without morphing, at the same levels.
    pub fn unmorphed(&self, place: [f64; 2]) -> f64 {
        Surface { state: &self.state.switched(), ..*self }.under(place)
    }

    /// The vertex of a finer neighbour in the middle of an edge of a tile.
    pub(crate) fn between(&self, tile: Tile, ends: [[usize; 2]; 2]) -> [f64; 3] {
        let level = self.own(tile).level;
        let [a, b] = ends.map(|at| self.height(tile, at));
        let finer = [ends[0][0] + ends[1][0], ends[0][1] + ends[1][1]];
        let [x, y] = self.terrain.place(tile, level - 1, finer);
        [x, y, (a + b) / 2.0]
    }

    fn own(&self, tile: Tile) -> TileState {
        self.state.tile(self.terrain.number(tile))
    }

    /// How far vertex i, j of a tile has morphed, 0 to 1: on an edge as the edge decides.
    pub fn fraction_at(&self, tile: Tile, at: [usize; 2]) -> f64 {
        let own = self.own(tile);
        let cells = self.terrain.cells(own.level);
        match Side::ALL.into_iter().find(|side| side.holds(at, cells)) {
            Some(side) => fraction(self.edges, own, beyond(self.terrain, self.state, tile, side)),
            None => own.fraction,
        }
    }

    /// Height of a vertex that has become the next level's by a fraction.
    fn morphed(&self, tile: Tile, level: usize, at: [usize; 2], fraction: f64) -> f64 {
        let whole = self.terrain.height(tile, level, at);
        // The coarsest level has nothing to become, and its cells may have no vertex beyond.
        if fraction == 0.0 || level + 1 >= self.levels {
            return whole;
        }
        self.terrain.mean(tile, level, at).map_or(whole, |mean| mean + (1.0 - fraction) * (whole - mean))
    }

    /// Sides that have the vertices of a finer neighbour too.
    fn split(&self, tile: Tile) -> Vec<Side> {
        let own = self.own(tile).level;
        let has_finer = |side: &Side| {
            beyond(self.terrain, self.state, tile, *side).is_some_and(|other| other.level < own)
        };
        match self.stitch {
            Stitch::CoarseSide => Side::ALL.into_iter().filter(has_finer).collect(),
            Stitch::FineSide | Stitch::None => Vec::new(),
        }
    }

    /// Which sides, in the order of [`Side::ALL`], lack the vertices that the neighbour lacks.
    fn stitched(&self, tile: Tile) -> [bool; 4] {
        let own = self.own(tile).level;
        Side::ALL.map(|side| {
            let other = beyond(self.terrain, self.state, tile, side);
            self.stitch == Stitch::FineSide && other.is_some_and(|other| other.level > own)
        })
    }
}

/// First vertices of the blocks of a tile of so many cells a side: two by two cells, or its only cell.
fn blocks(cells: usize) -> impl Iterator<Item = [usize; 2]> {
    let step = cells.min(2);
    (0..cells).step_by(step).flat_map(move |b| (0..cells).step_by(step).map(move |a| [a, b]))
}

/// Triangles of the block that begins at a vertex of a tile of so many cells a side.
fn block(cells: usize, [a, b]: [usize; 2], stitched: [bool; 4]) -> impl Iterator<Item = BlockTriangle> {
    // Vertices in the middle of a stitched side move into the corner before them.
    let moved = [([0, 1], [0, 0]), ([2, 1], [2, 0]), ([1, 0], [0, 0]), ([1, 2], [0, 2])];
    let is_moved: [bool; 4] = std::array::from_fn(|side| {
        let [i, j] = moved[side].0;
        cells > 1 && stitched[side] && Side::ALL[side].holds([a + i, b + j], cells)
    });
    let corner = move |at: [usize; 2]| {
        let side = (0..4).find(|side| is_moved[*side] && moved[*side].0 == at);
        side.map_or(at, |side| moved[side].1)
    };
    let has_area = |[p, q, r]: &BlockTriangle| p != q && q != r && r != p;
    cells_of(cells.min(2)).map(move |triangle| triangle.map(corner)).filter(has_area)
}

/// Triangles of one cell, or of two by two: each cell is cut from top left to bottom right.
fn cells_of(side: usize) -> impl Iterator<Item = BlockTriangle> {
    let cells = (0..side).flat_map(move |b| (0..side).map(move |a| [a, b]));
    cells.flat_map(|[a, b]| {
        let [bottom_left, bottom_right] = [[a, b], [a + 1, b]];
        let [top_left, top_right] = [[a, b + 1], [a + 1, b + 1]];
        [[top_left, bottom_left, bottom_right], [top_left, bottom_right, top_right]]
    })
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
