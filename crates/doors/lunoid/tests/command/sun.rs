//! `lunoid sun`, and a replay under the sun of a date.

use serde_json::Value;

use crate::scene::Scene;

const AT: &str = "1972-12-11T22:00:00Z";
const VALLEY: &str = "30.77,20.19";

fn document(scene: &Scene, arguments: &[&str]) -> Value {
    serde_json::from_str(&scene.expect(0, arguments).0).unwrap()
}

#[test]
fn sun_and_earth_over_a_place() {
    let scene = Scene::new();
    let (out, _) = scene.expect(0, &["sun", "--place", VALLEY, "--at", AT]);
    assert!(out.starts_with("1972-12-11T22:00:00Z at 20.19 N, 30.77 E\n"), "{out}");
    assert!(out.contains("sun    azimuth 96.") && out.contains("69 % lit, waning"), "{out}");
    let leap = ["--at", "2016-12-31T23:59:59Z", "--until", "2017-01-01T00:00:00Z", "--step", "1"];
    let (out, _) = scene.expect(0, &[&["sun", "--place", VALLEY][..], &leap].concat());
    let times: Vec<&str> = out.lines().skip(1).filter_map(|line| line.split(' ').next()).collect();
    assert_eq!(times, ["2016-12-31T23:59:59Z", "2016-12-31T23:59:60Z", "2017-01-01T00:00:00Z"]);
    let found =
        document(&scene, &["sun", "--place", "-17.47136,-3.6453", "--at", "1971-02-05T09:18:13Z", "--json"]);
    let sky = &found["skies"][0];
    assert_eq!((&found["schema"], &sky["at"]), (&"lunoid.sun/1".into(), &"1971-02-05T09:18:13Z".into()));
    assert!((sky["sun"]["elevation_deg"].as_f64().unwrap() - 10.3).abs() < 0.1, "{sky}");
    assert_eq!(sky["sun"]["azimuth_deg"], sky["sun"]["true_azimuth_deg"]);
    let table = ["--until", "1972-12-12T01:00:00Z", "--step", "3600"];
    let (out, _) = scene.expect(0, &[&["sun", "--place", VALLEY, "--at", AT][..], &table].concat());
    assert_eq!(out.lines().count(), 5, "{out}");
    assert!(out.lines().last().unwrap().starts_with("1972-12-12T01:00:00Z"), "{out}");
}

#[test]
fn what_is_no_date_or_place_is_refused() {
    let scene = Scene::new();
    for (arguments, said) in [
        (
            &["--place", VALLEY, "--at", "1972-12-11"][..],
            "expected a date and time such as 1972-12-11T22:00:00Z",
        ),
        (&["--place", VALLEY, "--at", "1972-12-11T22:00:00"], "time zone is missing"),
        (&["--place", VALLEY, "--at", "1859-12-11T22:00:00Z"], "expected a year from 1960 to 2050"),
        (&["--place", VALLEY, "--at", "2051-01-01T00:00:00Z"], "expected a year from 1960 to 2050"),
        (
            &["--place", VALLEY, "--at", AT, "--until", "2051-01-01T00:00:00Z", "--step", "60"],
            "expected a year from 1960 to 2050",
        ),
        (&["--place", VALLEY, "--at", "2017-12-31T23:59:60Z"], "no leap second ends that minute"),
        (&["--place", "30", "--at", AT], "expected longitude"),
        (&["--place", "30,91", "--at", AT], "expected longitude"),
        (&["--at", AT], "BANK"),
        (&["--place", VALLEY, "--at", AT, "--until", AT], "--step"),
        (&["--place", VALLEY, "--at", AT, "--until", "1971-01-01T00:00:00Z", "--step", "60"], "or later"),
        (
            &["--place", VALLEY, "--at", AT, "--until", "1973-01-01T00:00:00Z", "--step", "0.1"],
            "raise --step",
        ),
    ] {
        let (out, err) = scene.expect(2, &[&["sun"][..], arguments].concat());
        assert!(out.is_empty() && err.contains(said), "{arguments:?}: {err}");
    }
    scene.expect(0, &["bank", "generate", "tiny.toml", "-o", "nowhere.bank"]);
    let (_, err) = scene.expect(3, &["sun", "nowhere.bank", "--at", AT]);
    assert!(err.contains("nowhere.bank: the bank knows no place on the Moon"), "{err}");
    assert!(err.contains("give --place LON,LAT") && !err.contains("[sun]"), "{err}");
}

/// The scenario of the scene with other keys under `[sun]`.
fn under(scene: &Scene, name: &str, keys: &str) {
    let text = std::fs::read_to_string(scene.join("tiny.toml")).unwrap();
    let start = text.find("[sun]").unwrap();
    let end = start + 5 + text[start + 5..].find("\n[").unwrap();
    scene.write(name, format!("{}[sun]\n{keys}\n{}", &text[..start], &text[end..]));
}

#[test]
fn a_date_lights_as_its_angles_do_and_stands_in_the_record() {
    let scene = Scene::new();
    let sky = &document(&scene, &["sun", "--place", VALLEY, "--at", AT, "--json"])["skies"][0];
    under(
        &scene,
        "dated.toml",
        &format!("at = '{AT}'\nplace = {{ longitude_deg = 30.77, latitude_deg = 20.19 }}"),
    );
    under(
        &scene,
        "angles.toml",
        &format!(
            "azimuth_deg = {}\nelevation_deg = {}",
            sky["sun"]["azimuth_deg"], sky["sun"]["elevation_deg"]
        ),
    );
    for name in ["dated", "angles"] {
        scene.expect(0, &["replay", &format!("{name}.toml"), "-q", "--out", name]);
    }
    scene.expect(0, &["compare", "dated", "angles", "--max-rmse", "1e-6"]);
    let bare = format!("scenario.sun.at={AT}");
    let more = [
        "--set",
        &bare,
        "--set",
        "scenario.sun.place.longitude_deg=30.77",
        "--set",
        "scenario.sun.place.latitude_deg=20.19",
    ];
    under(&scene, "open.toml", "");
    scene.expect(0, &[&["replay", "open.toml", "-q", "--no-page", "--out", "set"][..], &more].concat());
    scene.expect(0, &["compare", "dated", "set", "--max-rmse", "0"]);
    let record = |run: &str| -> Value {
        serde_json::from_str(&std::fs::read_to_string(scene.join(&format!("{run}/run.json"))).unwrap())
            .unwrap()
    };
    let dated = record("dated");
    assert_eq!(&dated["sky"], sky);
    assert_eq!(dated["sun"]["azimuth_deg"], sky["sun"]["azimuth_deg"]);
    assert_eq!(record("angles")["sky"], Value::Null);
    let (out, _) = scene.expect(0, &["info", "dated.toml"]);
    assert!(out.contains("sun of 1972-12-11T22:00:00Z"), "{out}");
    let (_, err) = scene.expect(3, &["replay", "dated.toml", "-q", "--out", "dated2", "--bank", "no.bank"]);
    assert!(err.contains("no.bank"), "{err}");
    under(
        &scene,
        "night.toml",
        "at = '1972-12-25T22:00:00Z'\nplace = { longitude_deg = 30.77, latitude_deg = 20.19 }",
    );
    let (_, err) = scene.expect(3, &["replay", "night.toml", "-q", "--out", "night"]);
    assert!(err.contains("the sun stands at an elevation of -") && err.contains("`lunoid sun`"), "{err}");
    assert!(!scene.join("night").exists());
}
