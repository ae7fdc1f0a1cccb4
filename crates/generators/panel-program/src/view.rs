//! The synthesised camera.

use glam::{DMat3, DVec3};
use raster::Projection;

use crate::Restrictions;
use crate::lie::Lie;
use crate::real::Real;

/// Where the eye stands and what it sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Eye: north, east, up (m).
    pub eye: DVec3,
    /// Axes right, down and ahead of the picture, each in north, east, up.
    pub axes: [DVec3; 3],
    /// Tangents of half the field, across and down.
    pub half_field: [f64; 2],
    /// Columns and lines of the screen.
    pub size: [u32; 2],
}

/// The camera in georectangular axes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Camera {
    eye: DVec3,
    /// Right, down, ahead; along y lengths are scaled so that pixels are square.
    rows: [DVec3; 3],
    pub projection: Projection,
    /// Height of a square pixel over the height of a true one.
    squeeze: f64,
}

impl Camera {
    /// The camera of `view`. `first` and `last` are the first posts of the first and of the last row (m, georectangular): skewed axes come from them,
    /// and turn with nothing.
    pub fn new(view: &View, lie: &Lie, [first, last]: [DVec3; 2], restrictions: Restrictions) -> Self {
        let real = Real::new(restrictions.real4);
        let rows = match restrictions.skewed_axes {
            true => skewed(first, last),
            false => {
                let turn: DMat3 = lie.turn(view.eye);
                view.axes.map(|axis| turn * axis)
            }
        };
        let size = view.size.map(f64::from);
        let quarter = if restrictions.quadrant { 2.0 } else { 1.0 };
        let focal = [0, 1].map(|axis| quarter * size[axis] / (2.0 * view.half_field[axis]));
        let squeeze = focal[1] / focal[0];
        let centre = if restrictions.quadrant { [size[0], 0.0] } else { size.map(|side| side / 2.0) };
        let [right, down, ahead] = rows.map(|row| real.vector(row));
        Self {
            eye: lie.point(view.eye, real),
            rows: [right, down * squeeze, ahead],
            projection: Projection { focal: focal[0], centre },
            squeeze,
        }
    }

    /// Right, down and ahead (m) of a georectangular point.
    pub fn place(&self, point: DVec3) -> DVec3 {
        DVec3::from_array(self.rows.map(|row| row.dot(point - self.eye)))
    }

    /// Distance (m) of a georectangular point from the eye.
    pub fn distance(&self, point: DVec3) -> f64 {
        (point - self.eye).length()
    }

    /// Length of the ray to a place on the screen, 1 along the axis ahead.
    pub fn stretch(&self, place: [f64; 2]) -> f64 {
        let ray = self.projection.ray(place);
        DVec3::new(ray.x, ray.y / self.squeeze, 1.0).length()
    }
}

/// Axes of EXT_ORIEN: down to the middle of the body, back along the first posts of the rows, and the cross product of both to the left.
fn skewed(first: DVec3, last: DVec3) -> [DVec3; 3] {
    let (down, back) = (-first, first - last);
    let left = down.cross(back);
    [-left.normalize(), down.normalize(), -back.normalize()]
}
