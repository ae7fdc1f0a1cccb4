//! The keys of the analog parts. Units change here: inside, all is in seconds, hertz, volts and shares.

use diagnostics::{Field, Reader};

use crate::{
    AmplifierParts, AnalogParts, BlendWeight, ComparatorParts, FeatureChainParts, FoldDetect,
    FunctionGeneratorParts, LevelBlendParts, LoopParts, MAIN_WIRES, MemoryParts, MultiplierParts,
    MultiplyingDacParts, PictureTubeParts, ProjectionParts, ReflectivityParts, SampleHoldParts,
    ShadowLineParts, SweepParts, TextureParts, VideoSwitchParts, WireParts, WriteCompensation,
};

/// Tables that hold analog keys beside others.
pub(super) struct SharedTables<'r, 'a> {
    pub spread: &'r Option<Reader<'a>>,
    pub dpp: &'r Option<Reader<'a>>,
    pub memory: &'r Option<Reader<'a>>,
    pub features: &'r Option<Reader<'a>>,
    pub shadows: &'r Option<Reader<'a>>,
}

/// Every table is read before one that is missing or wrong ends the reading.
pub(super) fn analog(root: &Reader, shared: &SharedTables) -> Option<AnalogParts> {
    let part = |name: &str| root.table(name);
    let full_scale = part("analog").map(|t| t.f64("full_scale_v").between(1e-3, 1e3).unit("V").required());
    let switch = [("on", true), ("off", false)];
    let spread = shared.spread.as_ref().map(|t| t.one_of("parts", &switch).required());
    let sweep = part("sweep").map(|t| sweep(&t));
    let function_generator = part("function_generator").map(|t| function_generator(&t));
    let multiplier = part("multiplier").map(|t| multiplier(&t));
    let multiplying_dac = part("multiplying_dac").map(|t| multiplying_dac(&t));
    let amplifier = part("amplifier").map(|t| amplifier(&t));
    let summer =
        part("summer").map(|t| t.u32("inputs_per_stage").between(2, 36).or_word("unlimited").required());
    let comparator = part("comparator").map(|t| comparator(&t));
    let sample_hold = part("sample_hold").map(|t| sample_hold(&t));
    let reflectivity = part("reflectivity").map(|t| reflectivity(&t));
    let level_blend = level_blend(&root.table_or_empty("level_blend"));
    let video_switch = part("video_switch").map(|t| video_switch(&t));
    let video = part("video").map(|t| megahertz(&t, "bandwidth_mhz").required());
    let projection = shared.dpp.as_ref().map(projection);
    let memory = shared.memory.as_ref().map(memory);
    let picture_tube = picture_tube(&root.table_or_empty("picture_tube"));
    let feature = shared.features.as_ref().map(feature_chain);
    let shadow_line = shared.shadows.as_ref().map(|t| percent(t, "line_error_pct").required());
    let texture = part("texture_generator").map(|t| texture(&t));
    let wires = part("wires").map(|t| wires(&t));
    Some(AnalogParts {
        full_scale: full_scale??,
        spread: spread??,
        sweep: sweep??,
        function_generator: function_generator??,
        multiplier: multiplier??,
        multiplying_dac: multiplying_dac??,
        amplifier: amplifier??,
        summer_inputs: summer??,
        comparator: comparator??,
        sample_hold: sample_hold??,
        reflectivity: reflectivity??,
        level_blend: level_blend?,
        video_switch: video_switch??,
        feature: feature??,
        shadow_line: ShadowLineParts { error: shadow_line?? },
        texture: texture??,
        projection: projection??,
        memory: memory??,
        picture_tube: picture_tube?,
        video_bandwidth: video??,
        wires: wires??,
    })
}

fn nanoseconds<'a>(table: &Reader<'a>, key: &str) -> Field<'a, f64> {
    table.f64(key).between(0.0, 1e9).unit("ns").map(|time| 1e-9 * time)
}

fn signed_nanoseconds<'a>(table: &Reader<'a>, key: &str) -> Field<'a, f64> {
    table.f64(key).between(-1e6, 1e6).unit("ns").map(|time| 1e-9 * time)
}

/// Reads a key in millivolts, 0 to 1e6; the value is in volts.
fn millivolts<'a>(table: &Reader<'a>, key: &str) -> Field<'a, f64> {
    table.f64(key).between(0.0, 1e6).unit("mV").map(|voltage| 1e-3 * voltage)
}

/// Volts times nanoseconds, the area of a pulse; volt seconds inside.
fn pulse<'a>(table: &Reader<'a>, key: &str) -> Field<'a, f64> {
    table.f64(key).between(0.0, 1e9).unit("V ns").map(|area| 1e-9 * area)
}

