//! `lunoid timing` and `lunoid sizing`.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;

/// `tiny.toml` on the nominal machine with a buffer that holds all of it, slow enough for late sets.
const NOMINAL: [&str; 6] =
    ["--machine", "pra-nominal", "--set", "buffer.words=unlimited", "--set", "loader.access_ns=2000"];

fn with<'a>(command: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    command.iter().chain(&NOMINAL).chain(more).copied().collect()
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn recorded() -> Scene {
    let scene = Scene::new();
    let record = with(&["timing", "record", "tiny.toml"], &["--frames", "1..3", "--out", "base.json"]);
    let (out, _) = scene.expect(0, &record);
    assert!(out.starts_with("base.json: Tiny on pra-nominal") && out.contains("sets late"), "{out}");
    scene
}

#[test]
fn a_baseline_is_met_by_the_same_run_whatever_the_threads() {
    let scene = recorded();
    for jobs in ["1", "2"] {
        let check = with(&["timing", "check", "tiny.toml"], &["--baseline", "base.json", "--jobs", jobs]);
        let (out, _) = scene.expect(0, &check);
        assert_eq!(out, "baseline met: Tiny on pra-nominal, frames: 2\n");
    }
    let again =
        with(&["timing", "record", "tiny.toml"], &["--frames", "1..3", "--out", "again.json", "-j", "2"]);
    scene.expect(0, &again);
    assert_eq!(fs::read(scene.join("base.json")).unwrap(), fs::read(scene.join("again.json")).unwrap());
}

/// Blocks that run without work, and bodies too small to be seen that are drawn all the same, change no event.
#[test]
fn what_is_drawn_beside_meets_the_baseline() {
    let scene = recorded();
    for option in ["--everything", "--lossless"] {
        let check = with(&["timing", "check", "tiny.toml"], &["--baseline", "base.json", option]);
        let (out, _) = scene.expect(0, &check);
        assert_eq!(out, "baseline met: Tiny on pra-nominal, frames: 2\n", "{option}");
    }
}

#[test]
fn frames_that_are_not_asked_for_are_not_checked() {
    let scene = recorded();
    let check =
        |frames| with(&["timing", "check", "tiny.toml"], &["--baseline", "base.json", "--frames", frames]);
    let (out, _) = scene.expect(0, &check("2..3"));
    assert!(out.contains("frames: 1"), "{out}");
    // A frame that the baseline does not have is a difference.
    let (out, _) = scene.expect(1, &check("0..3"));
    assert!(out.contains("@@ frame 0 @@\n+frame: recorded"), "{out}");
}

#[test]
fn a_slower_part_is_caught_told_and_reported() {
    let scene = recorded();
    let slower = ["--set", "loader.access_ns=2050", "--baseline", "base.json", "--junit", "timing.xml"];
    let (out, _) = scene.expect(1, &with(&["timing", "check", "tiny.toml"], &slower));
    let words = ["baseline not met", "of other inputs", "@@ frame 1 @@", "deadlines.transfer.least"];
    assert!(words.iter().all(|word| out.contains(word)), "{out}");
    let junit = fs::read_to_string(scene.join("timing.xml")).unwrap();
    assert!(
        junit.contains("tests=\"4\" failures=\"4\"") && junit.contains("<failure type=\"timing\""),
        "{junit}"
    );
    let (out, _) =
        scene.expect(1, &with(&["timing", "check", "tiny.toml"], &[&slower[..], &["--json"]].concat()));
    let document = json(&out);
    assert_eq!((&document["schema"], &document["met"]), (&"lunoid.timing.check/1".into(), &false.into()));
    assert_eq!(document["frames"][0]["frame"], 1);
}

/// The key comes first, then the first event with both ticks, then the totals.
#[test]
fn a_slower_part_is_named_with_the_first_event_that_it_moved() {
    let scene = recorded();
    let slower = ["--set", "loader.access_ns=2050", "--baseline", "base.json"];
    let (out, _) = scene.expect(1, &with(&["timing", "check", "tiny.toml"], &slower));
    let lines: Vec<&str> = out.lines().collect();
    assert!(lines[1].ends_with("machine.loader.access_ns differs"), "{out}");
    assert_eq!(lines[2..4], ["-machine.loader.access_ns: 2000", "+machine.loader.access_ns: 2050"]);
    assert!(lines[4].starts_with("first event that moved: frame 1, sweep "), "{out}");
    let tick = |line: &str| -> u64 {
        let (_, rest) = line.split_once("tick ").unwrap();
        rest.split_once(':').unwrap().0.parse().unwrap()
    };
    assert!(lines[5].starts_with("-tick ") && lines[6].starts_with("+tick "), "{out}");
    assert!(tick(lines[5]) < tick(lines[6]), "words come later: {out}");
    assert_eq!(lines[7], "totals:");
    // The raster of the command is a key like any other, and the sweeps of the baseline are found again by it.
    let fewer = ["--sweeps", "20", "--baseline", "base.json"];
    let (out, _) = scene.expect(1, &with(&["timing", "check", "tiny.toml"], &fewer));
    assert!(out.contains("+asked.sweeps: 20") && out.contains("first event that moved"), "{out}");
}

