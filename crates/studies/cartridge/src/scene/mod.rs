//! Scenes: what is run.

pub mod drum;
pub mod ground;
pub mod machine;
pub mod noise;
pub mod part;
pub mod photograph;
pub mod scenario;
pub mod turn;
pub mod view;

use serde::Deserialize;

use crate::engine::Engine;
use crate::reading::Reading;

/// The scene that is run, by its kind.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum CartridgeScene {
    /// The whole machine, or `exact`, over a ground: one frame.
    Machine(machine::MachineScene),
    /// One analog part on the bench.
    Part(part::PartScene),
    /// The deviates that noise is made of.
    Noise(noise::NoiseScene),
    /// One drum behind a storage buffer.
    Drum(drum::DrumScene),
    /// A view that turns on the spot, and the drums that bring what it comes to show.
    Turn(turn::TurnScene),
    /// Pixels, the rays through them, and pixels again.
    View(view::ViewScene),
    /// Frames of a whole scenario, drawn by the machine or by any generator.
    Scenario(scenario::ScenarioScene),
}

/// Runs of a scene at most: models by headings by grounds.
const MOST_RUNS: usize = 1000;

/// One run of a scene: one hardware model, one heading, one ground.
#[derive(Debug, Clone)]
pub enum Case {
    Machine(Box<machine::MachineCase>),
    Part(part::PartCase),
    Noise(noise::NoiseCase),
    Drum(drum::DrumCase),
    Turn(turn::TurnCase),
    View(view::ViewScene),
    Scenario(Box<scenario::ScenarioCase>),
}

/// What came of a run.
#[derive(Debug, Clone)]
pub enum Seen {
    Machine(Box<machine::Drawn>),
    Part(part::Output),
    Noise(noise::Deviates),
    Drum(drum::Waits),
    Turn(turn::Turned),
    View(view::Trips),
    Scenario(Vec<scenario::Frame>),
}

impl CartridgeScene {
    /// Its word in files.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Machine(_) => "machine",
            Self::Part(_) => "part",
            Self::Noise(_) => "noise",
            Self::Drum(_) => "drum",
            Self::Turn(_) => "turn",
            Self::View(_) => "view",
            Self::Scenario(_) => "scenario",
        }
    }

    /// Whether an engine runs scenes of this kind.
    pub fn is_for(&self, engine: Engine) -> bool {
        match self {
            Self::Machine(_) => engine.has_signals() || engine.is_judge(),
            Self::Scenario(_) => engine != Engine::Part,
            _ => engine == Engine::Part,
        }
    }

    /// Every run that the scene means.
    pub fn cases(&self) -> Result<Vec<Case>, String> {
        let cases: Vec<Case> = match self {
            Self::Machine(scene) => {
                scene.cases()?.into_iter().map(|case| Case::Machine(Box::new(case))).collect()
            }
            Self::Part(scene) => scene.cases()?.into_iter().map(Case::Part).collect(),
            Self::Noise(scene) => scene.cases()?.into_iter().map(Case::Noise).collect(),
            Self::Drum(scene) => scene.cases()?.into_iter().map(Case::Drum).collect(),
            Self::Turn(scene) => scene.cases()?.into_iter().map(Case::Turn).collect(),
            Self::View(scene) => scene.checked().map(|()| vec![Case::View(scene.clone())])?,
            Self::Scenario(scene) => vec![Case::Scenario(Box::new(scene.case()?))],
        };
        match cases.len() {
            0 => Err("the scene means no run at all: a list of it is empty".into()),
            1..=MOST_RUNS => Ok(cases),
            count => Err(format!("the scene means {count} runs: expected at most {MOST_RUNS}")),
        }
    }
}

impl Case {
    /// Returns the case in words, for messages.
    pub fn what(&self) -> String {
        match self {
            Self::Machine(case) => case.what(),
            Self::Part(case) => case.model.name.clone(),
            Self::Noise(case) => case.model.name.clone(),
            Self::Drum(case) => case.model.name.clone(),
            Self::Turn(case) => case.model.name.clone(),
            Self::View(_) => "all views".into(),
            Self::Scenario(case) => case.what(),
        }
    }

    /// Columns and lines of the picture of a scenario; `None` of other kinds.
    pub fn size(&self) -> Option<[usize; 2]> {
        if let Self::Scenario(case) = self { Some(case.size()) } else { None }
    }

    /// Runs it on an engine, and keeps what the readings look at.
    pub fn run(&self, engine: Engine, readings: &[&Reading]) -> Result<Seen, String> {
        Ok(match self {
            Self::Machine(case) => Seen::Machine(Box::new(case.draw(engine, readings)?)),
            Self::Part(case) => Seen::Part(case.run()),
            Self::Noise(case) => Seen::Noise(case.run()),
            Self::Drum(case) => Seen::Drum(case.run()),
            Self::Turn(case) => Seen::Turn(case.run()?),
            Self::View(scene) => Seen::View(scene.run()),
            Self::Scenario(case) => Seen::Scenario(case.draw(engine)?),
        })
    }
}

/// `value` is within a range that its key allows.
pub(crate) fn within(key: &str, value: f64, low: f64, high: f64) -> Result<(), String> {
    match (low..=high).contains(&value) {
        true => Ok(()),
        false => Err(format!("{key} = {value}: expected {low} to {high}")),
    }
}