fn percent<'a>(table: &Reader<'a>, key: &str) -> Field<'a, f64> {
    table.f64(key).between(0.0, 100.0).unit("%").map(|share| 0.01 * share)
}

fn megahertz<'a>(table: &Reader<'a>, key: &str) -> Field<'a, Option<f64>> {
    let rate = table.f64(key).above(0.0).at_most(1e6).unit("MHz");
    rate.map(|rate| 1e6 * rate).or_word("unlimited")
}

fn volts_a_microsecond<'a>(table: &Reader<'a>, key: &str) -> Field<'a, Option<f64>> {
    let slew = table.f64(key).between(0.0, 1e9).unit("V/µs");
    slew.map(|slew| 1e6 * slew).or_word("unlimited")
}

fn bits<'a>(table: &Reader<'a>, key: &str) -> Field<'a, Option<u32>> {
    table.u32(key).between(1, 24).or_word("exact")
}

fn sweep(table: &Reader) -> Option<SweepParts> {
    let dac_bits = bits(table, "dac_bits").required();
    let settle = nanoseconds(table, "settle_ns").required();
    let nonlinearity = percent(table, "nonlinearity_pct").required();
    let glitch = pulse(table, "glitch_v_ns").required();
    let smoother = nanoseconds(table, "smoother_ns").required();
    let strobe_offset = signed_nanoseconds(table, "strobe_offset_ns").required();
    let ways = [("digital", FoldDetect::Digital), ("comparator", FoldDetect::Comparator)];
    let fold_detect = table.one_of("fold_detect", &ways).required();
    let preset = table.one_of("preset", &[("on", true), ("off", false)]).default(true);
    Some(SweepParts {
        dac_bits: dac_bits?,
        settle: settle?,
        nonlinearity: nonlinearity?,
        glitch: glitch?,
        smoother: smoother?,
        strobe_offset: strobe_offset?,
        fold_detect: fold_detect?,
        preset: preset?,
    })
}

fn level_blend(table: &Reader) -> Option<LevelBlendParts> {
    let usual = LevelBlendParts::IDEAL;
    let weights = [("quintic", BlendWeight::Quintic), ("cubic", BlendWeight::Cubic)];
    let weight = table.one_of("weight", &weights).default(usual.weight);
    let slope_term = table.one_of("slope_term", &[("on", true), ("off", false)]).default(usual.slope_term);
    Some(LevelBlendParts { weight: weight?, slope_term: slope_term? })
}

fn function_generator(table: &Reader) -> Option<FunctionGeneratorParts> {
    let segments = table.u32("segments").between(1, 1000).or_word("exact").required();
    let rounding = millivolts(table, "rounding_mv").required();
    let error = percent(table, "error_pct").required();
    let bandwidth = megahertz(table, "bandwidth_mhz").required();
    Some(FunctionGeneratorParts {
        segments: segments?,
        rounding: rounding?,
        error: error?,
        bandwidth: bandwidth?,
    })
}

fn multiplier(table: &Reader) -> Option<MultiplierParts> {
    let error = percent(table, "error_pct").required();
    let scale_error = percent(table, "scale_error_pct").required();
    let feedthrough = percent(table, "feedthrough_pct").required();
    let bandwidth = megahertz(table, "bandwidth_mhz").required();
    Some(MultiplierParts {
        error: error?,
        scale_error: scale_error?,
        feedthrough: feedthrough?,
        bandwidth: bandwidth?,
    })
}

fn multiplying_dac(table: &Reader) -> Option<MultiplyingDacParts> {
    let bits = bits(table, "bits").required();
    let gain_error = percent(table, "gain_error_pct").required();
    let bandwidth = megahertz(table, "bandwidth_mhz").required();
    let glitch = pulse(table, "glitch_v_ns").required();
    let switching = nanoseconds(table, "switching_ns").required();
    let feedthrough = percent(table, "feedthrough_pct").required();
    Some(MultiplyingDacParts {
        bits: bits?,
        gain_error: gain_error?,
        bandwidth: bandwidth?,
        glitch: glitch?,
        switching: switching?,
        feedthrough: feedthrough?,
    })
}

fn amplifier(table: &Reader) -> Option<AmplifierParts> {
    let gain_bandwidth = megahertz(table, "gain_bandwidth_mhz").required();
    let slew = volts_a_microsecond(table, "slew_v_us").required();
    let noise = millivolts(table, "noise_mv").required();
    let saturation = saturation(table).required();
    let recovery = table.f64("recovery_us").between(0.0, 1e6).unit("µs").map(|time| 1e-6 * time).required();
    Some(AmplifierParts {
        gain_bandwidth: gain_bandwidth?,
        slew: slew?,
        noise: noise?,
        saturation: saturation?,
        recovery: recovery?,
    })
}

