//! Which wires an elaborated machine has, and what full scale means on them.

use control_plane::{Blocks, MachineStage, WrittenRaster, has_state, is_state};
use display_projection_processor::DERIVATIVE;
use feature_generator::{SubGeneratorPlace, place_of};
use hardware_model::{Settings, ShadowParts};
use landscape::CraterGrain;
use scenario::Occlusion;
use shadow_controller::comparator_of;
use signal::{Kind, Signal, Unit, Wire};
use terrain_generator::{COARSE, FINE, InnerSignals, LIGHT, Scale, light_full_scales};

use crate::signal_table::signals;

/// High level of a gate (V): transistor logic of the time (our choice).
const LOGIC: f64 = 5.0;

/// Microseconds of a second.
pub(crate) const MICROSECONDS: f64 = 1e6;

/// Full scales of a stage.
pub(crate) struct Scales {
    /// Voltage at full scale.
    volts: f64,
    /// Middle of the stored heights, and what is full scale from there (m).
    height: [f64; 2],
    /// Slope at full scale.
    slope: f64,
    /// Tangent of elevation at the edge of the raster.
    tangent: f64,
    lines: f64,
    /// End of the range programme (m).
    range: f64,
    /// The most that a crater adds to the gain of texture, or takes from it.
    grain: f64,
    /// Inner signals of each level, the scale of its array, and the side of its regions (m).
    arrays: Vec<(&'static InnerSignals, Scale, f64)>,
    /// Full scales of the wires of the stage that makes light of slopes, by name.
    light: Vec<(&'static str, f64)>,
}

/// Wires of the machine elaborated for `stage`, in the order of the signal table: those of blocks that are there.
pub fn wires(stage: &MachineStage, blocks: &Blocks, raster: &WrittenRaster) -> Vec<Wire> {
    let scales = Scales::of(stage, raster);
    signals()
        .iter()
        .filter(|signal| is_there(signal, blocks, stage))
        .map(|signal| scales.wire(signal))
        .collect()
}

fn is_there(signal: &Signal, blocks: &Blocks, stage: &MachineStage) -> bool {
    let settings = &stage.settings;
    if is_state(signal) {
        return has_state(signal, stage, blocks);
    }
    match (signal.prefix(), signal.name) {
        ("fg", name) if place_of(name).is_some_and(|place| !has_sub_generator(place, settings)) => false,
        ("sc", name) if comparator_of(name).is_some_and(|number| !has_line_generator(number, settings)) => {
            false
        }
        ("fg", _) | (_, "mu.vs1" | "mu.vs1.fade") => blocks.features,
        ("sc", _) | (_, "mu.vs2" | "mu.vs2.fade") => blocks.shadows.is_some(),
        ("txg", _) => blocks.texture,
        ("pg", _) => blocks.bodies,
        ("yoke", _) => settings.yoke.is_some(),
        (_, "dpp.derivative") => settings.laws.occlusion == Occlusion::Derivative,
        (_, name) if name.contains(".coarse.") => blocks.coarse.is_some(),
        _ => true,
    }
}

fn has_sub_generator(place: SubGeneratorPlace, settings: &Settings) -> bool {
    settings.feature_generator.sub_generators.is_none_or(|count| place.number < count)
}

fn has_line_generator(number: usize, settings: &Settings) -> bool {
    match settings.shadow_controller {
        ShadowParts::Digital { line_generators } => {
            line_generators.is_none_or(|count| number < count as usize)
        }
        ShadowParts::ScanConverter { .. } => false,
    }
}

impl Scales {
    pub fn of(stage: &MachineStage, raster: &WrittenRaster) -> Self {
        let levels = stage.landscape.bank().levels();
        let of_level = |level| (Scale::of(level), level.region_size());
        let (fine, size) = of_level(stage.landscape.level());
        let mut scales = Self {
            volts: stage.settings.analog.full_scale,
            height: [fine.datum, fine.height],
            slope: fine.slope / size,
            tangent: raster.field.tan_half_height,
            lines: raster.lines as f64,
            range: stage.settings.range.end,
            grain: stage.landscape.crater_grain().map_or(1.0, CraterGrain::full_scale),
            arrays: vec![(&FINE, fine, size)],
            light: LIGHT
                .iter()
                .map(|signal| signal.name)
                .zip(light_full_scales(&stage.settings.analog))
                .collect(),
        };
        if let (Some(_), Some(level)) = (stage.settings.levels, levels.get(1)) {
            let (coarse, size) = of_level(level);
            scales.arrays.push((&COARSE, coarse, size));
            scales.height[1] = scales.height[1].max(coarse.height);
            scales.slope = scales.slope.max(coarse.slope / size);
        }
        scales
    }

    /// The wire of a signal.
    pub fn wire(&self, signal: &Signal) -> Wire {
        let inner = self.arrays.iter().find_map(|(signals, scale, region_size)| {
            Some(signals.find(signal.name)?.full_scale(scale, *region_size))
        });
        let light = || self.light.iter().find(|(name, _)| *name == signal.name).map(|(_, full)| [0.0, *full]);
        let [datum, full_scale] = inner.or_else(light).unwrap_or_else(|| self.of_unit(signal));
        let volts = match signal.kind {
            Kind::Analog => self.volts,
            Kind::Gate => LOGIC,
            Kind::Bus | Kind::Event => 0.0,
        };
        Wire { signal: *signal, full_scale, volts, datum }
    }

    /// Value at 0 V, and value at full scale from there, by the unit of a signal between blocks.
    fn of_unit(&self, signal: &Signal) -> [f64; 2] {
        match signal.unit {
            _ if matches!(signal.kind, Kind::Bus | Kind::Event) => [0.0, 1.0],
            Unit::Metre if signal.name == "sweep.range" => [0.0, self.range],
            // What is added to a height has no datum of its own.
            Unit::Metre if signal.name.ends_with(".height") && !is_added(signal) => self.height,
            Unit::Metre => [0.0, self.height[1]],
            Unit::Slope => [0.0, self.slope],
            Unit::Tangent => [0.0, self.tangent],
            Unit::TangentRate => [0.0, self.tangent / (DERIVATIVE * MICROSECONDS)],
            Unit::Line => [0.0, self.lines],
            Unit::Number if signal.name == "fg.grain" => [0.0, self.grain],
            _ => [0.0, 1.0],
        }
    }
}

/// Whether a height is one that others are added to.
fn is_added(signal: &Signal) -> bool {
    !matches!(signal.name, "tg.height" | "mu.height")
}
