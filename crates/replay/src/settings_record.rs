//! Settings, ground and vehicle as they stand in the record: units in the keys, clocks as exact fractions.

use hardware_model::{
    AnalogParts, Cpu, CrossingServer, DataBanks, Economy, Gate, LatePolicy, LoadDelay, Organisation,
    Settings, ShadowParts, SweepMemoryKind,
};
use landscape::relief::Relief;
use landscape::{Landscape, Sun, bank_file};
use quantities::degrees;
use scenario::{
    BodyVisibility, Curvature, FeatureLight, Ground, Occlusion, PixelRule, Projection, RangeLaw,
    RangeProgramme, Scalar, Scenario, ShadowedBodies, TextureInShadow, Vehicle,
};
use serde::Serialize;
use serde_json::{Value, json};

/// Everything that decides a picture but ground, light and pose.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SettingsRecord {
    scalar: &'static str,
    raster: Value,
    clocks: Value,
    range: Value,
    laws: Value,
    display: Value,
    cpu_ticks: Cpu,
    loader: Value,
    data_banks_ticks: DataBanks,
    analog_si: AnalogParts,
    seed: u64,
    sweep_memory: &'static str,
    blocks: Value,
    yoke: Value,
    levels: Value,
    shadows: Value,
    economy: &'static str,
    lunsim: Value,
}

impl SettingsRecord {
    /// The record of `settings`.
    pub fn new(settings: &Settings) -> Self {
        Self {
            scalar: match settings.scalar {
                Scalar::F32 => "f32",
                Scalar::F64 => "f64",
            },
            raster: raster(settings),
            clocks: clocks(settings),
            range: range(&settings.range),
            laws: laws(settings),
            display: json!({ "white": settings.display.white, "gamma": settings.display.gamma }),
            cpu_ticks: settings.cpu,
            loader: loader(settings),
            data_banks_ticks: settings.data_banks,
            analog_si: settings.analog.clone(),
            seed: settings.seed,
            sweep_memory: match settings.sweep_memory {
                SweepMemoryKind::ScanConverter => "scan-converter",
                SweepMemoryKind::DigitalMemory => "digital-memory",
            },
            blocks: blocks(settings),
            yoke: settings.yoke.map_or(Value::Null, |yoke| {
                let [step, rate, travel] = [yoke.step, yoke.rate, yoke.travel].map(degrees);
                json!({ "step_deg": step, "rate_deg_s": rate, "travel_deg": travel,
                        "natural_hz": yoke.natural, "damping": yoke.damping })
            }),
            levels: settings
                .levels
                .map_or(Value::Null, |switch| json!({ "switch_m": switch.range, "blend_m": switch.blend })),
            shadows: settings.shadows.map_or(Value::Null, |fineness| {
                json!({ "finest_m": fineness.finest, "angle_mrad": 1e3 * fineness.angle, "reach_m": fineness.reach })
            }),
            economy: match settings.economy {
                Economy::Bounded => "bounded",
                Economy::Swift => "swift",
                Economy::Lossless | Economy::LosslessBut(_) => "lossless",
                Economy::Everything => "everything",
            },
            lunsim: json!({
                "grid": settings.lunsim.grid,
                "intensity_codes": settings.lunsim.intensity_codes,
                "restrictions": settings.lunsim.restrictions,
            }),
        }
    }
}

fn raster(settings: &Settings) -> Value {
    let raster = &settings.raster;
    let angle = |tangent: f64| degrees(2.0 * libm::atan(tangent));
    json!({
        "sweeps": raster.sweeps,
        "samples_per_sweep": raster.samples,
        "columns": raster.columns,
        "lines": raster.lines,
        "field_of_view_deg": [angle(raster.field.tan_half_width), angle(raster.field.tan_half_height)],
    })
}

