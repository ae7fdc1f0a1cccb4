//! Plots of the study of the vehicle's shadow: error over the height of the ground, error of laws and methods over time.

use std::path::Path;

use crate::shadow::{FlatGroundOutcome, LawOutcome, SeenEdge};
use plots::{Axis, Panel, PointSeries, Trace, TraceLook, ladder_picture, trace_picture};
use vehicle_shadow::{Mast, flat_error, small_flat_error};

use super::folder::{ReportError, save};
use super::shadow::ShadowReport;

const WIDTH: u32 = 700;
/// Most marks of a panel: more would cover the curve.
const MARKS: usize = 60;
/// Half the height of a mark, of that of the panel.
const MARK: f64 = 0.03;
/// Points of a curve.
const CURVE: usize = 200;

/// `shadow.svg` and `laws.svg`, each with its PNG, where there is something to draw.
pub fn write_plots(folder: &Path, outcome: &ShadowReport) -> Result<(), ReportError> {
    flat_ground(folder, outcome)?;
    laws(folder, outcome)
}

/// A panel for each sun: measured error over z, with the formula's curve and its form for small angles.
fn flat_ground(folder: &Path, outcome: &ShadowReport) -> Result<(), ReportError> {
    let Some(suns) = outcome.seen() else { return Ok(()) };
    let curves: Vec<Curves> = suns.iter().map(|sun| Curves::of(outcome.mast, &sun.edges)).collect();
    let panels: Vec<Panel<'_>> = suns.iter().zip(&curves).map(|(sun, curves)| panel(sun, curves)).collect();
    let look = TraceLook {
        facts: vec![outcome.facts()],
        width: WIDTH,
        ..TraceLook::titled("Angle between the edge on true ground and on flat ground")
    };
    let x = Axis::new("z, height of the edge on true ground over the foot (m)");
    save(folder, "shadow", trace_picture(&x, &panels, &[], &look))
}

/// Points of error and time, but for the reference and for whatever has no error.
fn laws(folder: &Path, outcome: &ShadowReport) -> Result<(), ReportError> {
    let off = || outcome.laws.iter().filter(|law| law.rms > 0.0 && law.time_s[0] > 0.0);
    if off().next().is_none() {
        return Ok(());
    }
    let series = |ground| {
        let of = move |law: &&LawOutcome| law.law.starts_with(ground);
        let label = |law: &LawOutcome| format!("{}, {}", law.law, law.method);
        let found: Vec<&LawOutcome> = off().filter(of).collect();
        let labels: Vec<String> = found.iter().map(|law| label(law)).collect();
        let points: Vec<[f64; 2]> = found.iter().map(|law| [1e3 * law.time_s[0], law.rms]).collect();
        (ground, points, labels)
    };
    let all = ["true ground", "flat ground"].map(series);
    let drawn: Vec<PointSeries<'_>> = all
        .iter()
        .map(|(name, points, labels)| PointSeries {
            name,
            points: points.clone(),
            labels: labels.iter().map(String::as_str).collect(),
            joined: false,
        })
        .collect();
    let look = TraceLook {
        title: "Laws and methods against true ground without rounding".into(),
        facts: vec![outcome.facts()],
        width: WIDTH,
        height: 400,
    };
    let axes = ["time (ms a picture, median)", "rms of the dark share"];
    save(folder, "laws", ladder_picture(axes, &drawn, &[], &[], &look))
}

/// What a panel shows, over z (m) in mrad.
struct Curves {
    z: Vec<f64>,
    formula: Vec<f64>,
    small: Vec<f64>,
    /// Short upright strokes, with breaks between them.
    marks: [Vec<f64>; 2],
}

impl Curves {
    /// Of the edges, at least one, under suns of one elevation.
    fn of(mast: Mast, edges: &[SeenEdge]) -> Self {
        let extreme = |pick: fn(f64, f64) -> f64, of: fn(&SeenEdge) -> f64| {
            edges.iter().map(of).reduce(pick).unwrap_or_default()
        };
        let [low, high] = [f64::min, f64::max].map(|pick| extreme(pick, |edge| edge.rise));
        let distance = edges[0].distance;
        let z: Vec<f64> = (0..=CURVE).map(|step| low + (high - low) * step as f64 / CURVE as f64).collect();
        let along = |law: fn(f64, f64, f64, f64) -> f64| -> Vec<f64> {
            z.iter().map(|z| 1e3 * law(mast.top, mast.eye, *z, distance)).collect()
        };
        let half = MARK * 1e3 * extreme(f64::max, |edge| edge.measured);
        let mut by_rise: Vec<&SeenEdge> = edges.iter().collect();
        by_rise.sort_by(|a, b| a.rise.total_cmp(&b.rise));
        let marked = || by_rise.iter().step_by(edges.len().div_ceil(MARKS));
        let strokes = |edge: &&SeenEdge| [1e3 * edge.measured - half, 1e3 * edge.measured + half, f64::NAN];
        let marks =
            [marked().flat_map(|edge| [edge.rise; 3]).collect(), marked().flat_map(strokes).collect()];
        Self { formula: along(flat_error), small: along(small_flat_error), marks, z }
    }
}

fn panel<'a>(sun: &FlatGroundOutcome, curves: &'a Curves) -> Panel<'a> {
    let [x, y] = &curves.marks;
    let traces = vec![
        Trace { name: "measured", x, y },
        Trace { name: "formula", x: &curves.z, y: &curves.formula },
        Trace { name: "for small angles", x: &curves.z, y: &curves.small },
    ];
    let elevation = sun.elevation_deg.unwrap_or_default();
    Panel { axis: Axis::new(format!("mrad, sun at {elevation:.1} deg")), traces }
}
