//! What a state is of: program, machine and mission, as hashes of all that decides a picture.

use generator::Stage;
use hardware_model::{MachineRecord, Settings};
use run_record::{
    ChannelRecord, GroundRecord, PathRecord, Program, SceneryRecord, SunRecord, VehicleRecord, ViewRecord,
    hash,
};
use scenario::Scenario;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::error::{Fault, Other};

/// Whose state it is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Identity {
    /// The program that wrote it.
    pub program: Program,
    /// Name of the hardware model.
    pub machine: String,
    /// Title of the scenario.
    pub scenario: String,
    /// Hashes of what decides a picture.
    pub hashes: Hashes,
}

/// Hashes of what decides a picture: BLAKE3, hexadecimal.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Hashes {
    /// Settings of the machine.
    pub settings: String,
    /// What is asked of a picture: raster, field, clocks, display, laws.
    pub view: String,
    /// Words of the ground.
    pub ground: String,
    /// What lies and stands on the ground.
    pub scenery: String,
    /// Sun, vehicle and path.
    pub mission: String,
}

impl Hashes {
    /// Each hash with the name of what it is of.
    fn named(&self) -> [(&'static str, &str); 5] {
        let Self { settings, view, ground, scenery, mission } = self;
        [
            ("settings of the machine", settings),
            ("view", view),
            ("ground", ground),
            ("scenery", scenery),
            ("sun, vehicle and path", mission),
        ]
    }
}

impl Identity {
    /// That of a machine called `machine` with `settings` in `stage` of `scenario`, as `program` draws it.
    pub fn new(
        program: Program,
        machine: &str,
        scenario: &Scenario,
        (stage, settings): (&Stage, &Settings),
    ) -> Self {
        let of = |value: serde_json::Value| hash(value.to_string().as_bytes());
        let hashes = Hashes {
            settings: of(json!(MachineRecord::of(settings))),
            view: of(json!(ViewRecord::from(&stage.view))),
            ground: of(GroundRecord::new(&scenario.ground, &stage.landscape).content()),
            scenery: of(json!(SceneryRecord::new(stage))),
            mission: of(json!({
                "sun": SunRecord::from(&stage.scenery.sun(0.0)),
                "vehicle": VehicleRecord::from(&scenario.vehicle),
                "waypoints": PathRecord::from(scenario.way()).waypoints_blake3,
                "channel": scenario.channel.as_ref().map(ChannelRecord::from),
            })),
        };
        Self { program, machine: machine.to_owned(), scenario: scenario.title.clone(), hashes }
    }

    /// Refuses a state of `other`; `words` are those with which it was saved.
    pub(crate) fn expect(&self, other: &Self, words: &[String]) -> Result<(), Fault> {
        if self.program != other.program {
            let [found, expected] = [other, self].map(|of| told(&of.program));
            return Err(Fault::Program { found, expected });
        }
        let mut both = other.hashes.named().into_iter().zip(self.hashes.named());
        match both.find(|((_, found), (_, expected))| found != expected) {
            None => Ok(()),
            Some(((what, found), (_, expected))) => {
                let [found, expected] = [found, expected].map(|hash| hash.chars().take(16).collect());
                let machines = [other, self].map(|of| of.machine.clone());
                let words = words.join(" ");
                Err(Fault::Other(Box::new(Other { what, found, expected, machines, words })))
            }
        }
    }
}

/// A program in words.
fn told(program: &Program) -> String {
    let Program { name, version, commit, result_family } = program;
    format!("{name} {version} (commit {commit}, result family {result_family})")
}
