//! Models, their bases, overlays and single settings.

use std::fs;
use std::path::{Path, PathBuf};

use diagnostics::ProblemList;
use hardware_model::{
    Asked, BUILT_IN, FeatureParts, HardwareModel, LatePolicy, LoadedModel, MixingParts, ModelSource,
    ShadowParts, SweepMemoryKind, Yoke,
};
use proptest::prelude::*;
use quantities::{Rate, radians};
use scenario::{FeatureLight, Occlusion, PixelRule, Projection, RangeLaw, RangeProgramme};
use sweep_program::{Colour, PreloadRegister};
use tempfile::TempDir;

const IDEAL: &str = BUILT_IN[0].1;

fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn read(folder: &TempDir, name: &str) -> Result<LoadedModel, ProblemList> {
    HardwareModel::read(&folder.path().join(name), &[], &[])
}

fn set(pairs: &[(&str, &str)]) -> Result<LoadedModel, ProblemList> {
    let sets: Vec<(String, String)> = pairs.iter().map(|(k, v)| ((*k).into(), (*v).into())).collect();
    HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &[], &sets)
}

fn titles(result: Result<LoadedModel, ProblemList>) -> Vec<String> {
    result.map_or_else(|list| list.iter().map(|problem| problem.title.clone()).collect(), |_| Vec::new())
}

#[test]
fn the_ideal_model() {
    let ideal = HardwareModel::ideal();
    assert_eq!((ideal.name.as_str(), ideal.raster.sweeps, ideal.raster.samples), ("ideal", 1000, 1000));
    assert_eq!(ideal.master_clock, Rate::new(1_000_000_000, 1).unwrap());
    assert_eq!(ideal.range, RangeProgramme { law: RangeLaw::Geometric, start: 1.5, end: 5000.0 });
    assert_eq!((ideal.loader.access, ideal.loader.late_policy), (0, LatePolicy::StrobeThrough));
    assert_eq!((ideal.laws.projection, ideal.laws.occlusion), (Projection::Exact, Occlusion::PeakHold));
    assert_eq!(
        (ideal.laws.pixel_rule, ideal.sweep_memory),
        (PixelRule::LineMean, SweepMemoryKind::ScanConverter)
    );
    assert_eq!(ideal.loader.delays, []);
    assert_eq!(ideal.feature_generator, FeatureParts::default());
    assert_eq!(ideal.shadow_controller, ShadowParts::default());
    assert_eq!(ideal.mixing_unit, MixingParts::default());
    assert_eq!(ideal.laws.feature_light, FeatureLight::Combined);
    let (step, rate, travel) = (radians(0.1), radians(10.0), radians(40.0));
    let yoke = Yoke { step, rate, travel, natural: None, damping: 1.0 };
    assert_eq!(ideal.yoke, yoke);
}

#[test]
fn every_number_of_the_ideal_model_says_where_it_comes_from() {
    let is_value = |line: &&str| line.contains(" = ") && !line.starts_with(['#', ' ']);
    let is_head = |line: &&str| line.starts_with("format") || line.starts_with("name");
    let sources = ["# reported", "# inferred", "# period", "# chosen", "# measured"];
    let values = IDEAL.lines().filter(is_value).filter(|line| !is_head(line));
    let without: Vec<&str> =
        values.filter(|line| !sources.iter().any(|source| line.contains(source))).collect();
    assert_eq!(without, [""; 0]);
}

#[test]
fn differences_are_merged_key_by_key_down_the_chain() {
    let folder = folder(&[
        ("low.toml", "format = 1\nname = 'low'\nbase = 'ideal'\n[raster]\nsweeps = 525\nupdate_hz = 10\n"),
        ("top.toml", "format = 1\nname = 'top'\nbase = 'low'\n[raster]\nsweeps = 600\n"),
    ]);
    let top = read(&folder, "top.toml").unwrap_or_else(|list| panic!("{list}"));
    assert_eq!((top.model.name.as_str(), top.model.raster.sweeps), ("top", 600));
    assert_eq!(top.model.raster.update, Rate::new(10, 1).unwrap());
    assert_eq!(top.model.raster.samples, 1000);
    assert_eq!(top.files, [folder.path().join("low.toml"), folder.path().join("top.toml")]);
    let origin = |key: &str| {
        let value = top.values.iter().find(|value| value.key == key).unwrap();
        (value.value.clone(), value.origin.rsplit('/').next().unwrap().to_owned())
    };
    assert_eq!(origin("raster.sweeps"), ("600".into(), "top.toml:5".into()));
    assert_eq!(origin("raster.update_hz"), ("10".into(), "low.toml:6".into()));
    assert!(origin("raster.samples_per_sweep").1.starts_with("built-in ideal.toml:"));
    let listing = top.effective();
    assert!(
        listing
            .lines()
            .any(|line| { line.starts_with("raster.sweeps = 600 ") && line.ends_with("top.toml:5") }),
        "{listing}"
    );
}