#[test]
fn bounds_let_the_timing_differ() {
    let scene = recorded();
    let check = |code: i32, bounds: &[&str]| {
        let slower = ["--set", "loader.access_ns=2050", "--baseline", "base.json"];
        let bounds: Vec<&str> = bounds.iter().flat_map(|bound| ["--allow", *bound]).collect();
        scene.expect(code, &with(&["timing", "check", "tiny.toml"], &[&slower[..], &bounds].concat()))
    };
    let (out, _) = check(0, &["late-words<=1000000", "slack>=-1000000"]);
    let first = out.lines().next().unwrap();
    assert!(first.starts_with("baseline met within what is allowed: "), "{out}");
    assert!(first.contains("; the baseline is of other inputs: "), "{out}");
    let (out, _) = check(1, &["late-words<=0"]);
    assert!(out.contains("beyond late-words<=0: found "), "{out}");
    let (_, err) = check(2, &["late-words=3"]);
    assert!(err.contains("--allow") && err.contains("`late-words=3`"), "{err}");
    // A machine without drums has no corners to wait for; a name that nobody has is a slip of the pen.
    check(0, &["missed.corner<=0"]);
    let (out, err) = check(2, &["missed.corners<=0"]);
    assert!(
        out.is_empty() && err.contains("`missed.corners<=0`: no such deadline; expected one of "),
        "{err}"
    );
}

/// What a rover carries or how its picture is lit has no part in the timing; where it drives has.
#[test]
fn inputs_are_what_decides_the_timing() {
    let scene = recorded();
    scene.vary("lit.toml", "elevation_deg = 15", "elevation_deg = 16");
    scene.vary("moved.toml", "x_m = 108", "x_m = 108.5");
    let check = |file| with(&["timing", "check", file], &["--baseline", "base.json"]);
    scene.expect(0, &check("lit.toml"));
    let (out, _) = scene.expect(1, &check("moved.toml"));
    assert!(out.contains("-inputs: "), "{out}");
}

/// The shipped baselines by the command that is written in their guide.
#[test]
fn shipped_baselines_hold_inputs_and_all() {
    let scene = Scene::new();
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../..");
    for (name, machine) in [("ridge-crossing", "ideal"), ("tracks", "pra-nominal")] {
        let scenario = format!("{root}/scenarios/{name}.toml");
        let baseline = format!("{root}/tests/timing-baselines/{name}.{machine}.json");
        let check =
            ["timing", "check", &scenario, "--machine", machine, "--sweeps", "21", "--baseline", &baseline];
        let set = ["--set", "buffer.words=unlimited"];
        scene.expect(0, &[&check[..], &set].concat());
    }
}

/// What a generator of another kind shows of its deadlines: its own counts, its misses by rows, and the map of what it lost.
#[test]
fn a_generator_with_deadlines_shows_its_own() {
    let scene = Scene::new();
    let slow = ["--machine", "sampled", "--set", "sampler.sampler_hz=1000", "--no-progress"];
    let show = |code, rest: &[&str]| {
        scene.expect(code, &[&["timing", "show", "tiny.toml", "--frame", "1"], rest, &slow[..]].concat())
    };
    let (out, _) = show(0, &["--misses", "0..1", "--slack", "slack.png", "--overload", "map.png"]);
    assert!(!out.contains("folds") && out.contains("sub-area.3") && out.contains("frame  row"), "{out}");
    assert!(out.contains("(ms)") && out.contains("loss"), "{out}");
    assert!(scene.join("slack.png").is_file() && scene.join("map.png").is_file());
    let (_, err) = show(2, &["--misses", "0..999"]);
    assert!(err.contains("a frame has rows 0.."), "{err}");
    let (_, err) = show(2, &["--sweep", "1", "--out", "a.png"]);
    assert!(err.contains("--sweep: sampled has no sweeps"), "{err}");
    let without =
        ["timing", "show", "tiny.toml", "--frame", "1", "--machine", "ideal", "--overload", "map.png"];
    let (_, err) = scene.expect(2, &without);
    assert!(err.contains("--overload: ideal has no overload map"), "{err}");
    let sizing = ["sizing", "tiny.toml", "--frames", "0..1"];
    let (out, _) = scene.expect(0, &[&sizing[..], &slow].concat());
    assert!(out.contains("sum over sub-areas of max(entries, least)"), "{out}");
    let (_, err) = scene.expect(2, &["sizing", "tiny.toml", "--machine", "lunsim"]);
    assert!(err.contains("no sweeps and no deadlines; expected a hardware model"), "{err}");
}

