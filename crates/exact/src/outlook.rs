//! The ground as one eye sees it: the first place where a ray meets it.

use landscape::{Level, parabolic_drop};
use rayon::prelude::*;
use scenario::Curvature;

use crate::bernstein::{Coefficients, DEGREE, first_reach};
use crate::patch::{Patch, UpperPlane};
use crate::walk::{Stretch, Walk};

/// A line of sight: where it goes over the ground, and how it rises.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Unit vector over the ground: north, east.
    pub direction: [f64; 2],
    /// Tangent of its elevation, positive up.
    pub rise: f64,
}

/// What a ray meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sight {
    /// The ground.
    Ground(Spot),
    /// Nothing up to the far range or the edge of the problem area.
    Sky,
    /// At the near range the ray is under the ground: what it met lies nearer, and no sweep draws that.
    TooNear,
}

/// A visible place of the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Ground range (m).
    pub range: f64,
    /// Region, north and east.
    pub region: [usize; 2],
    /// Place in the region (u, v).
    pub local: [f64; 2],
}

/// A plane above each region of a level: what a ray stays above of needs no root finding.
#[derive(Debug, Clone, PartialEq)]
pub struct Ceilings {
    planes: Vec<UpperPlane>,
    columns: usize,
    highest: f64,
}

impl Ceilings {
    /// Planes of every region of `level`; uses the threads of the current rayon pool.
    pub fn new(level: &Level) -> Self {
        let [rows, columns] = level.corners().map(|corners| corners - 1);
        let plane = |index: usize| Patch::new(level, [index / columns, index % columns]).upper_plane();
        let planes: Vec<UpperPlane> = (0..rows * columns).into_par_iter().map(plane).collect();
        let highest = planes.iter().map(UpperPlane::highest).fold(f64::NEG_INFINITY, f64::max);
        Self { planes, columns, highest }
    }

    fn over(&self, [north, east]: [usize; 2]) -> &UpperPlane {
        &self.planes[north * self.columns + east]
    }
}

/// The ground around one eye.
#[derive(Debug, Clone)]
pub struct Outlook<'a> {
    level: &'a Level,
    ceilings: &'a Ceilings,
    origin: [f64; 2],
    height: f64,
    bend: f64,
    near: f64,
    far: f64,
}

impl<'a> Outlook<'a> {
    /// The ground of `level` from `eye` (north, east, height; m), between the ranges `near` and `far` (m).
    pub fn new(
        level: &'a Level,
        ceilings: &'a Ceilings,
        eye: [f64; 3],
        curvature: Curvature,
        [near, far]: [f64; 2],
    ) -> Self {
        let bend = match curvature {
            Curvature::None => 0.0,
            Curvature::Parabolic => parabolic_drop(1.0),
        };
        let origin = level.in_regions(eye[0], eye[1]);
        Self { level, ceilings, origin, height: eye[2], bend, near, far }
    }

    /// Where ground begins to be seen (m).
    pub fn near(&self) -> f64 {
        self.near
    }

    /// What `ray` meets first.
    pub fn look(&self, ray: &Ray) -> Sight {
        self.look_from(ray, self.near)
    }

    /// The same, if it is known that the ray is above the ground up to the range `from` (m).
    pub fn look_from(&self, ray: &Ray, from: f64) -> Sight {
        let step = ray.direction.map(|direction| direction / self.level.region_size());
        let Some(walk) = Walk::new(self.level, self.origin, step, from, self.far) else {
            return Sight::Sky;
        };
        for stretch in walk {
            if self.is_above_everything(ray, stretch.from) {
                return Sight::Sky;
            }
            let ends = [stretch.from, stretch.to].map(|range| self.local(stretch.region, step, range));
            if self.stays_above(ray, &stretch, ends) {
                continue;
            }
            let above = self.ground_above_ray(ray, &stretch, ends);
            if stretch.from == self.near && above[0] > 0.0 {
                return Sight::TooNear;
            }
            if let Some(share) = first_reach(&above) {
                let range = stretch.from + share * (stretch.to - stretch.from);
                let local = self.local(stretch.region, step, range);
                return Sight::Ground(Spot { range, region: stretch.region, local });
            }
        }
        Sight::Sky
    }

    fn local(&self, region: [usize; 2], step: [f64; 2], range: f64) -> [f64; 2] {
        std::array::from_fn(|axis| self.origin[axis] + range * step[axis] - region[axis] as f64)
    }

    /// Whether a rising ray has passed the height of the highest ground: it meets nothing more.
    fn is_above_everything(&self, ray: &Ray, range: f64) -> bool {
        ray.rise >= 0.0 && self.height + (self.bend * range + ray.rise) * range > self.ceilings.highest
    }

    /// Whether the ray passes above the region's ceiling; curvature is taken at its least.
    fn stays_above(&self, ray: &Ray, stretch: &Stretch, ends: [[f64; 2]; 2]) -> bool {
        let ceiling = self.ceilings.over(stretch.region);
        let floor = self.height + self.bend * stretch.from * stretch.from;
        ceiling.height(ends[0]) < floor + ray.rise * stretch.from
            && ceiling.height(ends[1]) < floor + ray.rise * stretch.to
    }

    /// `G(s) = h(s) - s^2 / 2R - H - t s` over the stretch (m): positive where the ray is under the ground.
    fn ground_above_ray(&self, ray: &Ray, stretch: &Stretch, ends: [[f64; 2]; 2]) -> Coefficients {
        let heights = Patch::new(self.level, stretch.region).along(ends[0], ends[1]);
        let (start, length, n) = (stretch.from, stretch.to - stretch.from, DEGREE as f64);
        std::array::from_fn(|index| {
            let k = index as f64;
            let range = start + length * k / n;
            let square =
                start * start + length * (2.0 * start * k / n + length * k * (k - 1.0) / (n * (n - 1.0)));
            heights[index] - self.height - self.bend * square - ray.rise * range
        })
    }
}
