//! The light of a lamp over a mission: how it falls with distance, whether it twinkles, when ground takes it out of sight.
//!
//! **Law.** All pixels of a picture are added up, with the lamp and without. The difference is the *light* of the lamp, in pixels of
//! display white. What the lamp hides counts against it. The *closed form* is intensity times area of the lamp's disc with nothing in
//! front. A frame has the lamp *in sight* if it shows more than [`IN_SIGHT`] of that. *Twinkle* is the spread of the share of the closed
//! form, over its mean. Frames that show more than [`MOSTLY`] count, as a lamp that ground hides in part does not twinkle.
//! **Our choices.** A string of lamps is one light: their sum, and the distance of the nearest. A lamp beside the picture is out of sight.
//! The light of a star goes with the least diameter of its disc; the closed form has the default one.

use generator::{FrameError, Generator, PlaneKind, Planes, Stage, Weight};
use glam::DVec3;
use light_points::{Disc, LeastDiameter};
use quantities::intensity;
use scenario::{LightPoint, LightSource, Pose, View};
use serde::Serialize;
use signal::Probe;

use crate::StudyError;

/// A lamp that shows no more than this share of its closed form is out of sight. Chosen: far above rounding, far below any pixel of it.
pub const IN_SIGHT: f64 = 1e-3;

/// A lamp that shows more than this share of its closed form is not hidden in part. Chosen: patterns of sampling points vary by less.
pub const MOSTLY: f64 = 0.5;

/// What a lamp shows with nothing in front, frame by frame.
#[derive(Debug, Clone, PartialEq)]
pub struct ClosedForm {
    /// Light (pixels of white); 0 while a flash is dark or its lobe points elsewhere.
    pub light: Vec<f64>,
    /// Distance to the eye (m); infinite where no lamp is there.
    pub distances: Vec<f64>,
}

/// What a lamp shows in one way of drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct LightCurve {
    /// Name of the way.
    pub name: String,
    /// Light of each frame (pixels of white).
    pub light: Vec<f64>,
}

/// Figures of a curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LightFigures {
    /// Name of the way.
    pub name: String,
    /// How many frames have the lamp in sight.
    pub in_sight: usize,
    /// Frames at which it comes into sight, the first frame not counted.
    pub appears: Vec<u64>,
    /// Frames at which it is first out of sight.
    pub vanishes: Vec<u64>,
    /// Least, mean and largest share of the closed form over the frames that show most of it; none if there is none.
    pub share: Option<[f64; 3]>,
    /// Largest share less least, over the mean.
    pub twinkle: Option<f64>,
}

/// What the lamps of `alone`, a stage that has no other light, show the eye with nothing in front.
pub fn closed_form(alone: &Stage, poses: &[Pose]) -> ClosedForm {
    let (mut light, mut distances) = (Vec::new(), Vec::new());
    for pose in poses {
        let (eye, lamps) = (DVec3::from_array(pose.eye), alone.scenery.effects(pose.time).lights);
        light.push(lamps.iter().map(|lamp| shown(lamp, eye, focal(&alone.view))).sum());
        distances.push(lamps.iter().map(|lamp| distance(lamp, eye)).fold(f64::INFINITY, f64::min));
    }
    ClosedForm { light, distances }
}

/// Light of a lamp (pixels of white) for an eye, with the focal length in pixels.
fn shown(lamp: &LightPoint, eye: DVec3, focal: f64) -> f64 {
    // Intensity times area of a lamp is the same whatever the least diameter.
    let disc = Disc::of_light(lamp, eye, focal, LeastDiameter::between_sweeps(1.0));
    disc.map_or(0.0, |disc| disc.light() * intensity(lamp.colour))
}

fn distance(lamp: &LightPoint, eye: DVec3) -> f64 {
    match lamp.source {
        LightSource::Lamp { at, .. } => (at - eye).length(),
        LightSource::Star { .. } => f64::INFINITY,
    }
}

/// Focal length (pixels) with which areas are right.
fn focal(view: &View) -> f64 {
    let of = |pixels: u32, tangent: f64| f64::from(pixels) / (2.0 * tangent);
    (of(view.columns, view.field.tan_half_width) * of(view.lines, view.field.tan_half_height)).sqrt()
}