/// A frame by itself is what it is in a sequence, where a picture shows frames before its own.
#[test]
fn pictures_of_a_slow_sampler_do_not_depend_on_what_was_drawn_before() {
    let scene = Scene::new();
    for policy in ["late", "extend"] {
        let set = format!("sampled.overload=\"{policy}\"");
        let replay = |frames: &str, out: &str| {
            let slow = ["--machine", "sampled", "--set", "sampler.sampler_hz=2000", "--set", &set, "-q"];
            let what = ["replay", "tiny.toml", "--no-page", "--frames", frames, "--out", out];
            scene.expect(0, &[&what[..], &slow].concat());
            fs::read(scene.join(out).join("frames/frame-000002.png")).unwrap()
        };
        assert_eq!(
            replay("0..3", &format!("{policy}-all")),
            replay("2..3", &format!("{policy}-one")),
            "{policy}"
        );
    }
}

#[test]
fn bad_input_ends_with_3_and_one_error() {
    let scene = recorded();
    scene.write("broken.json", "{ \"format\": 1, ");
    scene.write("newer.json", "{ \"format\": 9 }");
    let late = fs::read_to_string(scene.join("base.json")).unwrap();
    scene.write(
        "late.json",
        late.replace("\"frame\": 1,", "\"frame\": 91,").replace("\"frame\": 2,", "\"frame\": 92,"),
    );
    let cases = [
        ("gone.json", "no such file"),
        ("broken.json", "expected a timing record"),
        ("newer.json", "expected at most 2"),
        ("late.json", "its first frame is 91, the scenario has frames 0..4"),
    ];
    for (file, said) in cases {
        let (out, err) = scene.expect(3, &with(&["timing", "check", "tiny.toml"], &["--baseline", file]));
        assert!(out.is_empty() && err.contains(said) && err.matches("error").count() == 1, "{file}: {err}");
        assert!(err.contains(file), "{err}");
    }
    let wrong = [
        &["timing", "check", "tiny.toml", "--baseline", "base.json", "--tolerance-samples", "-1"][..],
        &["timing", "check", "tiny.toml", "--baseline", "base.json", "--frames", "0..9"],
        &["timing", "show", "tiny.toml", "--machine", "exact"],
        &["timing", "show", "tiny.toml", "--frame", "9"],
        &["timing", "show", "tiny.toml", "--frame", "1", "--sweep", "40", "--out", "a.png"],
        &["timing", "show", "tiny.toml", "--frame", "1", "--sweep", "4"],
        &[
            "timing",
            "show",
            "tiny.toml",
            "--frame",
            "1",
            "--sweep",
            "4",
            "--out",
            "a.png",
            "--level",
            "coarse",
        ],
        &[
            "timing",
            "show",
            "tiny.toml",
            "--frame",
            "1",
            "--sweep",
            "4",
            "--out",
            "a.png",
            "--range-m",
            "9,3",
        ],
        &["timing", "show", "tiny.toml", "--misses", "40"],
        &["sizing", "tiny.toml", "--machine", "exact"],
        &["sizing", "tiny.toml", "--shows", "0"],
    ];
    for wrong in wrong {
        let (out, err) = scene.expect(2, wrong);
        assert!(out.is_empty() && err.contains("error"), "{wrong:?}: {err}");
    }
    assert!(!scene.join("a.png").exists());
}

#[test]
fn a_record_is_shown_as_text_document_and_plots() {
    let scene = Scene::new();
    let show = with(&["timing", "show", "tiny.toml"], &["--utilisation", "use.png", "--slack", "slack.png"]);
    let (out, _) = scene.expect(0, &show);
    let words =
        ["deadline", "loader.red", "critical path of frame", "transfer: fine level", "pointer arithmetic"];
    assert!(words.iter().all(|word| out.contains(word)), "{out}");
    let timeline = with(
        &["timing", "show", "tiny.toml", "--json", "--frame", "2"],
        &["--sweep", "7", "--out", "sweep.png", "--range-m", "0,200"],
    );
    let document = json(&scene.expect(0, &timeline).0);
    assert_eq!(document["schema"], "lunoid.timing.show/1");
    assert_eq!(document["record"]["frames"].as_array().unwrap().len(), 1);
    // The chain of the worst transfer adds up to the slack that the control plane found.
    let chain = &document["critical_path"]["chains"][0];
    assert_eq!((&chain["deadline"], &document["critical_path"]["frame"]), (&"transfer".into(), &2.into()));
    assert_eq!(chain["slack"], document["record"]["frames"][0]["deadlines"]["transfer"]["least"]);
    for file in ["use.png", "slack.png", "sweep.png"] {
        assert!(fs::read(scene.join(file)).unwrap().starts_with(b"\x89PNG"), "{file}");
    }
}

