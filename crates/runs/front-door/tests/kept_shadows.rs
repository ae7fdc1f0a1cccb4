//! Shadow boundaries that a stage finds go where they are wished, or else where the caller keeps them.

use std::fs;
use std::path::Path;

use front_door::{Opened, Wishes, open};
use generator::{PlaneKind, Planes};
use hardware_model::ShadowCache;
use signal::Probe;

const SCENARIO: &str = r#"format = 1
title = "t"
shows = "s"
frames = 2
[landscape.generated]
seed = 1
extent_m = [400, 400]
region_size_m = 40
[landscape.generated.undulation]
rms_height_m = 2
hurst = 0.9
longest_m = 300
shortest_m = 160
waves = 20
[sun]
azimuth_deg = 100
elevation_deg = 1
[path]
keyframes = [{ t_s = 0, x_m = 100, y_m = 200 }, { t_s = 5, x_m = 108, y_m = 205 }]
[raster]
sweeps = 24
samples_per_sweep = 40
[range]
programme = "geometric"
start_m = 2
end_m = 150
[shadows]
"#;

/// The scenario in `folder` with a folder of shadows that is wished, or none.
fn opened(folder: &Path, wished: Option<&Path>) -> Opened {
    let path = folder.join("t.toml");
    fs::write(&path, SCENARIO).unwrap();
    let wishes = Wishes { shadow_cache: wished.map(Path::to_owned), ..Wishes::default() };
    open(&path, &wishes).unwrap_or_else(|error| panic!("{error}"))
}

/// Draws frame 0 by the generator of `opened`.
fn draw(opened: &Opened) {
    let stage = opened.stage().unwrap();
    let pose = opened.poses(&stage, 0..1).unwrap().rows()[0].pose;
    let [columns, lines] = [stage.view.columns, stage.view.lines].map(|count| count as usize);
    let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
    let session = opened.generator.prepare(stage).unwrap();
    session.frame(0, &pose, &mut planes, &mut Probe::off()).unwrap();
}

#[test]
fn the_machine_that_draws_keeps_them() {
    let folder = tempfile::tempdir().unwrap();
    let kept = folder.path().join("kept");
    draw(&opened(folder.path(), None).keeping_shadows(ShadowCache::of_run(&kept)));
    assert_eq!(fs::read_dir(&kept).unwrap().count(), 1);
}

#[test]
fn a_wish_goes_first() {
    let folder = tempfile::tempdir().unwrap();
    let [kept, wished] = ["kept", "wished"].map(|name| folder.path().join(name));
    draw(&opened(folder.path(), Some(&wished)).keeping_shadows(ShadowCache::of_run(&kept)));
    assert!(!kept.exists() && fs::read_dir(&wished).unwrap().count() == 1);
}
