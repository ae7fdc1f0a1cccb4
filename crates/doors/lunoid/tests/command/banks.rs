use std::fs;

use files::{Npy, read_npy, write_npy};

use crate::scene::Scene;

/// Corners of a 3 x 4 lattice with different words everywhere.
fn corners(scene: &Scene, name: &str) -> Npy {
    let values: Vec<f64> = (0..3 * 4 * 9).map(|index| f64::from(index * 37 % 101) * 0.01).collect();
    let array = Npy::new(vec![3, 4, 9], values).unwrap();
    write_npy(scene.join(name), &array).unwrap();
    array
}

#[test]
fn corners_go_in_and_come_out() {
    let scene = Scene::new();
    let array = corners(&scene, "corners.npy");
    let import = ["bank", "import", "corners.npy", "--region-size-m", "250", "--origin-m", "-500,1000"];
    let (out, _) = scene.expect(0, &[&import[..], &["-o", "a.bank"]].concat());
    assert!(out.contains("2 x 3") && out.contains("250 m"), "{out}");
    assert!(scene.join("a.bank.toml").exists());
    scene.expect(0, &["bank", "export", "a.bank", "-o", "back.npy"]);
    assert_eq!(read_npy(scene.join("back.npy"), 1 << 20).unwrap(), array);
    let documents: Vec<serde_json::Value> = [
        &[&import[..], &["-o", "b.bank", "--json"]].concat()[..],
        &["bank", "generate", "tiny.toml", "-o", "g.bank", "--json"],
        &["bank", "export", "a.bank", "-o", "c.npy", "--json"],
    ]
    .map(|arguments| serde_json::from_str(&scene.expect(0, arguments).0).unwrap())
    .into();
    assert_eq!(documents[0]["levels"][0]["corners"], serde_json::json!([3, 4]));
    assert_eq!((&documents[0]["file"], &documents[1]["schema"]), (&"b.bank".into(), &"lunoid.bank/1".into()));
    assert_eq!(documents[2]["shape"], serde_json::json!([3, 4, 9]));
    let (out, _) = scene.expect(0, &["bank", "show", "a.bank", "-o", "a.png", "--json", "--regions"]);
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(document["levels"][0]["origin_m"], serde_json::json!([-500.0, 1000.0]));
    assert!(fs::read(scene.join("a.png")).unwrap().starts_with(b"\x89PNG"));
    let (out, _) = scene.expect(0, &["info", "a.bank"]);
    assert!(out.starts_with("corners\n"), "{out}");
    scene.expect(2, &["bank", "export", "a.bank", "--level", "1", "-o", "no.npy"]);
}

#[test]
fn a_generated_landscape_as_a_bank_gives_the_same_frames() {
    let scene = Scene::new();
    scene.expect(0, &["bank", "generate", "tiny.toml", "-o", "tiny.bank"]);
    scene.expect(0, &["replay", "tiny.toml", "-q", "--out", "a"]);
    scene.expect(0, &["replay", "tiny.toml", "-q", "--out", "b", "--bank", "tiny.bank"]);
    scene.expect(0, &["compare", "a", "b", "--max-rmse", "0"]);
    let record = fs::read_to_string(scene.join("b/run.json")).unwrap();
    let record: serde_json::Value = serde_json::from_str(&record).unwrap();
    assert_eq!(record["references"][0]["file"], "tiny.bank");
    assert_eq!(record["ground"]["source"], "bank");
}

/// A map of the Moon in metres, south and west of its origin.
#[test]
fn places_have_the_side_that_they_lie_on() {
    let scene = Scene::new();
    let row = "1.5 2 2.5 3 2.5 2 1.5 2 2.5 3 2.5 2\n";
    let head = "ncols 12\nnrows 12\nxllcorner -60000\nyllcorner -30000\ncellsize 10\nNODATA_value -9999\n";
    scene.write("ground.asc", format!("{head}{}", row.repeat(12)));
    let globe = "GEOGCS[\"g\",DATUM[\"d\",SPHEROID[\"s\",1737400.0,0.0]],PRIMEM[\"p\",0],UNIT[\"Degree\",0.0174532925199433]]";
    let map = format!(
        "PROJCS[\"m\",{globe},PROJECTION[\"Equidistant_Cylindrical\"],PARAMETER[\"Central_Meridian\",0],UNIT[\"Meter\",1.0]]"
    );
    scene.write("ground.prj", map);
    scene.expect(0, &["survey", "ground.asc", "-o", "ground.bank"]);
    let (out, _) = scene.expect(0, &["bank", "show", "ground.bank"]);
    assert!(out.contains("touches the Moon at 0.98") && out.contains(" S, 1.97"), "{out}");
    assert!(out.contains(" W (x = "), "{out}");
}

#[test]
fn wrong_corners_are_refused() {
    let scene = Scene::new();
    write_npy(scene.join("flat.npy"), &Npy::new(vec![3, 4], vec![0.0; 12]).unwrap()).unwrap();
    write_npy(scene.join("single.npy"), &Npy::new(vec![2, 2, 9], vec![0.0_f32; 36]).unwrap()).unwrap();
    let mut values = vec![0.0; 36];
    values[20] = f64::NAN;
    write_npy(scene.join("nan.npy"), &Npy::new(vec![2, 2, 9], values).unwrap()).unwrap();
    scene.write("text.npy", "no array");
    for name in ["flat", "single", "nan", "text", "missing"] {
        let file = format!("{name}.npy");
        let (_, err) = scene.expect(3, &["bank", "import", &file, "--region-size-m", "1", "-o", "x.bank"]);
        assert!(err.starts_with(&format!("error: {file}")), "{err}");
        assert!(!scene.join("x.bank").exists());
    }
}

#[test]
fn an_elevation_file_becomes_a_bank() {
    let scene = Scene::new();
    let wave = |line: usize, column: usize| 3.0 * ((line as f64) * 0.11 - 0.02 * (column as f64));
    let heights: Vec<f64> = (0..40 * 50).map(|at| wave(at / 50, at % 50)).collect();
    write_npy(scene.join("ground.npy"), &Npy::new(vec![40, 50], heights).unwrap()).unwrap();
    let base = ["survey", "ground.npy", "--spacing-m", "5", "--region-size-m", "40", "-o", "ground.bank"];
    let (out, _) = scene.expect(0, &[&base[..], &["--picture", "ground.png", "--json"]].concat());
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(document["schema"], "lunoid.survey/1");
    assert!(document["levels"][0]["rms_m"].as_f64().unwrap() < 1e-3, "{out}");
    assert!(fs::read(scene.join("ground.png")).unwrap().starts_with(b"\x89PNG"));
    scene.expect(0, &["bank", "show", "ground.bank"]);
    let (out, _) = scene.expect(0, &["info", "ground.npy"]);
    assert!(out.contains("40 lines of 50 samples"), "{out}");
    let (_, err) = scene.expect(3, &["survey", "ground.npy", "-o", "other.bank"]);
    assert!(err.contains("--spacing"), "{err}");
}
