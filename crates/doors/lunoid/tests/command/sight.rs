//! `lunoid sight`: lines, paths and areas over scenarios, banks and elevation files.

use std::fs;

use files::{Npy, NpyData, read_npy, write_npy};
use serde_json::Value;
use survey::ReadOptions;

use crate::scene::Scene;

const TINY: &str = include_str!("../tiny.toml");

fn document(scene: &Scene, arguments: &[&str]) -> Value {
    serde_json::from_str(&scene.expect(0, &[&["sight"][..], arguments, &["--json"]].concat()).0).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

/// Posts 5 m apart, three rows of 141: flat but for a ridge of 8 m at column 20. The southernmost row is row 2.
fn ridge(scene: &Scene) {
    let heights = (0..3 * 141).map(|at| if at % 141 == 20 { 8.0 } else { 0.0 }).collect();
    write_npy(scene.join("ridge.npy"), &Npy::new(vec![3, 141], NpyData::F64(heights)).unwrap()).unwrap();
}

const RIDGE: [&str; 5] = ["ridge.npy", "--spacing-m", "5", "--curvature", "flat"];

/// From 10 m above column 0 the line over the ridge falls by 2 m in 20 posts.
#[test]
fn a_ridge_hides_what_similar_triangles_say() {
    let scene = Scene::new();
    ridge(&scene);
    let look = |more: &[&str]| {
        document(&scene, &[&RIDGE[..], &["--from", "5,0", "--observer-height", "10"], more].concat())
    };
    let line = &look(&["--to", "5,300"])["lines"][0];
    assert_eq!(line["sight"], "hidden", "{line}");
    assert!((number(&line["least_height_m"]) - 4.0).abs() < 1e-12, "{line}");
    // The line falls by 10 m in 300 m; the flank rises from 95 m to 100 m by 8 m.
    let meets = (10.0 + 152.0) / (1.6 + 1.0 / 30.0);
    assert!((number(&line["blocker"]["distance_m"]) - meets).abs() < 1e-9, "{line}");
    assert_eq!(look(&["--to", "5,300", "--target-height", "4.001"])["lines"][0]["sight"], "visible");
    assert_eq!(look(&["--to", "5,300", "--target-height", "datum:3.999"])["lines"][0]["sight"], "hidden");
    let area = look(&["--area", "4,104,6,701"]);
    assert_eq!((&area["area"]["rows"], &area["area"]["columns"]), (&1.into(), &120.into()), "{area}");
    let hidden = number(&area["area"]["hidden"]);
    assert!((79.0..=80.0).contains(&hidden), "{area}");
}

#[test]
fn a_path_is_told_row_by_row() {
    let scene = Scene::new();
    ridge(&scene);
    scene.write("path.csv", "north_m,east_m,height_m\n5,50,\n5,300,\n5,300,5\n");
    let look = [&["sight"][..], &RIDGE, &["--from", "5,0", "--observer-height", "10", "--path", "path.csv"]]
        .concat();
    let (out, _) = scene.expect(0, &[&look[..], &["--out", "seen.csv"]].concat());
    let told: Vec<&str> = out.lines().skip(1).collect();
    assert!(told[0].starts_with("5,50: visible over 50.000 m"), "{out}");
    assert!(
        told[1].contains("hidden") && told[1].contains("seen from 4.0000 m above the ground up"),
        "{out}"
    );
    assert!(told[2].starts_with("5,300: visible"), "{out}");
    let csv = fs::read_to_string(scene.join("seen.csv")).unwrap();
    let words: Vec<&str> = csv.lines().skip(1).filter_map(|line| line.split(',').nth(2)).collect();
    assert_eq!(words, ["visible", "hidden", "visible"], "{csv}");
    scene.write("wrong.csv", "north_m,east_m,colour\n1,2,3\n");
    let (_, err) =
        scene.expect(3, &[&["sight"][..], &RIDGE, &["--from", "5,0", "--path", "wrong.csv"]].concat());
    assert!(err.contains("colour") && err.contains("wrong.csv"), "{err}");
}

#[test]
fn an_area_of_a_scenario_is_written_in_four_kinds() {
    let scene = Scene::new();
    let names = ["seen.tif", "seen.npy", "seen.csv", "seen.png"];
    let outs: Vec<&str> = names.iter().flat_map(|name| ["--out", name]).collect();
    let look = ["tiny.toml", "--from", "200,200", "--cell-m", "20", "--area", "0,100,400,400"];
    let told = document(&scene, &[&look[..], &outs].concat());
    let area = &told["area"];
    assert_eq!((&area["rows"], &area["columns"]), (&21.into(), &16.into()), "{told}");
    let codes = read_npy(scene.join("seen.npy"), 1 << 20).unwrap();
    assert_eq!(codes.shape(), [21, 16]);
    let codes = codes.data().to_f64();
    let count = |code: f64| codes.iter().filter(|found| **found == code).count() as f64;
    let counts = ["visible", "hidden", "unknown"].map(|word| number(&area[word]));
    assert_eq!(counts, [count(1.0), count(0.0), count(255.0)]);
    assert!(counts[0] > 10.0 && counts[1] > 10.0, "{told}");
    let raster = survey::read(scene.join("seen.tif"), &ReadOptions::default()).unwrap();
    assert_eq!((raster.affine.first, raster.affine.step), ([400.0, 100.0], [-20.0, 20.0]));
    assert!((0..21 * 16).all(|at| raster.height(at / 16, at % 16) == Some(codes[at])));
    let csv = fs::read_to_string(scene.join("seen.csv")).unwrap();
    let words = csv.lines().skip(1).zip(&codes);
    assert!(words.clone().all(|(line, code)| line.ends_with("visible") == (*code == 1.0)), "{csv}");
    assert_eq!(
        (csv.lines().count(), csv.lines().nth(1).unwrap().split(',').next()),
        (1 + 21 * 16, Some("400"))
    );
    assert!(fs::read(scene.join("seen.png")).unwrap().starts_with(b"\x89PNG"));
}

#[test]
fn a_line_ends_where_it_says_on_every_surface() {
    let scene = Scene::new();
    scene.expect(0, &["bank", "generate", "tiny.toml", "-o", "tiny.bank"]);
    let line = |ground: &str, more: &[&str]| {
        let look =
            [&[ground, "--from", "30,40", "--to", "371,333", "--observer-height", "0.5"][..], more].concat();
        let told = document(&scene, &look);
        (told["surface"].clone(), told["lines"][0].clone())
    };
    let (surface, exact) = line("tiny.toml", &[]);
    assert_eq!(surface, "landscape");
    assert_eq!(line("tiny.bank", &[]).1, exact);
    let least = number(&exact["least_height_m"]);
    assert!(least > 0.1 && exact["sight"] == "hidden", "{exact}");
    let at = |height: f64| line("tiny.toml", &["--target-height", &height.to_string()]).1["sight"].clone();
    assert_eq!((at(least + 1e-6), at(least - 1e-6)), ("visible".into(), "hidden".into()));
    let (surface, mesh) = line("tiny.toml", &["--surface", "mesh", "--cell-m", "0.5"]);
    assert_eq!(surface, "mesh");
    assert!((number(&mesh["least_height_m"]) - least).abs() < 0.02, "{mesh} {exact}");
    assert_eq!(line("tiny.toml", &["--surface", "level:3", "--cell-m", "0.5"]).0, "level 3");
    let flat = number(&line("tiny.toml", &["--curvature", "flat"]).1["least_height_m"]);
    let round = |law: &str| {
        let body = ["--curvature", law, "--radius-m", "20000"];
        number(&line("tiny.toml", &body).1["least_height_m"])
    };
    let [parabola, sphere] = ["parabola", "sphere"].map(round);
    assert!(flat < least && least < parabola && parabola < sphere, "{flat} {least} {parabola} {sphere}");
    scene.expect(
        0,
        &[
            "sight",
            "tiny.toml",
            "--from",
            "30,40",
            "--to",
            "371,333",
            "--out",
            "line.svg",
            "--out",
            "line.csv",
        ],
    );
    assert!(fs::read_to_string(scene.join("line.svg")).unwrap().contains("first ground above it"));
}

#[test]
fn threads_do_not_matter() {
    let scene = Scene::new();
    for (threads, name) in [("1", "one.npy"), ("3", "three.npy")] {
        let look = [
            "sight",
            "tiny.toml",
            "--from",
            "200,200",
            "--layer",
            "least-height",
            "--jobs",
            threads,
            "--out",
            name,
        ];
        scene.expect(0, &look);
    }
    assert_eq!(fs::read(scene.join("one.npy")).unwrap(), fs::read(scene.join("three.npy")).unwrap());
}

#[test]
fn what_cannot_be_looked_at_is_refused() {
    let scene = Scene::new();
    ridge(&scene);
    let refused = |code: i32, arguments: &[&str], said: &str| {
        let (out, err) = scene.expect(code, &[&["sight"][..], arguments].concat());
        assert!(out.is_empty() && err.contains(said), "{arguments:?}: {err}");
    };
    let from = ["tiny.toml", "--from", "200,200"];
    let scenario = |more: &[&str], said: &str| refused(2, &[&from[..], more].concat(), said);
    scenario(&["--to", "900,0"], "no ground at (900, 0) m");
    scenario(&["--to", "100,100", "--observer-height", "datum:-50"], "below the ground");
    scenario(&["--to", "100,100", "--observer-height", "-1"], "expected metres above the ground");
    scenario(&["--to", "100,100", "--path", "path.csv"], "cannot be used with");
    scenario(&["--surface", "morphed"], "expected landscape, mesh, shown, or level:N");
    scenario(&["--surface", "level:6"], "takes every 64th");
    scenario(&["--refraction", "1", "--to", "100,100"], "refraction coefficient is 1");
    scenario(&["--radius-m", "100", "--to", "390,200"], "distance to the target (m) is 190");
    scenario(&["--cell-m", "0.01"], "give another size of a cell");
    scenario(&["--area", "900,900,990,990", "--surface", "mesh"], "no post of the ground lies there");
    scenario(&["--target-height", "datum:5"], "targets stand above the ground");
    scenario(&["--layer", "least-height", "--target-height", "1"], "the least height counts from the ground");
    scenario(&["--out", "seen.jpg"], "expected a name that ends in .tif");
    scenario(&["--to", "100,100", "--out", "line.tif"], "expected a name that ends in .csv");
    scenario(&["--out", "tiny.toml"], "would replace");
    for (option, value) in
        [("--band", "1"), ("--scale", "2"), ("--offset", "1"), ("--no-data", "-9"), ("--spacing-m", "5")]
    {
        let said = format!("{option}: tiny.toml is a scenario or a bank");
        scenario(&["--to", "100,100", option, value], &said);
    }
    let posts =
        |more: &[&str], said: &str| refused(2, &[&RIDGE[..], &["--from", "5,0"], more].concat(), said);
    posts(&["--surface", "landscape"], "which has no closed form");
    posts(&["--cell-m", "5"], "posts of its own");
    posts(&["--area", "5,900,10,990"], "no post of the ground lies there");
    let uneven = ["ridge.npy", "--spacing-m", "5,6", "--from", "5,0"];
    refused(3, &uneven, "expected one spacing");
    refused(3, &["nothing.tif", "--from", "5,0"], "nothing.tif");
    assert_eq!(scene.list("."), ["ridge.npy", "tiny.toml"]);
}

/// Far ground is coarse in the picture, so it hides otherwise than the mesh of its posts does.
#[test]
fn the_ground_of_a_frame_hides_as_it_is_drawn() {
    let scene = Scene::new();
    let coarse = format!("{TINY}\n[lod]\nspacing_m = 12.5\norder = 3\nranges_m = [20, 40, 60, 80]\n");
    scene.write("coarse.toml", coarse);
    let look = |surface: &[&str]| {
        let area = document(
            &scene,
            &[&["coarse.toml", "--from", "200,200", "--observer-height", "2"], surface].concat(),
        );
        (
            area["surface"].as_str().unwrap().to_owned(),
            number(&area["area"]["hidden"]),
            number(&area["area"]["rows"]),
        )
    };
    let shown = ["--surface", "shown", "--machine", "lod-mesh"];
    let (word, drawn, rows) = look(&shown);
    assert_eq!(word, "frame 0 as it is drawn");
    let finest = look(&[&shown[..], &["--set", "lod.levels=1"]].concat());
    let (_, mesh, of_mesh) = look(&["--surface", "mesh", "--cell-m", "12.5"]);
    assert!((finest.1 - mesh).abs() <= 0.02 * rows * rows && rows <= of_mesh, "{finest:?} {mesh}");
    assert!(drawn != finest.1, "{drawn} of {rows} rows");
    for (code, arguments, said) in [
        (2, &["--frame", "1"][..], "--frame: only with --surface shown"),
        (2, &["--surface", "shown"], "it has no levels of detail"),
        (2, &["--surface", "shown", "--machine", "lod-mesh", "--frame", "99999"], "--frame 99999"),
        (2, &["--surface", "shown", "--machine", "lod-mesh", "--cell-m", "5"], "--cell-m"),
        (3, &["--surface", "shown", "--machine", "lod-mesh", "--set", "lod.stitch=none"], "lod.stitch"),
    ] {
        let (_, err) =
            scene.expect(code, &[&["sight", "coarse.toml", "--from", "200,200"][..], arguments].concat());
        assert!(err.contains(said), "{said} in {err}");
    }
    ridge(&scene);
    let (_, err) =
        scene.expect(2, &["sight", "ridge.npy", "--spacing-m", "5", "--from", "5,0", "--surface", "shown"]);
    assert!(err.contains("has no frames"), "{err}");
}
