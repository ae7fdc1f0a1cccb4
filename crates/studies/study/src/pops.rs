//! Distances along the view axis frame by frame: what levels of detail do to them (chapter 6 of a thesis on tests of navigation).
//!
//! **Law.** A *curve* is the distance to the ground as it is drawn, over the frames of a mission. The first way of a generator draws the
//! finest ground alone: its curve is the truth. An *excess jump* is the change of (curve - truth) from one frame to the next. A *pop* is
//! what changes for a camera that stands, at the moment when levels change: the distance from the pose of a frame with the levels of that
//! frame, less the distance with those of the frame before. A tile whose level changes is at that end of it at which the other begins.
//! **Our choices.** A frame whose axis meets no ground counts in no figure.

use generator::{FrameError, Generator, PlaneKind, Planes, Session, Stage};
use rayon::prelude::*;
use scenario::{FieldOfView, Pose, View};
use serde::Serialize;
use signal::Probe;

use crate::StudyError;

/// A pop above this (m) is one; less is rounding.
pub const LEAST_POP: f64 = 1e-9;

/// Distances of one way with levels of detail.
#[derive(Debug, Clone, PartialEq)]
pub struct PopCurve {
    /// Name of the way.
    pub name: String,
    /// Distance of each frame (m); infinite for sky.
    pub distances: Vec<f64>,
    /// Pop of each frame (m) against the frame before; 0 of the first, NaN where an axis meets no ground.
    pub pops: Vec<f64>,
}

/// A frame with a value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AtFrame {
    /// Number of the frame.
    pub frame: u64,
    /// Value that it has (m).
    pub metres: f64,
}

/// Figures of a curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PopFigures {
    /// Name of the way.
    pub name: String,
    /// Root mean square of curve - truth (m).
    pub rms_m: f64,
    /// Largest excess jump, at the later of its frames; none with fewer than two frames.
    pub largest_jump: Option<AtFrame>,
    /// Largest pop of all frames.
    pub largest_pop: Option<AtFrame>,
    /// How many frames have a pop above [`LEAST_POP`].
    pub pops: usize,
}

/// The curve of a generator made ready in one way, over `poses`; the number of the first is `first`.
///
/// # Errors
/// If a pose cannot be drawn. `None` if the generator tells no distance of single rays.
pub fn curve(
    name: &str,
    session: &dyn Session,
    first: u64,
    poses: &[Pose],
) -> Result<Option<PopCurve>, FrameError> {
    let at = |index: usize| {
        let (frame, pose) = (first + index as u64, &poses[index]);
        let Some(distance) = session.sounding(frame, pose, [pose; 2])? else { return Ok(None) };
        let before = &poses[index.saturating_sub(1)];
        let change = [[before, pose], [pose, before]].map(|levels| session.sounding(frame, pose, levels));
        let [from, to] = change.map(|told| told.map(|told| told.unwrap_or(f64::NAN)));
        let (from, to) = (from?, to?);
        let pop = if from.is_finite() && to.is_finite() { (to - from).abs() } else { f64::NAN };
        Ok(Some((distance, pop)))
    };
    let told: Result<Vec<Option<(f64, f64)>>, FrameError> =
        (0..poses.len()).into_par_iter().map(at).collect();
    let Some(told) = told?.into_iter().collect::<Option<Vec<_>>>() else { return Ok(None) };
    let (distances, pops) = told.into_iter().unzip();
    Ok(Some(PopCurve { name: name.into(), distances, pops }))
}

/// The curve of a generator by its pictures of the middle alone, each of one pixel: for generators that tell no single rays. Its pops are not
/// known.
///
/// # Errors
/// If the generator cannot draw the stage or a pose, or draws no distances.
pub fn curve_of_pictures(
    generator: &dyn Generator,
    stage: &Stage,
    first: u64,
    poses: &[Pose],
) -> Result<PopCurve, StudyError> {
    if !generator.planes().contains(&PlaneKind::Distance) {
        return Err(StudyError::Ladder(format!(
            "generator {} draws no distances along the view axis: choose one that does, as exact, sampled or lod-mesh",
            generator.name()
        )));
    }
    let session = generator.prepare(Stage { view: middle(&stage.view), ..stage.clone() })?;
    let at = |index: usize| {
        let mut planes = Planes::new(1, 1, &[PlaneKind::Distance]);
        session.frame(first + index as u64, &poses[index], &mut planes, &mut Probe::off())?;
        let distance = planes.get(PlaneKind::Distance).and_then(|plane| plane.first().copied());
        let is_ground = |distance: &f32| *distance != PlaneKind::Distance.sky();
        Ok(distance.filter(is_ground).map_or(f64::INFINITY, f64::from))
    };
    let distances: Result<Vec<f64>, FrameError> = (0..poses.len()).map(at).collect();
    Ok(PopCurve { name: generator.name().into(), distances: distances?, pops: vec![f64::NAN; poses.len()] })
}

