//! Vertices of a finer neighbour on the edges of a coarser tile.

use crate::{Side, Surface, Tile};

/// The mesh of a tile while triangles on its sides are split.
pub struct Inserted<'a> {
    pub surface: &'a Surface<'a>,
    pub tile: Tile,
    /// Number of the tile's first vertex.
    pub first: usize,
    pub vertices: &'a mut Vec<[f64; 3]>,
    /// Inserted vertices of each side, with the cell of the side in whose middle they lie.
    pub known: [Vec<(usize, u32)>; 4],
}

/// A corner of a triangle: a vertex of the tile, or an inserted one by its number.
#[derive(Debug, Clone, Copy)]
enum Corner {
    Own([usize; 2]),
    Inserted(u32),
}

impl Inserted<'_> {
    /// Adds a triangle, split in the middle of its edges on `sides`.
    pub fn add(&mut self, corners: [[usize; 2]; 3], sides: &[Side], triangles: &mut Vec<[u32; 3]>) {
        self.split(corners.map(Corner::Own), sides, triangles);
    }

    fn split(&mut self, corners: [Corner; 3], sides: &[Side], triangles: &mut Vec<[u32; 3]>) {
        let Some((side, rest)) = sides.split_first() else {
            triangles.push(corners.map(|corner| self.number(corner)));
            return;
        };
        // A part of a triangle that was split before may have lost this edge.
        let Some((k, edge)) = self.edge_on(*side, &corners) else {
            return self.split(corners, rest, triangles);
        };
        let middle = Corner::Inserted(self.middle(*side, edge));
        for moved in [k, (k + 1) % 3] {
            let mut part = corners;
            part[moved] = middle;
            self.split(part, rest, triangles);
        }
    }

    /// The edge of a triangle on a side: number of its first corner, and its two vertices.
    fn edge_on(&self, side: Side, corners: &[Corner; 3]) -> Option<(usize, [[usize; 2]; 2])> {
        let cells = self.surface.terrain.cells(self.surface.tile_state(self.tile).level);
        let own = |corner: Corner| match corner {
            Corner::Own(at) => Some(at).filter(|at| side.holds(*at, cells)),
            Corner::Inserted(_) => None,
        };
        (0..3).find_map(|k| Some((k, [own(corners[k])?, own(corners[(k + 1) % 3])?])))
    }

    fn number(&self, corner: Corner) -> u32 {
        let cells = self.surface.terrain.cells(self.surface.tile_state(self.tile).level);
        match corner {
            Corner::Own([i, j]) => (self.first + j * (cells + 1) + i) as u32,
            Corner::Inserted(number) => number,
        }
    }

    /// Number of the vertex in the middle of an edge: on it, at the post between its ends.
    fn middle(&mut self, side: Side, [from, to]: [[usize; 2]; 2]) -> u32 {
        let cell = (from[0] + from[1]).min(to[0] + to[1]);
        let known = &self.known[side as usize];
        if let Some((_, number)) = known.iter().find(|(at, _)| *at == cell) {
            return *number;
        }
        let number = self.vertices.len() as u32;
        self.vertices.push(self.surface.between(self.tile, [from, to]));
        self.known[side as usize].push((cell, number));
        number
    }
}
