//! Light points on the screen, and which sub-areas their discs meet.

use light_points::{BeamPoint, Disc, LeastDiameter, Light, count_under, projected_diameter};
use raster::{DistancePlane, Sampling, Screen, SubArea};
use scenario::{LightPoint, LightSource};
use translucency::{Feature, FeatureError};

use crate::camera::Camera;
use crate::faces::NEAR;
use crate::parameters::Parameters;

/// Discs wider than this (pixels) are not normalised: counting would take long, and their light changes by less than a hundredth as
/// they move. Chosen.
const WIDEST_COUNTED: f64 = 32.0;

/// A light point of one frame on the screen.
#[derive(Debug, Clone, Copy)]
pub struct Point {
    /// Number of its feature.
    pub id: u32,
    /// Whether a beam draws it.
    pub is_calligraphic: bool,
    /// Middle on the screen (pixels).
    pub middle: [f64; 2],
    /// How near it is (1/m); 0 for a star.
    pub q: f64,
    /// Its disc with nothing in front.
    pub disc: Disc,
    priority: i32,
    colour: [f64; 3],
}

impl Point {
    /// A light point where it is seen; `None` where it sends nothing to the eye or lies behind it.
    pub fn new(light: &LightPoint, id: u32, camera: &Camera, run: &Parameters) -> Option<Self> {
        let least = LeastDiameter::new(run.least_diameter, &run.sampling()).ok()?;
        let intensity = light.towards(camera.eye);
        let (place, q, disc) = match light.source {
            LightSource::Lamp { at, diameter } => {
                let place = camera.place(at);
                let distance = (at - camera.eye).length();
                let projected = projected_diameter(diameter, distance, camera.focal()).ok()?;
                (place, 1.0 / place.z, Disc::of_lamp(projected, intensity, least))
            }
            LightSource::Star { direction, magnitude } => {
                let disc = Disc::of_star(magnitude, run.white_magnitude, least).ok()?;
                (camera.direction(direction), 0.0, disc.dimmed(intensity))
            }
        };
        let is_before = if q == 0.0 { place.z > 0.0 } else { place.z > NEAR };
        (is_before && intensity > 0.0).then(|| Self {
            id,
            is_calligraphic: light.calligraphic,
            middle: camera.projection.project(place),
            q,
            disc,
            priority: i32::from(light.priority),
            colour: light.colour,
        })
    }

    /// Its feature at the sampling points of the raster.
    ///
    /// # Errors If its light is no number.
    pub fn feature(&self, run: &Parameters, sampling: &Sampling) -> Result<Feature, FeatureError> {
        let is_counted = run.normalise && self.disc.diameter <= WIDEST_COUNTED && !self.is_calligraphic;
        let covered = if is_counted { count_under(self.middle, self.disc.diameter, sampling) } else { 0 };
        let intensity = match covered {
            0 => self.disc.intensity,
            covered => self.disc.normalised(covered, sampling.count()),
        };
        let Light { added, translucency } = Light::new(intensity, run.blending);
        Feature::light(self.id, self.priority, self.colour, added, translucency)
    }

    /// Its distance, the same all over the disc.
    pub fn plane(&self) -> DistancePlane {
        DistancePlane { slope: [0.0; 2], origin: self.q }
    }

    /// Its colour (linear red, green, blue).
    pub fn colour(&self) -> [f64; 3] {
        self.colour
    }

    /// The point as the beam draws it, with the light (intensity times pixels squared) that reaches the eye.
    pub fn of_beam(&self, light: f64) -> BeamPoint {
        BeamPoint { id: self.id, place: self.middle, light }
    }

    /// Whether its disc meets a rectangle of pixels.
    fn meets(&self, area: &SubArea) -> bool {
        let ranges = [area.columns(), area.rows()];
        let away = [0, 1].map(|axis| {
            let (low, high) = (f64::from(ranges[axis].start), f64::from(ranges[axis].end));
            (low - self.middle[axis]).max(self.middle[axis] - high).max(0.0)
        });
        let radius = self.disc.diameter / 2.0;
        away[0] * away[0] + away[1] * away[1] <= radius * radius
    }
}

/// Light points near to far, and the lists of the sub-areas.
#[derive(Debug, Default)]
pub struct Lights {
    /// Points of the frame whose discs meet the screen, near to far.
    pub points: Vec<Point>,
    /// Numbers of points by sub-area, each near to far.
    lists: Vec<Vec<u32>>,
}

impl Lights {
    /// Orders and lists the points.
    pub fn new(mut points: Vec<Point>, screen: &Screen) -> Self {
        let [columns, rows] = screen.counts();
        let mut lists = vec![Vec::new(); screen.sub_areas()];
        points.sort_by(|a, b| b.q.total_cmp(&a.q).then(b.priority.cmp(&a.priority)).then(a.id.cmp(&b.id)));
        points.retain(|point| !met(point, screen, [columns, rows]).is_empty());
        for (number, point) in points.iter().enumerate() {
            for area in met(point, screen, [columns, rows]) {
                lists[area].push(number as u32);
            }
        }
        Self { points, lists }
    }

    /// Numbers of the points that a sub-area lists, near to far.
    pub fn of(&self, sub_area: usize) -> &[u32] {
        &self.lists[sub_area]
    }
}

/// Numbers of the sub-areas that a disc meets, ascending.
fn met(point: &Point, screen: &Screen, counts: [u32; 2]) -> Vec<usize> {
    let side = f64::from(screen.side());
    let range = |axis: usize| {
        let [low, high] = [-0.5, 0.5].map(|half| (point.middle[axis] + half * point.disc.diameter) / side);
        // Conversion saturates: what lies beside the screen meets nothing.
        (low.floor().max(0.0) as u32)..((high.floor() + 1.0).max(0.0) as u32).min(counts[axis])
    };
    let numbers = range(1).flat_map(|row| range(0).map(move |column| (row * counts[0] + column) as usize));
    numbers.filter(|number| point.meets(&screen.sub_area(*number))).collect()
}
