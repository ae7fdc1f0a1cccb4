//! A shot as it is drawn.

use generator::{FrameCounts, Label, PlaneKind, Planes};
use picture::{ColourPicture, Depth, Encoder, Transfer};
use signal::Probe;

use super::Shot;
use crate::Shipped;

/// Raster of all shots.
const RASTER: [u32; 2] = [480, 252];

/// Planes that are drawn.
const KINDS: [PlaneKind; 5] =
    [PlaneKind::Intensity, PlaneKind::Red, PlaneKind::Green, PlaneKind::Blue, PlaneKind::Label];

/// A frame with what is measured in it.
pub struct Still {
    /// The picture in colour, as displayed.
    pub picture: ColourPicture,
    /// Linear light, line by line.
    pub light: Vec<f32>,
    /// Labels of all pixels.
    pub labels: Vec<f32>,
    /// Counts of the work done.
    pub counts: FrameCounts,
}

impl Still {
    /// Pixels of a label.
    pub fn pixels(&self, label: Label) -> usize {
        let code = f32::from(label.code());
        self.labels.iter().filter(|found| **found == code).count()
    }

    /// Light of the water and of what is laid upon it, line by line; NaN where there is sky or a ship.
    pub fn shown(&self) -> impl Iterator<Item = f64> {
        let others = [Label::Sky, Label::Ship].map(|label| f32::from(label.code()));
        let pixels = self.light.iter().zip(&self.labels);
        pixels.map(move |(light, label)| if others.contains(label) { f64::NAN } else { f64::from(*light) })
    }

    /// Columns of the picture.
    pub fn columns(&self) -> usize {
        self.picture.columns()
    }
}

/// Draws a shot by the generator of smooth-shaded faces, without ground.
pub(super) fn sea_faces(shot: &Shot) -> Still {
    let shipped = Shipped::changed(shot.scenario, None, |scenario| {
        (scenario.raster.columns, scenario.raster.lines) = (Some(RASTER[0]), Some(RASTER[1]));
        (shot.change)(scenario);
    });
    let usual = [("faces.ground", "false")];
    let order =
        [("faces.order", "lists")].into_iter().filter(|(key, _)| shot.sets.iter().all(|set| set.0 != *key));
    let sets: Vec<(&str, &str)> = usual.into_iter().chain(order).chain(shot.sets.iter().copied()).collect();
    let generator =
        registry::configure_with(&smooth_faces::ROW, &sets).unwrap_or_else(|problems| panic!("{problems}"));
    let session = generator.prepare(shipped.stage().stage()).expect("a shipped stage");
    let [columns, lines] = RASTER.map(|pixels| pixels as usize);
    let mut planes = Planes::new(columns, lines, &KINDS);
    let pose = shipped.pose(shot.frame).pose;
    let counts = session.frame(shot.frame, &pose, &mut planes, &mut Probe::off()).expect("a shipped frame");
    let [light, red, green, blue, labels] = KINDS.map(|kind| planes.get(kind).expect("asked for"));
    let display = shipped.settings.display;
    let transfer = Transfer::new(display.white as f32, display.gamma as f32).expect("a shipped display");
    let encoder = Encoder::new(transfer, Depth::Eight);
    let picture = encoder.encode_colour([red, green, blue], columns, lines).expect("no NaN reaches a frame");
    Still { picture, light: light.to_vec(), labels: labels.to_vec(), counts }
}
