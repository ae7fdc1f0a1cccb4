//! `lunoid study pops`: curves of levels of detail, their page, and the tiles of a jump in the record.

use serde_json::Value;

use crate::scene::Scene;

/// Rough ground from straight above, 20 frames a second, from 500 m to 400 m: the tile below changes its level at 450 m.
const DOWN: &str = r#"format = 1
title = "Down"
shows = "A camera that looks straight down sinks through the distance at which tiles change their level."
machine = "lod-mesh"
duration_s = 1
[landscape]
albedo = 0.6
[landscape.generated]
seed = 1
extent_m = [1600, 1600]
region_size_m = 20
[landscape.generated.undulation]
rms_height_m = 14
hurst = 0.5
longest_m = 400
shortest_m = 60
[sun]
azimuth_deg = 60
elevation_deg = 30
[lod]
order = 3
spacing_m = 10
levels = 3
ranges_m = [450, 900, 1350]
[vehicle]
max_speed_m_s = 200
[path]
file = "down.csv"
[raster]
columns = 80
lines = 60
field_of_view_deg = [40, 30]
update_hz = 20
refresh_hz = 20
"#;

fn scene() -> Scene {
    let scene = Scene::new();
    scene.write("down.toml", DOWN);
    let head = "t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n";
    scene.write("down.csv", format!("{head}0,750,750,500,0,-90,0\n1,750,750,400,0,-90,0\n"));
    scene
}

fn read(scene: &Scene, file: &str) -> String {
    std::fs::read_to_string(scene.join(file)).unwrap()
}

#[test]
fn a_jump_is_on_the_page_and_its_tile_in_the_record() {
    let scene = scene();
    scene.expect(0, &["study", "pops", "down.toml", "--out", "pops", "--pictures", "3", "--no-progress"]);
    let page = read(&scene, "pops/index.html");
    let data = page.split_once("type=\"application/json\">").unwrap().1.split_once("</script>").unwrap().0;
    let data: Value = serde_json::from_str(data).unwrap();
    let ways: Vec<&str> =
        data["ways"].as_array().unwrap().iter().map(|way| way["name"].as_str().unwrap()).collect();
    assert_eq!(ways, ["switching", "morphing"]);
    let pops = |way: usize| {
        data["ways"][way]["pops"]
            .as_array()
            .unwrap()
            .iter()
            .map(|pop| pop.as_f64().unwrap())
            .collect::<Vec<_>>()
    };
    let jump = pops(0).iter().position(|pop| *pop > 0.01).expect("switching pops");
    assert!(pops(1).iter().all(|pop| *pop < 1e-9), "morphing does not");
    // The frame of the jump has a picture of each way, and the tiles that changed.
    let shot = data["shots"].as_array().unwrap().iter().find(|shot| shot["frame"] == jump as u64).unwrap();
    let tiles = |changes: &Value| -> Vec<String> {
        changes.as_array().unwrap().iter().map(|change| change["tile"].as_str().unwrap().to_owned()).collect()
    };
    let told = tiles(&shot["changes"]);
    assert!(!told.is_empty());
    for file in shot["files"].as_array().unwrap().iter().flat_map(|files| files.as_array().unwrap()) {
        assert!(scene.path().join("pops").join(file.as_str().unwrap()).is_file(), "{file}");
    }
    // The record of timing names the same tiles, and `explain` the one that the axis meets.
    let frames = format!("{jump}..{}", jump + 1);
    scene.expect(0, &["timing", "record", "down.toml", "--frames", &frames, "--out", "timing.json"]);
    let record: Value = serde_json::from_str(&read(&scene, "timing.json")).unwrap();
    assert_eq!(tiles(&record["frames"][0]["level_changes"]), told);
    let (explained, _) =
        scene.expect(0, &["explain", "down.toml", "--frame", &jump.to_string(), "--pixel", "40,30"]);
    let tile = explained.lines().find(|line| line.contains("column ") && line.contains("row ")).unwrap();
    let number =
        |word: &str| tile.split_once(word).unwrap().1.split([',', ';']).next().unwrap().trim().to_owned();
    assert!(told.contains(&format!("tile.{}.{}", number("column"), number("row"))), "{tile} {told:?}");
}

#[test]
fn what_makes_no_page_is_refused() {
    let scene = scene();
    let (_, told) = scene.expect(2, &["study", "pops", "down.toml", "--pictures", "3"]);
    assert!(told.contains("--out"), "{told}");
    let (_, told) = scene.expect(2, &["study", "pops", "down.toml", "--out", "pops", "--pictures", "1"]);
    assert!(told.contains("2..=1000"), "{told}");
    let (_, told) = scene.expect(
        2,
        &[
            "study",
            "pops",
            "down.toml",
            "--machine",
            "sampled",
            "--frames",
            "0..2",
            "--out",
            "pops",
            "--pictures",
            "2",
        ],
    );
    assert!(told.contains("no ways with levels of detail"), "{told}");
    // Without pictures such a generator is held against the judge, and has no pops.
    scene.expect(
        0,
        &["study", "pops", "down.toml", "--machine", "sampled", "--frames", "0..2", "--out", "pops"],
    );
    assert!(read(&scene, "pops/pops.svg").contains("off the finest ground"));
}
