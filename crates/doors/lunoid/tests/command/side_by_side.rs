//! Several machines on one scenario: a run of each, and one page.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;

const SEVERAL: [&str; 8] =
    ["replay", "tiny.toml", "--machine", "ideal", "--machine", "pra-nominal", "--out", "all"];

/// The three machines; LUNSIM cannot do relief.
fn with_lunsim(rest: &[&str]) -> Vec<String> {
    let lunsim = ["--machine", "lunsim", "--set", "lunsim.restrictions=false", "--set", "lunsim.grid=64"];
    [&SEVERAL[..], &lunsim, rest].concat().into_iter().map(str::to_owned).collect()
}

fn run(scene: &Scene, code: i32, arguments: &[String]) -> (String, String) {
    scene.expect(code, &arguments.iter().map(String::as_str).collect::<Vec<_>>())
}

#[test]
fn one_page_holds_them_against_exact() {
    let scene = Scene::new();
    let (out, _) = run(&scene, 0, &with_lunsim(&["--json", "--sweeps", "48"]));
    let document: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(document["schema"], "lunoid.replay-several/1");
    assert_eq!(document["runs"].as_array().unwrap().len(), 4);
    let names = ["exact", "ideal", "index.html", "lunsim", "pra-nominal", "side-by-side.json"];
    assert_eq!(scene.list("all"), names);
    let figures: Value =
        serde_json::from_slice(&fs::read(scene.join("all/side-by-side.json")).unwrap()).unwrap();
    assert_eq!(figures, document["side_by_side"]);
    let machines = figures["machines"].as_array().unwrap();
    let order: Vec<&str> = machines.iter().map(|machine| machine["name"].as_str().unwrap()).collect();
    assert_eq!(order, ["ideal", "pra-nominal", "lunsim", "exact"]);
    assert_eq!((&machines[3]["errors"], &machines[2]["model"]), (&Value::Null, &Value::Null));
    let rmse = |machine: usize| {
        let errors = machines[machine]["errors"].as_array().unwrap();
        assert_eq!(errors.len(), 4);
        errors.iter().map(|error| error["rmse"].as_f64().unwrap()).sum::<f64>()
    };
    // Parts of 1970 are worse than ideal ones.
    assert!(0.0 < rmse(0) && rmse(0) < rmse(1) && rmse(2) > 0.0, "{figures}");
    assert!(machines.iter().all(|machine| machine["time"]["drawing_s"].as_f64().unwrap() > 0.0), "{figures}");
    let page = fs::read_to_string(scene.join("all/index.html")).unwrap();
    assert!(order.iter().all(|name| page.contains(&format!("href=\"{name}/index.html\""))), "links");
    assert_eq!(page.matches("Difference of ").count(), 12);
    assert!(page.contains("Left out") && !page.contains("://"), "a page of its own");
    // What stands against what is what `compare` says.
    let (told, _) = scene.expect(0, &["compare", "all/ideal", "all/exact", "--json"]);
    let told: Value = serde_json::from_str(&told).unwrap();
    assert_eq!(told["pictures"][2]["rmse"], machines[0]["errors"][2]["rmse"]);
}

#[test]
fn a_run_among_others_is_the_run_alone_and_goes_on() {
    let scene = Scene::new();
    let first: Vec<&str> = [&SEVERAL[..], &["--frames", "0..2"]].concat();
    scene.expect(0, &first);
    let (out, _) = scene.expect(0, &SEVERAL);
    assert_eq!(out.matches("2 drawn now").count(), 3, "{out}");
    let page = fs::read(scene.join("all/index.html")).unwrap();
    let (again, _) = scene.expect(0, &SEVERAL);
    assert_eq!(again.matches("all there already").count(), 3, "{again}");
    assert_eq!(fs::read(scene.join("all/index.html")).unwrap(), page);
    scene.expect(0, &["replay", "tiny.toml", "--machine", "pra-nominal", "--out", "alone"]);
    for file in ["run.json", "page.json", "index.html"] {
        let read = |folder: &str| fs::read(scene.join(folder).join(file)).unwrap();
        assert!(read("alone") == read("all/pra-nominal"), "{file}");
    }
    scene.expect(0, &["page", "all/ideal"]);
}

#[test]
fn what_cannot_stand_side_by_side_is_refused() {
    let scene = Scene::new();
    let (_, err) = scene.expect(2, &[&SEVERAL[..], &["--truth", "range"]].concat());
    assert!(err.contains("--truth: this belongs to one run"), "{err}");
    let (_, err) = scene.expect(2, &[&SEVERAL[..], &["--machine", "ideal"]].concat());
    assert!(err.contains("two machines would draw into the folder `ideal`"), "{err}");
    scene.vary("open.toml", "sweeps = 40\n", "");
    let mut open = SEVERAL;
    open[1] = "open.toml";
    let (_, err) = scene.expect(2, &open);
    assert!(err.contains("ideal draws 1000 x ") && err.contains("pra-nominal draws 525 x "), "{err}");
    assert!(!scene.join("all").exists(), "nothing was begun");
    scene.expect(0, &["replay", "tiny.toml", "-q", "--out", "one"]);
    let mut one = SEVERAL;
    one[7] = "one";
    let (_, err) = scene.expect(4, &one);
    assert!(err.contains("one: there is `index.html` already"), "{err}");
    scene.expect(0, &SEVERAL);
    scene.expect(4, &["replay", "tiny.toml", "--out", "all"]);
}

/// Before any machine draws: what one cannot do at elaboration, and what it cannot do in a later frame.
#[test]
fn a_machine_that_cannot_draw_the_scenario_stops_all_of_them() {
    let scene = Scene::new();
    let (_, err) = scene.expect(3, &[&SEVERAL[..], &["--machine", "lunsim"]].concat());
    let words = [
        "error: tiny.toml: --machine lunsim: lunsim cannot do",
        "ground of any relief ([landscape]: ",
        "change the scenario, or lift",
    ];
    assert!(words.iter().all(|word| err.contains(word)) && err.lines().count() == 1, "{err}");
    assert!(!scene.join("all").exists(), "nothing was begun");
    // The eye looks down in the last frame, and it is seen before the first is drawn.
    let keyframes = "keyframes = [
  { t_s = 0, x_m = 100, y_m = 200 },
  { t_s = 5, x_m = 108, y_m = 205 },
]";
    scene.vary("down.toml", keyframes, "file = 'down.csv'");
    let rows = "0,100,200,30,0,0,0\n0.2,101,200,30,0,0,0\n0.3,102,200,30,0,85,0\n";
    scene.write("down.csv", format!("t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n{rows}"));
    let mut down = SEVERAL;
    down[1] = "down.toml";
    let (_, err) = scene.expect(3, &down);
    assert!(err.starts_with("error: down.toml: --machine ideal: frame 3: pitch 85.0 deg"), "{err}");
    assert!(!scene.join("all").exists(), "nothing was begun");
}

/// What is set of parts is set of the machines that have them: the closed form beside them has none.
#[test]
fn parts_are_set_of_those_that_have_them() {
    let scene = Scene::new();
    scene.expect(0, &[&SEVERAL[..], &["--set", "loader.access_ns=90"]].concat());
    let words = |folder: &str| fs::read_to_string(scene.join(folder).join("page.json")).unwrap();
    assert!(words("all/pra-nominal").contains("loader.access_ns=90"));
    assert!(!words("all/exact").contains("loader.access_ns=90"));
}
