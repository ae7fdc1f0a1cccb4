//! `lunoid study shadow`: the edge of the vehicle's shadow on flat ground against that on true ground.

use std::path::{Path, PathBuf};

use clap::Args;
use plots::{Axis, Panel, Trace, TraceLook, trace_picture};
use quantities::radians;
use scenario::PoseTable;
use serde_json::{Value, json};
use study::shadow::{FlatGroundOutcome, FlatGroundPlan, SeenEdge, csv, flat_ground, table};
use vehicle_shadow::{Mast, Shape, flat_error, small_flat_error};

use super::outputs::{Outputs, markdown, write};
use super::plots::save;
use crate::cli::COMMIT;
use crate::loading::{Loaded, StageArgs, Threads};
use crate::output::table as columns;
use crate::{Failure, Verdict, values};

/// Elevations of the sun where none are given (degrees): those of the page's table.
const ELEVATIONS: [f64; 3] = [30.0, 16.7, 8.0];
/// Most marks of a panel: more would cover the curve.
const MARKS: usize = 60;
/// Half the height of a mark, of that of the panel.
const MARK: f64 = 0.03;
/// Points of a curve.
const CURVE: usize = 200;

const AFTER: &str = "Examples:
  lunoid study shadow scenarios/vehicle-shadow.toml
  lunoid study shadow scenarios/vehicle-shadow.toml --vehicle rover --sun 45 --sun 10
  lunoid study shadow scenarios/showpiece.toml --places 200 --azimuths 24 --out studies/shadow

Row `own` is the scenario's sun at each frame's time; each --sun stands at every azimuth. `off formula` is the largest
difference between the measured error and the report's formula with the height z that was found.
--out gets shadow.json, shadow.csv with every edge, shadow.md and a plot of error over height. The exit status is 1 if
an error differs from the formula by more than 1e-9 rad. docs/blocks/vehicle-shadow.md has the law.";

/// The vehicle's shadow: where flat ground has its edge, and where true ground has it.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct ShadowStudy {
    /// Scenario file: its ground, its path, its sun.
    scenario: PathBuf,
    #[command(flatten)]
    threads: Threads,
    /// Take the top of this vehicle, and the scenario's eye height: lander, rover, flag, package, marker, or a Wavefront
    /// OBJ file. The report's if left out: its top at 10 feet, its view port at 5.
    #[arg(long, value_name = "SHAPE")]
    vehicle: Option<String>,
    /// Height of the view port above the ground.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    eye_height: Option<f64>,
    /// Elevation of a sun in degrees, 0.1 to 89; may be given several times. 30, 16.7 and 8 if left out.
    #[arg(long, value_name = "DEG", value_parser = elevation)]
    sun: Vec<f64>,
    /// Places along the path, at most one a frame.
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u16).range(1..=1000))]
    places: u16,
    /// Azimuths of each sun at each place.
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u16).range(1..=360))]
    azimuths: u16,
    #[command(flatten)]
    outputs: Outputs,
}

/// What came of it.
struct Outcome {
    title: String,
    mast: Mast,
    /// Height of a line of the picture, at its middle (rad).
    line_rad: f64,
    suns: Vec<FlatGroundOutcome>,
}

fn elevation(text: &str) -> Result<f64, String> {
    let sound = |degrees: &f64| (0.1..=89.0).contains(degrees);
    values::finite(text).ok().filter(sound).ok_or_else(|| "expected degrees from 0.1 to 89".into())
}

