//! Models that cannot be are refused, with the reason; models at odds with their timing are warned.

use hardware_model::{Finding, Grade, GroundScale, HardwareModel, ModelSource};
use proptest::prelude::*;

fn with(sets: &[(&str, &str)]) -> HardwareModel {
    let sets: Vec<(String, String)> = sets.iter().map(|(k, v)| ((*k).into(), (*v).into())).collect();
    let ideal = ModelSource::BuiltIn("ideal".into());
    HardwareModel::load(&ideal, &[], &sets).unwrap_or_else(|list| panic!("{list}")).model
}

type Sets = &'static [(&'static str, &'static str)];

#[track_caller]
fn only(sets: &[(&str, &str)], grade: Grade) -> Finding {
    let found = with(sets).check();
    let [finding] = &found[..] else { panic!("one finding of {sets:?}: {found:#?}") };
    assert_eq!(finding.grade, grade, "{finding:?}");
    finding.clone()
}

#[test]
fn what_cannot_be_built_is_refused() {
    let cases: [(Sets, &str, &str); 12] = [
        (&[("loader.served_by", "io-processor")], "loader.words_per_access", "9 words an access"),
        (&[("loader.served_by", "cpu-interrupt")], "loader.served_by", "32-bit words: it brings 2"),
        (&[("buffer.words", "4096")], "buffer.words", "4096 words with no drum"),
        (&[("buffer.words", "575"), ("drum.rotation_ms", "17")], "drum.record_words", "one record of 576"),
        (&[("amplifier.slew_v_us", "0")], "amplifier.slew_v_us", "no output ever moves"),
        (&[("wires.slew_v_us", "0")], "wires.slew_v_us", "ever leaves its first value"),
        (&[("comparator.hysteresis_pct", "100")], "comparator.hysteresis_pct", "100 % of full scale"),
        (
            &[("sample_hold.acquire_ns", "34000")],
            "sample_hold.acquire_ns",
            "34 µs, longer than the drawn 33.33",
        ),
        (&[("sweep.fold_detect", "comparator")], "comparator.delay_ns", "there is none"),
        (&[("drum.coarse", "together")], "drum.coarse", "drum.rotation_ms is 0"),
        (&[("shadow_bank.drums", "apart")], "shadow_bank.drums", "records of [shadow_bank] lie on drums"),
        (
            &[
                ("drum.rotation_ms", "17"),
                ("feature_bank.drums", "together"),
                ("feature_bank.buffer_words", "95"),
            ],
            "feature_bank.buffer_words",
            "buffer_words = 96 would do",
        ),
    ];
    for (sets, key, reason) in cases {
        let found = with(sets).check();
        let refusals: Vec<&Finding> = found.iter().filter(|finding| finding.grade == Grade::Refuse).collect();
        let [refusal] = refusals[..] else { panic!("{sets:?}: {found:#?}") };
        assert!(refusal.keys.contains(&key) && refusal.message.contains(reason), "{refusal:?}");
        assert_eq!(found[0].grade, Grade::Refuse);
    }
}

/// 24 corners a second in a turn over 5 km in regions of 300 m, each half a turn of a drum: terrain takes 0.21 of it, five kinds
/// would be too many, and so are three on a drum that turns half as fast.
#[test]
fn kinds_that_fill_a_drum_together_are_warned_of() {
    let told = |rotation: &str, kinds: &[&str]| {
        let drum = [("drum.rotation_ms", rotation), ("drum.record_words", "9")];
        let places = kinds.iter().map(|kind| (*kind, "together"));
        let sets: Vec<(&str, &str)> = drum.into_iter().chain(places).collect();
        with(&sets).check().into_iter().find(|finding| finding.message.contains("kinds of data on them"))
    };
    let all = ["feature_bank.drums", "shadow_bank.drums", "polyhedron_bank.drums"];
    assert_eq!(told("17.4", &all), None);
    assert_eq!(told("35", &[]), None);
    let found = told("35", &all).expect("four kinds take 1.7 of the drum");
    assert!(found.grade == Grade::Warn(Some("A5")) && found.message.contains("with 4 kinds"), "{found:?}");
}

