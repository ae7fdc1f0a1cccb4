//! A frame beside the map.

use generator::Stage;
use picture::{AnyPicture, ColourPicture, beside};
use quantities::sin_cos;
use scenario::Pose;

use crate::BriefingError;
use crate::map::{Place, map};
use crate::marks::Canvas;

/// Colour of the course that is still to fly. All colours and widths are chosen.
const AHEAD: [u16; 3] = [140, 95, 20];
/// Colour of the course that is flown.
const FLOWN: [u16; 3] = [255, 170, 0];
/// Colour of the eye and of its rays.
const EYE: [u16; 3] = [90, 200, 255];
/// Width of the course and of rays (pixels).
const WIDTH: f64 = 2.0;
/// Diameter of the eye (pixels).
const DISC: f64 = 7.0;
/// Length of a ray, as a share of the shorter side of the map.
const RAY: f64 = 0.25;

/// A course over its map, ready for any of its frames.
#[derive(Debug, Clone)]
pub struct Briefing {
    place: Place,
    /// The map with all the course, still to fly.
    canvas: Canvas,
    course: Vec<Pose>,
    /// From the heading to each side of the field of view (rad).
    half_field: f64,
    /// Length of a ray (pixels).
    ray: f64,
}

impl Briefing {
    /// The map of a stage, as large as its frames, with the poses of all its frames as the course.
    ///
    /// # Errors
    /// If the photographs cannot be laid over the ground, or frames have no pixels.
    pub fn new(stage: &Stage, course: Vec<Pose>) -> Result<Self, BriefingError> {
        let size = [stage.view.columns, stage.view.lines].map(|count| count as usize);
        let place = Place::fitting(stage.landscape.level().extent(), size);
        let map = AnyPicture::from(map(stage, &place)?).to_colour();
        let mut canvas = Canvas::over(&map);
        along(&mut canvas, &place, &course, AHEAD);
        Ok(Self {
            place,
            canvas,
            course,
            half_field: libm::atan(stage.view.field.tan_half_width),
            ray: RAY * size[0].min(size[1]) as f64,
        })
    }

    /// How places lie on the map.
    pub fn place(&self) -> &Place {
        &self.place
    }

    /// The map as it is in a frame: the course flown so far, the eye, and the angle of view.
    ///
    /// # Errors
    /// If the course has no such frame.
    pub fn map(&self, frame: usize) -> Result<ColourPicture, BriefingError> {
        let frames = self.course.len();
        let pose = self.course.get(frame).ok_or(BriefingError::Frame { frame, frames })?;
        let mut canvas = self.canvas.clone();
        along(&mut canvas, &self.place, &self.course[..=frame], FLOWN);
        let eye = on_map(&self.place, pose);
        for side in [-self.half_field, self.half_field] {
            let (sin, cos) = sin_cos(pose.attitude.heading + side);
            canvas.line([eye, [eye[0] + self.ray * sin, eye[1] - self.ray * cos]], WIDTH, EYE);
        }
        canvas.line([eye, eye], DISC, EYE);
        Ok(canvas.finish()?)
    }

    /// The picture of a frame with the map on its right.
    ///
    /// # Errors
    /// If the course has no such frame, or the picture is not as large as the map.
    pub fn page(&self, picture: &AnyPicture, frame: usize) -> Result<ColourPicture, BriefingError> {
        let picture = picture.to_eight_bits().to_colour();
        Ok(beside(&[&picture, &self.map(frame)?])?)
    }
}

/// Draws the course of poses.
fn along(canvas: &mut Canvas, place: &Place, course: &[Pose], colour: [u16; 3]) {
    for pair in course.windows(2) {
        canvas.line([0, 1].map(|end| on_map(place, &pair[end])), WIDTH, colour);
    }
}

fn on_map(place: &Place, pose: &Pose) -> [f64; 2] {
    place.pixel([pose.eye[0], pose.eye[1]])
}