/// A pixel of a view, in its middle.
fn middle(view: &View) -> View {
    let field = FieldOfView {
        tan_half_width: view.field.tan_half_width / f64::from(view.columns),
        tan_half_height: view.field.tan_half_height / f64::from(view.lines),
    };
    View { columns: 1, lines: 1, field, ..view.clone() }
}

impl PopCurve {
    /// Whether the view axis meets ground in a frame at least.
    pub fn meets_ground(&self) -> bool {
        self.distances.iter().any(|distance| distance.is_finite())
    }

    /// Curve - truth (m), frame by frame; NaN where an axis meets no ground.
    pub fn off(&self, truth: &Self) -> Vec<f64> {
        let pairs = self.distances.iter().zip(&truth.distances);
        pairs
            .map(|(own, truth)| if own.is_finite() && truth.is_finite() { own - truth } else { f64::NAN })
            .collect()
    }

    /// Figures against the truth; `first` is the number of the first frame.
    pub fn figures(&self, truth: &Self, first: u64) -> PopFigures {
        let off = self.off(truth);
        let known: Vec<f64> = off.iter().copied().filter(|off| off.is_finite()).collect();
        let squares = known.iter().map(|off| off * off).sum::<f64>();
        let jumps = (1..).zip(off.windows(2)).map(|(index, pair)| (index, pair[1] - pair[0]));
        let pops = self.pops.iter().copied().enumerate();
        PopFigures {
            name: self.name.clone(),
            rms_m: if known.is_empty() { f64::NAN } else { (squares / known.len() as f64).sqrt() },
            largest_jump: largest(jumps, first),
            largest_pop: largest(pops, first),
            pops: self.pops.iter().filter(|pop| **pop > LEAST_POP).count(),
        }
    }
}

/// The value that is largest in size, the first of equals; values that are no numbers do not count.
fn largest(values: impl Iterator<Item = (usize, f64)>, first: u64) -> Option<AtFrame> {
    let known = values.filter(|(_, value)| value.is_finite());
    let larger =
        |most: (usize, f64), next: (usize, f64)| if next.1.abs() > most.1.abs() { next } else { most };
    known.reduce(larger).map(|(index, metres)| AtFrame { frame: first + index as u64, metres })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(distances: &[f64], pops: &[f64]) -> PopCurve {
        PopCurve { name: "it".into(), distances: distances.into(), pops: pops.into() }
    }

    #[test]
    fn figures_are_against_the_truth() {
        let truth = curve(&[100.0, 90.0, 80.0, 70.0], &[0.0; 4]);
        let own = curve(&[101.0, 92.0, 79.0, 70.0], &[0.0, 0.5, 3.0, 1e-12]);
        let figures = own.figures(&truth, 20);
        // Off by 1, 2, -1 and 0.
        assert!((figures.rms_m - 1.5_f64.sqrt()).abs() < 1e-12);
        assert_eq!(figures.largest_jump, Some(AtFrame { frame: 22, metres: -3.0 }));
        assert_eq!(figures.largest_pop, Some(AtFrame { frame: 22, metres: 3.0 }));
        assert_eq!(figures.pops, 2);
    }

    #[test]
    fn sky_counts_in_no_figure() {
        let truth = curve(&[100.0, f64::INFINITY, 80.0], &[0.0; 3]);
        let own = curve(&[103.0, 92.0, f64::INFINITY], &[0.0, f64::NAN, f64::NAN]);
        let figures = own.figures(&truth, 0);
        assert_eq!((figures.rms_m, figures.largest_jump, figures.pops), (3.0, None, 0));
        assert_eq!(figures.largest_pop, Some(AtFrame { frame: 0, metres: 0.0 }));
    }
}