/// The light of what `stages` differ in, with it and without, as a generator draws it; the number of the first of `poses` is `first`.
///
/// # Errors
/// If the generator cannot draw a stage or a pose.
pub fn light_curve(
    name: &str,
    generator: &dyn Generator,
    stages: [&Stage; 2],
    first: u64,
    poses: &[Pose],
) -> Result<LightCurve, StudyError> {
    let [with, without] = stages.map(|stage| sums(generator, stage, first, poses));
    let light = with?.iter().zip(without?).map(|(with, without)| with - without).collect();
    Ok(LightCurve { name: name.into(), light })
}

/// What a generator lacks of a stage, each with the reason: a lamp that it does not draw is among them.
///
/// # Errors
/// If the generator cannot draw the stage.
pub fn not_modelled(generator: &dyn Generator, stage: &Stage) -> Result<Vec<String>, StudyError> {
    let omissions = generator.prepare(stage.clone())?.omissions().into_iter();
    let lacking = omissions.filter(|omission| omission.weight == Weight::NotModelled);
    Ok(lacking.map(|omission| format!("{}: {}", omission.what, omission.why)).collect())
}

/// Sum of all pixels of each picture. One after the other: a picture may depend on those before it.
fn sums(
    generator: &dyn Generator,
    stage: &Stage,
    first: u64,
    poses: &[Pose],
) -> Result<Vec<f64>, StudyError> {
    let (columns, lines) = (stage.view.columns as usize, stage.view.lines as usize);
    let session = generator.prepare(stage.clone())?;
    let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
    let sum = |(frame, pose): (u64, &Pose)| -> Result<f64, FrameError> {
        session.frame(frame, pose, &mut planes, &mut Probe::off())?;
        let intensity = planes.get(PlaneKind::Intensity).unwrap_or_default();
        Ok(intensity.iter().map(|&pixel| f64::from(pixel)).sum())
    };
    Ok((first..).zip(poses).map(sum).collect::<Result<_, _>>()?)
}

impl LightCurve {
    /// Share of the closed form that each frame shows; NaN where the lamp sends the eye nothing.
    pub fn shares(&self, whole: &ClosedForm) -> Vec<f64> {
        let pairs = self.light.iter().zip(&whole.light);
        pairs.map(|(shown, whole)| if *whole > 0.0 { shown / whole } else { f64::NAN }).collect()
    }

    /// Figures against the closed form; `first` is the number of the first frame.
    pub fn figures(&self, whole: &ClosedForm, first: u64) -> LightFigures {
        let shares = self.shares(whole);
        let is_in_sight = |share: f64| share > IN_SIGHT;
        let frames_where = |turns: fn(bool, bool) -> bool| -> Vec<u64> {
            let pairs = (first + 1..).zip(shares.windows(2));
            let turned = pairs.filter(|(_, pair)| turns(is_in_sight(pair[0]), is_in_sight(pair[1])));
            turned.map(|(frame, _)| frame).collect()
        };
        let seen: Vec<f64> = shares.iter().copied().filter(|share| *share > MOSTLY).collect();
        let share = (!seen.is_empty()).then(|| {
            let mean = seen.iter().sum::<f64>() / seen.len() as f64;
            let least = seen.iter().copied().fold(f64::INFINITY, f64::min);
            [least, mean, seen.iter().copied().fold(0.0, f64::max)]
        });
        LightFigures {
            name: self.name.clone(),
            in_sight: shares.iter().filter(|share| is_in_sight(**share)).count(),
            appears: frames_where(|before, now| !before && now),
            vanishes: frames_where(|before, now| before && !now),
            share,
            twinkle: share.map(|[least, mean, most]| (most - least) / mean),
        }
    }
}

#[cfg(test)]
mod tests {
    use hardware_model::{HardwareModel, ModelSource};
    use scenario::{PoseTable, Scenario};

    use super::*;
    use crate::stability::BASE;

    fn curve(light: &[f64]) -> LightCurve {
        LightCurve { name: "it".into(), light: light.into() }
    }

