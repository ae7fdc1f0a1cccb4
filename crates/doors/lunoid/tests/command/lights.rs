//! `lunoid study lights`: what it finds, what it leaves in a folder, what it refuses.

use serde_json::Value;

use crate::scene::Scene;

/// A plain under a lamp of half a metre, which a wall hides at first; the eye comes nearer and passes the wall.
const PLAIN: &str = r#"format = 1
title = "Plain"
shows = "A lamp over a plain comes out from behind a wall."
machine = "sampled"
duration_s = 2
[landscape]
albedo = 0.02
[landscape.generated]
seed = 1
extent_m = [600, 600]
region_size_m = 30
[landscape.generated.undulation]
rms_height_m = 0
hurst = 0.8
longest_m = 200
shortest_m = 100
[sun]
azimuth_deg = 60
elevation_deg = 10
[[object]]
id = "wall"
file = "wall.obj"
x_m = 130
y_m = 300
[[light]]
id = "beacon"
x_m = 300
y_m = 300
above_m = 6
diameter_m = 0.5
colour = [1, 1, 1]
[[light]]
id = "other"
x_m = 310
y_m = 320
above_m = 3
diameter_m = 0.2
colour = [1, 0, 0]
[stars]
seed = 1
count = 40
[vehicle]
max_speed_m_s = 60
[path]
file = "plain.csv"
[raster]
columns = 120
lines = 80
update_hz = 10
"#;

/// 2 x 40 m and 12 m high, its foot in the origin.
const WALL: &str = "v -1 -20 0\nv 1 -20 0\nv 1 20 0\nv -1 20 0\nv -1 -20 12\nv 1 -20 12\nv 1 20 12\nv -1 20 12\n\
                    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

#[test]
fn a_lamp_keeps_its_light_unless_it_is_not_divided() {
    let scene = plain();
    let (out, _) =
        scene.expect(0, &["study", "lights", "plain.toml", "--light", "beacon", "--out", "found", "--json"]);
    let told: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(
        (told["schema"].as_str(), told["light"].as_str()),
        (Some("lunoid.study-lights/1"), Some("beacon"))
    );
    let of = |way: usize, figure: &str| told["ways"][way][figure].as_f64().unwrap();
    let names: Vec<_> = (0..3).map(|way| told["ways"][way]["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["raster", "undivided", "beam"]);
    for way in 0..3 {
        let appears = told["ways"][way]["appears"].as_array().unwrap();
        assert_eq!(appears.len(), 1, "{told}");
        assert!(told["ways"][way]["vanishes"].as_array().unwrap().is_empty(), "{told}");
    }
    let [raster, undivided, beam] = [0, 1, 2].map(|way| of(way, "twinkle"));
    assert!(raster < 0.02 && beam < 0.02 && undivided > 0.1, "{told}");
    for way in [0, 2] {
        let mean = told["ways"][way]["share"][1].as_f64().unwrap();
        assert!((mean - 1.0).abs() < 0.02, "{told}");
    }
    for file in ["lights.json", "lights.csv", "lights.md", "lights.svg"] {
        assert!(scene.path().join("found").join(file).exists(), "{file}");
    }
    let csv = std::fs::read_to_string(scene.path().join("found/lights.csv")).unwrap();
    let mut lines = csv.lines();
    assert!(
        lines.next().unwrap().starts_with("frame,t_s,distance_m,closed_form_white_px,raster_white_px"),
        "{csv}"
    );
    let row = |line: &str| line.split(',').map(|cell| cell.parse().unwrap()).collect::<Vec<f64>>();
    let rows: Vec<Vec<f64>> = lines.map(row).collect();
    // By the inverse square of the distance.
    let [first, last] = [&rows[0], &rows[rows.len() - 1]];
    assert!((first[3] * first[2] * first[2] / (last[3] * last[2] * last[2]) - 1.0).abs() < 1e-9, "{csv}");
    assert!(first[2] > last[2] && first[4] == 0.0 && last[4] > 0.0, "{csv}");
}

#[test]
fn a_light_that_is_not_there_is_refused_with_those_that_are() {
    let scene = plain();
    let (_, said) = scene.expect(2, &["study", "lights", "plain.toml"]);
    assert!(said.contains("2 lights") && said.contains("beacon, other"), "{said}");
    let (_, said) = scene.expect(2, &["study", "lights", "plain.toml", "--light", "becon"]);
    assert!(said.contains("--light becon: no such light") && said.contains("beacon, other"), "{said}");
    let (_, said) = scene.expect(3, &["study", "lights", "tiny.toml"]);
    assert!(said.contains("no [[light]]"), "{said}");
}

#[test]
fn what_would_be_passed_over_is_refused() {
    let scene = plain();
    let all = ["study", "lights", "plain.toml", "--light", "beacon", "--out", "found"];
    let (_, said) = scene.expect(2, &[&all[..], &["--set", "sampled.normalise=false"]].concat());
    assert!(said.contains("--set sampled.normalise: the ways of this study set it"), "{said}");
    scene.write("plain.toml", PLAIN.replacen("diameter_m = 0.5", "diameter_m = 0.5\nintensity = 0", 1));
    let (_, said) = scene.expect(3, &all);
    assert!(said.contains("the light sends the eye nothing in frames 0..20"), "{said}");
    assert!(!scene.path().join("found").exists());
}

fn plain() -> Scene {
    let scene = Scene::new();
    scene.write("plain.toml", PLAIN);
    scene.write("wall.obj", WALL);
    scene.write(
        "plain.csv",
        "t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n0,60,300,4,0,0,0\n2,120,300,30,0,-6,0\n",
    );
    scene
}
