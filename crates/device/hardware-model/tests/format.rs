//! `docs/hardware-model-format.md` is true: its examples are read, its keys are all keys, each of them counts.

use std::collections::BTreeSet;
use std::fs;

use hardware_model::{BUILT_IN, HardwareModel, MachineRecord, ModelSource, Settings};
use scenario::{Display, FieldOfView, LawWishes, RasterWishes, Scalar};

const DOC: &str = include_str!("../../../../docs/hardware-model-format.md");

fn blocks() -> Vec<&'static str> {
    let opening = "```toml\n";
    let starts = DOC.match_indices(opening).map(|(at, _)| at + opening.len());
    starts.map(|start| &DOC[start..start + DOC[start..].find("```").unwrap()]).collect()
}

fn documented_keys() -> BTreeSet<&'static str> {
    let (_, table) = DOC.split_once("## Keys\n").unwrap();
    let rows = table.lines().filter_map(|line| line.strip_prefix("| `"));
    rows.map(|row| row.split('`').next().unwrap()).collect()
}

#[test]
fn all_examples_are_read() {
    let [model, overlay, wires] = blocks()[..] else { panic!("a model, an overlay and a model with wires") };
    let folder = tempfile::tempdir().unwrap();
    let [model_file, overlay_file, wires_file] =
        ["model.toml", "overlay.toml", "wires.toml"].map(|name| folder.path().join(name));
    for (file, text) in [(&model_file, model), (&overlay_file, overlay), (&wires_file, wires)] {
        fs::write(file, text).unwrap();
    }
    let loaded =
        HardwareModel::read(&model_file, &[overlay_file], &[]).unwrap_or_else(|list| panic!("{list}"));
    assert_eq!((loaded.model.name.as_str(), loaded.model.loader.access), ("late-loads", 300));
    assert_eq!(loaded.model.loader.delays.len(), 1);
    assert_ne!(loaded.model.range, HardwareModel::ideal().range);
    let wires =
        HardwareModel::read(&wires_file, &[], &[]).unwrap_or_else(|list| panic!("{list}")).model.analog.wires;
    assert!(wires.drives("mu.reflectivity") && !wires.drives("mu.height"));
}

/// A list of one delay with one of its keys changed.
fn delay(key: &str, value: &str) -> String {
    let usual = [
        ("frame", "1"),
        ("sweep", "2"),
        ("crossing", "3"),
        ("colour", "'red'"),
        ("register", "'x-first'"),
        ("word", "[0, 1]"),
        ("ticks", "5"),
    ];
    let pairs = usual.map(|(name, usual)| format!("{name} = {}", if name == key { value } else { usual }));
    format!("[{{ {} }}]", pairs.join(", "))
}

