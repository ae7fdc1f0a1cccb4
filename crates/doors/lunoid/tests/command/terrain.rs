//! `lunoid terrain`: ground under textures, from the picture to the frame.

use std::fs;

use picture::{Depth, GreyPicture, Limits, read_png, write_png};
use serde_json::Value;

use crate::scene::Scene;

/// Ground of 61 x 55 posts, 50 m apart, with a crater.
fn ground(scene: &Scene) {
    let area = ["--longitude-deg", "3.0,3.1", "--latitude-deg", "26.0,26.1", "--resolution-m", "50"];
    scene.expect(0, &[&["terrain", "new", "ground.toml"][..], &area].concat());
    let crater =
        ["--id", "west", "--crater", "3.03,26.05,400", "--wall-percent", "4", "--depth-percent", "20"];
    scene.expect(0, &[&["terrain", "add", "ground.toml"][..], &crater].concat());
}

/// A picture of one code, in 8 bits.
fn grey(scene: &Scene, name: &str, code: u16) {
    write_png(scene.join(name), &GreyPicture::new(1, 1, Depth::Eight, vec![code]).unwrap(), &[]).unwrap();
}

fn shown(scene: &Scene) -> Value {
    serde_json::from_str(&scene.expect(0, &["terrain", "show", "ground.toml", "--json"]).0).unwrap()
}

fn first_frame(scene: &Scene, export: &str, machine: &str) -> f64 {
    let scenario = format!("{export}/scenario.toml");
    let out = format!("{export}-{machine}");
    let raster = [
        "--frames",
        "0..1",
        "--no-page",
        "--set",
        "scenario.raster.columns=64",
        "--set",
        "scenario.raster.lines=64",
    ];
    scene.expect(
        0,
        &[
            &[
                "replay",
                &scenario,
                "--machine",
                machine,
                "--out",
                &out,
                "--set",
                "scenario.display.gamma=1",
                "--set",
                "scenario.display.white=1",
            ][..],
            &raster,
        ]
        .concat(),
    );
    let picture = read_png(
        scene.join(&format!("{out}/frames/{}", scene.list(&format!("{out}/frames"))[0])),
        &Limits::default(),
    )
    .unwrap();
    let codes = picture.codes();
    codes.iter().map(|code| f64::from(*code)).sum::<f64>() / codes.len() as f64
}

/// A texture of one albedo darkens `exact` and the mesh by that albedo.
#[test]
fn a_texture_is_the_albedo_of_every_generator_that_draws_one() {
    let scene = Scene::new();
    ground(&scene);
    scene.expect(0, &["terrain", "export", "ground.toml", "--out", "bare", "--no-progress"]);
    // 137 of 255 is a quarter of the light under the usual curve.
    grey(&scene, "soil.png", 137);
    scene.expect(0, &["terrain", "add", "ground.toml", "--id", "soil", "--texture", "soil.png"]);
    scene.expect(0, &["terrain", "export", "ground.toml", "--out", "dark", "--no-progress"]);
    let told: Value =
        serde_json::from_str(&fs::read_to_string(scene.join("dark/export.json")).unwrap()).unwrap();
    assert_eq!(
        (&told["albedo"]["colour"], &told["albedo"]["pixel_m"]),
        (&false.into(), &50.0.into()),
        "{told}"
    );
    scene.expect(0, &["check", "dark/scenario.toml"]);
    for machine in ["exact", "lod-mesh"] {
        let [bare, dark] = ["bare", "dark"].map(|export| first_frame(&scene, export, machine));
        assert!((dark / bare - 0.25).abs() < 0.01, "{machine}: {dark} of {bare}");
    }
}

#[test]
fn textures_are_shown_removed_and_brought_back() {
    let scene = Scene::new();
    ground(&scene);
    grey(&scene, "soil.png", 60);
    let whole = ["terrain", "add", "ground.toml", "--id", "soil", "--texture", "soil.png"];
    scene.expect(0, &[&whole[..], &["--tile", "1,0"]].concat());
    let share = |shown: &Value| shown["features"][0]["share_of_posts"].as_f64().unwrap();
    let (soil, heights) = (shown(&scene), shown(&scene)["heights_m"].clone());
    assert_eq!(soil["features"][0]["kind"], "texture", "{soil}");
    assert!(share(&soil) > 0.1 && share(&soil) < 0.5, "{soil}");
    let text = fs::read_to_string(scene.join("ground.toml")).unwrap();
    scene.expect(0, &["terrain", "remove", "ground.toml", "soil"]);
    assert_eq!(shown(&scene)["heights_m"], heights);
    scene.expect(0, &["terrain", "undo", "ground.toml"]);
    assert_eq!(fs::read_to_string(scene.join("ground.toml")).unwrap(), text);
    let plot = |name: &str| {
        scene.expect(0, &["terrain", "show", "ground.toml", "--plot", name, "--pixels", "64"]);
        read_png(scene.join(name), &Limits::default())
            .unwrap()
            .codes()
            .iter()
            .map(|code| u64::from(*code))
            .sum::<u64>()
    };
    let dark = plot("dark.png");
    scene.expect(0, &["terrain", "remove", "ground.toml", "soil"]);
    assert!(plot("bare.png") > dark + dark / 20, "a dark texture darkens the picture");
}