#[test]
fn a_file_in_the_folder_goes_before_the_built_in() {
    let ideal = IDEAL.replace("sweeps = 1000", "sweeps = 700");
    let folder =
        folder(&[("ideal.toml", &ideal), ("mine.toml", "format = 1\nname = 'mine'\nbase = 'ideal'\n")]);
    assert_eq!(read(&folder, "mine.toml").unwrap().model.raster.sweeps, 700);
}

#[test]
fn overlays_lie_over_one_another_and_settings_over_them() {
    let folder = folder(&[
        ("a.toml", "format = 1\n[raster]\nsweeps = 300\nsamples_per_sweep = 400\n"),
        ("b.toml", "format = 1\n[raster]\nsweeps = 301\nrefresh_hz = 90\n"),
    ]);
    let overlays: Vec<PathBuf> = ["a.toml", "b.toml"].map(|name| folder.path().join(name)).into();
    let sets = [("raster.refresh_hz".to_owned(), "120".to_owned())];
    let loaded = HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &overlays, &sets).unwrap();
    let raster = loaded.model.raster;
    assert_eq!((raster.sweeps, raster.samples), (301, 400));
    assert_eq!((loaded.model.name.as_str(), raster.refresh), ("ideal", Rate::new(120, 1).unwrap()));
    assert_eq!(loaded.files, overlays);
    assert!(loaded.effective().contains("# --set:1"), "{}", loaded.effective());
}

#[test]
fn settings_need_no_quotes_for_words() {
    let model = set(&[("dpp.projection", "as-reported"), ("dpp.occlusion", "\"derivative\"")]).unwrap().model;
    assert_eq!(
        (model.laws.projection, model.laws.occlusion),
        (Projection::AsReported, Occlusion::Derivative)
    );
    let rate = set(&[("dpu.clock_mhz", "100/7")]).unwrap().model.master_clock;
    assert_eq!(rate, Rate::new(100_000_000, 7).unwrap());
}

#[test]
fn settings_that_are_none() {
    assert!(titles(set(&[("sweeps", "3")]))[0].contains("no key of a part"));
    assert!(titles(set(&[("raster.", "3")]))[0].contains("no key of a part"));
    assert!(titles(set(&[("raster.sweeps\n[x]", "3")]))[0].contains("no key of a part"));
    assert_eq!(titles(set(&[("raster.sweps", "3")])), ["unknown key `raster.sweps`"]);
    assert!(titles(set(&[("raster.sweeps", "3\nlines = 4")]))[0].contains("must be a whole number"));
    assert!(titles(set(&[("raster.sweeps", "\"")]))[0].contains("must be a whole number"));
    assert!(titles(set(&[("raster.sweeps", "nan")]))[0].contains("must be a whole number"));
}

#[test]
fn parts_are_counted_or_unlimited() {
    let parts = |value: &str| {
        set(&[("feature_generator.sub_generators", value)])
            .map(|loaded| loaded.model.feature_generator.sub_generators)
    };
    assert_eq!((parts("unlimited").unwrap(), parts("6").unwrap()), (None, Some(6)));
    for wrong in ["0", "unlimted", "1.5", "-1"] {
        let found = titles(set(&[("shadow_controller.line_generators", wrong)]));
        assert!(found[0].contains("or the word \"unlimited\""), "{wrong}: {found:?}");
    }
}

#[test]
fn a_scan_converter_has_its_figures_as_shares() {
    let variant = ("shadow_controller.variant", "scan-converter");
    let offset = ("shadow_controller.registration_offset_pct", "[0.5, -1]");
    let model = set(&[variant, offset, ("shadow_controller.registration_gain_pct", "2")]).unwrap().model;
    assert_eq!(model.shadow_controller, ShadowParts::ScanConverter { offset: [0.005, -0.01], gain: 0.02 });
}

#[test]
fn access_times_round_up_to_ticks() {
    let ticks = |nanoseconds: &str, clock: &str| {
        set(&[("loader.access_ns", nanoseconds), ("dpu.clock_mhz", clock)]).unwrap().model.loader.access
    };
    assert_eq!(ticks("950", "20"), 19);
    assert_eq!(ticks("951", "20"), 20);
    assert_eq!(ticks("0.5", "500"), 1);
    assert_eq!(ticks("0", "500"), 0);
    assert_eq!(ticks("100", "\"50/3\""), 2);
}