/// A fold is seen at a tick, and words that come with it are there at once: nothing waits for less than no time.
#[test]
fn words_that_come_with_their_fold_wait_for_nothing() {
    let scene = Scene::new();
    for frame in ["0", "1", "2", "3"] {
        let show = ["timing", "show", "tiny.toml", "--json", "--frame", frame];
        let document = json(&scene.expect(0, &show).0);
        let chain = &document["critical_path"]["chains"][0];
        assert!(chain["links"].as_array().unwrap().is_empty(), "{chain}");
        assert_eq!(chain["slack"], document["record"]["frames"][0]["deadlines"]["transfer"]["least"]);
    }
}

/// From a column of the picture to every line of the record that concerns it.
#[test]
fn misses_of_a_sweep_are_listed_line_by_line() {
    let scene = Scene::new();
    let slow = ["--frame", "2", "--set", "loader.access_ns=4000"];
    let show = |sweeps: String| {
        let more = [&slow[..], &["--misses", &sweeps]].concat();
        scene.expect(0, &with(&["timing", "show", "tiny.toml"], &more)).0
    };
    let lines = |sweeps: String| {
        let out = show(sweeps);
        out.lines().filter(|line| line.starts_with('2') && line.ends_with("access")).count()
    };
    let document = json(&scene.expect(0, &with(&["timing", "show", "tiny.toml", "--json"], &slow)).0);
    let misses = document["record"]["frames"][0]["misses"].as_array().unwrap();
    let of = |range: std::ops::Range<u64>| {
        let ours = misses.iter().filter(|missed| range.contains(&missed["sweep"].as_u64().unwrap()));
        ours.filter(|missed| missed["cause"] == "access").count()
    };
    assert_eq!(lines("0..40".into()), of(0..40));
    let sweep = misses[0]["sweep"].as_u64().unwrap();
    assert_eq!(lines(sweep.to_string()), of(sweep..sweep + 1));
    assert!(of(0..40) > of(sweep..sweep + 1));
    let quiet = (0..40).find(|&sweep| misses.iter().all(|missed| missed["sweep"] != sweep)).unwrap();
    let out = show(quiet.to_string());
    assert!(out.contains(&format!("no misses in sweeps {quiet}..")), "{out}");
}

fn rows(document: &Value) -> impl Iterator<Item = &Value> {
    document["tables"].as_array().unwrap().iter().flat_map(|table| table["rows"].as_array().unwrap())
}

#[test]
fn sizing_measures_what_the_record_counts() {
    let scene = Scene::new();
    let frames = ["--frames", "1..3", "--json"];
    let sized = json(&scene.expect(0, &with(&["sizing", "tiny.toml"], &frames)).0);
    assert_eq!(sized["schema"], "lunoid.sizing/1");
    let measured = |key: &str| {
        let row = rows(&sized).find(|row| row["key"] == key).unwrap_or_else(|| panic!("{key}: {sized:#}"));
        row["measured"].as_f64().unwrap()
    };
    let shown = json(&scene.expect(0, &with(&["timing", "show", "tiny.toml"], &frames)).0);
    let total = |key: &str| shown["totals"][key].as_u64().unwrap() as f64;
    let sweeps = 2.0 * 40.0;
    assert!((measured("crossings") - total("folds") / sweeps).abs() < 1e-9);
    let late = shown["totals"]["sets"]["late"].as_u64().unwrap() as f64;
    assert!(late > 0.0 && (measured("tears") - late / 2.0).abs() < 1e-9, "{late}");
}

