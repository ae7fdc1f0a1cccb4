//! The ground around an eye as triangles.

use glam::DVec3;
use landscape::Landscape;
use rayon::prelude::*;

use crate::error::MeshError;
use crate::grid::{Grid, extent};
use crate::numbers::Numbers;
use crate::rings::{Block, Ring, Rings, rings};

/// Vertices and triangles of the ground in flat buffers, which are used for mesh after mesh.
#[derive(Debug, Clone, Default)]
pub struct GroundMesh {
    pub(crate) vertices: Vec<Vertex>,
    pub(crate) triangles: Vec<[u32; 3]>,
    numbers: Numbers,
}

/// A vertex of the ground, from the closed form of the landscape without what is too small for its `spacing`
/// ([`Landscape::at_spacing`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// Place: north, east, up (m).
    pub place: DVec3,
    /// Slopes of the ground to the north and to the east (m/m); its normal is `(-slopes[0], -slopes[1], 1)`, not scaled.
    pub slopes: [f64; 2],
    /// Share of red, green and blue light that is returned, 0..=1.
    pub albedo: [f64; 3],
    /// Side of a cell (m) of the coarsest ring that has the vertex.
    pub spacing: f64,
}

impl GroundMesh {
    /// Makes the mesh anew for an eye (north, east, up; m).
    ///
    /// # Errors If the eye is not over the bank, or the rings are out of range.
    pub fn fill(&mut self, landscape: &Landscape, eye: DVec3, rings: Rings) -> Result<(), MeshError> {
        self.fill_where(landscape, eye, rings, |_| true)
    }

    /// The same of those blocks alone of which `is_wanted` holds. It gets the south-western and the north-eastern corner of a block
    /// (north, east; m); its triangles are those of the whole mesh.
    ///
    /// # Errors If the eye is not over the bank, or the rings are out of range.
    pub fn fill_where(
        &mut self,
        landscape: &Landscape,
        eye: DVec3,
        rings: Rings,
        is_wanted: impl Fn([[f64; 2]; 2]) -> bool,
    ) -> Result<(), MeshError> {
        self.lay_out(landscape, eye, rings, is_wanted)?;
        self.raise(landscape);
        Ok(())
    }

    /// All vertices. One where the bank has no ground belongs to no triangle, and its height is not a number.
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Numbers of the corners of each triangle, counter-clockwise seen from above.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Places and triangles, without heights.
    fn lay_out(
        &mut self,
        landscape: &Landscape,
        eye: DVec3,
        wish: Rings,
        is_wanted: impl Fn([[f64; 2]; 2]) -> bool,
    ) -> Result<(), MeshError> {
        let extent = extent(landscape.bank());
        let [south, west, north, east] = extent;
        let is_over = (south..=north).contains(&eye.x) && (west..=east).contains(&eye.y);
        if !(is_over && eye.is_finite()) {
            return Err(MeshError::Eye { eye: eye.to_array(), extent });
        }
        wish.check(landscape.bank())?;
        let grid = Grid::new(landscape.bank(), wish.finest_step());
        self.vertices.clear();
        self.triangles.clear();
        self.numbers.clear();
        let eye = [grid.steps(0, eye.x), grid.steps(1, eye.y)];
        for ring in rings(&grid, eye, wish.cells) {
            self.numbers.start(&ring, &grid);
            for block in ring.blocks(&grid) {
                let corner = |k: usize| [0, 1].map(|axis| grid.place(axis, block.lines[axis][k]));
                if is_wanted([corner(0), corner(2)]) {
                    self.fan(&block, &ring, &grid);
                }
            }
        }
        Ok(())
    }

    /// The triangles of a block: a fan about its middle.
    fn fan(&mut self, block: &Block, ring: &Ring, grid: &Grid) {
        let [[south, north], [west, east]] = block.meets_coarser;
        // Round the block, each side with its middle; a middle that a coarser ring lacks is left out.
        let round = [
            (false, 0, 0),
            (south, 0, 1),
            (false, 0, 2),
            (east, 1, 2),
            (false, 2, 2),
            (north, 2, 1),
            (false, 2, 0),
            (west, 1, 0),
        ];
        let middle = self.vertex(block, [1, 1], ring, grid);
        let kept = round.into_iter().filter(|(is_left_out, ..)| !is_left_out);
        let mut corners = [0; 8];
        let mut count = 0;
        for (_, i, j) in kept {
            corners[count] = self.vertex(block, [i, j], ring, grid);
            count += 1;
        }
        for k in 0..count {
            let [from, to] = [corners[k], corners[(k + 1) % count]];
            // At a border lines fall together.
            if from != to && from != middle && to != middle {
                self.triangles.push([middle, from, to]);
            }
        }
    }

    /// Number of the vertex at the crossing of two lines of a block.
    fn vertex(&mut self, block: &Block, line: [usize; 2], ring: &Ring, grid: &Grid) -> u32 {
        let at = [0, 1].map(|axis| block.lines[axis][line[axis]]);
        let vertices = &mut self.vertices;
        self.numbers.of(at, || {
            let place = DVec3::new(grid.place(0, at[0]), grid.place(1, at[1]), f64::NAN);
            let cells = if block.is_shared(line) { 2 * ring.step } else { ring.step };
            let spacing = cells as f64 * grid.step;
            vertices.push(Vertex { place, slopes: [0.0; 2], albedo: [0.0; 3], spacing });
            vertices.len() as u32 - 1
        })
    }

    /// Heights, slopes and albedo of all vertices; triangles without ground go.
    fn raise(&mut self, landscape: &Landscape) {
        self.vertices.par_iter_mut().for_each(|vertex| {
            let (x, y) = (vertex.place.x, vertex.place.y);
            if let Some(ground) = landscape.at_spacing(x, y, vertex.spacing) {
                vertex.place.z = ground.height;
                vertex.slopes = ground.slopes;
                vertex.albedo = landscape.albedo_at(x, y);
            }
        });
        let vertices = &self.vertices;
        self.triangles.retain(|corners| corners.iter().all(|&k| vertices[k as usize].place.z.is_finite()));
    }
}