#[test]
fn a_texture_that_cannot_be_leaves_the_landscape_as_it_was() {
    let scene = Scene::new();
    ground(&scene);
    grey(&scene, "soil.png", 60);
    fs::write(scene.join("text.png"), "no picture").unwrap();
    let text = fs::read_to_string(scene.join("ground.toml")).unwrap();
    let add = ["terrain", "add", "ground.toml", "--id", "soil"];
    for (code, arguments, said) in [
        (3, &["--texture", "nowhere.png"][..], "nowhere.png"),
        (3, &["--texture", "text.png"], "text.png"),
        (3, &["--texture", "soil.png", "--tile", "9,0"], "tile"),
        (2, &["--texture", "soil.png", "--tile", "1"], "0,3"),
        (2, &["--tile", "0,0"], "--texture"),
    ] {
        let (_, err) = scene.expect(code, &[&add[..], arguments].concat());
        assert!(err.contains(said), "{said} in {err}");
        assert_eq!(fs::read_to_string(scene.join("ground.toml")).unwrap(), text, "{arguments:?}");
    }
}

/// Neither the export nor the plot takes the place of a picture that the landscape reads.
#[test]
fn outputs_over_the_pictures_of_a_landscape_are_refused() {
    let scene = Scene::new();
    ground(&scene);
    fs::create_dir(scene.join("out")).unwrap();
    grey(&scene, "out/albedo.png", 60);
    let picture = fs::read(scene.join("out/albedo.png")).unwrap();
    scene.expect(0, &["terrain", "add", "ground.toml", "--id", "soil", "--texture", "out/albedo.png"]);
    let (_, err) = scene.expect(2, &["terrain", "export", "ground.toml", "--out", "out"]);
    assert!(err.contains("out/albedo.png"), "{err}");
    let (_, err) = scene.expect(2, &["terrain", "show", "ground.toml", "--plot", "out/albedo.png"]);
    assert!(err.contains("would replace a file of the landscape"), "{err}");
    assert_eq!(fs::read(scene.join("out/albedo.png")).unwrap(), picture);
}

#[test]
fn options_of_another_kind_are_refused_by_name() {
    let scene = Scene::new();
    ground(&scene);
    grey(&scene, "soil.png", 60);
    let text = fs::read_to_string(scene.join("ground.toml")).unwrap();
    let crater = ["--crater", "3.04,26.05,300", "--wall-percent", "4", "--depth-percent", "20"];
    let boulder = ["--boulder", "3.04,26.05,3"];
    let soil = ["--texture", "soil.png"];
    for (kind, stray, option) in [
        (&crater[..], &["--shape", "rock"][..], "--shape"),
        (&crater[..], &["--seed", "3"], "--seed"),
        (&crater[..], &["--tile", "0,0"], "--tile"),
        (&boulder[..], &["--tile", "0,0"], "--tile"),
        (&boulder[..], &["--decay", "linear"], "--decay"),
        (&soil[..], &["--seed", "3"], "--seed"),
        (&soil[..], &["--shape", "cube"], "--shape"),
    ] {
        let (_, err) =
            scene.expect(2, &[&["terrain", "add", "ground.toml", "--id", "more"][..], kind, stray].concat());
        assert!(err.contains(option), "{option} in {err}");
        assert_eq!(fs::read_to_string(scene.join("ground.toml")).unwrap(), text);
    }
}

