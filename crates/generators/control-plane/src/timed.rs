//! The control plane as a job that takes time, and what decides its timing in one hash.

use generator::{FrameError, InputsHash, Timed};
use hardware_model::{BankPlace, Economy, LevelTurn, ShadowParts};
use quantities::Rate;
use scenario::{Pose, Scenario};
use timing::{FrameTiming, Task};

use crate::control_plane::ControlPlane;
use crate::stage::MachineStage;

impl Timed for ControlPlane {
    fn master(&self) -> Rate {
        self.stage().settings.timebase.master
    }

    fn inputs(&self, scenario: &Scenario) -> String {
        inputs_hash(scenario, self.stage())
    }

    fn before_mission(&self, first: &Pose) -> Result<Vec<Task>, FrameError> {
        Self::before_mission(self, first)
    }

    fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        Self::frame(self, frame, pose)
    }

    fn frame_for_totals(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        Self::frame_for_totals(self, frame, pose)
    }
}

/// Hash of everything that decides the timing of a mission: ground, bodies, path, and the settings of the digital side.
/// Neither the frames that are recorded nor analog parts and display are in it: they change no event; light only where
/// shadows have a timing.
fn inputs_hash(scenario: &Scenario, stage: &MachineStage) -> String {
    let MachineStage { landscape, scenery, settings } = stage;
    let mut hash = InputsHash::new("lunoid timing, inputs, format 1");
    hash.add_bank(landscape);
    hash.add_way(scenario);
    for standing in scenery.standing() {
        hash.add("body", &(standing.from, standing.until, standing.body.vertices().len()));
    }
    let raster = &settings.raster;
    hash.add("raster", &(raster.sweeps, raster.samples, raster.field, settings.timebase));
    hash.add("fan", &(settings.laws.projection, settings.range, settings.yoke, settings.levels));
    // Bodies that are too small to be seen are not transformed. Nothing else of the economy changes an event.
    let small = if settings.economy.leaves_out_small_bodies() { Economy::Bounded } else { Economy::Lossless };
    hash.add("sight", &(small, raster.lines));
    if settings.levels.is_some() && settings.level_turn != LevelTurn::NEVER {
        hash.add("level turn", &settings.level_turn);
    }
    hash.add("cpu", &settings.cpu);
    hash.add("loader", &settings.loader);
    hash.add("data banks", &settings.data_banks);
    if !settings.kind_banks.is_plain() {
        hash.add("kind banks", &settings.kind_banks);
    }
    hash.add("seed", &settings.seed);
    add_craters(&mut hash, stage);
    add_shadows(&mut hash, scenario, stage);
    hash.finish()
}

/// Craters, where their words take time, parts to take them are few, or they lie on drums.
fn add_craters(hash: &mut InputsHash, MachineStage { landscape, settings, .. }: &MachineStage) {
    let parts = settings.feature_generator;
    let is_local = settings.kind_banks.features.place == BankPlace::Local;
    let is_at_once = settings.feature_words.is_none() && parts.sub_generators.is_none() && is_local;
    if landscape.features().is_empty() || is_at_once {
        return;
    }
    hash.add("feature generator", &(parts, settings.feature_words));
    hash.add_craters(landscape);
}

/// What casts shadows and when, where the words of their boundaries take time, parts to take them are few, or they lie on drums; and
/// bodies on drums.
fn add_shadows(
    hash: &mut InputsHash,
    scenario: &Scenario,
    MachineStage { scenery, settings, .. }: &MachineStage,
) {
    let line_generators = match settings.shadow_controller {
        ShadowParts::Digital { line_generators } => line_generators,
        ShadowParts::ScanConverter { .. } => None,
    };
    let banks = &settings.kind_banks;
    let is_timed = (settings.segment_words.is_some() || line_generators.is_some())
        && matches!(settings.shadow_controller, ShadowParts::Digital { .. });
    let lie_on_drums = [banks.shadows, banks.polyhedra].iter().any(|bank| bank.place != BankPlace::Local);
    if settings.shadows.is_some() && (is_timed || lie_on_drums) {
        hash.add("shadow controller", &(line_generators, settings.segment_words, settings.shadows));
        hash.add("suns", &scenery.suns());
        hash.add("tracks", &scenario.tracks);
    } else if !lie_on_drums {
        return;
    }
    for body in scenery.standing().iter().map(|standing| &standing.body) {
        hash.add("body", &(body.object, body.kind, body.foot, body.vertices().collect::<Vec<_>>()));
    }
    scenery.vehicle().iter().for_each(|vehicle| hash.add("vehicle", vehicle));
}
