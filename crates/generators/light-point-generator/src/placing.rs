//! Where a light point is seen, how large and how bright.

use glam::DVec3;
use light_points::{Blending, Disc, LeastDiameter, Light};
use polyhedron_generator::{Place, ViewPlane};
use quantities::intensity;
use scenario::{LightPoint, LightSource};
use sweep_memory::Reading;

use crate::chords::{Chords, spacing};

/// The eye of a frame, and how its picture is read.
#[derive(Debug, Clone, Copy)]
pub struct Optics<'a> {
    /// From the ground to the upright view-plane.
    pub view: &'a ViewPlane,
    /// From the raster to the picture.
    pub reading: &'a Reading,
}

/// A light point of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Number of the light among those of the mission.
    pub light: u32,
    /// Whether a second beam draws it.
    pub is_calligraphic: bool,
    /// Middle on the picture (pixels, from its top left corner).
    pub middle: [f64; 2],
    /// Inverse ground range (1/m): 0 of a star.
    pub near: f32,
    /// Inverse distance along the view axis (1/m): 0 of a star.
    pub depth: f64,
    /// Its disc with nothing in front.
    pub disc: Disc,
    /// Its colour (linear red, green, blue).
    pub colour: [f64; 3],
    /// What the third video switch adds where it is seen (intensity).
    pub added: f32,
    /// Share of what is behind it that it lets through.
    pub translucency: f64,
    /// Which of two points at one distance is nearer: the higher.
    pub priority: i8,
}

impl Point {
    /// Whether its disc lies over a place of the picture (pixels).
    pub fn covers(&self, place: [f64; 2]) -> bool {
        let [x, y] = [0, 1].map(|axis| place[axis] - self.middle[axis]);
        4.0 * (x * x + y * y) <= self.disc.diameter * self.disc.diameter
    }
}

impl Optics<'_> {
    /// A light point and its chords; `None` where it sends the eye nothing, or lies behind it or beside the picture.
    pub(crate) fn place(&self, light: &LightPoint) -> Option<(Point, Chords)> {
        let Self { view, reading } = *self;
        let (place, near) = self.seen(light)?;
        let written = reading.written([place.x, place.y]);
        let middle = reading.shown(written);
        let least = LeastDiameter::between_sweeps(spacing(written, reading));
        let disc = Disc::of_light(light, DVec3::from_array(view.eye), self.focal(), least)?;
        if !self.reaches_picture(middle, disc.diameter) {
            return None;
        }
        let chords = Chords::of(&disc, middle, reading);
        let measured = chords.area.filter(|_| !light.calligraphic).map(|area| disc.spread_over(area));
        let Light { added, translucency } = Light::new(measured.unwrap_or(disc.intensity), Blending::Hiding);
        let point = Point {
            light: light.id,
            is_calligraphic: light.calligraphic,
            middle,
            near: near as f32,
            depth: place.depth,
            disc,
            colour: light.colour,
            added: (added * intensity(light.colour)) as f32,
            translucency,
            priority: light.priority,
        };
        (!chords.all.is_empty()).then_some((point, chords))
    }

    /// Its place on the upright view-plane, and its inverse ground range (1/m).
    fn seen(&self, light: &LightPoint) -> Option<(Place, f64)> {
        match light.source {
            LightSource::Lamp { at, .. } => {
                let range = (at - DVec3::from_array(self.view.eye)).truncate().length();
                Some((self.view.point(at)?, 1.0 / range))
            }
            LightSource::Star { direction, .. } => Some((self.view.direction(direction)?, 0.0)),
        }
    }

    /// Focal length (pixels) with which areas are right.
    fn focal(&self) -> f64 {
        let Reading { view, columns, lines, .. } = self.reading;
        let focal = |pixels: usize, tangent: f64| pixels as f64 / (2.0 * tangent);
        (focal(*columns, view.field.tan_half_width) * focal(*lines, view.field.tan_half_height)).sqrt()
    }

    /// Whether a disc may reach the picture.
    fn reaches_picture(&self, middle: [f64; 2], diameter: f64) -> bool {
        let size = [self.reading.columns, self.reading.lines];
        (0..2).all(|axis| (-diameter..=size[axis] as f64 + diameter).contains(&middle[axis]))
    }
}