#[test]
fn heights_without_a_place_and_voids_are_warned_of() {
    let scene = Scene::new();
    ground(&scene);
    let row = |line: usize| {
        (0..40).map(|at| if line < 10 && at < 20 { "-9999 " } else { "7 " }).collect::<String>()
    };
    let rows: Vec<String> = (0..40).map(row).collect();
    let head = "ncols 40\nnrows 40\nxllcorner 5\nyllcorner 9\ncellsize 100\nNODATA_value -9999\n";
    scene.write("heights.asc", format!("{head}{}\n", rows.join("\n")));
    let (_, err) = scene.expect(0, &["terrain", "import", "ground.toml", "heights.asc"]);
    assert!(err.contains("names no projection") && err.contains("are void"), "{err}");
    let warnings = shown(&scene)["warnings"].to_string();
    assert!(warnings.contains("names no projection") && warnings.contains("are void"), "{warnings}");
}

#[cfg(unix)]
#[test]
fn a_journal_that_cannot_be_written_leaves_the_landscape() {
    let scene = Scene::new();
    let area = ["--longitude-deg", "3.0,3.1", "--latitude-deg", "26.0,26.1", "--resolution-m", "50"];
    scene.expect(0, &[&["terrain", "new", "ground.toml"][..], &area].concat());
    scene.write("elsewhere", "");
    std::os::unix::fs::symlink(scene.join("elsewhere"), scene.join("ground.toml.journal")).unwrap();
    let text = fs::read_to_string(scene.join("ground.toml")).unwrap();
    let crater =
        ["--id", "west", "--crater", "3.03,26.05,400", "--wall-percent", "4", "--depth-percent", "20"];
    let output = scene.run(&[&["terrain", "add", "ground.toml"][..], &crater].concat());
    assert!(!output.status.success());
    assert_eq!(fs::read_to_string(scene.join("ground.toml")).unwrap(), text);
}

/// The database of ground elsewhere does not pass for that of the bank.
#[test]
fn a_database_of_another_place_is_refused() {
    let scene = Scene::new();
    for (name, longitude) in [("here", "3.0,3.1"), ("there", "13.0,13.1")] {
        let file = format!("{name}.toml");
        let area = ["--longitude-deg", longitude, "--latitude-deg", "26.0,26.1", "--resolution-m", "100"];
        scene.expect(0, &[&["terrain", "new", &file][..], &area].concat());
        scene.expect(0, &["terrain", "export", &file, "--out", name, "--no-progress"]);
    }
    scene.expect(0, &["check", "here/scenario.toml"]);
    fs::copy(scene.join("there/terrain.lod"), scene.join("here/terrain.lod")).unwrap();
    let (_, err) = scene.expect(3, &["check", "here/scenario.toml"]);
    assert!(err.contains("longitude 13.05") && err.contains("from one export"), "{err}");
}

#[test]
fn a_landscape_and_its_database_say_what_they_hold() {
    let scene = Scene::new();
    ground(&scene);
    scene.expect(0, &["terrain", "export", "ground.toml", "--out", "out"]);
    let held = |file: &str| -> Value {
        serde_json::from_str(&scene.expect(0, &["info", file, "--json"]).0).unwrap()
    };
    let landscape = held("ground.toml");
    assert_eq!(landscape["posts"], held("out/terrain.lod")["posts"]);
    assert_eq!(landscape["features"][0]["kind"], "crater");
    let database = held("out/terrain.lod");
    assert_eq!(database["radius_m"], 1_737_400.0);
    let errors: Vec<f64> =
        database["errors_m"].as_array().unwrap().iter().map(|e| e.as_f64().unwrap()).collect();
    assert_eq!(errors.len(), 1 + database["order"].as_u64().unwrap() as usize);
    assert!(errors[0] == 0.0 && errors[errors.len() - 1] > 1.0, "{errors:?}");
    assert!(scene.expect(0, &["info", "out/terrain.lod"]).0.contains("terrain database"));
    assert!(scene.expect(0, &["check", "ground.toml"]).0.contains("landscape, no fault"));

    // A damaged database and a landscape out of range are refused with their place.
    let mut bytes = fs::read(scene.join("out/terrain.lod")).unwrap();
    let last = bytes.len() - 1;
    bytes[last] ^= 1;
    fs::write(scene.join("broken.lod"), bytes).unwrap();
    assert!(scene.expect(3, &["info", "broken.lod"]).1.contains("broken.lod: the block of the text"));
    let text = fs::read_to_string(scene.join("ground.toml")).unwrap();
    fs::write(scene.join("deep.toml"), text.replace("depth_percent = 20", "depth_percent = 2000")).unwrap();
    let told = scene.expect(3, &["check", "deep.toml"]).1;
    assert!(told.contains("deep.toml:") && told.contains("depth_percent"), "{told}");
}
