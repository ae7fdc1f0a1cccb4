//! A scenario over surveyed ground.

use std::env;
use std::path::Path;

use compare::{RidgeError, compare, horizon_of_picture, horizon_of_range, ridge_error, ridge_mask};
use control_plane::MachineStage;
use exact::Exact;
use generator::{Generator, PlaneKind, Planes, Session};
use hardware_model::{HardwareModel, Settings};
use landscape::Georeference;
use machine::Prepare;
use picture::{Depth, Encoder, GreyPicture, Transfer};
use quantities::{degrees, radians};
use scenario::{FieldOfView, FieldWish, Pose, PoseTable, RasterWishes, Scenario};
use signal::Probe;
use study::shadow::{FlatGroundOutcome, FlatGroundPlan, flat_ground};
use survey::{ReadOptions, SurveyOptions, SurveyReport, survey};
use vehicle_shadow::Mast;

use crate::shared;

/// Most sweeps of a frame where the environment does not say: enough to see a fault, few enough for every day.
const SWEEPS: u32 = 96;

/// Step of range, as a part of it, that makes a ridge.
const RIDGE: f32 = 0.2;

/// A scenario, its ground and what the survey said of it.
pub struct Drive {
    /// File name of the scenario.
    pub name: &'static str,
    /// Figures of the survey.
    pub report: SurveyReport,
    poses: PoseTable,
    stage: MachineStage,
}

/// How far a frame of the machine is from the closed form.
pub struct Agreement {
    /// Part of the pixels outside the ridge mask that are off by more than two levels of 255.
    pub off: f64,
    /// The same of all pixels.
    pub off_anywhere: f64,
    /// Lines by which the lit horizon is off.
    pub horizon: RidgeError,
}

impl Drive {
    /// Surveys `file` and puts the scenario `name` on it.
    pub fn over(name: &'static str, file: &Path, read: &ReadOptions, options: &SurveyOptions) -> Self {
        let elevation = survey::read(file, read).expect("a readable elevation file");
        let found = survey(&elevation, options, &mut |_| {}).expect("ground that can be fitted");
        let scenario = Scenario::read(shared::scenario(&format!("{name}.toml"))).expect("a sound scenario");
        // Edges of cast shadows have figures of their own: the sheet of the shadow controller.
        let scenario = Scenario { shadows: None, ..scenario };
        let settings = settings(&scenario);
        let stage =
            front_door::over(found.bank, &scenario, settings).unwrap_or_else(|e| panic!("{name}: {e}"));
        let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
        let poses = PoseTable::resolve(&scenario, &stage.landscape, update, yoke, 0..scenario.frames(update))
            .unwrap_or_else(|problems| panic!("{name}: {problems}"));
        Self { name, report: found.report, poses, stage }
    }

    /// Where the ground lies on the Moon.
    pub fn georeference(&self) -> Option<Georeference> {
        self.stage.landscape.bank().georeference()
    }

    /// Every pose has finite pitch and roll of at most `most` degrees, and the vehicle keeps within its limits.
    pub fn expect_upright(&self, most: f64) {
        for row in self.poses.rows() {
            let tilts = [row.pose.attitude.pitch, row.pose.attitude.roll].map(degrees);
            let sound = tilts.iter().all(|tilt| tilt.is_finite() && tilt.abs() <= most);
            assert!(sound, "{} frame {}: pitch and roll {tilts:?} degrees", self.name, row.frame);
        }
        assert!(self.poses.limits().is_empty(), "{}: {:?}", self.name, self.poses.limits());
    }

    /// Edges of the report's mast along the path: the scenario's sun and three others, 24 azimuths of each.
    pub fn shadow_edges(&self) -> Vec<FlatGroundOutcome> {
        let plan = FlatGroundPlan {
            mast: Mast::REPORT,
            elevations: [30.0, 16.7, 8.0].map(radians).to_vec(),
            places: 100,
            azimuths: 24,
        };
        flat_ground(&self.stage, self.poses.rows(), &plan)
    }