fn saturation<'a>(table: &Reader<'a>) -> Field<'a, Option<f64>> {
    table.f64("saturation_v").above(0.0).at_most(1e6).unit("V").or_word("unlimited")
}

fn comparator(table: &Reader) -> Option<ComparatorParts> {
    let delay = nanoseconds(table, "delay_ns").required();
    let overdrive = table.f64("overdrive_mv_ns").between(0.0, 1e9).unit("mV ns").map(|area| 1e-12 * area);
    let overdrive = overdrive.required();
    let hysteresis = percent(table, "hysteresis_pct").required();
    let offset = millivolts(table, "offset_mv").required();
    Some(ComparatorParts { delay: delay?, overdrive: overdrive?, hysteresis: hysteresis?, offset: offset? })
}

fn sample_hold(table: &Reader) -> Option<SampleHoldParts> {
    let acquire = nanoseconds(table, "acquire_ns").required();
    let droop = table.f64("droop_mv_us").between(0.0, 1e6).unit("mV/µs").map(|rate| 1e3 * rate).required();
    let pedestal = millivolts(table, "pedestal_mv").required();
    let aperture = nanoseconds(table, "aperture_ns").required();
    let jitter = nanoseconds(table, "jitter_ns").required();
    Some(SampleHoldParts {
        acquire: acquire?,
        droop: droop?,
        pedestal: pedestal?,
        aperture: aperture?,
        jitter: jitter?,
    })
}

/// A model without the keys of the stage has an ideal one: files from before there were any keep their meaning.
fn reflectivity(table: &Reader) -> Option<ReflectivityParts> {
    const IDEAL: ReflectivityParts = ReflectivityParts::IDEAL;
    let delay_mismatch = signed_nanoseconds(table, "delay_mismatch_ns").required();
    let slope_full_scale = table.f64("slope_full_scale").between(0.01, 100.0).unit("m/m");
    let slope_full_scale = slope_full_scale.default(IDEAL.slope_full_scale);
    let error = percent(table, "multiplier_error_pct").default(IDEAL.multiplier.error);
    let scale_error = percent(table, "multiplier_scale_error_pct").default(IDEAL.multiplier.scale_error);
    let feedthrough = percent(table, "multiplier_feedthrough_pct").default(IDEAL.multiplier.feedthrough);
    let bandwidth = megahertz(table, "multiplier_bandwidth_mhz").default(IDEAL.multiplier.bandwidth);
    let summer_bandwidth = megahertz(table, "summer_bandwidth_mhz").default(IDEAL.summer_bandwidth);
    let root_error = percent(table, "root_error_pct").default(IDEAL.root.error);
    let root_bandwidth = megahertz(table, "root_bandwidth_mhz").default(IDEAL.root.bandwidth);
    let divider_error = percent(table, "divider_error_pct").default(IDEAL.divider.error);
    let divider_bandwidth = megahertz(table, "divider_bandwidth_mhz").default(IDEAL.divider.bandwidth);
    let saturation = saturation(table).default(IDEAL.saturation);
    Some(ReflectivityParts {
        delay_mismatch: delay_mismatch?,
        slope_full_scale: slope_full_scale?,
        multiplier: MultiplierParts {
            error: error?,
            scale_error: scale_error?,
            feedthrough: feedthrough?,
            bandwidth: bandwidth?,
        },
        summer_bandwidth: summer_bandwidth?,
        root: LoopParts { error: root_error?, bandwidth: root_bandwidth? },
        divider: LoopParts { error: divider_error?, bandwidth: divider_bandwidth? },
        saturation: saturation?,
    })
}

fn video_switch(table: &Reader) -> Option<VideoSwitchParts> {
    let time = nanoseconds(table, "time_ns").required();
    let level_mismatch = percent(table, "level_mismatch_pct").required();
    let gain_mismatch = percent(table, "gain_mismatch_pct").required();
    let delay_mismatch = nanoseconds(table, "delay_mismatch_ns").required();
    let crosstalk = decibels(table, "crosstalk_db").required();
    Some(VideoSwitchParts {
        time: time?,
        level_mismatch: level_mismatch?,
        gain_mismatch: gain_mismatch?,
        delay_mismatch: delay_mismatch?,
        crosstalk: crosstalk?,
    })
}