#[test]
fn delays_are_read() {
    let one = "[{ frame = 2, sweep = 3, crossing = 4, colour = 'red', register = 'y-first', word = [2, 1], ticks = 9 }]";
    let model = set(&[("loader.delay", one)]).unwrap_or_else(|list| panic!("{list}")).model;
    let delay = model.loader.delays[0];
    assert_eq!((delay.frame, delay.sweep, delay.crossing, delay.ticks), (Some(2), 3, 4, 9));
    assert_eq!((delay.colour, delay.register, delay.word), (Colour::Red, PreloadRegister::YFirst, 7));
    let bad = one.replace("[2, 1]", "[3, 1]").replace("'red'", "'blue'");
    let found = titles(set(&[("loader.delay", &bad)]));
    assert_eq!(found.len(), 2, "{found:?}");
}

#[test]
fn one_word_is_delayed_once() {
    let entry = |frame: &str, word: &str| {
        format!(
            "{{ {frame} sweep = 3, crossing = 4, colour = 'red', register = 'y-first', word = {word}, ticks = 9 }}"
        )
    };
    let list = |a: &str, b: &str| format!("[{a}, {b}]");
    for (a, b, faults) in [
        (entry("", "[0, 0]"), entry("frame = 1,", "[0, 0]"), 1),
        (entry("frame = 1,", "[0, 0]"), entry("frame = 1,", "[0, 0]"), 1),
        (entry("frame = 1,", "[0, 0]"), entry("frame = 2,", "[0, 0]"), 0),
        (entry("", "[0, 0]"), entry("", "[0, 1]"), 0),
    ] {
        let read = set(&[("loader.delay", &list(&a, &b))]);
        assert_eq!(read.map_or_else(|list| list.len(), |_| 0), faults, "{a} and {b}");
    }
}

#[test]
fn the_effective_model_is_itself_a_model() {
    let delay = "sweep = 1\ncrossing = 2\ncolour = 'green'\nregister = 'x-first'\nword = [0, 2]\nticks = 7\n";
    let model = format!(
        "format = 1\nname = 'm'\nbase = 'ideal'\n[[loader.delay]]\nframe = 4\n{delay}[[loader.delay]]\nframe = 5\n{delay}"
    );
    let folder = folder(&[("m.toml", &model)]);
    let overlay = folder.path().join("o.toml");
    fs::write(&overlay, "format = 1\ndpu.clock_mhz = '100/3'\nrange.programme = 'two-rate'\n").unwrap();
    let first = HardwareModel::read(&folder.path().join("m.toml"), &[overlay], &[]).unwrap();
    assert_eq!(first.model.loader.delays.len(), 2);
    fs::write(folder.path().join("again.toml"), first.effective()).unwrap();
    let again = read(&folder, "again.toml").unwrap_or_else(|list| panic!("{list}"));
    assert_eq!(again.model, first.model);
}

#[test]
fn faults_of_all_layers_are_listed_at_once() {
    let folder = folder(&[
        ("low.toml", "format = 1\nname = 'low'\nbase = 'ideal'\n[raster]\nsweeps = 0\nsweps = 1\n"),
        (
            "top.toml",
            "format = 1\nbase = 'low'\n[dpp]\nprojection = 'none'\n[range]\nend_m = 1\n[new]\nx = 1",
        ),
    ]);
    let found = titles(read(&folder, "top.toml"));
    for expected in [
        "`raster.sweeps`",
        "`raster.sweps`",
        "missing key `name`",
        "`dpp.projection`",
        "`new`",
        "`range.end_m` = 1",
    ] {
        assert!(found.iter().any(|title| title.contains(expected)), "{expected}: {found:#?}");
    }
    assert_eq!(found.len(), 6, "{found:#?}");
}

#[test]
fn a_model_without_base_needs_every_key() {
    let folder = folder(&[("bare.toml", "format = 1\nname = 'bare'\n[raster]\nsweeps = 5\n")]);
    let found = titles(read(&folder, "bare.toml"));
    for expected in ["`raster.update_hz`", "`range`", "`dpu`", "`loader`", "`dpp`", "`sweep_memory`"] {
        assert!(found.iter().any(|title| title.contains(expected)), "{expected}: {found:#?}");
    }
}

