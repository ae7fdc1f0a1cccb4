//! Frames of a whole scenario, by any generator.

use std::collections::BTreeMap;
use std::sync::Arc;

use control_plane::MachineStage;
use diagnostics::{ProblemList, ProblemRecord, Problems, TomlFile};
use generator::{FrameCounts, Generator, PlaneKind, Planes, Row, Session, Weight};
use hardware_model::{HardwareModel, ModelSource};
use scenario::{Pose, PoseTable, Scalar, Scenario};
use serde::Deserialize;
use signal::Probe;
use toml::Table;

use super::photograph::InlinePhotograph;
use crate::engine::Engine;

/// Some frames of a scenario, one after the other.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ScenarioScene {
    /// Numbers of the frames that are drawn, in order.
    pub frames: Vec<u64>,
    /// The scenario: keys of a scenario file. It names no other file.
    #[cfg_attr(test, schemars(with = "serde_json::Map<String, serde_json::Value>"))]
    pub scenario: Table,
    /// Channel of the scenario that is looked through; without it, the vehicle's own camera.
    pub channel: Option<String>,
    /// Figures of what a generator runs on: tables of its file of figures, over those that ship.
    #[serde(default)]
    #[cfg_attr(test, schemars(with = "serde_json::Map<String, serde_json::Value>"))]
    pub gear: Table,
    /// Photographs of the ground, in place of the files that a scenario names.
    #[serde(default, rename = "photograph")]
    pub photographs: Vec<InlinePhotograph>,
}

/// Frames of a scene at most.
const MOST_FRAMES: usize = 1000;

/// A scenario on its ground.
#[derive(Debug, Clone)]
pub struct ScenarioCase {
    /// The vehicle's pose in each frame that is drawn, with the number of the frame.
    pub poses: Vec<(u64, Pose)>,
    scenario: Scenario,
    stage: MachineStage,
    texts: [String; 2],
}

/// What came of a frame.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Planes that the engine draws, by name, each line by line.
    pub planes: BTreeMap<&'static str, Vec<f32>>,
    /// What the frame took and lost.
    pub counts: FrameCounts,
}

impl ScenarioScene {
    pub(super) fn case(&self) -> Result<ScenarioCase, String> {
        self.expect_frames()?;
        self.expect_gear()?;
        let text = |table: &Table| toml::to_string(table).map_err(|error| error.to_string());
        let texts = [text(&self.scenario)?, text(&self.gear)?];
        let scenario = self.read(&texts)?;
        let settings =
            front_door::settings(&scenario, &model(&scenario)?).map_err(|error| error.to_string())?;
        let (update, yoke) = (settings.timebase.update, settings.yoke);
        let (first, last) = (self.frames[0], self.frames[self.frames.len() - 1]);
        let end = scenario.frames(update);
        if last >= end {
            return Err(format!("frames: {last}: expected below {end}, the frames of the scenario"));
        }
        let mut stage = front_door::build(&scenario, settings).map_err(|error| error.to_string())?;
        if !self.photographs.is_empty() {
            let photographs = self.photographs.iter().map(InlinePhotograph::made);
            let photographs = photographs.collect::<Result<Arc<[_]>, String>>()?;
            stage.landscape = Arc::new((*stage.landscape).clone().with_photographs(photographs));
        }
        let table = PoseTable::resolve(&scenario, &stage.landscape, update, yoke, first..last + 1);
        let table = table.map_err(|problems| problems.to_string())?;
        let pose = |&frame: &u64| (frame, table.rows()[(frame - first) as usize].pose);
        let poses = self.frames.iter().map(pose).collect();
        Ok(ScenarioCase { poses, scenario, stage, texts })
    }

    fn expect_frames(&self) -> Result<(), String> {
        if !(1..=MOST_FRAMES).contains(&self.frames.len()) {
            return Err(format!("frames: {} of them: expected 1 to {MOST_FRAMES}", self.frames.len()));
        }
        match self.frames.windows(2).find(|pair| pair[0] >= pair[1]) {
            Some(pair) => Err(format!("frames: {} after {}: expected each once, in order", pair[1], pair[0])),
            None => Ok(()),
        }
    }

    fn expect_gear(&self) -> Result<(), String> {
        let gear = registry::ROWS.iter().filter_map(|row| row.gear);
        let known: Vec<&str> = gear.flat_map(|gear| gear.tables).copied().collect();
        match self.gear.keys().find(|table| !known.contains(&table.as_str())) {
            Some(table) => {
                Err(format!("gear: unknown table `{table}`, expected one of {}", known.join(", ")))
            }
            None => Ok(()),
        }
    }

