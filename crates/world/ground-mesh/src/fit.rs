//! Rings that are as fine as a tolerance asks for.

use glam::DVec3;
use landscape::Landscape;

use crate::error::MeshError;
use crate::height_error::HeightError;
use crate::mesh::GroundMesh;
use crate::rings::{FEWEST_CELLS, MOST_CELLS, Rings};

/// What is asked of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wish {
    /// Half the side of the innermost square (m); see [`Rings`].
    pub half_side: f64,
    /// Focal length of the picture (pixels), above 0.
    pub focal: f64,
    /// Error in the picture that is allowed (pixels), above 0.
    pub tolerance: f64,
    /// Most triangles of the mesh.
    pub most_triangles: usize,
}

/// The rings that were chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fitted {
    /// Rings of the mesh, for the frames that follow.
    pub rings: Rings,
    /// Its error from this eye.
    pub error: HeightError,
    /// Whether the error is within the tolerance; if not, the limit on triangles came first.
    pub is_met: bool,
}

impl GroundMesh {
    /// Makes the mesh for an eye (north, east, up; m), with cells halved until its error is within the tolerance or half of them would
    /// exceed the limit on triangles.
    ///
    /// # Errors If a figure or the eye is out of range, or the coarsest mesh exceeds the limit.
    pub fn fit(&mut self, landscape: &Landscape, eye: DVec3, wish: &Wish) -> Result<Fitted, MeshError> {
        for (what, found) in [("tolerance (pixels)", wish.tolerance), ("focal length (pixels)", wish.focal)] {
            if !(found > 0.0 && found.is_finite()) {
                return Err(MeshError::Figure { what, found });
            }
        }
        let mut fitted = None::<Fitted>;
        let mut cells = FEWEST_CELLS;
        while cells <= MOST_CELLS {
            let rings = Rings { half_side: wish.half_side, cells };
            self.lay_out(landscape, eye, rings, |_| true)?;
            if self.triangles.len() > wish.most_triangles {
                break;
            }
            self.raise(landscape);
            let error = self.height_error(landscape, eye, wish.focal);
            let is_met = error.pixels <= wish.tolerance;
            fitted = Some(Fitted { rings, error, is_met });
            if is_met {
                break;
            }
            cells *= 2;
        }
        let Some(fitted) = fitted else {
            return Err(MeshError::Triangles { limit: wish.most_triangles, needed: self.triangles.len() });
        };
        if !fitted.is_met {
            self.fill(landscape, eye, fitted.rings)?;
        }
        Ok(fitted)
    }
}
