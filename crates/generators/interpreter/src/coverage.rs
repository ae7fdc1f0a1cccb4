//! What the interpreter does not model, and why: those signals are not compared.

use hardware_model::{AnalogParts, Settings, WriteCompensation};

/// What of one sweep it cannot know.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Unknown {
    /// Craters that came late or found no sub-generator.
    pub craters: bool,
    /// Craters or edges of shadow on the way.
    pub breaks: bool,
}

/// Why the interpreter has no opinion on `signal` under `settings`; `None` if it has.
pub fn why_not(signal: &str, settings: &Settings, unknown: Unknown) -> Option<&'static str> {
    behind_amplifiers(signal, settings, unknown).or_else(|| inside_blocks(signal, settings, unknown))
}

/// Main signals and what lies behind them, where they have output amplifiers: the terrain's it knows everywhere, the others between
/// rims and edges of shadow.
fn behind_amplifiers(signal: &str, settings: &Settings, unknown: Unknown) -> Option<&'static str> {
    let Settings { analog: AnalogParts { wires, spread, .. }, .. } = settings;
    let is_terrain = ["tg.height", "tg.slope.u", "tg.slope.v", "tg.reflectivity"].contains(&signal);
    let lies_behind =
        is_terrain || ["fg.", "mu.", "dpp.", "sm."].iter().any(|block| signal.starts_with(block));
    if wires.is_ideal() || !lies_behind {
        return None;
    }
    let is_cut = !is_terrain && unknown.breaks || signal == "fg.reflectivity";
    match (*spread, is_cut) {
        (true, _) => Some("output amplifiers drawn from a seed"),
        (false, true) => Some("rims and edges of shadow behind output amplifiers"),
        (false, false) => None,
    }
}

fn inside_blocks(signal: &str, settings: &Settings, unknown: Unknown) -> Option<&'static str> {
    let parts = &settings.analog;
    let of = |other: &str| inside_blocks(other, settings, unknown);
    match signal {
        "sweep.range" => None,
        _ if signal.starts_with("sweep.") => terrain_parts(settings),
        "sc.or" => Some("given: the gate is taken as the machine has it"),
        "sc.gate" | "mu.vs2" | "mu.vs2.fade" | "fg.present" | "mu.vs1.fade" if has_gates(settings) => {
            Some("real video switches or comparators")
        }
        "sc.gate" | "mu.vs2" | "mu.vs2.fade" => None,
        "sm.write" => Some("strokes of the beam between samples"),
        "pg.present" | "pg.reflectivity" => Some("polyhedra"),
        "txg.texture" => (!parts.texture_is_ideal()).then_some("real parts of the texture generator"),
        "fg.reflectivity" => of("fg.height").or_else(|| of("tg.height")),
        "mu.height" => of("tg.height").or_else(|| of("fg.height")),
        "mu.vs1" | "mu.reflectivity" if has_gates(settings) => {
            Some("real video switches, comparators or amplifier")
        }
        "mu.vs1" | "mu.vs1.fade" => of("fg.reflectivity"),
        "mu.reflectivity" => of("fg.reflectivity").or_else(|| of("txg.texture")),
        "sm.video" => of("mu.reflectivity").or_else(|| of("dpp.hold")),
        _ if signal.starts_with("tg.") => terrain_parts(settings),
        _ if signal.starts_with("fg.") && !parts.features_are_ideal() => {
            Some("real parts of the sub-generators")
        }
        _ if signal.starts_with("fg.") => unknown.craters.then_some("craters that came late or were dropped"),
        _ if signal.starts_with("dpp.") && drives_parts(settings) => {
            Some("real parts of projection processor or write gun")
        }
        _ if signal.starts_with("dpp.") => of("mu.height"),
        _ => Some("no such wire in the report's drawing"),
    }
}

fn terrain_parts(settings: &Settings) -> Option<&'static str> {
    let amplifier = &settings.analog.amplifier;
    (amplifier.slew.is_some() && amplifier.gain_bandwidth.is_none())
        .then_some("amplifiers that slew without a bandwidth")
}

fn has_gates(settings: &Settings) -> bool {
    !(settings.analog.mixing_is_ideal() && settings.analog.comparator_is_ideal())
}

fn drives_parts(settings: &Settings) -> bool {
    let memory = &settings.analog.memory;
    !settings.analog.projection_is_ideal()
        || memory.write_compensation != WriteCompensation::Exact
        || memory.deflection.is_some()
}
