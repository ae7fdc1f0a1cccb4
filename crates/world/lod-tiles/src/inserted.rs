//! Vertices of a finer neighbour on the edges of a coarser tile.

use crate::surface::{Origin, TileMesh};
use crate::{Side, Surface, Tile};

/// The mesh of a tile while triangles on its sides are split.
pub struct Inserted<'a> {
    surface: &'a Surface<'a>,
    tile: Tile,
    /// Cells of a side of the tile.
    cells: usize,
    pub mesh: TileMesh,
    /// Inserted vertices of each side, with the cell of the side in whose middle they lie.
    known: [Vec<(usize, u32)>; 4],
}

/// A corner of a triangle: a vertex of the tile, or an inserted one by its number.
#[derive(Debug, Clone, Copy)]
enum Corner {
    Own([usize; 2]),
    Inserted(u32),
}

impl<'a> Inserted<'a> {
    /// A tile whose mesh has its own vertices, and no triangles yet.
    pub fn new(surface: &'a Surface<'a>, tile: Tile, mesh: TileMesh) -> Self {
        let cells = surface.terrain.cells(surface.tile_state(tile).level);
        Self { surface, tile, cells, mesh, known: [const { Vec::new() }; 4] }
    }

    /// Adds a triangle, split in the middle of its edges on `sides`.
    pub fn add(&mut self, corners: [[usize; 2]; 3], sides: &[Side]) {
        self.split(corners.map(Corner::Own), sides);
    }

    fn split(&mut self, corners: [Corner; 3], sides: &[Side]) {
        let Some((side, rest)) = sides.split_first() else {
            let triangle = corners.map(|corner| self.number(corner));
            self.mesh.triangles.push(triangle);
            return;
        };
        let Some((k, edge)) = self.edge_on(*side, &corners) else {
            return self.split(corners, rest);
        };
        let middle = Corner::Inserted(self.middle(*side, edge));
        for moved in [k, (k + 1) % 3] {
            let mut part = corners;
            part[moved] = middle;
            self.split(part, rest);
        }
    }

    /// The edge of a triangle on a side: number of its first corner, and its two vertices.
    fn edge_on(&self, side: Side, corners: &[Corner; 3]) -> Option<(usize, [[usize; 2]; 2])> {
        let own = |corner: Corner| match corner {
            Corner::Own(at) => Some(at).filter(|at| side.holds(*at, self.cells)),
            Corner::Inserted(_) => None,
        };
        (0..3).find_map(|k| Some((k, [own(corners[k])?, own(corners[(k + 1) % 3])?])))
    }

    fn number(&self, corner: Corner) -> u32 {
        match corner {
            Corner::Own([i, j]) => (j * (self.cells + 1) + i) as u32,
            Corner::Inserted(number) => number,
        }
    }

    /// Number of the vertex in the middle of an edge: on it, at the post between its ends.
    fn middle(&mut self, side: Side, ends: [[usize; 2]; 2]) -> u32 {
        let cell = ends.map(|[i, j]| i + j).into_iter().min().unwrap_or(0);
        let known = &self.known[side as usize];
        if let Some((_, number)) = known.iter().find(|(at, _)| *at == cell) {
            return *number;
        }
        let number = self.mesh.vertices.len() as u32;
        let between = ends.map(|end| self.number(Corner::Own(end)));
        self.mesh.vertices.push(self.surface.between(self.tile, ends));
        self.mesh.origins.push(Origin { between, share: 1.0 });
        self.known[side as usize].push((cell, number));
        number
    }
}
