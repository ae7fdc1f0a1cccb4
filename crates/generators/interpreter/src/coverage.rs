//! What the interpreter does not model, and why: those signals are not compared.

use hardware_model::{AnalogParts, Settings};

/// What of one sweep it cannot know.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Unknown {
    /// Craters or edges of shadow on the way.
    pub breaks: bool,
}

/// Why the interpreter has no opinion on `signal` under `settings`; `None` if it has.
pub fn why_not(signal: &str, settings: &Settings, unknown: Unknown) -> Option<&'static str> {
    behind_amplifiers(signal, settings, unknown).or_else(|| inside_blocks(signal, settings, unknown))
}

/// Why the interpreter has `signal` at the samples of the machine alone, and straight between them; `None` if it has it at every step.
pub fn why_straight(signal: &str, settings: &Settings) -> Option<&'static str> {
    let parts = &settings.analog;
    let features = || (!parts.features_are_ideal()).then_some("real parts of the feature generator");
    let switching = || (!parts.switching_is_ideal()).then_some("real parts of the mixing unit");
    let beam = || (!parts.beam_is_ideal()).then_some("real parts of projection processor or write gun");
    match signal.split('.').next() {
        Some("fg" | "sc" | "mu") => features().or_else(switching),
        Some("dpp") => features().or_else(beam),
        Some("sm") => features().or_else(switching).or_else(beam),
        _ => None,
    }
}

/// Main signals and what lies behind them, where they have output amplifiers: the terrain's it knows everywhere, the others between
/// rims and edges of shadow.
fn behind_amplifiers(signal: &str, settings: &Settings, unknown: Unknown) -> Option<&'static str> {
    let AnalogParts { wires, .. } = &settings.analog;
    let is_terrain = ["tg.height", "tg.slope.u", "tg.slope.v", "tg.reflectivity"].contains(&signal);
    let lies_behind = ["fg.", "mu.", "dpp.", "sm."].iter().any(|block| signal.starts_with(block));
    if wires.is_ideal() || is_terrain || !lies_behind {
        return None;
    }
    let is_cut = unknown.breaks || signal == "fg.reflectivity";
    is_cut.then_some("rims and edges of shadow behind output amplifiers")
}

fn inside_blocks(signal: &str, settings: &Settings, unknown: Unknown) -> Option<&'static str> {
    let of = |other: &str| inside_blocks(other, settings, unknown);
    match signal {
        "sweep.range" => None,
        _ if signal.starts_with("sweep.") || signal.starts_with("tg.") => terrain_parts(settings),
        "sc.or" => Some("given: the gate is taken as the machine has it"),
        "sc.gate" | "mu.vs2" | "mu.vs2.fade" | "txg.texture" => None,
        "sm.write" => Some("strokes of the beam between samples"),
        "pg.present" | "pg.reflectivity" => Some("polyhedra"),
        "fg.reflectivity" | "mu.height" | "mu.vs1" | "mu.vs1.fade" => of("tg.height"),
        "mu.reflectivity" => of("fg.reflectivity").or_else(|| behind_switches(settings)),
        "sm.video" => {
            let own = of("mu.reflectivity").or_else(|| of("dpp.hold"));
            own.or_else(|| delay_line(settings, unknown))
        }
        _ if signal.starts_with("fg.") => None,
        _ if signal.starts_with("dpp.") => of("mu.height"),
        _ if is_digital_state(signal) => {
            Some("folded from events of the digital side, which are compared one by one")
        }
        _ => Some("no such wire in the report's drawing"),
    }
}

/// Whether a wire is the state of a unit of the digital side.
fn is_digital_state(signal: &str) -> bool {
    const UNITS: [&str; 6] = ["cpu", "loader", "drum", "channel", "editor", "buffer"];
    signal.split('.').next().is_some_and(|unit| UNITS.contains(&unit))
}

fn terrain_parts(settings: &Settings) -> Option<&'static str> {
    let amplifier = &settings.analog.amplifier;
    (amplifier.slew.is_some() && amplifier.gain_bandwidth.is_none())
        .then_some("amplifiers that slew without a bandwidth")
}

/// The fades of real switches jump and bend between samples, and an amplifier that may slew is behind them.
fn behind_switches(settings: &Settings) -> Option<&'static str> {
    let parts = &settings.analog;
    (!parts.switching_is_ideal() && parts.wires.drives("mu.reflectivity"))
        .then_some("an output amplifier behind a mixing unit of real parts")
}

/// Behind the delay line of a real processor a sample is what lies between two samples of the mixing unit: at the edges of an ideal one
/// that is a curve.
fn delay_line(settings: &Settings, unknown: Unknown) -> Option<&'static str> {
    let parts = &settings.analog;
    let delays = !parts.beam_is_ideal() && parts.projection.bandwidth.is_some();
    (delays && parts.switching_is_ideal() && unknown.breaks)
        .then_some("edges of an ideal mixing unit behind a delay line")
}