#[test]
fn bases_that_lead_nowhere() {
    let folder = folder(&[
        ("a.toml", "format = 1\nname = 'a'\nbase = 'b'\n"),
        ("b.toml", "format = 1\nname = 'b'\nbase = 'a'\n"),
        ("c.toml", "format = 1\nname = 'c'\nbase = 'idael'\n"),
        ("d.toml", "format = 1\nname = 'd'\nbase = '../a'\n"),
        ("e.toml", "format = 2\nname = 'e'\nunknown = 1\n"),
    ]);
    let cycle = titles(read(&folder, "a.toml"));
    assert!(cycle.len() == 1 && cycle[0].starts_with("a model is based on itself"), "{cycle:?}");
    assert_eq!(cycle[0].matches(".toml").count(), 3, "{cycle:?}");
    let unknown = read(&folder, "c.toml").unwrap_err().to_string();
    assert!(unknown.contains("c.toml:3:8") && unknown.contains("did you mean `ideal`?"), "{unknown}");
    assert!(unknown.contains("a, b, c, d, e, ideal"), "{unknown}");
    assert!(titles(read(&folder, "d.toml"))[0].contains("a name of letters"));
    assert_eq!(titles(read(&folder, "e.toml")).len(), 1);
}

#[test]
fn overlays_that_are_none() {
    let folder = folder(&[
        ("named.toml", "format = 1\nname = 'x'\nbase = 'ideal'\n"),
        ("bare.toml", "[raster]\nsweeps = 3\n"),
    ]);
    let over = |name: &str| {
        titles(HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &[folder.path().join(name)], &[]))
    };
    assert_eq!(over("named.toml"), ["`name` in an overlay", "`base` in an overlay"]);
    assert_eq!(over("bare.toml"), ["missing key `format`"]);
    assert!(over("missing.toml")[0].contains("no such file"));
}

#[test]
fn a_machine_is_found_by_name_or_path() {
    let top = folder(&[]);
    let models = top.path().join("hardware-models");
    let scenarios = top.path().join("scenarios");
    fs::create_dir(&models).unwrap();
    fs::create_dir(&scenarios).unwrap();
    fs::write(models.join("frugal.toml"), "format = 1\nname = 'frugal'\nbase = 'ideal'\n").unwrap();
    let find = |name: &str, folder: &Path| ModelSource::find(name, folder);
    let ModelSource::File(found) = find("frugal", &scenarios).unwrap() else { panic!("a file") };
    assert_eq!(found.canonicalize().unwrap(), models.join("frugal.toml").canonicalize().unwrap());
    assert!(matches!(find("frugal", top.path()), Ok(ModelSource::File(_))));
    assert_eq!(find("x/frugal", &scenarios).unwrap(), ModelSource::File("x/frugal".into()));
    assert_eq!(find("mine.toml", &scenarios).unwrap(), ModelSource::File("mine.toml".into()));
    assert!(find("ideal", &scenarios).is_ok());
    let unknown = find("frugl", &scenarios).unwrap_err().to_string();
    assert!(
        unknown.contains("unknown machine `frugl`") && unknown.contains("did you mean `frugal`?"),
        "{unknown}"
    );
    let far = find("zzz", &scenarios).unwrap_err().to_string();
    assert!(far.contains("frugal, ideal"), "{far}");
    let asked = Asked { place: "some.toml", others: &["exact"] };
    let beside = ModelSource::find_as(asked, "exat", &scenarios).unwrap_err().to_string();
    assert!(beside.contains("did you mean `exact`? known: exact, frugal"), "{beside}");
    assert!(beside.contains("--> some.toml"), "{beside}");
}

#[test]
fn files_that_are_no_model() {
    let folder = folder(&[("bad.toml", "format = = 1")]);
    fs::write(folder.path().join("binary.toml"), [0xff, 0xfe, 0x00]).unwrap();
    assert!(titles(read(&folder, "none.toml"))[0].contains("no such file"));
    assert!(titles(read(&folder, "bad.toml"))[0].contains("not valid TOML"));
    assert!(titles(read(&folder, "binary.toml"))[0].contains("not UTF-8"));
    assert!(titles(HardwareModel::read(folder.path(), &[], &[]))[0].contains("folder"));
}

proptest! {
    #[test]
    fn damage_is_refused_or_read_and_never_panics(
        cuts in prop::collection::vec((0usize..10_000, 0usize..12, "[-a-z0-9_=.,\"'\\[\\]{}\n# ]{0,6}"), 1..6),
    ) {
        let mut text = IDEAL.to_owned();
        for (at, length, put) in cuts {
            let at = at.min(text.len());
            text.replace_range(at..(at + length).min(text.len()), &put);
        }
        let folder = folder(&[("m.toml", &text)]);
        let _ = read(&folder, "m.toml").map(|loaded| loaded.effective()).map_err(|list| list.render(true));
    }

    #[test]
    fn any_setting_is_taken_or_refused(key in "\\PC{0,12}", value in "\\PC{0,12}") {
        let _ = set(&[(&key, &value)]).map_err(|list| list.render(false));
        let _ = set(&[("dpu.clock_mhz", &value)]).map_err(|list| list.render(false));
    }
}
