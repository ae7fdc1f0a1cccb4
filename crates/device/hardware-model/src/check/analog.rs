//! What the analog parts cannot follow.

use scenario::{Occlusion, RangeLaw};

use super::{Check, Grade, short};
use crate::{FoldDetect, SweepMemoryKind, WriteCompensation};

pub(super) fn check(check: &mut Check) {
    ramps(check);
    bandwidths(check);
    slew(check);
    wires(check);
    words_and_segments(check);
    comparators(check);
    hold(check);
    light_and_switches(check);
    features_and_shadows(check);
    foreground(check);
    memory(check);
    roll(check);
}

/// Thresholds in shares of a crossing from hardware 4.9 and A8, A9.
fn ramps(check: &mut Check) {
    let (sweep, axis) = (check.model.analog.sweep, check.budget.crossings.axis);
    let of_crossing = |time: f64| short(100.0 * time / axis);
    check.warn_if(sweep.smoother > 0.1 * axis, "A8", &["sweep.smoother_ns"], || {
        format!("the smoother takes {} % of a crossing, more than a tenth", of_crossing(sweep.smoother))
    });
    check.warn_if(sweep.strobe_offset.abs() > 0.01 * axis, "A9", &["sweep.strobe_offset_ns"], || {
        format!("the strobe misses the fold by {} % of a crossing", of_crossing(sweep.strobe_offset))
    });
    check.warn_if(sweep.settle > axis, "A9", &["sweep.settle_ns"], || {
        format!("the ramp's converter settles in {} % of a crossing", of_crossing(sweep.settle))
    });
    let acts_on_nothing = sweep.dac_bits.is_none() && (sweep.nonlinearity != 0.0 || sweep.glitch != 0.0);
    check.push_if(
        acts_on_nothing,
        Grade::Warn(None),
        &["sweep.nonlinearity_pct", "sweep.glitch_v_ns", "sweep.dac_bits"],
        || "errors of a ramp converter that is exact: they are of no use".into(),
    );
    check.warn_if(sweep.fold_detect == FoldDetect::Comparator, "A9", &["sweep.fold_detect"], || {
        "folds found on the analog ramp come later than the ramp by the comparator's delay".into()
    });
    let step = sweep.dac_bits.map_or(0.0, |bits| check.budget.ground.region_size / f64::from(1_u32 << bits));
    check.warn_if(step > LINE_AT_100_M, "A12", &["sweep.dac_bits"], || {
        format!(
            "a step of the ramp is {} m, a line of level ground at 100 m is {LINE_AT_100_M} m",
            short(step)
        )
    });
}

/// Level ground in one of 1000 lines of 30 degrees, seen from 1.63 m (hardware 4.8).
const LINE_AT_100_M: f64 = 3.2;

/// Hardware 4.9: ten times the rate of regions for each factor of a product, five times for the sum, twice that for the light.
fn bandwidths(check: &mut Check) {
    let (analog, rate) = (&check.model.analog, 1.0 / check.budget.crossings.axis);
    let light = &analog.reflectivity;
    let video = check.budget.sweep.video_bandwidth;
    let sum = |product: f64| product / analog.summer_inputs.map_or(1.0, |inputs| f64::from(inputs) + 1.0);
    let parts = [
        ("function_generator.bandwidth_mhz", analog.function_generator.bandwidth, 10.0 * rate),
        ("multiplier.bandwidth_mhz", analog.multiplier.bandwidth, 10.0 * rate),
        ("multiplying_dac.bandwidth_mhz", analog.multiplying_dac.bandwidth, 10.0 * rate),
        ("amplifier.gain_bandwidth_mhz", analog.amplifier.gain_bandwidth.map(sum), 5.0 * rate),
        ("reflectivity.multiplier_bandwidth_mhz", light.multiplier.bandwidth, 10.0 * rate),
        ("reflectivity.summer_bandwidth_mhz", light.summer_bandwidth, 10.0 * rate),
        ("reflectivity.root_bandwidth_mhz", light.root.bandwidth, 10.0 * rate),
        ("reflectivity.divider_bandwidth_mhz", light.divider.bandwidth, 10.0 * rate),
        ("video.bandwidth_mhz", analog.video_bandwidth, video),
    ];
    for (key, bandwidth, needed) in parts {
        let Some(bandwidth) = bandwidth else { continue };
        check.warn_if(bandwidth < needed, "A6", &[key], || {
            format!("a bandwidth of {} MHz, needed are {}", short(1e-6 * bandwidth), short(1e-6 * needed))
        });
    }
}

