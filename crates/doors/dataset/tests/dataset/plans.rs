//! Plans: what is wrong with one is told at its line, before any ground is made.

use dataset::Plan;

use crate::scene::{PLAN, Scene};

/// What is said of the plan with `from` replaced by `to`, as text and with the line of each fault.
fn said_of(from: &str, to: &str) -> (String, Vec<Option<usize>>) {
    assert!(PLAN.contains(from), "{from}");
    let scene = Scene::new(&PLAN.replacen(from, to, 1));
    let faults = Plan::read(&scene.path("plan.toml")).expect_err(to);
    let records = faults.records();
    assert!(records.iter().all(|record| record.file.ends_with("plan.toml")), "{faults}");
    (faults.to_string(), records.iter().map(|record| record.line).collect())
}

#[test]
fn every_broken_plan_is_one_error_with_its_line() {
    let cases = [
        ("format = 1", "format = 2", "newer than the format 1", 1),
        ("seed = 7", "sede = 7\nseed = 7", "unknown key `sede`", 5),
        ("seed = 7", "seed = -7", "`seed` must be a whole number", 5),
        ("draws = 3", "draws = 5000000", "15000000 samples", 6),
        ("draws = 3", "draws = 0", "`draws` must be a whole number from 1", 6),
        ("about = \"Nothing but a test.\"\n", "", "missing key `about`", 1),
        ("licence = \"CC0-1.0\"", "licence = 3", "`licence` must be one line of text", 4),
        (
            "licence = \"CC0-1.0\"",
            "licence = \"X\"\nlicence_file = \"gone.txt\"",
            "gone.txt: no such file",
            5,
        ),
        (
            "licence = \"CC0-1.0\"",
            "licence = \"X\"\nlicence_file = \"../gone.txt\"",
            "../gone.txt: not beside the plan",
            5,
        ),
        (
            "\"scenario.raster.lines=30\"]",
            "\"scenario.raster.lines=30\", \"scenario.sun.azimuth_deg=9\"]",
            "drawn as well",
            12,
        ),
        ("[\"scene.toml\"]", "[]", "`scenarios` must be", 7),
        ("[\"scene.toml\"]", "[\"scene.toml\", \"scene.toml\"]", "`scenarios` must be", 7),
        ("[\"scene.toml\"]", "[\"gone.toml\"]", "gone.toml", 7),
        ("[\"ideal\"]", "[\"idael\"]", "idael", 8),
        ("\"range\", \"label\"", "\"range\", \"depth\"", "no ground truth is called `depth`", 9),
        ("\"range\", \"label\"", "\"pose\"", "\"pose\", which is no plane", 9),
        ("\"late_words\"", "\"early_words\"", "no counter is called \"early_words\"", 10),
        ("compare = true", "compare = 1", "`compare` must be true or false", 11),
        (
            "columns=40",
            "columns:40\",\"scenario.raster.columns=40",
            "`set` has \"scenario.raster.columns:40\"",
            12,
        ),
        ("= [0, 360]\n\"scen", "= [360, 0]\n\"scen", "low not above high", 15),
        ("= [0, 360]\n\"scen", "= [0, 1, 2]\n\"scen", "an array of 2 numbers", 15),
        ("= [10, 40]", "= [10, 400]", "400", 16),
        ("sun.azimuth_deg", "sun.azimut_deg", "azimut_deg", 15),
        (
            "= [0, 360]\n\"scen",
            "= [0, inf]\n\"scen",
            "`draw.number.\"scenario.sun.azimuth_deg\"` must be",
            15,
        ),
        ("x_m = [20, 380]", "x_m = [380, 20]", "`pose.x_m` must be", 19),
        (
            "x_m = [20, 380]",
            "x_m = [20, 380]\nz_m = [10, 20]\npitch_deg = [0, 1]",
            "missing key `pose.roll_deg`",
            18,
        ),
        ("heading_deg = [0, 360]", "heading_deg = [0, 360]\nframes = [3, 1]", "first not above last", 22),
        ("heading_deg = [0, 360]", "heading_deg = [0, 360]\nframes = [0, 5000]", "has no frame 5000", 22),
        ("block_m = 80", "block_m = 0", "`splits.block_m` must be", 24),
        ("reach_m = 15", "reach_m = 500", "spans more than 4 blocks", 25),
        ("train = 0.5", "train = 0.6", "sum up to 1.1", 26),
        ("name = \"coarse\"\noverlay", "name = \"tear\"\noverlay", "two faults are called \"tear\"", 38),
        ("overlay = \"coarse\"", "overlay = \"sloth\"", "sloth", 39),
        ("\"loader.access_ns\" = [3000, 9000]", "\"loader.acess_ns\" = [3000, 9000]", "acess_ns", 35),
        ("\"loader.access_ns\" = [3000, 9000]", "\"loader.access_ns\" = [-5, 9000]", "access_ns", 35),
    ];
    let mut wrong = Vec::new();
    for (from, to, expected, line) in cases {
        let (said, lines) = said_of(from, to);
        if !said.contains(expected) || lines != [Some(line)] {
            wrong.push(format!(
                "{to}: expected {expected:?} in line {line} alone, told of lines {lines:?}:\n{said}"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn all_faults_of_a_plan_are_told_at_once() {
    let text = PLAN.replace("seed = 7", "seed = \"x\"").replace("block_m = 80", "block = 80");
    let scene = Scene::new(&text);
    let faults = Plan::read(&scene.path("plan.toml")).expect_err("three faults");
    // The unknown key, the missing one, and the seed.
    assert_eq!(faults.len(), 3, "{faults}");
}

#[test]
fn a_plan_that_is_no_text_or_not_there_is_refused() {
    let scene = Scene::new(PLAN);
    std::fs::write(scene.path("plan.toml"), [0xff, 0xfe, 0x00]).unwrap();
    assert_eq!(Plan::read(&scene.path("plan.toml")).expect_err("no text").len(), 1);
    assert!(Plan::read(&scene.path("gone.toml")).expect_err("gone").to_string().contains("gone.toml"));
    assert_eq!(Plan::read(scene.folder.path()).expect_err("a folder").len(), 1);
}

#[test]
fn a_machine_with_memory_has_first_frames_alone() {
    let text = PLAN.replace("overlay = \"coarse\"", "overlay = \"ghost\"");
    let scene =
        Scene::new(&text.replace("heading_deg = [0, 360]", "heading_deg = [0, 360]\nframes = [0, 2]"));
    let said = Plan::read(&scene.path("plan.toml"));
    // Residue of the tube is memory; an overlay without it is not.
    let settings = front_door::open(
        &scene.path("scene.toml"),
        &drive::Wishes { overlays: vec!["ghost".into()], ..drive::Wishes::default() },
    );
    let remembers = settings.unwrap().settings.analog.remembers_frames();
    assert_eq!(said.is_err(), remembers, "{said:?}");
}

const PAGE: &str = include_str!("../../../../../docs/dataset-plan.md");

/// A folder of the repository.
fn at_root(path: &str) -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..").join(path)
}

#[test]
fn the_example_of_the_page_is_a_plan_whose_samples_are_made() {
    let (_, rest) = PAGE.split_once("```toml\n").expect("an example");
    let (example, _) = rest.split_once("```").expect("its end");
    let scenarios = at_root("scenarios").canonicalize().unwrap();
    let scene = Scene::new(&example.replace("../", &format!("{}/", scenarios.display())));
    let plan = scene.plan();
    assert_eq!(plan.samples(), 400);
    let made = dataset::Maker::new(&plan).make(2).unwrap();
    let names: Vec<&str> = made.arrays.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["picture", "split", "changed", "range", "label"]);
    assert_eq!((made.row.scenario.as_str(), made.row.fault.as_str()), ("landing-site", "none"));
}

#[test]
fn every_key_of_the_page_is_a_key_of_plans() {
    let table = PAGE.split("\n## ").nth(1).expect("the section of the plan");
    let keys = "format title about licence licence_file seed draws scenarios machines truth counters compare set [draw.number] \
                [draw.whole] [draw.one_of] pose.x_m pose.y_m pose.heading_deg pose.z_m pose.pitch_deg pose.roll_deg pose.frames \
                splits.block_m splits.reach_m splits.train fault.name fault.overlay fault.number";
    for key in keys.split_whitespace() {
        assert!(table.contains(&format!("`{key}`")), "{key} has no row");
    }
}

#[test]
fn the_shipped_plan_is_one() {
    let plan =
        Plan::read(&at_root("scenarios/datasets/first-look.toml")).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((plan.samples(), plan.combinations()), (24, 6));
}

#[test]
fn loaders_have_at_most_thirty_lines() {
    for (name, text) in dataset::LOADERS {
        assert!(text.lines().count() <= 30, "{name}");
    }
}
