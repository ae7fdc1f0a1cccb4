//! Settings of the machine for the record of a run: units in the keys, clocks as exact fractions.

use hardware_model::{
    CrossingServer, Economy, Gate, LatePolicy, LoadDelay, Organisation, Settings, ShadowParts,
    SweepMemoryKind,
};
use scenario::{RangeLaw, RangeProgramme, Scalar};
use serde_json::{Value, json};

/// Everything that decides a picture beside ground, light, view and pose.
pub(crate) fn settings_record(settings: &Settings) -> Value {
    json!({
        "scalar": match settings.scalar {
            Scalar::F32 => "f32",
            Scalar::F64 => "f64",
        },
        "raster": { "sweeps": settings.raster.sweeps, "samples_per_sweep": settings.raster.samples },
        "clocks": clocks(settings),
        "range": range(&settings.range),
        "cpu_ticks": settings.cpu,
        "loader": loader(settings),
        "data_banks_ticks": settings.data_banks,
        "analog_si": settings.analog,
        "seed": settings.seed,
        "sweep_memory": match settings.sweep_memory {
            SweepMemoryKind::ScanConverter => "scan-converter",
            SweepMemoryKind::DigitalMemory => "digital-memory",
        },
        "blocks": blocks(settings),
        "economy": match settings.economy {
            Economy::Bounded => "bounded",
            Economy::Preview => "preview",
            Economy::Lossless | Economy::LosslessBut(_) => "lossless",
            Economy::Everything => "everything",
        },
    })
}

/// Rates as whole numbers or fractions of hertz, in words: a float would round them.
fn clocks(settings: &Settings) -> Value {
    let clocks = &settings.timebase;
    json!({
        "master": clocks.master.to_string(),
        "sample": clocks.sample_rate().to_string(),
        "active_samples": clocks.active_samples,
        "retrace_samples": clocks.retrace_samples,
    })
}

fn range(programme: &RangeProgramme) -> Value {
    let (word, more) = match programme.law {
        RangeLaw::ConstantRate => ("constant-rate", None),
        RangeLaw::TwoRate { switch, fine_share } => ("two-rate", Some((switch, fine_share))),
        RangeLaw::ConstantElevation => ("constant-elevation", None),
        RangeLaw::Geometric => ("geometric", None),
    };
    let mut record = json!({ "programme": word, "start_m": programme.start, "end_m": programme.end });
    if let Some((switch, fine_share)) = more {
        record["switch_m"] = switch.into();
        record["fine_share"] = fine_share.into();
    }
    record
}

/// Parts of the blocks beside the terrain path; a number that is not there is "any".
fn blocks(settings: &Settings) -> Value {
    let (features, mixing) = (&settings.feature_generator, &settings.mixing_unit);
    json!({
        "feature_generator": {
            "organisation": match features.organisation {
                Organisation::ByRegion => "by-region",
                Organisation::Scheduled => "scheduled",
            },
            "sub_generators": features.sub_generators,
        },
        "shadow_controller": match settings.shadow_controller {
            ShadowParts::Digital { line_generators } => {
                json!({ "variant": "digital", "line_generators": line_generators })
            }
            ShadowParts::ScanConverter { offset, gain } => {
                json!({ "variant": "scan-converter", "offset_share": offset, "gain_share": gain })
            }
        },
        "mixing_unit": {
            "gate": match mixing.gate {
                Gate::Presence => "presence",
                Gate::SelfKeyed => "self-keyed",
            },
            "threshold": mixing.threshold,
        },
    })
}

fn loader(settings: &Settings) -> Value {
    let loader = &settings.loader;
    let policy = match loader.late_policy {
        LatePolicy::StrobeThrough => "strobe-through",
        LatePolicy::Latched => "latched",
    };
    let delays: Vec<Value> = loader.delays.iter().map(delay).collect();
    json!({
        "served_by": match loader.served_by {
            CrossingServer::WiredPointers => "wired-pointers",
            CrossingServer::IoProcessor => "io-processor",
            CrossingServer::CpuInterrupt => "cpu-interrupt",
        },
        "words_per_access": loader.words_per_access,
        "access_ticks": loader.access,
        "pointer_ticks": loader.pointer,
        "io_processor_ticks": loader.io_processor,
        "strobe_ticks": loader.strobe,
        "urgent_first": loader.urgent_first,
        "diagonal_register": loader.diagonal_register,
        "stop_after_crossings": loader.stop_after_crossings,
        "late_policy": policy,
        "delay": delays,
    })
}

fn delay(delay: &LoadDelay) -> Value {
    json!({
        "frame": delay.frame,
        "sweep": delay.sweep,
        "crossing": delay.crossing,
        "colour": format!("{:?}", delay.colour).to_lowercase(),
        "register": format!("{:?}", delay.register).to_lowercase(),
        "word": [delay.word / 3, delay.word % 3],
        "ticks": delay.ticks,
    })
}