type Setting = (&'static str, String);

/// Each key and a value that `ideal` does not have; the setting between stands in both models compared.
fn changes() -> Vec<(&'static str, Option<Setting>, String)> {
    let two_rate = || Some(("range.programme", "two-rate".to_owned()));
    let scan_converter = || Some(("shadow_controller.variant", "scan-converter".to_owned()));
    let one_delay = || Some(("loader.delay", delay("", "")));
    let mut changes = vec![
        ("raster.sweeps", None, "525".to_owned()),
        ("raster.samples_per_sweep", None, "500".into()),
        ("raster.blanking_fraction", None, "0.17".into()),
        ("raster.update_hz", None, "15".into()),
        ("raster.refresh_hz", None, "60".into()),
        ("range.programme", None, "constant-rate".into()),
        ("range.start_m", None, "2".into()),
        ("range.end_m", None, "6000".into()),
        ("range.switch_m", two_rate(), "70".into()),
        ("range.fine_share", two_rate(), "0.3".into()),
        ("dpu.clock_mhz", None, "20".into()),
        ("level_turn.rate_deg_s", None, "5".into()),
        ("level_turn.range_pct", Some(("level_turn.rate_deg_s", "5".to_owned())), "40".into()),
        ("loader.access_ns", None, "950".into()),
        ("loader.late_policy", None, "latched".into()),
        ("loader.served_by", None, "io-processor".into()),
        ("loader.words_per_access", None, "1".into()),
        ("loader.pointer_ns", None, "100".into()),
        ("loader.strobe_ns", None, "30".into()),
        ("loader.urgent_first", None, "false".into()),
        ("loader.diagonal_register", None, "true".into()),
        ("loader.stop_after_crossings", None, "0".into()),
        ("dpp.projection", None, "as-reported".into()),
        ("dpp.occlusion", None, "derivative".into()),
        ("dpp.curvature", None, "none".into()),
        ("sweep_memory.kind", None, "digital-memory".into()),
        ("sweep_memory.pixel_rule", None, "centre".into()),
        ("feature_generator.organisation", None, "by-region".into()),
        ("feature_generator.sub_generators", None, "6".into()),
        ("feature_generator.light", None, "as-reported".into()),
        ("shadow_controller.variant", None, "scan-converter".into()),
        ("shadow_controller.line_generators", None, "8".into()),
        ("shadow_controller.registration_offset_pct", scan_converter(), "[0, 0.7]".into()),
        ("shadow_controller.registration_gain_pct", scan_converter(), "-0.7".into()),
        ("mixing_unit.gate", None, "self-keyed".into()),
        ("mixing_unit.threshold", None, "0.05".into()),
        ("mixing_unit.texture_in_shadow", None, "off".into()),
        ("polyhedron_generator.visibility", None, "as-reported".into()),
        ("polyhedron_generator.shadowed_bodies", None, "vanish".into()),
        ("polyhedron_generator.shading", None, "smooth".into()),
        ("roll.step_deg", None, "0".into()),
        ("roll.rate_deg_s", None, "3".into()),
        ("roll.travel_deg", None, "30".into()),
    ];
    let delays = [
        ("loader.delay.frame", "9"),
        ("loader.delay.sweep", "9"),
        ("loader.delay.crossing", "9"),
        ("loader.delay.colour", "'black'"),
        ("loader.delay.register", "'y-first'"),
        ("loader.delay.word", "[1, 1]"),
        ("loader.delay.ticks", "9"),
    ];
    changes.extend(digital_changes());
    changes.extend(analog_changes().map(|(key, value)| (key, None, value.to_owned())));
    changes.extend(delays.map(|(key, value)| (key, one_delay(), value.to_owned())));
    changes
}

/// Processor, drums and buffer.
fn digital_changes() -> impl Iterator<Item = (&'static str, Option<Setting>, String)> {
    let drum = || Some(("drum.rotation_ms", "17.4".to_owned()));
    let of_the_drum =
        [("drum.rate_mb_s", "1.2"), ("drum.record_words", "9"), ("drum.queue", "fifo"), ("drum.count", "4")];
    let others = [
        ("cpu.memory_cycle_ns", "850"),
        ("cpu.memory_banks", "4"),
        ("cpu.multiply_us", "5"),
        ("cpu.interrupt_us", "8"),
        ("cpu.longest_instruction_us", "8"),
        ("cpu.crossing_instructions", "10"),
        ("cpu.instruction_cycles", "2"),
        ("cpu.crossing_multiplications", "1"),
        ("cpu.dma_cycles_per_word", "1"),
        ("cpu.sweep_setup_us", "16"),
        ("cpu.frame_tables_ms", "5"),
        ("cpu.vertex_us", "90"),
        ("cpu.priority_levels", "1"),
        ("drum.rotation_ms", "17.4"),
        ("io_processor.order_ns", "400"),
        ("io_processor.chain_ns", "200"),
        ("io_processor.edit_ns", "100"),
        ("channel.count", "1"),
        ("channel.rate_mb_s", "0.45"),
        ("buffer.words", "8192"),
        ("buffer.edit_ns", "100"),
        ("drum.coarse", "together"),
        ("feature_bank.drums", "apart"),
        ("feature_bank.record_words", "80"),
        ("feature_bank.record_regions", "2"),
        ("feature_bank.buffer_words", "4096"),
        ("feature_bank.edit_ns", "100"),
        ("shadow_bank.drums", "together"),
        ("shadow_bank.record_words", "80"),
        ("shadow_bank.record_regions", "2"),
        ("shadow_bank.buffer_words", "4096"),
        ("shadow_bank.edit_ns", "100"),
        ("polyhedron_bank.drums", "apart"),
        ("polyhedron_bank.record_words", "80"),
        ("polyhedron_bank.record_regions", "2"),
        ("polyhedron_bank.buffer_words", "4096"),
        ("polyhedron_bank.edit_ns", "100"),
        ("shadow_controller.load_words_us", "10"),
    ];
    let of_the_drum = of_the_drum.into_iter().map(move |(key, value)| (key, drum(), value.to_owned()));
    of_the_drum.chain(others.into_iter().map(|(key, value)| (key, None, value.to_owned())))
}

fn analog_changes() -> [(&'static str, &'static str); 89] {
    [
        ("analog.full_scale_v", "10"),
        ("spread.parts", "on"),
        ("spread.seed", "1970"),
        ("sweep.dac_bits", "10"),
        ("sweep.settle_ns", "150"),
        ("sweep.glitch_v_ns", "20"),
        ("sweep.smoother_ns", "40"),
        ("sweep.fold_detect", "comparator"),
        ("sweep.strobe_offset_ns", "-10"),
        ("sweep.preset", "off"),
        ("level_blend.weight", "cubic"),
        ("level_blend.slope_term", "off"),
        ("function_generator.segments", "20"),
        ("function_generator.error_pct", "0.1"),
        ("function_generator.bandwidth_mhz", "5"),
        ("multiplier.error_pct", "0.25"),
        ("multiplier.bandwidth_mhz", "8"),
        ("multiplying_dac.bits", "12"),
        ("multiplying_dac.gain_error_pct", "0.05"),
        ("multiplying_dac.bandwidth_mhz", "4"),
        ("multiplying_dac.glitch_v_ns", "150"),
        ("amplifier.gain_bandwidth_mhz", "80"),
        ("amplifier.slew_v_us", "200"),
        ("amplifier.noise_mv", "0.5"),
        ("amplifier.saturation_v", "11"),
        ("summer.inputs_per_stage", "6"),
        ("comparator.delay_ns", "40"),
        ("comparator.overdrive_mv_ns", "150"),
        ("comparator.hysteresis_pct", "0.1"),
        ("comparator.offset_mv", "2"),
        ("sample_hold.acquire_ns", "400"),
        ("sample_hold.droop_mv_us", "0.01"),
        ("sample_hold.pedestal_mv", "5"),
        ("reflectivity.delay_mismatch_ns", "12"),
        ("reflectivity.slope_full_scale", "2"),
        ("reflectivity.multiplier_error_pct", "0.25"),
        ("reflectivity.multiplier_scale_error_pct", "0.2"),
        ("reflectivity.multiplier_feedthrough_pct", "0.5"),
        ("reflectivity.multiplier_bandwidth_mhz", "8"),
        ("reflectivity.summer_bandwidth_mhz", "20"),
        ("reflectivity.root_error_pct", "0.5"),
        ("reflectivity.root_bandwidth_mhz", "5"),
        ("reflectivity.divider_error_pct", "1"),
        ("reflectivity.divider_bandwidth_mhz", "3"),
        ("reflectivity.saturation_v", "11"),
        ("video_switch.time_ns", "20"),
        ("video_switch.level_mismatch_pct", "1"),
        ("video.bandwidth_mhz", "12"),
        ("wires.bandwidth_mhz", "12"),
        ("wires.slew_v_us", "200"),
        ("wires.signals", "[\"mu.height\"]"),
        ("dpp.function_error_pct", "0.3"),
        ("dpp.function_bandwidth_mhz", "8"),
        ("sweep_memory.tubes", "2"),
        ("sweep_memory.tv_lines", "650"),
        ("sweep_memory.grey", "8"),
        ("sweep_memory.erase_residual", "0.08"),
        ("sweep_memory.registration_pct", "0.7"),
        ("sweep_memory.write_compensation", "100"),
        ("sweep_memory.write_compensation", "off"),
        ("sweep_memory.deflection_mhz", "3"),
        ("sweep_memory.bits", "6"),
        ("picture_tube.bandwidth_mhz", "10"),
        ("picture_tube.correction", "2.2"),
        ("picture_tube.gamma", "2.2"),
        ("picture_tube.cut_off_pct", "5"),
        ("picture_tube.phosphor_ms", "0.04"),
        ("picture_tube.tv_lines", "800"),
        ("picture_tube.fields", "2"),
        ("feature_generator.load_words_us", "10"),
        ("sweep.nonlinearity_pct", "0.05"),
        ("function_generator.rounding_mv", "50"),
        ("multiplier.scale_error_pct", "0.2"),
        ("multiplier.feedthrough_pct", "0.5"),
        ("multiplying_dac.switching_ns", "80"),
        ("multiplying_dac.feedthrough_pct", "0.3"),
        ("amplifier.recovery_us", "1"),
        ("sample_hold.aperture_ns", "20"),
        ("sample_hold.jitter_ns", "1"),
        ("video_switch.gain_mismatch_pct", "1"),
        ("video_switch.delay_mismatch_ns", "5"),
        ("video_switch.crosstalk_db", "-50"),
        ("feature_generator.chain_error_pct", "0.25"),
        ("feature_generator.chain_bandwidth_mhz", "5"),
        ("shadow_controller.line_error_pct", "0.25"),
        ("texture_generator.dac_bits", "6"),
        ("texture_generator.filter_mhz", "5"),
        ("roll.natural_hz", "90"),
        ("roll.damping", "0.25"),
    ]
}

fn model(sets: &[(&str, String)]) -> HardwareModel {
    let sets: Vec<(String, String)> =
        sets.iter().map(|(key, value)| ((*key).into(), value.clone())).collect();
    let ideal = ModelSource::BuiltIn("ideal".into());
    HardwareModel::load(&ideal, &[], &sets).unwrap_or_else(|list| panic!("{list}")).model
}

#[test]
fn every_documented_key_changes_something() {
    for (key, before, value) in changes() {
        let usual: Vec<(&str, String)> = before.into_iter().collect();
        let change = match key.strip_prefix("loader.delay.") {
            Some(part) => ("loader.delay", delay(part, &value)),
            None => (key, value),
        };
        let changed: Vec<(&str, String)> = usual.iter().cloned().chain([change]).collect();
        assert_ne!(model(&usual), model(&changed), "{key} changes nothing");
    }
}

/// Who goes on with a run holds its record to what is asked now: a key that changes the settings changes record or view.
#[test]
fn every_setting_stands_in_the_record() {
    let field = FieldOfView { tan_half_width: 0.4, tan_half_height: 0.3 };
    let settings = |model: &HardwareModel| {
        let display = Display { white: 1.0, gamma: 1.0 };
        let (wishes, laws) = (RasterWishes::default(), LawWishes::default());
        Settings::resolve(model, field, wishes, None, laws, Scalar::F32, display).expect("settings")
    };
    let mut told = 0;
    for (key, before, value) in changes() {
        if key.starts_with("loader.delay.") {
            continue;
        }
        let usual: Vec<(&str, String)> = before.into_iter().collect();
        let changed: Vec<(&str, String)> = usual.iter().cloned().chain([(key, value)]).collect();
        let [one, mut other] = [usual, changed].map(|sets| settings(&model(&sets)));
        if one.kind_banks.is_plain() && other.kind_banks.is_plain() {
            // Where each kind lies in a memory of its generator, records and buffers are of no effect.
            other.kind_banks = one.kind_banks;
        }
        if one != other {
            let differs = MachineRecord::of(&one) != MachineRecord::of(&other) || one.view() != other.view();
            assert!(differs, "{key} is not in the record");
            told += 1;
        }
    }
    assert!(told > 100, "{told} keys");
}

#[test]
fn the_table_names_every_key_and_no_other() {
    let mut tried: BTreeSet<&str> = changes().iter().map(|change| change.0).collect();
    tried.extend(["format", "name", "base"]);
    assert_eq!(documented_keys(), tried);
}

#[test]
fn the_ideal_model_writes_every_key() {
    let loaded = HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &[], &[]).unwrap();
    let written: BTreeSet<&str> = loaded.values.iter().map(|value| value.key.as_str()).collect();
    let of_the_table = |key: &&str| *key != "base" && !key.starts_with("loader.delay.");
    let mut expected: BTreeSet<&str> = documented_keys().into_iter().filter(of_the_table).collect();
    expected.insert("loader.delay");
    assert_eq!(written, expected);
    assert!(BUILT_IN[0].1.contains("hardware-model-format.md"));
}
