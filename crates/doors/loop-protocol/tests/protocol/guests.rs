//! What a session tells of machines that are not the hybrid one, and of times.

use serde_json::{Value, json};

use crate::home::{Scene, ask, done, ok, pose_json, problems};

/// The rows that a request of a name answers with, under that name.
fn rows(machine: Scene, name: &str) -> Vec<Value> {
    ok(&mut machine.session(), json!({ "do": name }))[name].as_array().unwrap().clone()
}

fn find<'a>(rows: &'a [Value], key: &str) -> &'a Value {
    rows.iter().find(|row| row["key"] == key).unwrap_or_else(|| panic!("no key {key}"))
}

/// A guest has its run parameters, its gear and the view, with what was set and from where; no part of the hybrid machine.
#[test]
fn the_parameters_of_a_guest_are_its_own() {
    let sampled = rows(Scene::by("sampled").setting("sampled.overload", "late"), "parameters");
    let overload = find(&sampled, "sampled.overload");
    assert_eq!((overload["value"].as_str(), overload["source"].as_str()), (Some("late"), Some("--set:1")));
    let free = sampled.iter().find(|row| row["value"].is_null()).expect("a parameter that no file sets");
    assert_eq!(free["source"], "sampled");
    assert!(find(&sampled, "dpp.projection")["value"].is_string(), "the view is that of any generator");
    for machine in ["sampled", "lunsim", "lod-mesh", "smooth-faces"] {
        let own = rows(Scene::by(machine).setting("lunsim.restrictions", "false"), "parameters");
        let keys: Vec<&str> = own.iter().map(|row| row["key"].as_str().unwrap()).collect();
        assert!(keys.is_sorted() && !keys.contains(&"loader.access_ns"), "{machine}: {keys:?}");
        let has_own = |key: &&str| drive_rows(machine).iter().any(|table| key.starts_with(table));
        assert!(keys.iter().any(has_own), "{machine}: {keys:?}");
    }
    let own = rows(Scene::by("pra-nominal"), "parameters");
    assert!(find(&own, "loader.access_ns")["value"].is_number());
    assert!(own.iter().all(|row| !row["key"].as_str().unwrap().starts_with("sampled.")));
}

/// Beginnings of the keys of a generator.
fn drive_rows(machine: &str) -> Vec<String> {
    let row = registry::find(machine).unwrap();
    row.tables().map(|table| format!("{table}.")).collect()
}

/// A guest whose frames have deadlines counts them; one without says that it has none.
#[test]
fn the_deadlines_of_a_guest_are_told() {
    let timing = json!({ "do": "timing", "frame": 1 });
    let sampled = ok(&mut Scene::by("sampled").session(), timing.clone());
    let names: Vec<&str> =
        sampled["deadlines"].as_array().unwrap().iter().map(|row| row["name"].as_str().unwrap()).collect();
    assert!(names.contains(&"sub-area") && names.contains(&"frame-tasks"), "{sampled}");
    assert!(sampled["folds"].is_null() && sampled["late_words"].is_null());
    let rows = sampled["deadlines"].as_array().unwrap();
    let missed: u64 = rows.iter().map(|row| row["missed"].as_u64().unwrap()).sum();
    assert_eq!(sampled["missed"], missed);
    assert!(rows.iter().any(|row| row["least_slack_us"].is_number()));
    let machine = ok(&mut Scene::by("pra-nominal").session(), timing.clone());
    assert!(machine["folds"].as_u64() > Some(0) && !machine["deadlines"].as_array().unwrap().is_empty());
    let exact = problems(&mut Scene::by("exact").session(), timing).remove(0);
    assert!(exact["title"].as_str().unwrap().contains("take no time"), "{exact}");
    let events =
        problems(&mut Scene::by("sampled").session(), json!({ "do": "events", "frame": 0 })).remove(0);
    assert_eq!(events["help"], "its deadlines are counted by `timing`");
}

/// The time of a look is that of its sun; time and frame that are left out follow from one another.
#[test]
fn the_time_of_a_look_counts() {
    let drifts =
        "elevation_deg = 15\nstep_s = 0.1\ndrift = [{ t_s = 0.3, azimuth_deg = 60, elevation_deg = 25 }]";
    let scene = Scene::by("exact").reworded("elevation_deg = 15", drifts);
    let pose = pose_json(&scene.drive().pose(0).unwrap());
    let mut session = scene.session();
    let mut look = |frame: Option<u64>, time_s: Option<f64>| {
        let mut pose = pose.clone();
        pose["time_s"] = json!(time_s);
        let seen = done(&ask(&mut session, json!({ "do": "look", "frame": frame, "pose": pose })));
        (seen["frame"].as_u64().unwrap(), seen["pose"]["time_s"].as_f64().unwrap(), seen["hash"].clone())
    };
    let [neither, third, of_time] = [look(None, None), look(Some(3), None), look(None, Some(0.3))];
    assert_eq!((neither.0, neither.1, third.1, of_time.0), (0, 0.0, 0.3, 3));
    assert_eq!(third.2, of_time.2);
    assert_ne!(neither.2, third.2, "the sun has moved");
    let both = look(Some(0), Some(0.3));
    assert_eq!((both.0, both.1, both.2), (0, 0.3, third.2));
}
