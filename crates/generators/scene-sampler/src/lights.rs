//! Light points on the screen, and which sub-areas their discs meet.

use glam::DVec3;
use light_points::{BeamPoint, Disc, LeastDiameter, Light, LightError, count_under};
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
    /// Its number among the light points of the mission.
    pub light: u32,
    /// Whether a beam draws it.
    pub is_calligraphic: bool,
    /// Middle on the screen (pixels).
    pub middle: [f64; 2],
    /// How near it is (1/m); 0 for a star.
    pub q: f64,
    /// Its disc with nothing in front.
    pub disc: Disc,
    /// What it does to sampling points under its disc.
    pub feature: Feature,
    colour: [f64; 3],
}

/// What all light points of a run share.
#[derive(Debug, Clone)]
pub struct Optics {
    run: Parameters,
    sampling: Sampling,
    least: LeastDiameter,
}

impl Optics {
    /// The optics of run parameters.
    ///
    /// # Errors If the pattern can miss the least disc.
    pub fn new(run: &Parameters) -> Result<Self, LightError> {
        let sampling = run.sampling();
        let least = LeastDiameter::new(run.least_diameter, &sampling)?;
        Ok(Self { run: *run, sampling, least })
    }

    /// What a disc does to the sampling points under it: it adds light, and lets through.
    fn light(&self, disc: &Disc, middle: [f64; 2], is_calligraphic: bool) -> Light {
        let is_counted = self.run.normalise && disc.diameter <= WIDEST_COUNTED && !is_calligraphic;
        let covered = if is_counted { count_under(middle, disc.diameter, &self.sampling) } else { 0 };
        let intensity = match covered {
            0 => disc.intensity,
            covered => disc.normalised(covered, self.sampling.count()),
        };
        Light::new(intensity, self.run.blending)
    }
}

impl Point {
    /// A light point where it is seen; `None` where it sends nothing to the eye, or lies behind it or beside the screen.
    ///
    /// # Errors If its light is no number.
    pub fn new(
        light: &LightPoint,
        id: u32,
        camera: &Camera,
        screen: &Screen,
        optics: &Optics,
    ) -> Result<Option<Self>, FeatureError> {
        let Some((place, q, disc)) = disc(light, camera, optics) else { return Ok(None) };
        let middle = camera.projection.project(place);
        if !is_near(middle, disc.diameter, screen) {
            return Ok(None);
        }
        let Light { added, translucency } = optics.light(&disc, middle, light.calligraphic);
        let feature = Feature::light(id, i32::from(light.priority), light.colour, added, translucency)?;
        let is_calligraphic = light.calligraphic;
        Ok(Some(Self {
            id,
            light: light.id,
            is_calligraphic,
            middle,
            q,
            disc,
            feature,
            colour: light.colour,
        }))
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

/// Camera axes (m) of a light point, how near it is (1/m) and its disc; `None` where it sends nothing to the eye or lies behind it.
fn disc(light: &LightPoint, camera: &Camera, optics: &Optics) -> Option<(DVec3, f64, Disc)> {
    let disc = Disc::of_light(light, camera.eye, camera.focal(), optics.least)?;
    let (place, q, is_before) = match light.source {
        LightSource::Lamp { at, .. } => {
            let place = camera.place(at);
            (place, 1.0 / place.z, place.z > NEAR)
        }
        LightSource::Star { direction, .. } => {
            let place = camera.direction(direction);
            (place, 0.0, place.z > 0.0)
        }
    };
    is_before.then_some((place, q, disc))
}

/// Whether a disc may reach the screen. What lies far outside is not counted.
fn is_near(middle: [f64; 2], diameter: f64, screen: &Screen) -> bool {
    let reaches = |axis: usize| {
        let size = f64::from(screen.size()[axis]);
        (-diameter..=size + diameter).contains(&middle[axis])
    };
    reaches(0) && reaches(1)
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
        points.sort_by(|a, b| {
            b.q.total_cmp(&a.q).then(b.feature.priority().cmp(&a.feature.priority())).then(a.id.cmp(&b.id))
        });
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
