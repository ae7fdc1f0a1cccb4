//! One photograph over the ground.

use glam::DVec3;
use landscape::Bank;
use photograph::{Photograph, Placement};
use quantities::sin_cos;
use sight::{Curvature, Point, Posts, Sight};

use crate::pyramid::Pyramid;
use crate::rule::Rule;
use crate::{DrapeError, Footprint, Ground};

/// Most looks into a photograph for one footprint. Chosen: a footprint sixteen times as long as wide is still sharp across.
pub const MOST_PROBES: u32 = 16;

/// A photograph, the ground that it sees, and how its axes lie there.
#[derive(Debug, Clone)]
pub(crate) struct Layer {
    pub photograph: Photograph,
    pyramid: Pyramid,
    rule: Rule,
    /// Whether its camera sees each post of the ground; nothing for a map, which sees all.
    sees: Option<Vec<bool>>,
}

/// A look into a photograph.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Look {
    /// Pixel I, J in the middle of the footprint.
    pub pixel: [f64; 2],
    /// Half axes of the footprint in the photograph (pixels).
    axes: [[f64; 2]; 2],
    /// Pixels of the photograph on a square metre of the ground.
    pub weight: f64,
}

impl Layer {
    /// Photograph `number` (from 1) over ground, whose triangles are `posts`.
    ///
    /// # Errors
    /// If its axes are not known there, or it shows nothing of the ground.
    pub fn new(
        photograph: &Photograph,
        number: usize,
        bank: &Bank,
        ground: &Ground,
        posts: &Posts,
    ) -> Result<Self, DrapeError> {
        let rule = Rule::of(photograph.placement(), bank, number)?;
        let [rows, columns] = ground.size();
        let all = (0..rows).flat_map(|row| (0..columns).map(move |column| [row, column]));
        let points = all.filter_map(|post| rule.point(ground.post(post)));
        photograph.coverage(points).map_err(|error| DrapeError::Photograph { number, error })?;
        let centre = match photograph.placement() {
            Placement::Camera { camera, .. } => rule.place(camera.centre()),
            Placement::Map(_) => None,
        };
        let sees = centre.map(|centre| sees(posts, centre, [rows, columns])).transpose();
        let sees = sees.map_err(|error| DrapeError::Camera { number, error })?;
        Ok(Self { pyramid: Pyramid::new(photograph), photograph: photograph.clone(), rule, sees })
    }

    /// Pixel I, J of a place (north, east, up; m), inside the picture or not; none behind the camera.
    pub fn pixel(&self, place: DVec3) -> Option<[f64; 2]> {
        self.photograph.pixel(self.rule.point(place)?)
    }

    /// Whether its camera sees a place of the ground.
    pub fn sees(&self, ground: &Ground, place: [f64; 2]) -> bool {
        let Some(sees) = &self.sees else { return true };
        let [share] = ground.between(place, |post| [f64::from(u8::from(sees[post]))]);
        share >= 0.5
    }

    /// Pixel I, J in which the photograph shows a place of the ground; none where it does not.
    pub fn shows(&self, ground: &Ground, place: DVec3) -> Option<[f64; 2]> {
        let pixel = self.pixel(place).filter(|pixel| self.photograph.holds(*pixel))?;
        self.sees(ground, [place.x, place.y]).then_some(pixel)
    }

    /// How the photograph shows a place in a footprint; none where it does not, or hardly.
    pub fn look(&self, ground: &Ground, place: DVec3, footprint: &Footprint) -> Option<Look> {
        let pixel = self.shows(ground, place)?;
        let step = |way: DVec3| {
            let [i, j] = self.pixel(place + way)?;
            Some([i - pixel[0], j - pixel[1]])
        };
        let [a, b] = [step(footprint.across)?, step(footprint.along)?];
        let weight = (a[0] * b[1] - a[1] * b[0]).abs() / footprint.area();
        Some(Look { pixel, axes: [a, b], weight })
    }

    /// Mean light of a look; probes beside the picture have that of its edge.
    pub fn light(&self, look: &Look) -> f64 {
        let [long, short] = principal(look.axes);
        // Full axes in pixels.
        let (length, width) = (2.0 * libm::hypot(long[0], long[1]), 2.0 * libm::hypot(short[0], short[1]));
        let count = (length / width.max(1.0)).ceil().clamp(1.0, f64::from(MOST_PROBES));
        let fineness = self.pyramid.fineness(libm::log2(width.max(length / count).max(1.0)));
        let probe = |number: u32| {
            let along = (2.0 * f64::from(number) + 1.0) / count - 1.0;
            let at = [look.pixel[0] + along * long[0], look.pixel[1] + along * long[1]];
            self.pyramid.light(&self.photograph, at, fineness)
        };
        (0..count as u32).map(probe).sum::<f64>() / count
    }
}

/// Whether a camera sees each post.
fn sees(posts: &Posts, centre: DVec3, [rows, columns]: [usize; 2]) -> Result<Vec<bool>, sight::SightError> {
    let observer = Point::above_datum([centre.x, centre.y], centre.z);
    let found = posts.viewshed(&observer, 0.0, Curvature::default())?;
    // Rows of a viewshed run from the north.
    let row = |row: usize| &found[(rows - 1 - row) * columns..][..columns];
    Ok((0..rows).flat_map(row).map(|sight| *sight == Sight::Visible).collect())
}

/// The longer and the shorter half axis of the ellipse whose conjugate half axes are given.
fn principal([a, b]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let dot = |p: [f64; 2], q: [f64; 2]| p[0] * q[0] + p[1] * q[1];
    // Points of the ellipse are a cos t + b sin t; they are farthest where the derivative of the square is 0.
    let turn = 0.5 * libm::atan2(2.0 * dot(a, b), dot(a, a) - dot(b, b));
    let (sin, cos) = sin_cos(turn);
    let first = [cos * a[0] + sin * b[0], cos * a[1] + sin * b[1]];
    let second = [cos * b[0] - sin * a[0], cos * b[1] - sin * a[1]];
    if dot(first, first) >= dot(second, second) { [first, second] } else { [second, first] }
}