fn slew(check: &mut Check) {
    let (amplifier, full_scale) = (check.model.analog.amplifier, check.model.analog.full_scale);
    let needed = 10.0 * check.budget.crossings.ramp;
    if let Some(slew) = amplifier.slew {
        check.warn_if(slew < needed, "A7", &["amplifier.slew_v_us"], || {
            format!("a slew rate of {} V/µs, needed are {}", short(1e-6 * slew), short(1e-6 * needed))
        });
    }
    let clips = [
        ("amplifier.saturation_v", amplifier.saturation),
        ("reflectivity.saturation_v", check.model.analog.reflectivity.saturation),
    ];
    for (key, clip) in clips {
        let Some(clip) = clip else { continue };
        check.warn_if(clip < full_scale, "A25", &[key, "analog.full_scale_v"], || {
            format!("outputs clip at {} V, full scale is {} V", short(clip), short(full_scale))
        });
    }
}

/// Main signals are behind one amplifier each: five times the rate of regions, as a sum, and a slew rate as any amplifier's.
fn wires(check: &mut Check) {
    let (wires, crossings) = (check.model.analog.wires, &check.budget.crossings);
    if !wires.driven.contains(&true) {
        return;
    }
    let (rate, ramp) = (5.0 / crossings.axis, 10.0 * crossings.ramp);
    if let Some(bandwidth) = wires.bandwidth {
        check.warn_if(bandwidth < rate, "A6", &["wires.bandwidth_mhz"], || {
            format!("a bandwidth of {} MHz, needed are {}", short(1e-6 * bandwidth), short(1e-6 * rate))
        });
    }
    if let Some(slew) = wires.slew {
        check.warn_if(slew < ramp, "A7", &["wires.slew_v_us"], || {
            format!("a slew rate of {} V/µs, needed are {}", short(1e-6 * slew), short(1e-6 * ramp))
        });
    }
}

fn words_and_segments(check: &mut Check) {
    let analog = &check.model.analog;
    let dac = analog.multiplying_dac;
    check.warn_if(dac.gain_error > 0.005, "A10", &["multiplying_dac.gain_error_pct"], || {
        format!("gain errors of {} %, trimmed ones have 0.2", short(100.0 * dac.gain_error))
    });
    check.warn_if(dac.bits.is_some_and(|bits| bits < 8), "A12", &["multiplying_dac.bits"], || {
        format!("coefficients of {} bits, converters had 8 to 14", dac.bits.unwrap_or_default())
    });
    let segments = analog.function_generator.segments;
    // Ripple of a broken line, max |g0''| h^2 / 16 (hardware 3.3).
    let ripple = segments.map_or(0.0, |n| 5.77 / (16.0 * f64::from(n) * f64::from(n)));
    check.warn_if(ripple > 0.005, "A11", &["function_generator.segments"], || {
        format!("{} segments leave {} % of ripple", segments.unwrap_or_default(), short(100.0 * ripple))
    });
}

fn comparators(check: &mut Check) {
    let (analog, rate) = (&check.model.analog, check.budget.crossings.rate);
    let shift = analog.comparator.delay * rate;
    check.warn_if(shift > 0.1 * check.budget.ground.region_size, "A13", &["comparator.delay_ns"], || {
        format!("edges lie {} m beyond their place, more than a tenth of a region", short(shift))
    });
    let (noise, width) = (analog.amplifier.noise, analog.comparator.hysteresis * analog.full_scale);
    let chatters = check.model.laws.occlusion == Occlusion::Derivative && width < 3.0 * noise;
    check.warn_if(
        chatters,
        "A16",
        &["comparator.hysteresis_pct", "amplifier.noise_mv", "dpp.occlusion"],
        || {
            let (width, noise) = (short(1e3 * width), short(1e3 * noise));
            format!("a hysteresis of {width} mV against noise of {noise} mV, needed is three times that")
        },
    );
}

fn hold(check: &mut Check) {
    let (analog, active) = (&check.model.analog, check.budget.sweep.active);
    let share = (analog.sample_hold.pedestal + analog.sample_hold.droop * active) / analog.full_scale;
    check.warn_if(share > 0.01, "A15", &["sample_hold.pedestal_mv", "sample_hold.droop_mv_us"], || {
        format!("pedestal and droop of a sweep are {} % of full scale", short(100.0 * share))
    });
}

