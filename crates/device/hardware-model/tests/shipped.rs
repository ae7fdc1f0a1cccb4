//! The models and overlays that the program carries.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use hardware_model::{
    AnalogParts, BLOCK_TABLES, BUILT_IN, Channels, CrossingServer, DrumQueue, FAULTS, FoldDetect, Grade,
    HardwareModel, IoProcessor, LoadedModel, ModelSource, PartCounts, WriteCompensation, prediction, proof,
};

const STATUS: [&str; 6] = ["reported", "inferred", "period", "unsourced", "chosen", "measured"];

fn load(name: &str, overlays: &[&str]) -> LoadedModel {
    let overlays: Vec<PathBuf> = overlays.iter().map(PathBuf::from).collect();
    let source = ModelSource::BuiltIn(name.into());
    HardwareModel::load(&source, &overlays, &[]).unwrap_or_else(|list| panic!("{name}: {list}"))
}

fn model(name: &str) -> HardwareModel {
    load(name, &[]).model
}

/// `value`, to a rounding of its unit.
fn assert_near(found: f64, value: f64) {
    assert!((found - value).abs() <= 1e-12 * value.abs(), "{found} for {value}");
}

/// Artefacts that a model is warned of.
fn artefacts(model: &HardwareModel) -> BTreeSet<&'static str> {
    let grades = model.check().into_iter().map(|finding| finding.grade);
    grades.filter_map(|grade| if let Grade::Warn(artefact) = grade { artefact } else { None }).collect()
}

#[test]
fn every_model_is_read_and_has_its_own_name() {
    for (name, _) in BUILT_IN {
        assert_eq!(model(name).name, name);
    }
    let complete = load("pra-nominal", &[]);
    let places = complete.values.iter().filter(|value| !value.origin.contains("pra-nominal"));
    assert_eq!(places.count(), 0, "pra-nominal stands on its own feet");
}

#[test]
fn every_value_says_where_it_comes_from() {
    for (name, text) in BUILT_IN.iter().chain(&FAULTS) {
        let is_value = |line: &&str| line.contains(" = ") && !line.starts_with(['#', ' ']);
        let is_head = |line: &&str| ["format ", "name ", "base "].iter().any(|head| line.starts_with(head));
        let says = |line: &&str| {
            let (_, comment) = line.split_once(" # ").unwrap_or_default();
            STATUS.iter().any(|status| comment.starts_with(status))
        };
        let values = text.lines().filter(is_value).filter(|line| !is_head(line));
        let without: Vec<&str> = values.filter(|line| !says(line)).collect();
        assert_eq!(without, [""; 0], "{name}");
    }
}

#[test]
fn what_is_carried_is_what_is_in_the_folder() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../hardware-models");
    let stems = |folder: PathBuf| -> BTreeSet<String> {
        let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let models = files.filter(|path| path.extension().is_some_and(|extension| extension == "toml"));
        models.map(|path| path.file_stem().unwrap().to_string_lossy().into_owned()).collect()
    };
    assert_eq!(stems(folder.clone()), BUILT_IN.map(|(name, _)| name.to_owned()).into());
    assert_eq!(stems(folder.join("faults")), FAULTS.map(|(name, _)| name.to_owned()).into());
}

#[test]
fn nothing_analog_is_there_in_the_ideal_model() {
    let ideal = HardwareModel::ideal();
    assert_eq!(ideal.analog, AnalogParts::ideal());
    assert!(ideal.analog.is_ideal() && ideal.loader.is_wired_through());
    assert_eq!((ideal.data_banks.drum, ideal.data_banks.buffer_words), (None, None));
    assert_eq!(ideal.data_banks.channels, Channels::default());
    assert_eq!((ideal.cpu, ideal.feature_words, ideal.seed), (Default::default(), None, 0));
}