    /// The built-in scene with a lamp 20 m ahead and without, and the pose of its frame.
    fn lamp_ahead() -> ([Stage; 2], Pose) {
        let lamp = "[[light]]\nid = 'lamp'\nx_m = 806.4\ny_m = 816.5\nabove_m = 3\ndiameter_m = 0.5\ncolour = [1, 1, 1]\n";
        let with = Scenario::parse("small", &format!("{BASE}\n{lamp}")).unwrap();
        let mut without = with.clone();
        without.effects.lights.clear();
        let ideal = HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &[], &[]).unwrap().model;
        let settings = front_door::settings(&with, &ideal).unwrap();
        let stages =
            [&with, &without].map(|scenario| front_door::build(scenario, settings.clone()).unwrap().stage());
        let table =
            PoseTable::resolve(&with, &stages[0].landscape, settings.timebase.update, None, 0..1).unwrap();
        (stages, table.rows()[0].pose)
    }

    #[test]
    fn the_judge_shows_the_closed_form() {
        let ([with, without], pose) = lamp_ahead();
        let whole = closed_form(&with, &[pose]);
        let judge = registry::configure_with(registry::judge(), &[]).unwrap();
        let curve = light_curve("exact", &*judge, [&with, &without], 0, &[pose]).unwrap();
        let share = curve.shares(&whole)[0];
        assert!((share - 1.0).abs() < 0.01, "{share} of {whole:?}");
        let dark = light_curve("exact", &*judge, [&without, &without], 0, &[pose]).unwrap();
        assert_eq!(dark.light, [0.0]);
    }

    #[test]
    fn who_draws_no_lamps_says_so() {
        let ([with, without], _) = lamp_ahead();
        let flat = registry::find("smooth-faces").unwrap();
        let flat = registry::configure_with(flat, &[]).unwrap();
        let lacking = |stage| not_modelled(&*flat, stage).unwrap();
        let new: Vec<_> =
            lacking(&with).into_iter().filter(|what| !lacking(&without).contains(what)).collect();
        assert!(new.len() == 1 && new[0].contains("lights"), "{new:?}");
    }

    #[test]
    fn figures_are_of_the_frames_that_show_most_of_it() {
        let whole = ClosedForm { light: vec![4.0, 10.0, 4.0, 5.0, 10.0, 10.0], distances: vec![1.0; 6] };
        // Hidden, hidden in part, three frames of its own, too faint to be in sight.
        let figures = curve(&[0.0, 1.0, 3.0, 5.0, 12.5, 0.001]).figures(&whole, 20);
        assert_eq!((figures.in_sight, figures.appears, figures.vanishes), (4, vec![21], vec![25]));
        assert_eq!(figures.share, Some([0.75, 1.0, 1.25]));
        assert_eq!(figures.twinkle, Some(0.5));
    }

    #[test]
    fn a_lamp_that_is_dark_has_no_share() {
        let whole = ClosedForm { light: vec![0.0, 4.0, 0.0], distances: vec![1.0; 3] };
        let figures = curve(&[0.0, 4.0, 0.0]).figures(&whole, 0);
        assert_eq!((figures.in_sight, figures.appears, figures.vanishes), (1, vec![1], vec![2]));
        let never = curve(&[0.0; 3]).figures(&whole, 0);
        assert_eq!((never.in_sight, never.share, never.twinkle), (0, None, None));
    }

    #[test]
    fn light_falls_with_the_square_of_the_distance() {
        let source = LightSource::Lamp { at: DVec3::new(0.0, 0.0, 2.0), diameter: 0.5 };
        let lamp = LightPoint {
            id: 0,
            source,
            colour: [1.0; 3],
            intensity: 2.0,
            lobe: None,
            priority: 0,
            calligraphic: false,
        };
        // A disc of 0.5 m at 10 m under a focal length of 100 pixels: 5 pixels wide, twice as bright as white.
        let near = shown(&lamp, DVec3::new(10.0, 0.0, 2.0), 100.0);
        assert!((near - 2.0 * std::f64::consts::PI * 25.0 / 4.0).abs() < 1e-12);
        let far = shown(&lamp, DVec3::new(1000.0, 0.0, 2.0), 100.0);
        assert!((near / far - 1e4).abs() < 1e-6);
    }
}