/// Number 3 of hardware section 8, over a range programme that is not the formula's: the rate of each sample takes the place
/// of a constant one.
#[test]
fn sizing_agrees_with_its_formulas() {
    let scene = Scene::new();
    let scenario = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../scenarios/ridge-crossing.toml");
    let command =
        ["sizing", scenario, "--machine", "pra-nominal", "--sweeps", "105", "--no-search", "--json"];
    let sized = json(&scene.expect(0, &command).0);
    let close = |key: &str, by: f64| {
        let row = rows(&sized).find(|row| row["key"] == key).unwrap_or_else(|| panic!("{key}: {sized:#}"));
        let ratio = row["ratio"].as_f64().unwrap();
        assert!((ratio - 1.0).abs() < by, "{row}");
    };
    close("crossings_here", 0.01);
    close("t_u_mean_ns", 0.01);
    close("late_urgent", 0.05);
    close("cpu_pct", 1e-6);
    // Over all azimuths, which one frame does not have.
    close("loader.red_pct", 0.15);
}

/// Both generators are loaded where two levels blend. A scenario that switches has no such words.
#[test]
fn sizing_counts_the_words_of_a_blend() {
    let scene = Scene::new();
    let scenario = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../scenarios/two-levels-blended.toml");
    let command = [
        "sizing",
        scenario,
        "--machine",
        "pra-nominal",
        "--sweeps",
        "105",
        "--frames",
        "0..1",
        "--no-search",
        "--json",
    ];
    let sized = json(&scene.expect(0, &command).0);
    let found =
        |key: &str| rows(&sized).find(|row| row["key"] == key).unwrap_or_else(|| panic!("{key}: {sized:#}"));
    for (key, by) in [
        ("blend_crossings_fine", 0.05),
        ("blend_crossings_coarse", 0.05),
        ("blend_words_fine", 0.05),
        ("blend_words_coarse", 0.05),
        // Three or four crossings, from wherever in its region the eye stands.
        ("blend_words_nearer", 0.15),
    ] {
        let ratio = found(key)["ratio"].as_f64().unwrap();
        assert!((ratio - 1.0).abs() < by, "{}", found(key));
    }
    // Four sets of nine words a crossing, but for those that the next crossing of the same axis overtakes.
    let measured = |key: &str| found(key)["measured"].as_f64().unwrap();
    let most = 105.0 * 36.0 * measured("blend_crossings_coarse");
    assert!((0.9 * most..=most).contains(&measured("blend_words_coarse")), "{most}");
    let switch = json(&scene.expect(0, &[&command[..], &["--set", "scenario.levels.blend_m=0"]].concat()).0);
    assert!(rows(&switch).all(|row| !row["key"].as_str().unwrap().starts_with("blend")), "{switch:#}");
}

/// What is found to be slow enough shows nothing, and a tick more does.
#[test]
fn the_search_ends_where_tears_begin() {
    let scene = Scene::new();
    let seen = |access: &str| {
        let set = format!("loader.access_ns={access}");
        let command =
            ["sizing", "tiny.toml", "--machine", "pra-nominal", "--json", "--no-search", "--set", &set];
        let sized = json(&scene.expect(0, &command).0);
        let row = rows(&sized).find(|row| row["key"] == "tears_seen").unwrap().clone();
        row["measured"].as_f64().unwrap()
    };
    let (out, _) = scene.expect(0, &["sizing", "tiny.toml", "--machine", "pra-nominal", "--json"]);
    let search = &json(&out)["searches"][0];
    assert_eq!(search["key"], "loader.access_ns");
    let slowest = search["slowest_ns"].as_f64().unwrap();
    assert!(slowest > 0.0 && !search["any"].as_bool().unwrap(), "{search}");
    assert_eq!(seen(&slowest.to_string()), 0.0);
    assert!(seen(&(slowest + 50.0).to_string()) > 0.0);
}

/// The viewer of `lod-mesh` has one unit work after the other, but for two stages of its board: in all it takes less than the frame is long.
#[test]
fn a_frame_of_one_unit_after_another_says_what_it_takes_in_all() {
    let scene = Scene::new();
    let last = |machine: &str| -> (String, Vec<f64>) {
        let (out, _) =
            scene.expect(0, &["timing", "show", "tiny.toml", "--machine", machine, "--frames", "0..1"]);
        let at = out.find("\nframe ").expect("a table of times");
        let mut lines = out[at + 1..].lines();
        let head = lines.next().unwrap().trim_end().rsplit("  ").next().unwrap().trim().to_owned();
        let row = lines.next().unwrap().split_whitespace().skip(1);
        (head, row.map(|number| number.parse().unwrap()).collect())
    };
    let (head, times) = last("lod-mesh");
    let [cpu, bus, vertex, triangle, capture, in_all] = times[..] else { panic!("{times:?}") };
    assert_eq!(head, "in all (ms)");
    assert!((cpu + bus + vertex.max(triangle) + capture - in_all).abs() < 0.03, "{times:?}");
    assert_eq!(last("smooth-faces").0, "frame length (ms)");
}