    /// Draws a frame with both generators.
    pub fn agreement(&self, frame: u64) -> Agreement {
        let pose = &self.poses.rows()[frame as usize].pose;
        let exact = Exact.prepare(self.stage.stage()).expect("exact draws every landscape");
        let [test, reference] = [self.stage.clone().prepare(), exact].map(|by| self.draw(&*by, frame, pose));
        let [columns, lines] = [test.columns(), test.lines()];
        let range = reference.get(PlaneKind::Range).expect("asked for");
        let mask = ridge_mask(range, columns, lines, RIDGE).expect("a range plane");
        let [a, b] = [&test, &reference].map(|planes| self.grey(planes));
        let off = |mask| compare(&a, &b, mask, &[2]).expect("pictures of one size").beyond[0].share;
        let crest = horizon_of_range(range, columns, lines).expect("a range plane");
        let horizon = lit_horizon_error(&a, &b, &crest);
        Agreement { off: off(Some(&mask)), off_anywhere: off(None), horizon }
    }

    fn draw(&self, session: &dyn Session, frame: u64, pose: &Pose) -> Planes {
        let raster = &self.stage.settings.raster;
        let kinds = [PlaneKind::Intensity, PlaneKind::Range];
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &kinds);
        session
            .frame(frame, pose, &mut planes, &mut Probe::new(Vec::new(), 0..0))
            .expect("a pose that can be drawn");
        planes
    }

    fn grey(&self, planes: &Planes) -> GreyPicture {
        let display = &self.stage.settings.display;
        let transfer = Transfer::new(display.white as f32, display.gamma as f32).expect("a display law");
        let intensity = planes.get(PlaneKind::Intensity).expect("asked for");
        let encoder = Encoder::new(transfer, Depth::Eight);
        encoder.encode(intensity, planes.columns(), planes.lines()).expect("finite intensities")
    }
}

/// Lines by which the horizon of `test` is off, over the columns whose crest is lit: a dark crest is as black as the
/// sky.
fn lit_horizon_error(test: &GreyPicture, reference: &GreyPicture, crest: &[Option<usize>]) -> RidgeError {
    let [seen, expected] = [test, reference].map(|picture| horizon_of_picture(picture, 0));
    // The range plane holds for the middle of a line, the picture for all of it.
    let is_lit = |column: &usize| {
        expected[*column].zip(crest[*column]).is_some_and(|(lit, crest)| lit.abs_diff(crest) <= 1)
    };
    let lit = |horizon: &[Option<usize>]| -> Vec<_> {
        (0..crest.len()).filter(is_lit).map(|column| horizon[column]).collect()
    };
    ridge_error(&lit(&seen), &lit(&expected), 0).expect("horizons of one width")
}

/// What the scenario comes to on its own machine, the ideal one: the columns in the middle of its picture, with the
/// angles between sweeps and between lines that the whole picture has.
fn settings(scenario: &Scenario) -> Settings {
    let asked = env::var("LUNOID_REAL_GROUND_SWEEPS").ok();
    let most = asked.map_or(SWEEPS, |text| text.parse().expect("a whole number of sweeps"));
    let FieldWish::Both(field) = scenario.field else { panic!("both angles") };
    let raster = resolve(scenario, field, RasterWishes::default()).raster;
    let sweeps = most.min(raster.sweeps);
    let share = f64::from(sweeps) / f64::from(raster.sweeps);
    let field = FieldOfView { tan_half_width: share * field.tan_half_width, ..field };
    let wishes = RasterWishes { sweeps: Some(sweeps), lines: Some(raster.lines), ..RasterWishes::default() };
    resolve(scenario, field, wishes)
}

fn resolve(scenario: &Scenario, field: FieldOfView, wishes: RasterWishes) -> Settings {
    let wished =
        Scenario { field: FieldWish::Both(field), raster: wishes.or(scenario.raster), ..scenario.clone() };
    front_door::settings(&wished, &HardwareModel::ideal())
        .expect("a scenario that goes with the ideal machine")
}
