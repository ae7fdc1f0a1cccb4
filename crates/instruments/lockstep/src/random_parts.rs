//! Real parts from a seed.

use std::f64::consts::PI;

use hardware_model::{
    AmplifierParts, AnalogParts, ComparatorParts, FeatureChainParts, FoldDetect, FunctionGeneratorParts,
    LoopParts, MultiplierParts, MultiplyingDacParts, ProjectionParts, ReflectivityParts, SampleHoldParts,
    ShadowLineParts, SweepParts, TextureParts, VideoSwitchParts,
};

use crate::random::Dice;

/// Parts of a terrain generator, and comparators, for samples of `step` seconds: time constants from a twentieth of a sample to two samples, or none; every fault of a part
/// there or not.
pub fn parts(dice: &mut Dice, step: f64) -> AnalogParts {
    let full_scale = dice.choose(&[1.0, 10.0]);
    let mut parts = AnalogParts {
        full_scale,
        spread: dice.choose(&[true, false]),
        sweep: sweep(dice, step, full_scale),
        function_generator: FunctionGeneratorParts {
            segments: dice.choose(&[None, Some(5), Some(20)]),
            rounding: dice.choose(&[0.0, 0.005 * full_scale]),
            error: dice.choose(&[0.0, 0.004]),
            bandwidth: bandwidth(dice, step),
        },
        multiplier: MultiplierParts {
            error: dice.choose(&[0.0, 0.01]),
            scale_error: dice.choose(&[0.0, 0.005]),
            feedthrough: dice.choose(&[0.0, 0.01]),
            bandwidth: bandwidth(dice, step),
        },
        multiplying_dac: MultiplyingDacParts {
            bits: dice.choose(&[None, Some(8), Some(12)]),
            gain_error: dice.choose(&[0.0, 0.002]),
            bandwidth: bandwidth(dice, step),
            glitch: dice.choose(&[0.0, 0.05 * full_scale * step]),
            switching: dice.choose(&[0.0, 0.7 * step]),
            feedthrough: dice.choose(&[0.0, 0.005]),
        },
        amplifier: amplifier(dice, step, full_scale),
        summer_inputs: dice.choose(&[None, Some(2), Some(6)]),
        comparator: ComparatorParts {
            delay: dice.choose(&[0.0, 0.4 * step]),
            overdrive: dice.choose(&[0.0, 0.001 * full_scale * step]),
            offset: dice.choose(&[0.0, 0.002 * full_scale]),
            ..ComparatorParts::IDEAL
        },
        reflectivity: ReflectivityParts {
            delay_mismatch: dice.choose(&[0.0, 0.5 * step]),
            ..ReflectivityParts::IDEAL
        },
        ..AnalogParts::ideal()
    };
    if dice.choose(&[true, false]) {
        light(dice, step, &mut parts);
    }
    parts
}

/// Parts of the stage that makes light of slopes, in the same way.
fn light(dice: &mut Dice, step: f64, parts: &mut AnalogParts) {
    let full_scale = parts.full_scale;
    parts.reflectivity = ReflectivityParts {
        slope_full_scale: dice.choose(&[0.3, 1.0, 4.0]),
        multiplier: MultiplierParts {
            error: dice.choose(&[0.0, 0.01]),
            scale_error: dice.choose(&[0.0, 0.005]),
            feedthrough: dice.choose(&[0.0, 0.01]),
            bandwidth: bandwidth(dice, step),
        },
        summer_bandwidth: bandwidth(dice, step),
        root: LoopParts { error: dice.choose(&[0.0, 0.01]), bandwidth: bandwidth(dice, step) },
        divider: LoopParts { error: dice.choose(&[0.0, 0.01]), bandwidth: bandwidth(dice, step) },
        saturation: dice.choose(&[None, Some(0.6 * full_scale), Some(1.1 * full_scale)]),
        ..parts.reflectivity
    };
}

/// Parts of feature generator, texture generator, mixing unit and projection processor, in the same way.
pub fn behind_the_terrain(dice: &mut Dice, step: f64, parts: &mut AnalogParts) {
    let full_scale = parts.full_scale;
    parts.feature = FeatureChainParts { error: dice.choose(&[0.0, 0.01]), bandwidth: bandwidth(dice, step) };
    parts.texture =
        TextureParts { bits: dice.choose(&[None, Some(4), Some(8)]), bandwidth: bandwidth(dice, step) };
    parts.video_switch = VideoSwitchParts {
        time: dice.choose(&[0.0, 0.4 * step, 3.0 * step]),
        level_mismatch: dice.choose(&[0.0, 0.01]),
        gain_mismatch: dice.choose(&[0.0, 0.01]),
        delay_mismatch: dice.choose(&[0.0, 0.1 * step, 1.7 * step]),
        crosstalk: dice.choose(&[None, Some(0.01)]),
    };
    parts.video_bandwidth = bandwidth(dice, step);
    parts.projection = ProjectionParts { error: dice.choose(&[0.0, 0.01]), bandwidth: bandwidth(dice, step) };
    parts.sample_hold = SampleHoldParts {
        acquire: dice.choose(&[0.0, 8.0 * step]),
        droop: dice.choose(&[0.0, 1e-4 * full_scale / step]),
        pedestal: dice.choose(&[0.0, 0.001 * full_scale]),
        aperture: dice.choose(&[0.0, 0.4 * step, 2.5 * step]),
        jitter: dice.choose(&[0.0, 0.02 * step]),
    };
    parts.comparator.delay = dice.choose(&[0.0, 0.4 * step, 1.3 * step]);
    parts.shadow_line = ShadowLineParts { error: dice.choose(&[0.0, 0.01]) };
}

/// Bandwidth of a part whose time constant is a part of a sample, or a few; none where it follows at once.
fn bandwidth(dice: &mut Dice, step: f64) -> Option<f64> {
    let share = libm::exp2(dice.between(-4.3, 1.0));
    dice.choose(&[None, Some(1.0 / (2.0 * PI * step * share))])
}

fn sweep(dice: &mut Dice, step: f64, full_scale: f64) -> SweepParts {
    let smoother = step * dice.between(0.1, 1.5);
    SweepParts {
        dac_bits: dice.choose(&[None, Some(6), Some(10)]),
        settle: dice.choose(&[0.0, 2.0 * step]),
        nonlinearity: dice.choose(&[0.0, 0.002]),
        glitch: dice.choose(&[0.0, 0.01 * full_scale * step]),
        smoother: dice.choose(&[0.0, smoother]),
        strobe_offset: dice.choose(&[0.0, 0.3 * step, -0.2 * step]),
        fold_detect: dice.choose(&[FoldDetect::Digital, FoldDetect::Comparator]),
        preset: dice.choose(&[true, false]),
    }
}

/// Amplifiers that may slew and clip; those that slew have a bandwidth.
fn amplifier(dice: &mut Dice, step: f64, full_scale: f64) -> AmplifierParts {
    let gain_bandwidth = bandwidth(dice, step).map(|band| 7.0 * band);
    AmplifierParts {
        gain_bandwidth,
        slew: gain_bandwidth.and(dice.choose(&[None, Some(full_scale / (20.0 * step))])),
        noise: dice.choose(&[0.0, 1e-4 * full_scale]),
        saturation: dice.choose(&[None, Some(0.3 * full_scale), Some(1.1 * full_scale)]),
        recovery: dice.choose(&[0.0, 5.0 * step]),
    }
}