/// Just within and just beyond: over 5 km in 300 m regions an ideal sweep of 33.3 µs runs at 150 m/µs, 2 µs a region.
#[test]
fn thresholds_are_where_the_reference_has_them() {
    let cases = [
        ("sweep.smoother_ns", "199", "201", "A8"),
        ("sweep.strobe_offset_ns", "-19.9", "-20.1", "A9"),
        ("sweep.settle_ns", "1999", "2001", "A9"),
        ("loader.access_ns", "199", "201", "A1"),
        ("comparator.delay_ns", "199", "201", "A13"),
        ("function_generator.bandwidth_mhz", "5.01", "4.99", "A6"),
        ("multiplier.bandwidth_mhz", "5.01", "4.99", "A6"),
        ("multiplying_dac.bandwidth_mhz", "5.01", "4.99", "A6"),
        ("amplifier.gain_bandwidth_mhz", "2.51", "2.49", "A6"),
        ("video.bandwidth_mhz", "15.01", "14.99", "A6"),
        ("amplifier.slew_v_us", "5.01", "4.99", "A7"),
        ("wires.bandwidth_mhz", "2.51", "2.49", "A6"),
        ("wires.slew_v_us", "5.01", "4.99", "A7"),
        ("amplifier.saturation_v", "1", "0.99", "A25"),
        ("multiplying_dac.bits", "8", "7", "A12"),
        ("multiplying_dac.gain_error_pct", "0.49", "0.51", "A10"),
        ("sweep.dac_bits", "7", "6", "A12"),
        ("function_generator.segments", "9", "8", "A11"),
        ("reflectivity.delay_mismatch_ns", "33", "34", "A17"),
        ("reflectivity.multiplier_bandwidth_mhz", "5.01", "4.99", "A6"),
        ("reflectivity.summer_bandwidth_mhz", "5.01", "4.99", "A6"),
        ("reflectivity.root_bandwidth_mhz", "5.01", "4.99", "A6"),
        ("reflectivity.divider_bandwidth_mhz", "5.01", "4.99", "A6"),
        ("reflectivity.saturation_v", "1", "0.99", "A25"),
        ("video_switch.time_ns", "33", "34", "A22"),
        ("cpu.sweep_setup_us", "33", "34", "A26"),
        ("sweep_memory.write_compensation", "20", "19", "A19"),
        ("sample_hold.pedestal_mv", "9", "11", "A15"),
        ("raster.refresh_hz", "90", "120", "A24"),
        ("level_blend.slope_term", "on", "off", "A27"),
    ];
    for (key, within, beyond, artefact) in cases {
        assert_eq!(with(&[(key, within)]).check(), [], "{key} = {within}");
        let finding = only(&[(key, beyond)], Grade::Warn(Some(artefact)));
        assert!(finding.keys.contains(&key) && !finding.message.is_empty(), "{finding:?}");
    }
}

#[test]
fn noise_needs_three_times_its_hysteresis() {
    let noisy = [("amplifier.noise_mv", "1"), ("dpp.occlusion", "derivative")];
    let quiet = [noisy[0], noisy[1], ("comparator.hysteresis_pct", "0.31")];
    assert_eq!(with(&quiet).check(), []);
    assert_eq!(with(&[noisy[0]]).check(), [], "a peak-hold compares elevations");
    only(&noisy, Grade::Warn(Some("A16")));
}

#[test]
fn a_register_beyond_both_stops_leaves_nothing_late() {
    let slow = [("loader.access_ns", "500")];
    only(&slow, Grade::Warn(Some("A1")));
    only(&[slow[0], ("loader.late_policy", "latched")], Grade::Warn(Some("A2")));
    let diagonal = ("loader.diagonal_register", "true");
    assert_eq!(with(&[slow[0], diagonal]).check(), []);
    only(&[slow[0], diagonal, ("loader.late_policy", "latched")], Grade::Warn(None));
}

#[test]
fn smaller_regions_ask_for_more() {
    let model = HardwareModel::load(&ModelSource::BuiltIn("pra-nominal".into()), &[], &[]).unwrap().model;
    let small = GroundScale { region_size: 20.0, ..model.usual_ground() };
    assert_eq!(model.check_over(model.usual_ground()), model.check());
    let found = model.check_over(small);
    for artefact in ["A1", "A5", "A6", "A8"] {
        assert!(
            found.iter().any(|finding| finding.grade == Grade::Warn(Some(artefact))),
            "{artefact}: {found:#?}"
        );
    }
}

proptest! {
    /// Degenerate parts are found or pass, and no figure is without a value.
    #[test]
    fn any_model_that_is_read_is_checked(
        access in 0.0..1e9f64, slew in 0.0..1e9f64, bits in 1u32..25, rotation in 0.0..1e4f64,
        region_size in 1e-3..1e6f64, range in 1e-3..1e6f64, rate in 1e-3..1e6f64,
    ) {
        let model = with(&[
            ("loader.access_ns", &access.to_string()),
            ("amplifier.slew_v_us", &slew.to_string()),
            ("sweep.dac_bits", &bits.to_string()),
            ("drum.rotation_ms", &rotation.to_string()),
            ("drum.rate_mb_s", &rate.to_string()),
        ]);
        let ground = GroundScale { region_size, range };
        model.check_over(ground);
        prop_assert!(model.budget(ground).lines().iter().all(|line| line.value.is_finite()));
    }
}

/// A delay is of use where its sweep is drawn and it holds its word back at all.
#[test]
fn delays_that_never_meet_their_word_are_told() {
    let delay = |sweep: u32, ticks: u32| {
        format!(
            "[{{ sweep = {sweep}, crossing = 1, colour = 'red', register = 'x-first', word = [1, 1], ticks = {ticks} }}]"
        )
    };
    let told =
        |list: &str| only(&[("loader.delay", list), ("raster.sweeps", "40")], Grade::Warn(None)).message;
    assert!(told(&delay(40, 9)).contains("in sweep 40, and a frame has sweeps 0..40"));
    assert!(told(&delay(39, 0)).contains("held back by no tick"));
    assert_eq!(with(&[("loader.delay", &delay(39, 9)), ("raster.sweeps", "40")]).check(), []);
}

/// A model is named in records, and found by its file.
#[test]
fn a_file_with_another_name_than_its_model_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let remarks = |file: &str| {
        let path = folder.path().join(file);
        std::fs::write(&path, "format = 1\nname = \"mine\"\nbase = \"ideal\"\n").unwrap();
        HardwareModel::read(&path, &[], &[]).unwrap().remarks
    };
    assert_eq!(remarks("mine.toml"), [""; 0]);
    assert!(remarks("other.toml")[0].contains("called `mine`, and its file `other`"));
}