#[test]
fn units_of_the_analog_parts() {
    let analog = model("pra-nominal").analog;
    let pairs = [
        (analog.full_scale, 10.0),
        (analog.sweep.settle, 150e-9),
        (analog.sweep.glitch, 20e-9),
        (analog.sweep.smoother, 40e-9),
        (analog.function_generator.error, 0.001),
        (analog.function_generator.bandwidth.unwrap(), 5e6),
        (analog.multiplier.error, 0.0025),
        (analog.multiplying_dac.gain_error, 0.0005),
        (analog.multiplying_dac.glitch, 150e-9),
        (analog.amplifier.gain_bandwidth.unwrap(), 80e6),
        (analog.amplifier.slew.unwrap(), 200e6),
        (analog.amplifier.noise, 0.5e-3),
        (analog.amplifier.saturation.unwrap(), 11.0),
        (analog.comparator.delay, 40e-9),
        (analog.comparator.overdrive, 150e-12),
        (analog.comparator.hysteresis, 0.001),
        (analog.comparator.offset, 2e-3),
        (analog.sample_hold.acquire, 400e-9),
        (analog.sample_hold.droop, 10.0),
        (analog.sample_hold.pedestal, 5e-3),
        (analog.reflectivity.delay_mismatch, 12e-9),
        (analog.sample_hold.aperture, 20e-9),
        (analog.sample_hold.jitter, 1e-9),
        (analog.video_switch.time, 20e-9),
        (analog.video_switch.gain_mismatch, 0.01),
        (analog.video_switch.delay_mismatch, 5e-9),
        (analog.video_switch.crosstalk.unwrap(), 0.003_162_277_660_168_379_5),
        (analog.sweep.nonlinearity, 0.0005),
        (analog.function_generator.rounding, 0.05),
        (analog.multiplier.scale_error, 0.002),
        (analog.multiplier.feedthrough, 0.005),
        (analog.multiplying_dac.switching, 80e-9),
        (analog.multiplying_dac.feedthrough, 0.003),
        (analog.amplifier.recovery, 1e-6),
        (analog.feature.error, 0.0025),
        (analog.feature.bandwidth.unwrap(), 5e6),
        (analog.shadow_line.error, 0.0025),
        (analog.texture.bandwidth.unwrap(), 5e6),
        (analog.projection.error, 0.003),
        (analog.memory.erase_residual, 0.08),
        (analog.memory.registration, 0.007),
        (analog.memory.deflection.unwrap(), 3e6),
        (analog.video_bandwidth.unwrap(), 12e6),
        (model("pra-nominal").yoke.natural.unwrap(), 90.0),
        (model("pra-nominal").feature_words.unwrap(), 10e6),
    ];
    for (found, value) in pairs {
        assert_near(found, value);
    }
    assert_eq!((analog.sweep.dac_bits, analog.multiplying_dac.bits), (Some(10), Some(12)));
    assert_eq!((analog.function_generator.segments, analog.summer_inputs), (Some(20), Some(6)));
    assert_eq!(analog.texture.bits, Some(6));
    assert_eq!(analog.memory.write_compensation, WriteCompensation::Ratio(100.0));
    assert_eq!(model("pra-overloaded").analog.memory.write_compensation, WriteCompensation::Off);
    assert_eq!(model("pra-overloaded").analog.sweep.fold_detect, FoldDetect::Comparator);
}

#[test]
fn times_of_the_digital_side_are_ticks() {
    let nominal = model("pra-nominal");
    // At 20 MHz: 100 ns are 2 ticks, 30 ns 1.
    assert_eq!((nominal.loader.access, nominal.loader.pointer, nominal.loader.strobe), (2, 2, 1));
    assert_eq!((nominal.cpu.sweep_setup, nominal.cpu.frame_tables), (320, 100_000));
    let drum = nominal.data_banks.drum.unwrap();
    assert_eq!((drum.rotation, drum.count, drum.queue), (348_000, 4, DrumQueue::ShortestLatency));
    // 1.2 MB/s are 0.6 words a microsecond: 33 1/3 ticks a word.
    assert_near(drum.word, 100.0 / 3.0);
    // Its channels are faster, and as many: 3 MB/s are 13 1/3 ticks a word.
    let channels = nominal.data_banks.channels;
    assert_eq!(channels.count, Some(4));
    assert_near(channels.word, 40.0 / 3.0);
    // At 5 MHz: 1.2 µs are 6 ticks, 200 ns 1. Nobody else has an I/O processor.
    let frugal = model("pra-frugal").loader;
    assert_eq!(frugal.channel_programme(), IoProcessor { order: 6, chain: 1, edit: 0 });
    assert_eq!(nominal.loader.channel_programme(), IoProcessor::default());
    assert_eq!(model("modern-analog").data_banks.drum, None);
    assert_eq!(model("pra-overloaded").loader.served_by, CrossingServer::CpuInterrupt);
}

