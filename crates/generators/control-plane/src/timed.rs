//! The control plane as a job that takes time, and what decides its timing in one hash.

use std::fmt::Debug;

use blake3::Hasher;
use generator::{FrameError, Timed};
use hardware_model::{BankPlace, ShadowParts};
use landscape::bank_file;
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
    let mut hasher = Hasher::new_derive_key("lunoid timing, inputs, format 1");
    hasher.update(&bank_file::content_hash(landscape.bank()));
    add(&mut hasher, "path", &(scenario.way().waypoints(), &scenario.vehicle));
    scenario.channel.iter().for_each(|channel| add(&mut hasher, "channel", channel));
    for standing in scenery.standing() {
        add(&mut hasher, "body", &(standing.from, standing.until, standing.body.vertices().len()));
    }
    let raster = &settings.raster;
    add(&mut hasher, "raster", &(raster.sweeps, raster.samples, raster.field, settings.timebase));
    add(&mut hasher, "fan", &(settings.laws.projection, settings.range, settings.yoke, settings.levels));
    // Bodies that are too small to be seen are not transformed.
    add(&mut hasher, "sight", &(settings.economy, raster.lines));
    add(&mut hasher, "cpu", &settings.cpu);
    add(&mut hasher, "loader", &settings.loader);
    add(&mut hasher, "data banks", &settings.data_banks);
    if !settings.kind_banks.is_plain() {
        add(&mut hasher, "kind banks", &settings.kind_banks);
    }
    add(&mut hasher, "seed", &settings.seed);
    add_craters(&mut hasher, stage);
    add_shadows(&mut hasher, scenario, stage);
    hasher.finalize().to_hex().to_string()
}

/// Craters, where their words take time, parts to take them are few, or they lie on drums.
fn add_craters(hasher: &mut Hasher, MachineStage { landscape, settings, .. }: &MachineStage) {
    let parts = settings.feature_generator;
    let is_local = settings.kind_banks.features.place == BankPlace::Local;
    let is_at_once = settings.feature_words.is_none() && parts.sub_generators.is_none() && is_local;
    if landscape.features().is_empty() || is_at_once {
        return;
    }
    add(hasher, "feature generator", &(parts, settings.feature_words));
    landscape.features().craters().iter().for_each(|crater| add(hasher, "crater", &crater));
}

/// What casts shadows and when, where the words of their boundaries take time, parts to take them are few, or they lie on drums; and
/// bodies on drums.
fn add_shadows(
    hasher: &mut Hasher,
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
        add(hasher, "shadow controller", &(line_generators, settings.segment_words, settings.shadows));
        add(hasher, "suns", &scenery.suns());
        add(hasher, "tracks", &scenario.tracks);
    } else if !lie_on_drums {
        return;
    }
    for body in scenery.standing().iter().map(|standing| &standing.body) {
        add(hasher, "body", &(body.object, body.kind, body.foot, body.vertices().collect::<Vec<_>>()));
    }
    scenery.vehicle().iter().for_each(|vehicle| add(hasher, "vehicle", vehicle));
}

/// Debug text names all fields, and floats in it read back the same.
fn add(hasher: &mut Hasher, name: &str, value: &impl Debug) {
    let text = format!("{name} {value:?}\n");
    hasher.update(text.as_bytes());
}
