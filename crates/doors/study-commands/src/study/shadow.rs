//! `lunoid study shadow`: the edge of the vehicle's shadow on flat ground against that on true ground.

use std::path::PathBuf;

use clap::Args;
use front_door::Opened;
use machine::MachineStage;
use quantities::radians;
use scenario::{PoseRow, PoseTable};
use study::Effort;
use study::report::{ShadowReport, is_of};
use study::shadow::{FlatGroundPlan, LawOutcome, flat_ground, laws};
use vehicle_shadow::{Mast, Shape};

use super::error::frames;
use super::outputs::Outputs;
use command_line::loading::{StageArgs, Threads, machine_stage};
use command_line::output::{Place, warn};
use command_line::program::COMMIT;
use command_line::{Failure, Verdict, values};

/// Elevations of the sun where none are given (degrees): those of the page's table.
const ELEVATIONS: [f64; 3] = [30.0, 16.7, 8.0];
/// Repetitions that are timed.
const REPETITIONS: u32 = 3;

const AFTER: &str = "Examples:
  lunoid study shadow scenarios/vehicle-shadow.toml
  lunoid study shadow scenarios/vehicle-shadow.toml --vehicle rover --sun 45 --sun 10
  lunoid study shadow scenarios/showpiece.toml --places 200 --azimuths 24 --out studies/shadow
  lunoid study shadow scenarios/vehicle-shadow.toml --vehicle rover --laws --frame 33

Row `own` is the scenario's sun at each frame's time; each --sun stands at every azimuth. `off
formula` is the largest difference between the measured error and the report's formula with the
height z that was found. --laws draws pictures by every law and method of `lunoid augment`,
against true ground without rounding: how much is dark, which part of the pixels is off by more
than half their light, and the time. --out gets shadow.json, shadow.csv with every edge,
shadow.md and a plot of error over height, with --laws one of error over time. The exit status
is 1 if an error differs from the formula by more than 1e-9 rad. docs/blocks/vehicle-shadow.md
has the law.";

/// The vehicle's shadow: where flat ground has its edge, and where true ground has it.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct ShadowStudy {
    /// Scenario file: its ground, its path, its sun.
    #[arg(value_parser = values::scenario)]
    scenario: PathBuf,
    #[command(flatten)]
    threads: Threads,
    /// Take the top of this vehicle, and the scenario's eye height: lander, rover, flag, package, marker, or a shape
    /// file. The report's if left out: its top at 10 feet, its view port at 5.
    #[arg(long, value_name = "SHAPE")]
    vehicle: Option<String>,
    /// Height of the view port above the ground.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    eye_height: Option<f64>,
    /// Elevation of a sun in degrees, 0.1 to 89; may be given several times. 30, 16.7 and 8 if left out.
    #[arg(long, value_name = "DEG", value_parser = elevation)]
    sun: Vec<f64>,
    /// Places along the path, at most one a frame.
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = values::whole(1..=1000_u16))]
    places: u16,
    /// Azimuths of each sun at each place.
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = values::whole(1..=360_u16))]
    azimuths: u16,
    /// Draw by every law and method as well.
    #[arg(long, requires = "vehicle")]
    laws: bool,
    /// Frame to draw; up to three times. The middle of the mission if left out.
    #[arg(long, value_name = "F", requires = "laws", value_parser = values::at_least(0_u64))]
    frame: Vec<u64>,
    /// Repetitions of each frame that are timed.
    #[arg(long, value_name = "N", default_value_t = REPETITIONS, requires = "laws", value_parser = values::whole(1..=1000_u32))]
    repetitions: u32,
    #[command(flatten)]
    outputs: Outputs,
}

/// What casts the shadow.
struct Caster {
    mast: Mast,
    shape: Option<Shape>,
}

fn elevation(text: &str) -> Result<f64, String> {
    let sound = |degrees: &f64| (0.1..=89.0).contains(degrees);
    values::finite(text).ok().filter(sound).ok_or_else(|| "expected degrees from 0.1 to 89".into())
}

impl ShadowStudy {
    /// Runs the study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let stage = StageArgs::of(&self.scenario);
        let vehicle = self.vehicle.iter().map(|shape| Place::file("--vehicle", shape));
        let sources: Vec<Place> = stage.sources().into_iter().chain(vehicle).collect();
        self.outputs.expect_apart(|file| is_of("shadow", file), &sources)?;
        let opened = stage.load()?;
        let drawn = if self.laws { frames(&self.frame, opened.frames())? } else { Vec::new() };
        let Caster { mast, shape } = self.caster(&opened)?;
        let pool = self.threads.pool()?;
        let stage = machine_stage(&opened, &pool)?;
        let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
        let path = PoseTable::resolve(&opened.scenario, &stage.landscape, update, yoke, 0..opened.frames())
            .map_err(Failure::input)?;
        let path = path.rows();
        let elevations = if self.sun.is_empty() { &ELEVATIONS[..] } else { &self.sun };
        let plan = FlatGroundPlan {
            mast,
            elevations: elevations.iter().copied().map(radians).collect(),
            places: self.places.into(),
            azimuths: self.azimuths.into(),
        };
        let raster = &stage.settings.raster;
        let outcome = ShadowReport {
            commit: COMMIT.into(),
            mast,
            line_rad: 2.0 * raster.field.tan_half_height / f64::from(raster.lines),
            suns: flat_ground(&stage, path, &plan),
            laws: match shape.filter(|_| self.laws) {
                Some(shape) => pool.install(|| self.draw(&stage, path, &drawn, &shape))?,
                None => Vec::new(),
            },
            title: opened.scenario.title,
        };
        if let Some(folder) = &self.outputs.out {
            outcome.leave(folder)?;
        }
        self.outputs.print(&outcome.json(), &outcome.text())?;
        Ok(if outcome.holds() { Verdict::Yes } else { Verdict::No })
    }

    /// Pictures of the frames `drawn` of the whole `path`, by every law and method.
    fn draw(
        &self,
        stage: &MachineStage,
        path: &[PoseRow],
        drawn: &[u64],
        shape: &Shape,
    ) -> Result<Vec<LawOutcome>, Failure> {
        self.outputs.say("laws and methods");
        let rows: Vec<PoseRow> = drawn.iter().map(|&frame| path[frame as usize]).collect();
        let raster = &stage.settings.raster;
        let size = [raster.columns as usize, raster.lines as usize];
        Ok(laws(stage, &rows, shape, size, Effort { repetitions: self.repetitions })?)
    }

    fn caster(&self, opened: &Opened) -> Result<Caster, Failure> {
        let Some(name) = &self.vehicle else {
            let mast = Mast { eye: self.eye_height.unwrap_or(Mast::REPORT.eye), ..Mast::REPORT };
            return Ok(Caster { mast, shape: None });
        };
        let eye = self.eye_height.unwrap_or(opened.scenario.vehicle.eye_height);
        let shape = Shape::find(name, eye)?;
        shape.notes().iter().for_each(|note| warn(note));
        let top = shape.top();
        match top > 0.0 {
            true => Ok(Caster { mast: Mast { top, eye }, shape: Some(shape) }),
            false => Err(Failure::input(format!(
                "--vehicle {name}: its highest point lies {top} m above its foot point; expected a vehicle above 0"
            ))),
        }
    }
}