/// Rates as whole numbers or fractions of hertz, in words: a float would round them.
fn clocks(settings: &Settings) -> Value {
    let clocks = &settings.timebase;
    json!({
        "master": clocks.master.to_string(),
        "sample": clocks.sample_rate().to_string(),
        "update": clocks.update.to_string(),
        "refresh": settings.raster.refresh.to_string(),
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

fn laws(settings: &Settings) -> Value {
    let laws = &settings.laws;
    json!({
        "projection": match laws.projection {
            Projection::AsReported => "as-reported",
            Projection::Corrected => "corrected",
            Projection::Exact => "exact",
        },
        "curvature": match laws.curvature {
            Curvature::None => "none",
            Curvature::Parabolic => "parabolic",
            Curvature::Exact => "exact",
        },
        "occlusion": match laws.occlusion {
            Occlusion::Derivative => "derivative",
            Occlusion::PeakHold => "peak-hold",
        },
        "pixel_rule": match laws.pixel_rule {
            PixelRule::LineMean => "line-mean",
            PixelRule::Centre => "centre",
        },
        "feature_light": match laws.feature_light {
            FeatureLight::AsReported => "as-reported",
            FeatureLight::Combined => "combined",
        },
        "body_visibility": match laws.body_visibility {
            BodyVisibility::AsReported => "as-reported",
            BodyVisibility::Depth => "depth",
        },
        "shadowed_bodies": match laws.shadowed_bodies {
            ShadowedBodies::Vanish => "vanish",
            ShadowedBodies::Dark => "dark",
        },
        "texture_in_shadow": match laws.texture_in_shadow {
            TextureInShadow::On => "on",
            TextureInShadow::Off => "off",
        },
    })
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

/// The ground of a run: where it came from, and the hash of its words.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroundRecord {
    source: &'static str,
    title: String,
    content_blake3: String,
    albedo: f64,
    levels: Vec<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    generator: Option<Value>,
}

impl GroundRecord {
    /// The record of `landscape`; `ground` says where it came from.
    pub fn new(ground: &Ground, landscape: &Landscape) -> Self {
        let bank = landscape.bank();
        let (source, generator) = match ground {
            Ground::Bank(_) => ("bank", None),
            Ground::Generated(relief) => ("generated", Some(generated(relief))),
        };
        let level = |level: &landscape::Level| json!({ "region_size_m": level.region_size(), "origin_m": level.origin(), "corners": level.corners() });
        Self {
            source,
            title: bank.title().into(),
            content_blake3: bank_file::content_hash(bank).iter().map(|byte| format!("{byte:02x}")).collect(),
            albedo: landscape.albedo(),
            levels: bank.levels().iter().map(level).collect(),
            generator,
        }
    }
}

/// Parameters of a generated landscape, in the keys of a scenario file.
fn generated(relief: &Relief) -> Value {
    let undulation = relief.undulation.as_ref().map(|part| {
        json!({ "rms_height_m": part.rms_height, "hurst": part.hurst, "longest_m": part.longest,
                "shortest_m": part.shortest, "waves": part.waves })
    });
    let craters = relief.craters.as_ref().map(|part| {
        json!({ "smallest_radius_m": part.smallest_radius, "largest_radius_m": part.largest_radius,
                "density": part.density, "subdued_depth_ratio": part.subdued,
                "fresh_depth_ratio": part.fresh })
    });
    let massifs: Vec<Value> = relief
        .massifs
        .iter()
        .map(|part| {
            json!({ "at_m": part.at, "height_m": part.height, "radius_m": part.radius,
                    "detail_m": part.detail, "ruggedness": part.ruggedness })
        })
        .collect();
    let rilles: Vec<Value> = relief
        .rilles
        .iter()
        .map(|part| {
            let meander =
                part.meander.as_ref().map(|bend| json!({ "swing_m": bend.swing, "length_m": bend.length }));
            json!({ "through_m": part.through, "azimuth_deg": degrees(part.azimuth), "width_m": part.width,
                    "depth_m": part.depth, "meander": meander })
        })
        .collect();
    json!({ "seed": relief.seed, "extent_m": relief.extent, "region_size_m": relief.region_size,
            "tilt_m_per_m": relief.tilt, "undulation": undulation, "craters": craters,
            "massif": massifs, "rille": rilles })
}

/// Direction of the light.
pub(crate) fn sun(sun: &Sun) -> Value {
    json!({ "azimuth_deg": degrees(sun.azimuth), "elevation_deg": degrees(sun.elevation) })
}

/// Size and limits of the vehicle.
pub(crate) fn vehicle(vehicle: &Vehicle) -> Value {
    json!({
        "eye_height_m": vehicle.eye_height,
        "wheelbase_m": vehicle.wheelbase,
        "track_m": vehicle.track,
        "max_speed_m_s": vehicle.max_speed,
        "max_turn_deg_s": degrees(vehicle.max_turn),
        "max_slope_deg": degrees(vehicle.max_slope),
    })
}

/// BLAKE3 of the waypoints: two paths with this hash are the same path.
pub(crate) fn waypoints_hash(scenario: &Scenario) -> String {
    let mut hasher = blake3::Hasher::new();
    for waypoint in scenario.path.waypoints() {
        for value in [waypoint.time, waypoint.at[0], waypoint.at[1]] {
            hasher.update(&value.to_le_bytes());
        }
        for value in [waypoint.heading, waypoint.eye_height, waypoint.pitch, waypoint.roll] {
            // No number is NaN, so NaN can stand for "open".
            hasher.update(&value.unwrap_or(f64::NAN).to_le_bytes());
        }
    }
    hasher.finalize().to_hex().to_string()
}
