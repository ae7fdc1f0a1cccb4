//! Draws a scene by a machine and judges what comes out, wire by wire and pixel by pixel.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use control_plane::{ControlPlane, MachineStage};
use exact::{Columns, Exact};
use generator::{FrameCounts, Generator, PlaneKind, Planes};
use hardware_model::HardwareModel;
use machine::Prepare;
use scenario::{Pose, Scalar};
use signal::Probe;

use super::cell::{Action, Found};
use super::scene::StabilityScene;
use crate::figures::{Bench, SignalErrors, Sum};

/// A machine that draws scenes.
#[derive(Debug, Clone, Copy)]
pub struct Drawer<'a> {
    /// Its name in the matrix.
    pub name: &'static str,
    /// Hardware model with the machine's parts.
    pub model: &'a HardwareModel,
    /// Scalar type of the analog signals.
    pub scalar: Scalar,
    /// What they are held against.
    pub judge: Judge,
}

/// What a frame is held against.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Judge {
    /// Ideal parts: height and reflectivity are the ground's, to roundings.
    Rounding,
    /// Real parts, words always in time: height and slopes are the ground's, to a share of full scale.
    Share,
    /// A machine whose words come late is wrong by a whole region wherever they do: of its error nothing is said, but its
    /// picture's is told.
    Bounds,
}

/// What parts may be off by at rest, root mean square, as a share of full scale (figures of `pra-nominal`). A product passes
/// two function generators (knees rounded by 0.5 % of full scale), two multipliers (0.25 and 0.2 %) and a converter
/// (0.05 %): 0.84 % together, and the sum of 36 that are off independently of each other the root of 36 times as much.
const SHARE: f64 = 0.05;
/// How late function generators, multipliers and summers are together (s; hardware section 4.9).
const DELAY: f64 = 120e-9;
/// What a signal moves by in a region at most, root mean square, that swings through full scale both ways once in two; and
/// what it can move by at all (full scales).
const SWING: f64 = std::f64::consts::PI;
const FARTHEST: f64 = 2.0;

/// What real parts may be off by on `scene`, as a share of full scale: at rest, and by as much as signals move while they
/// are on their way. Of few samples the mean is no mean: so much more.
pub fn share_allowed(scene: &StabilityScene, drawer: &Drawer<'_>) -> f64 {
    let Ok((stage, _)) = scene.build(drawer.model, drawer.scalar) else { return SHARE };
    let count = scene.samples as usize;
    let ranges: Vec<f64> = (0..count).map(|sample| stage.settings.range.at_sample(sample, count)).collect();
    let late = DELAY * stage.settings.timebase.sample_rate().hertz();
    let mut moved = Sum::default();
    for step in ranges.windows(2).filter(|step| step[0] < scene.reach()) {
        let regions = (step[1] - step[0]) / scene.region_size;
        // A ramp with a fold or more in one step of its converter may be anywhere.
        moved.add(if regions > 1.0 { FARTHEST } else { (SWING * late * regions).min(FARTHEST) });
    }
    let few = 2.0 / (f64::from(scene.sweeps) * f64::from(scene.samples)).sqrt();
    (SHARE * (1.0 + few) + moved.rms()).min(1.0)
}

/// A picture may be brighter than white by what parts can overshoot.
const BRIGHTEST: f64 = 2.0;

/// What comes of `scene` by `drawer`.
pub fn draw(scene: &StabilityScene, drawer: &Drawer<'_>) -> Found {
    match catch_unwind(AssertUnwindSafe(|| drawn(scene, drawer))) {
        Ok(found) => found.unwrap_or_else(Found::refused),
        Err(panic) => Found {
            finite: false,
            bounded: false,
            error: None,
            action: Action::Panicked(words_of(panic.as_ref())),
            time_s: 0.0,
        },
    }
}

fn words_of(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("a panic without words").to_owned()
}