/// Decibels below the signal; a share inside.
fn decibels<'a>(table: &Reader<'a>, key: &str) -> Field<'a, Option<f64>> {
    let loss = table.f64(key).between(-200.0, -1.0).unit("dB");
    loss.map(|loss| libm::pow(10.0, loss / 20.0)).or_word("none")
}

fn feature_chain(table: &Reader) -> Option<FeatureChainParts> {
    let error = percent(table, "chain_error_pct").required();
    let bandwidth = megahertz(table, "chain_bandwidth_mhz").required();
    Some(FeatureChainParts { error: error?, bandwidth: bandwidth? })
}

fn texture(table: &Reader) -> Option<TextureParts> {
    let bits = bits(table, "dac_bits").required();
    let bandwidth = megahertz(table, "filter_mhz").required();
    Some(TextureParts { bits: bits?, bandwidth: bandwidth? })
}

fn wires(table: &Reader) -> Option<WireParts> {
    let bandwidth = megahertz(table, "bandwidth_mhz").required();
    let slew = volts_a_microsecond(table, "slew_v_us").required();
    let rule = format!("names among {}", MAIN_WIRES.join(", "));
    let known = |names: &Vec<String>| names.iter().all(|name| MAIN_WIRES.contains(&name.as_str()));
    let names = table.string_list("signals").must(&rule, known).required()?;
    let driven = MAIN_WIRES.map(|wire| names.iter().any(|name| name == wire));
    Some(WireParts { bandwidth: bandwidth?, slew: slew?, driven })
}

fn projection(table: &Reader) -> Option<ProjectionParts> {
    let error = percent(table, "function_error_pct").required();
    let bandwidth = megahertz(table, "function_bandwidth_mhz").required();
    Some(ProjectionParts { error: error?, bandwidth: bandwidth? })
}

fn memory(table: &Reader) -> Option<MemoryParts> {
    let tubes = table.u32("tubes").between(1, 2).required();
    let tv_lines = tv_lines(table).required();
    let grey = table.u32("grey").between(2, 65_536).or_word("unlimited").required();
    let erase_residual = table.f64("erase_residual").at_least(0.0).below(1.0).required();
    let registration = percent(table, "registration_pct").required();
    let write_compensation = write_compensation(table).required();
    let deflection = megahertz(table, "deflection_mhz").required();
    // A file from before there was this key keeps its meaning.
    let bits = bits(table, "bits").default(MemoryParts::IDEAL.bits);
    Some(MemoryParts {
        tv_lines: tv_lines?,
        grey: grey?,
        erase_residual: erase_residual?,
        registration: registration?,
        write_compensation: write_compensation?,
        deflection: deflection?,
        tubes: tubes?,
        bits: bits?,
    })
}

/// A model without these keys has an ideal display: files from before there were any keep their meaning.
fn picture_tube(table: &Reader) -> Option<PictureTubeParts> {
    const IDEAL: PictureTubeParts = PictureTubeParts::IDEAL;
    let bandwidth = megahertz(table, "bandwidth_mhz").default(IDEAL.bandwidth);
    let correction = table.f64("correction").between(1.0, 4.0).default(IDEAL.correction);
    let gamma = table.f64("gamma").between(1.0, 4.0).default(IDEAL.gamma);
    let cut_off = table.f64("cut_off_pct").between(0.0, 50.0).unit("%").map(|share| 0.01 * share);
    let cut_off = cut_off.default(IDEAL.cut_off);
    let phosphor = table.f64("phosphor_ms").between(0.0, 1e3).unit("ms").map(|time| 1e-3 * time);
    let phosphor = phosphor.default(IDEAL.phosphor);
    let tv_lines = tv_lines(table).default(IDEAL.tv_lines);
    let fields = table.u32("fields").between(1, 2).default(IDEAL.fields);
    Some(PictureTubeParts {
        bandwidth: bandwidth?,
        correction: correction?,
        gamma: gamma?,
        cut_off: cut_off?,
        phosphor: phosphor?,
        tv_lines: tv_lines?,
        fields: fields?,
    })
}

fn tv_lines<'a>(table: &Reader<'a>) -> Field<'a, Option<u32>> {
    table.u32("tv_lines").between(2, 100_000).or_word("unlimited")
}

fn write_compensation<'a>(table: &Reader<'a>) -> Field<'a, WriteCompensation> {
    let ratio = table.f64("write_compensation").between(1.0, 1e9).map(WriteCompensation::Ratio);
    let or_exact = ratio.or_word("exact").map(|ratio| ratio.unwrap_or(WriteCompensation::Exact));
    or_exact.or_word("off").map(|found| found.unwrap_or(WriteCompensation::Off))
}