impl ShadowStudy {
    /// Studies.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let mut loaded = StageArgs::of(&self.scenario).load()?;
        let mast = self.mast(&loaded)?;
        let pool = self.threads.pool()?;
        let stage = loaded.stage(&pool)?;
        let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
        let path = PoseTable::resolve(&loaded.scenario, &stage.landscape, update, yoke, 0..loaded.frames());
        let elevations = if self.sun.is_empty() { &ELEVATIONS[..] } else { &self.sun };
        let plan = FlatGroundPlan {
            mast,
            elevations: elevations.iter().copied().map(radians).collect(),
            places: self.places.into(),
            azimuths: self.azimuths.into(),
        };
        let raster = &stage.settings.raster;
        let outcome = Outcome {
            mast,
            line_rad: 2.0 * raster.field.tan_half_height / f64::from(raster.lines),
            suns: flat_ground(&stage, path.map_err(Failure::input)?.rows(), &plan),
            title: loaded.scenario.title,
        };
        if let Some(folder) = &self.outputs.out {
            write(folder, "shadow", &outcome.json(), &csv(&outcome.suns), &outcome.page())?;
            outcome.plot(folder)?;
        }
        self.outputs.print(&outcome.json(), &outcome.text())?;
        let holds = outcome.suns.iter().all(FlatGroundOutcome::holds);
        Ok(if holds { Verdict::Yes } else { Verdict::No })
    }

    fn mast(&self, loaded: &Loaded) -> Result<Mast, Failure> {
        let Some(name) = &self.vehicle else {
            return Ok(Mast { eye: self.eye_height.unwrap_or(Mast::REPORT.eye), ..Mast::REPORT });
        };
        let eye = self.eye_height.unwrap_or(loaded.scenario.vehicle.eye_height);
        let top = Shape::find(name, eye)?.top();
        match top > 0.0 {
            true => Ok(Mast { top, eye }),
            false => Err(Failure::input(format!(
                "--vehicle {name}: its highest point lies {top} m above its foot point; expected a vehicle above 0"
            ))),
        }
    }
}

impl Outcome {
    fn json(&self) -> Value {
        json!({
            "schema": "lunoid.study-shadow/1",
            "commit": COMMIT,
            "title": self.title,
            "top_m": self.mast.top,
            "eye_m": self.mast.eye,
            "line_rad": self.line_rad,
            "holds": self.suns.iter().all(FlatGroundOutcome::holds),
            "suns": self.suns,
        })
    }

    fn facts(&self) -> String {
        let (Mast { top, eye }, line) = (self.mast, 1e3 * self.line_rad);
        format!("{}, top {top:.3} m, eye {eye:.3} m, a line {line:.2} mrad, commit {COMMIT}", self.title)
    }

    fn rows(&self) -> Vec<Vec<String>> {
        table(&self.suns, self.line_rad)
    }

    fn text(&self) -> String {
        format!("{}\n\n{}", self.facts(), columns(&self.rows()))
    }

    /// The same as a page of Markdown.
    fn page(&self) -> String {
        let plot =
            if self.seen().is_some() { "![Error over height of the ground](shadow.svg)\n\n" } else { "" };
        format!("{}.\n\n{plot}{}", self.facts(), markdown(&self.rows()))
    }

    /// Suns of one elevation under which edges are seen; none where there is nothing to draw.
    fn seen(&self) -> Option<Vec<&FlatGroundOutcome>> {
        let seen: Vec<_> =
            self.suns.iter().filter(|sun| sun.elevation_deg.is_some() && sun.seen > 0).collect();
        (!seen.is_empty()).then_some(seen)
    }

    /// A panel for each sun: measured error over z, with the formula's curve and its form for small angles.
    fn plot(&self, folder: &Path) -> Result<(), Failure> {
        let Some(suns) = self.seen() else { return Ok(()) };
        let curves: Vec<Curves> = suns.iter().map(|sun| Curves::of(self.mast, &sun.edges)).collect();
        let panels: Vec<Panel<'_>> =
            suns.iter().zip(&curves).map(|(sun, curves)| panel(sun, curves)).collect();
        let look = TraceLook {
            facts: vec![self.facts()],
            width: 700,
            ..TraceLook::titled("Angle between the edge on true ground and on flat ground")
        };
        let x = Axis::new("z, height of the edge on true ground over the foot (m)");
        save(folder, "shadow", &trace_picture(&x, &panels, &[], &look))
    }
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
        let every = edges.len().div_ceil(MARKS);
        let marked = || edges.iter().step_by(every);
        let strokes = |edge: &SeenEdge| [1e3 * edge.measured - half, 1e3 * edge.measured + half, f64::NAN];
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