fn light_and_switches(check: &mut Check) {
    let (analog, sample) = (&check.model.analog, check.budget.sweep.sample);
    let mismatch = analog.reflectivity.delay_mismatch.abs();
    check.warn_if(mismatch > sample, "A17", &["reflectivity.delay_mismatch_ns"], || {
        format!("light is {} ns off, a sample takes {}", short(1e9 * mismatch), short(1e9 * sample))
    });
    check.warn_if(!analog.level_blend.slope_term, "A27", &["level_blend.slope_term"], || {
        "a blend of two levels without the slope term is lit by slopes that the ground does not have".into()
    });
    let switch = analog.video_switch;
    check.warn_if(switch.time > sample, "A22", &["video_switch.time_ns"], || {
        format!("switches take {} ns, a sample {}", short(1e9 * switch.time), short(1e9 * sample))
    });
    check.warn_if(switch.level_mismatch > 0.05, "A22", &["video_switch.level_mismatch_pct"], || {
        format!(
            "levels of the switches differ by {} %, adjusted ones by 2",
            short(100.0 * switch.level_mismatch)
        )
    });
}

/// Craters behind their chain, edges of shadow beside their lines, what a switch lets through.
fn features_and_shadows(check: &mut Check) {
    let (analog, crossings) = (&check.model.analog, &check.budget.crossings);
    let (region_size, rate) = (check.budget.ground.region_size, crossings.rate);
    if let Some(bandwidth) = analog.feature.bandwidth {
        let late = rate / (2.0 * std::f64::consts::PI * bandwidth);
        let key = "feature_generator.chain_bandwidth_mhz";
        check.warn_if(late > 0.1 * region_size, "A6", &[key], || {
            format!("craters lie {} m beyond their place, more than a tenth of a region", short(late))
        });
    }
    let lines = analog.shadow_line.error;
    check.warn_if(lines > 0.01, "A13", &["shadow_controller.line_error_pct"], || {
        format!("line generators are {} % off, multipliers had 0.1 to 1", short(100.0 * lines))
    });
    if let Some(crosstalk) = analog.video_switch.crosstalk {
        check.warn_if(crosstalk > 0.0101, "A22", &["video_switch.crosstalk_db"], || {
            format!(
                "{} % of what is off gets through at 5 MHz, good switches had 0.1 to 1",
                short(100.0 * crosstalk)
            )
        });
    }
}

fn foreground(check: &mut Check) {
    let range = &check.model.range;
    let step = range.end / f64::from(check.model.raster.samples);
    check.warn_if(range.law == RangeLaw::ConstantRate, "A18", &["range.programme"], || {
        format!("at a constant rate every sample is {} m, and the foreground has a handful", short(step))
    });
}

fn memory(check: &mut Check) {
    let memory = check.model.analog.memory;
    let is_poor = match memory.write_compensation {
        WriteCompensation::Exact => false,
        WriteCompensation::Ratio(ratio) => ratio < 20.0,
        WriteCompensation::Off => true,
    };
    check.warn_if(is_poor, "A19", &["sweep_memory.write_compensation"], || {
        "the beam's speed varies 100 000 : 1 in a sweep, its current hardly".into()
    });
    check.warn_if(memory.erase_residual > 0.2, "A20", &["sweep_memory.erase_residual"], || {
        format!("{} of a picture outlives its erasure", short(memory.erase_residual))
    });
    check.warn_if(memory.registration > 0.02, "A21", &["sweep_memory.registration_pct"], || {
        format!("reading is {} % off writing, tubes had 0.3 to 2", short(100.0 * memory.registration))
    });
    let is_idle = memory.bits.is_some() && check.model.sweep_memory != SweepMemoryKind::DigitalMemory;
    check.push_if(is_idle, Grade::Warn(None), &["sweep_memory.bits", "sweep_memory.kind"], || {
        "words of a digital memory, and the memory is a scan converter: they are of no use".into()
    });
}

fn roll(check: &mut Check) {
    let (yoke, step) = (check.model.yoke, quantities::degrees(check.model.yoke.step));
    check.warn_if(step > 0.5, "A23", &["roll.step_deg"], || {
        format!("a step turns the horizon by {} degrees", short(step))
    });
    check.warn_if(yoke.natural.is_some() && yoke.damping < 0.1, "A23", &["roll.damping"], || {
        format!("the yoke rings with a damping of {}", short(yoke.damping))
    });
}
