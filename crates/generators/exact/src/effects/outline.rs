//! What a thing covers of the screen.

use glam::DVec3;
use scenario::SkyDisc;

use super::circle;
use super::screen::Screen;

/// A shape on the screen.
#[derive(Debug, Clone, PartialEq)]
pub enum Outline {
    /// A convex polygon: corners in pixels, x towards y.
    Polygon(Vec<[f64; 2]>),
    /// A circle of the view-plane.
    Circle {
        /// Its middle in pixels.
        middle: [f64; 2],
        /// Its radius (pixels of the geometric mean of both sides).
        radius: f64,
    },
    /// A disc of the sky, with the box (pixels) that it lies in: a cone, not a circle, in perspective.
    Cone(SkyDisc, [[f64; 2]; 2]),
}

impl Outline {
    /// A convex polygon of these corners (pixels); `None` if it has no area, or a corner is no number.
    pub fn polygon(mut corners: Vec<[f64; 2]>) -> Option<Self> {
        let doubled = doubled_area(&corners);
        if doubled < 0.0 {
            corners.reverse();
        }
        (doubled.is_finite() && doubled != 0.0).then_some(Self::Polygon(corners))
    }

    /// The box (low, high; pixels) that it lies in.
    pub fn bounds(&self, screen: &Screen) -> [[f64; 2]; 2] {
        match self {
            Self::Polygon(corners) => {
                let fold = |start: f64, pick: fn(f64, f64) -> f64| {
                    [0, 1].map(|axis| corners.iter().map(|corner| corner[axis]).fold(start, pick))
                };
                [fold(f64::INFINITY, f64::min), fold(f64::NEG_INFINITY, f64::max)]
            }
            Self::Circle { middle, radius } => {
                let unit = screen.rounded([1.0; 2]);
                [-radius, *radius].map(|radius| [0, 1].map(|axis| middle[axis] + radius / unit[axis]))
            }
            Self::Cone(_, bounds) => *bounds,
        }
    }

    /// Share (0 to 1) of a pixel that it covers; of a disc of the sky no more is known than whether the pixel is in its box.
    pub fn share(&self, screen: &Screen, low: [f64; 2]) -> f64 {
        let high = low.map(|at| at + 1.0);
        match self {
            Self::Polygon(corners) => {
                let all = [low, high, [low[0], high[1]], [high[0], low[1]]];
                let is_full = || all.iter().all(|corner| is_inside(corners, *corner));
                if is_full() { 1.0 } else { raster::area_within(corners, low, high).min(1.0) }
            }
            Self::Circle { middle, radius } => {
                let place = |at: [f64; 2]| screen.rounded([at[0] - middle[0], at[1] - middle[1]]);
                circle::area_within(*radius, place(low), place(high)).min(1.0)
            }
            Self::Cone(_, [from, to]) => {
                let meets = |axis: usize| from[axis] < high[axis] && to[axis] > low[axis];
                if meets(0) && meets(1) { 1.0 } else { 0.0 }
            }
        }
    }

    /// Whether it covers a place in pixels, through which `ray` goes.
    pub fn covers(&self, screen: &Screen, at: [f64; 2], ray: DVec3) -> bool {
        match self {
            Self::Polygon(corners) => is_inside(corners, at),
            Self::Circle { middle, radius } => {
                let [x, y] = screen.rounded([at[0] - middle[0], at[1] - middle[1]]);
                x * x + y * y <= radius * radius
            }
            Self::Cone(disc, _) => disc.light(ray.normalize()).is_some(),
        }
    }
}

/// Whether a place lies in a convex polygon or on its edge.
fn is_inside(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let mut last = corners[corners.len() - 1];
    corners.iter().all(|&[to_x, to_y]| {
        let [from_x, from_y] = std::mem::replace(&mut last, [to_x, to_y]);
        (to_x - from_x) * (y - from_y) >= (to_y - from_y) * (x - from_x)
    })
}

/// Twice the signed area of a polygon.
fn doubled_area(corners: &[[f64; 2]]) -> f64 {
    let Some(&[x, y]) = corners.first() else { return 0.0 };
    let cross = |pair: &[[f64; 2]]| (pair[0][0] - x) * (pair[1][1] - y) - (pair[1][0] - x) * (pair[0][1] - y);
    corners.windows(2).map(cross).sum()
}
