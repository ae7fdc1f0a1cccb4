//! Depth of a panel over the screen, and the buffer that keeps the nearest.

use glam::DVec3;
use raster::DistancePlane;

/// Depth of a panel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DepthPlane {
    /// 1 over the distance along the axis ahead, linear on the screen: exact for planes.
    Nearness(DistancePlane),
    /// `a i + b j + c d = -1` with the Euclidean distance d at the corners, as the listing has it.
    Written {
        /// Coefficients a, b and c.
        coefficients: [f64; 3],
    },
}

/// Why a panel has no depth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoDepth {
    /// It stands edge-on: it has no area on the screen.
    EdgeOn,
    /// Its determinant is 0 although it has an area: the listing divides by it.
    Determinant,
}

impl DepthPlane {
    /// The plane of the listing through three corners (column, row, distance in m), by the inverse of their matrix.
    ///
    /// # Errors
    /// If the determinant is 0, or the coefficient of the distance.
    pub fn written(corners: [DVec3; 3]) -> Result<Self, NoDepth> {
        let [p, q, r] = corners;
        // Columns of the adjoint are cross products of the rows.
        let adjoint = [q.cross(r), r.cross(p), p.cross(q)];
        let determinant = p.dot(adjoint[0]);
        let sum = adjoint[0] + adjoint[1] + adjoint[2];
        let has_area = sum.z != 0.0;
        match (determinant == 0.0, has_area) {
            (true, true) => Err(NoDepth::Determinant),
            (_, false) => Err(NoDepth::EdgeOn),
            (false, true) => Ok(Self::Written { coefficients: (-sum / determinant).to_array() }),
        }
    }

    /// The plane of 1/w through three places on the screen (column, row, 1/w in 1/m); none where it stands edge-on.
    pub(crate) fn nearness(corners: [DVec3; 3]) -> Option<Self> {
        let [p, q, r] = corners;
        let normal = (q - p).cross(r - p);
        let slope = [-normal.x / normal.z, -normal.y / normal.z];
        let origin = p.z - slope[0] * p.x - slope[1] * p.y;
        origin.is_finite().then_some(Self::Nearness(DistancePlane { slope, origin }))
    }

    /// Its value at a place on the screen: 1/w (1/m), or the distance (m).
    pub fn at(&self, place: [f64; 2]) -> f64 {
        match self {
            Self::Nearness(plane) => plane.at(place),
            Self::Written { coefficients: [a, b, c] } => -(1.0 + (a * place[0] + b * place[1])) / c,
        }
    }
}

/// The nearest value of each pixel. 0 means empty in both ways.
#[derive(Debug, Clone)]
pub(crate) struct DepthBuffer {
    values: Vec<f64>,
    is_distance: bool,
}

impl DepthBuffer {
    pub fn new(pixels: usize, is_distance: bool) -> Self {
        Self { values: vec![0.0; pixels], is_distance }
    }

    /// Keeps `value` where it is nearer than what the pixel has; whether it is.
    pub fn keep(&mut self, pixel: usize, value: f64) -> bool {
        let before = &mut self.values[pixel];
        // In the listing a distance of 0 or below wins, or empties the pixel.
        let is_nearer = match self.is_distance {
            true => *before == 0.0 || value < *before,
            false => value > *before,
        };
        if is_nearer {
            *before = value;
        }
        is_nearer
    }

    pub fn value(&self, pixel: usize) -> f64 {
        self.values[pixel]
    }
}