fn drawn(scene: &StabilityScene, drawer: &Drawer<'_>) -> Result<Found, String> {
    let (stage, pose) = scene.build(drawer.model, drawer.scalar)?;
    let session = stage.clone().prepare();
    let mut planes = planes(&stage);
    let start = Instant::now();
    let counts =
        session.frame(0, &pose, &mut planes, &mut Probe::off()).map_err(|error| error.to_string())?;
    let time_s = start.elapsed().as_secs_f64();
    let picture = planes.get(PlaneKind::Intensity).unwrap_or_default();
    let wires = wires_are_finite(&stage, session.as_ref(), &pose)?;
    let error = match drawer.judge {
        Judge::Rounding => rounding_error(scene, &signals(&stage, session.as_ref(), &pose)?, &pose),
        Judge::Share => share_error(scene, &signals(&stage, session.as_ref(), &pose)?, &pose),
        Judge::Bounds => picture_error(&stage, &pose, picture)?,
    };
    Ok(Found {
        finite: wires && picture.iter().all(|pixel| pixel.is_finite()),
        bounded: picture.iter().all(|&pixel| (0.0..=BRIGHTEST).contains(&f64::from(pixel))),
        error: Some(error),
        action: action(&counts),
        time_s,
    })
}

fn planes(stage: &MachineStage) -> Planes {
    let raster = stage.settings.raster;
    Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity])
}

/// What a frame had to leave out, counted.
fn action(counts: &FrameCounts) -> Action {
    match counts["dropped_features"] + counts["dropped_segments"] + counts["late_words"] {
        0 => Action::Exact,
        count => Action::Clamped(count),
    }
}

/// Every signal of the sweeps in the middle.
fn wires_are_finite(
    stage: &MachineStage,
    session: &dyn generator::Session,
    pose: &Pose,
) -> Result<bool, String> {
    let middle = stage.settings.raster.sweeps / 2;
    let mut probe = Probe::new(vec!["*".to_owned()], middle..middle + 2);
    let raster = stage.settings.raster;
    let mut none = Planes::new(raster.columns as usize, raster.lines as usize, &[]);
    session.frame(0, pose, &mut none, &mut probe).map_err(|error| error.to_string())?;
    let values = probe.waveforms.iter().flat_map(|wave| wave.values.iter().chain(&wave.times));
    Ok(!probe.waveforms.is_empty() && values.fold(true, |all, value| all & value.is_finite()))
}

/// Signals against the ground below the sweeps.
fn signals(
    stage: &MachineStage,
    session: &dyn generator::Session,
    pose: &Pose,
) -> Result<SignalErrors, String> {
    let (control, exact) = (ControlPlane::new(stage.clone()), Columns::new(stage.stage()));
    let bench = Bench { stage, session, control: &control, exact: &exact };
    let mut errors = SignalErrors::default();
    errors.add_frame(&bench, 0, pose).map_err(|error| error.to_string())?;
    Ok(errors)
}

/// Height over its full scale, or reflectivity, whichever is more wrong.
fn rounding_error(scene: &StabilityScene, errors: &SignalErrors, pose: &Pose) -> f64 {
    let full_scale = (scene.highest() + pose.eye[2].abs()).max(f64::MIN_POSITIVE);
    (errors.value("height max") / full_scale).max(errors.value("reflectivity rms"))
}

/// Height or slope over what is largest on the wire, whichever is more wrong in the mean.
fn share_error(scene: &StabilityScene, errors: &SignalErrors, pose: &Pose) -> f64 {
    let [highest, steepest] = errors.largest();
    // Heights are counted from the eye, whose own is rounded.
    let rounding = f64::from(f32::EPSILON) * pose.eye[2].abs() / SHARE;
    let height = scene.highest().max(highest) + rounding;
    let slope = scene.steepest().max(steepest);
    let share = |rms: f64, full: f64| if full > 0.0 { rms / full } else { rms };
    share(errors.value("height rms"), height).max(share(errors.value("slope rms"), slope))
}

/// RMSE of the picture against `exact`.
fn picture_error(stage: &MachineStage, pose: &Pose, picture: &[f32]) -> Result<f64, String> {
    let mut truth = planes(stage);
    let session = Exact.prepare(stage.stage()).map_err(|error| error.to_string())?;
    session.frame(0, pose, &mut truth, &mut Probe::off()).map_err(|error| error.to_string())?;
    let (mut sum, truth) = (Sum::default(), truth.get(PlaneKind::Intensity).unwrap_or_default());
    picture.iter().zip(truth).for_each(|(a, b)| sum.add(f64::from(*a) - f64::from(*b)));
    Ok(sum.rms())
}