    /// The scenario through its channel, with the tables of all generators right.
    fn read(&self, texts: &[String; 2]) -> Result<Scenario, String> {
        let scenario = Scenario::parse_beside("scenario", &texts[0], &registry::parameter_tables())
            .map_err(|problems| told(&problems))?;
        for row in registry::ROWS {
            configured(row, texts)?;
        }
        if let Some(file) = scenario.files().first() {
            return Err(format!("scenario: {}: a cartridge is one file; expected no other", file.display()));
        }
        let Some(name) = &self.channel else { return Ok(scenario) };
        scenario.through(name).ok_or_else(|| format!("channel: the scenario has no channel `{name}`"))
    }
}

/// The hardware model that the scenario names; under a generator the ideal machine.
fn model(scenario: &Scenario) -> Result<HardwareModel, String> {
    let name = front_door::base_model(&scenario.machine);
    let loaded = HardwareModel::load(&ModelSource::BuiltIn(name.into()), &[], &[]);
    loaded.map(|loaded| loaded.model).map_err(|problems| told(&problems))
}

impl ScenarioCase {
    pub(super) fn what(&self) -> String {
        self.scenario.title.clone()
    }

    /// Columns and lines of the picture.
    pub fn size(&self) -> [usize; 2] {
        let raster = self.stage.settings.raster;
        [raster.columns as usize, raster.lines as usize]
    }

    /// Tangents of half the field of view, across and upright.
    pub fn tangents(&self) -> [f64; 2] {
        let field = self.stage.settings.raster.field;
        [field.tan_half_width, field.tan_half_height]
    }

    pub(super) fn draw(&self, engine: Engine) -> Result<Vec<Frame>, String> {
        let (session, kinds) = self.session(engine)?;
        let [columns, lines] = self.size();
        let mut planes = Planes::new(columns, lines, &kinds);
        let frame = |(frame, pose): &(u64, Pose)| -> Result<Frame, String> {
            let counts =
                session.frame(*frame, pose, &mut planes, &mut Probe::off()).map_err(|e| e.to_string())?;
            let drawn = kinds.iter().filter_map(|kind| Some((kind.name(), planes.get(*kind)?.to_vec())));
            Ok(Frame { planes: drawn.collect(), counts })
        };
        self.poses.iter().map(frame).collect()
    }

    /// The engine on this stage, and the planes that it draws.
    fn session(&self, engine: Engine) -> Result<(Box<dyn Session>, Vec<PlaneKind>), String> {
        let scalar = if engine == Engine::MachineF32 { Scalar::F32 } else { Scalar::F64 };
        let generator: Arc<dyn Generator> = match engine {
            Engine::Generator(name) => self.generator(name)?,
            Engine::MachineF32 | Engine::MachineF64 | Engine::Part => {
                Arc::new(machine::HybridMachine::new(hardware_model::Settings {
                    scalar,
                    ..self.stage.settings.clone()
                }))
            }
        };
        let kinds = generator.planes().iter().copied().filter(|kind| PlaneKind::ALL.contains(kind)).collect();
        let stage = match generator.remembers_frames() {
            true => front_door::with_course(self.stage.clone(), &self.scenario)
                .map_err(|error| error.to_string())?,
            false => self.stage.clone(),
        };
        let session = generator.prepare(stage.stage()).map_err(|error| error.to_string())?;
        let lacking = session.omissions().into_iter().find(|omission| omission.weight == Weight::NotModelled);
        if let Some(lacking) = lacking {
            return Err(format!(
                "not drawn: {}: {}; leave it out of the scene, or the engine",
                lacking.what, lacking.why
            ));
        }
        Ok((session, kinds))
    }

    fn generator(&self, name: &str) -> Result<Arc<dyn Generator>, String> {
        let row = registry::find(name).ok_or_else(|| format!("no generator is called `{name}`"))?;
        configured(row, &self.texts)
    }
}

/// A generator by the tables of a scenario and of gear, each as text.
fn configured(row: &Row, texts: &[String; 2]) -> Result<Arc<dyn Generator>, String> {
    let problems = Problems::new();
    let file = |name: &str, text: &str| TomlFile::parse(name, text, &problems);
    let layers = [file("scenario", &texts[0]), file("gear", &texts[1])].into_iter().flatten();
    registry::configure(row, layers).map_err(|problems| told(&problems))
}

/// Faults by their keys: lines of a text that is made of the file's tables would mislead.
fn told(problems: &ProblemList) -> String {
    let one = |record: ProblemRecord| {
        let ProblemRecord { file, title, expected, .. } = record;
        let expected = expected.filter(|expected| !title.contains(expected.as_str()));
        let expected = expected.map_or(String::new(), |expected| format!(", expected {expected}"));
        format!("{file}: {title}{expected}")
    };
    problems.records().into_iter().map(one).collect::<Vec<_>>().join("; ")
}