#[test]
fn sane_machines_pass_and_others_are_warned() {
    for sane in ["ideal", "pra-wires", "pra-parts", "pra-nominal", "modern-analog"] {
        assert_eq!(model(sane).check(), [], "{sane}");
    }
    assert_eq!(artefacts(&model("pra-frugal")), ["A1", "A24"].into());
    let overloaded = model("pra-overloaded");
    assert!(overloaded.check().iter().all(|finding| finding.grade != Grade::Refuse));
    assert!(artefacts(&overloaded).len() >= 18, "{:?}", artefacts(&overloaded));
}

/// The artefact that a file says it proves is the one that its model is warned of.
#[test]
fn each_fault_is_found_and_no_other() {
    for (name, text) in FAULTS {
        let proves = text.split("Proves ").nth(1).unwrap().split([',', ' ']).next().unwrap();
        let faulty = load("ideal", &[name]);
        assert_eq!(artefacts(&faulty.model), [proves].into(), "{name}");
        assert!(faulty.files.is_empty(), "{name} is carried, not read from a file");
        assert!(faulty.values.iter().any(|value| value.origin.contains(&format!("faults/{name}.toml"))));
    }
}

#[test]
fn faults_go_over_any_model_and_over_one_another() {
    let both = load("pra-nominal", &["quilt", "starve"]).model;
    assert_near(both.analog.multiplying_dac.gain_error, 0.02);
    assert_eq!(both.data_banks.drum.unwrap().record_words, 9);
    let source = ModelSource::BuiltIn("ideal".into());
    let unknown = HardwareModel::load(&source, &["taer".into()], &[]).unwrap_err().to_string();
    assert!(unknown.contains("taer: no such file"), "{unknown}");
}

/// Section 6.1 of the specification, and hardware 1 for the slopes.
#[test]
fn parts_are_counted() {
    let nominal = PartCounts::of(&model("pra-nominal"));
    assert_eq!((nominal.function_generators, nominal.derivative_generators), (12, 12));
    assert_eq!((nominal.height_multipliers, nominal.multipliers), (36, 108));
    assert_eq!((nominal.height_multiplying_dacs, nominal.multiplying_dacs), (36, 108));
    assert_eq!((nominal.registers, nominal.wired_pointers, nominal.buffer_banks), (108, 4, 4));
    // Six amplifiers of six inputs and one over them, three times.
    assert_eq!(nominal.summing_amplifiers, 21);
    assert_eq!((nominal.sub_generators, nominal.line_generators, nominal.tubes), (Some(18), Some(8), 2));
    let overloaded = PartCounts::of(&model("pra-overloaded"));
    assert_eq!((overloaded.summing_amplifiers, overloaded.limit_stops, overloaded.wired_pointers), (3, 4, 0));
    assert_eq!(PartCounts::of(&model("modern-analog")).registers, 144);
    let text = PartCounts::of(&HardwareModel::ideal()).to_string();
    for part in ["108 analog multipliers (36 for the height)", "any number of sub-generators", "1 tube\n"] {
        assert!(text.contains(part), "{part}:\n{text}");
    }
    assert!(!text.contains(" \n"), "{text}");
}

#[test]
fn every_fault_proves_and_predicts() {
    for (name, text) in FAULTS {
        assert!(!proof(text).is_empty() && prediction(text).len() > 20, "{name}: {}", prediction(text));
    }
    let text = "# One fault. Proves A1, tears (hardware 5).\n# Words\n# come late.\nformat = 1\n# not this\n";
    assert_eq!((proof(text), &*prediction(text)), ("A1, tears", "Words come late."));
    assert_eq!(prediction("format = 1\n"), "");
}

/// Every table of the ideal model describes a block of the diagram.
#[test]
fn tables_belong_to_blocks() {
    let tables: BTreeSet<&str> = BLOCK_TABLES.iter().flat_map(|(_, tables)| tables.iter().copied()).collect();
    let (_, text) = BUILT_IN.iter().find(|(name, _)| *name == "ideal").unwrap();
    let written: BTreeSet<&str> =
        text.lines().filter_map(|line| line.strip_prefix('[')?.strip_suffix(']')).collect();
    assert!(written.len() > 20 && tables == written, "{:?}", tables.symmetric_difference(&written));
}
