//! Draws a scene by a machine and judges what comes out, wire by wire and pixel by pixel.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use exact::{Columns, Exact};
use generator::{FrameCounts, Generator, PlaneKind, Planes, Stage};
use hardware_model::HardwareModel;
use machine::{ControlPlane, HybridMachine};
use scenario::{Pose, Scalar};
use signal::Probe;

use super::cell::{Action, Found};
use super::scene::Scene;
use crate::figures::{Bench, SignalErrors, Sum};

/// A machine that draws scenes.
#[derive(Debug, Clone, Copy)]
pub struct Drawer<'a> {
    /// Its name in the matrix.
    pub name: &'static str,
    /// Its parts.
    pub model: &'a HardwareModel,
    /// Its signals.
    pub scalar: Scalar,
    /// Whether its parts are ideal: then its signals are held against the ground.
    pub is_ideal: bool,
}

/// A picture may be brighter than white by what parts can overshoot.
const BRIGHTEST: f64 = 2.0;

/// What comes of `scene` by `drawer`: the error is that of its signals, heights over their full scale and reflectivity; of a
/// machine with parts, which are wrong by design, that of the picture.
pub fn draw(scene: &Scene, drawer: &Drawer<'_>) -> Found {
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

fn drawn(scene: &Scene, drawer: &Drawer<'_>) -> Result<Found, String> {
    let (stage, pose) = scene.build(drawer.model, drawer.scalar)?;
    let session = HybridMachine.prepare(stage.clone()).map_err(|error| error.to_string())?;
    let mut planes = planes(&stage);
    let start = Instant::now();
    let counts =
        session.frame(0, &pose, &mut planes, &mut Probe::off()).map_err(|error| error.to_string())?;
    let time_s = start.elapsed().as_secs_f64();
    let picture = planes.get(PlaneKind::Intensity).unwrap_or_default();
    let wires = wires_are_finite(&stage, session.as_ref(), &pose)?;
    let error = match drawer.is_ideal {
        true => signal_error(scene, &stage, session.as_ref(), &pose)?,
        false => picture_error(&stage, &pose, picture)?,
    };
    Ok(Found {
        finite: wires && picture.iter().all(|pixel| pixel.is_finite()),
        bounded: picture.iter().all(|&pixel| (0.0..=BRIGHTEST).contains(&f64::from(pixel))),
        error: Some(error),
        action: action(&counts),
        time_s,
    })
}

fn planes(stage: &Stage) -> Planes {
    let raster = stage.settings.raster;
    Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity])
}

/// What a frame had to leave out, counted.
fn action(counts: &FrameCounts) -> Action {
    match counts.dropped_features + counts.dropped_segments + counts.late_words {
        0 => Action::Exact,
        count => Action::Clamped(count),
    }
}

/// Every signal of the sweeps in the middle.
fn wires_are_finite(stage: &Stage, session: &dyn generator::Session, pose: &Pose) -> Result<bool, String> {
    let middle = stage.settings.raster.sweeps / 2;
    let mut probe = Probe::new(vec!["*".to_owned()], middle..middle + 2);
    let raster = stage.settings.raster;
    let mut none = Planes::new(raster.columns as usize, raster.lines as usize, &[]);
    session.frame(0, pose, &mut none, &mut probe).map_err(|error| error.to_string())?;
    let values = probe.waveforms.iter().flat_map(|wave| wave.values.iter().chain(&wave.times));
    Ok(!probe.waveforms.is_empty() && values.fold(true, |all, value| all & value.is_finite()))
}

/// Height over the full scale of its wire, or reflectivity, whichever is more wrong.
fn signal_error(
    scene: &Scene,
    stage: &Stage,
    session: &dyn generator::Session,
    pose: &Pose,
) -> Result<f64, String> {
    let (control, exact) = (ControlPlane::new(stage.clone()), Columns::new(stage.clone()));
    let bench = Bench { stage, session, control: &control, exact: &exact };
    let mut errors = SignalErrors::default();
    errors.add_frame(&bench, 0, pose).map_err(|error| error.to_string())?;
    let figures = errors.figures();
    let value =
        |name: &str| figures.iter().find(|figure| figure.name == name).map_or(0.0, |figure| figure.value);
    let full_scale = (scene.highest() + pose.eye[2].abs()).max(f64::MIN_POSITIVE);
    Ok((value("height max") / full_scale).max(value("reflectivity rms")))
}

/// RMSE of the picture against `exact`.
fn picture_error(stage: &Stage, pose: &Pose, picture: &[f32]) -> Result<f64, String> {
    let mut truth = planes(stage);
    let session = Exact.prepare(stage.clone()).map_err(|error| error.to_string())?;
    session.frame(0, pose, &mut truth, &mut Probe::off()).map_err(|error| error.to_string())?;
    let (mut sum, truth) = (Sum::default(), truth.get(PlaneKind::Intensity).unwrap_or_default());
    picture.iter().zip(truth).for_each(|(a, b)| sum.add(f64::from(*a) - f64::from(*b)));
    Ok(sum.rms())
}
