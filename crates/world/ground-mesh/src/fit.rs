//! Rings that are as fine as a tolerance asks for.

use glam::DVec3;
use landscape::Landscape;

use crate::error::MeshError;
use crate::mesh::GroundMesh;
use crate::rings::{FEWEST_CELLS, Rings};

/// What is asked of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wish {
    /// Half the side of the innermost square (m); see [`Rings`].
    pub half_side: f64,
    /// Most cells along half the side of every square; see [`Rings`].
    pub most_cells: u32,
    /// Focal length of the picture (pixels), above 0.
    pub focal: f64,
    /// Error in the picture that is allowed (pixels), above 0.
    pub tolerance: f64,
}

/// The rings that were chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fitted {
    /// Rings of the mesh, for the frames that follow.
    pub rings: Rings,
    /// Whether the error is within the tolerance; if not, the limit on cells came first.
    pub is_met: bool,
}

impl GroundMesh {
    /// Makes the mesh for an eye (north, east, up; m) of those blocks alone of which `is_wanted` holds, as
    /// [`GroundMesh::fill_where`] does. Its cells are halved until its error is within the tolerance, or as many as are allowed.
    ///
    /// # Errors If a figure or the eye is out of range.
    pub fn fit_where(
        &mut self,
        landscape: &Landscape,
        eye: DVec3,
        wish: &Wish,
        is_wanted: impl Fn([[f64; 2]; 2]) -> bool,
    ) -> Result<Fitted, MeshError> {
        for (what, found) in [("tolerance (pixels)", wish.tolerance), ("focal length (pixels)", wish.focal)] {
            if !(found > 0.0 && found.is_finite()) {
                return Err(MeshError::Figure { what, found });
            }
        }
        let mut cells = FEWEST_CELLS;
        loop {
            let rings = Rings { half_side: wish.half_side, cells: cells.min(wish.most_cells) };
            self.fill_where(landscape, eye, rings, &is_wanted)?;
            let is_met = self.is_within(landscape, eye, wish.focal, wish.tolerance);
            if is_met || cells >= wish.most_cells {
                return Ok(Fitted { rings, is_met });
            }
            cells *= 2;
        }
    }
}
