use std::fs;
use std::path::Path;

use tempfile::tempdir;

use crate::drive::{Drive, expect_equal, joined};

/// Three shards, backwards and the first twice, against the run of one machine. `orders` joins 1, 2, 7 and 13.
fn expect_joins(drive: &Drive, what: &str) {
    let at = tempdir().unwrap();
    let whole = at.path().join("whole");
    drive.whole(&whole);
    let of = ((drive.frames.end - drive.frames.start) as u32).min(3);
    let mut folders = drive.shards(of, at.path());
    let twice = at.path().join("twice");
    drive.shard(1, of, &twice);
    folders.reverse();
    folders.push(twice);
    let out = at.path().join("joined");
    joined(&folders, &out);
    expect_equal(&whole, &out, &format!("{what}, {of} shards"));
}

#[test]
fn every_model_draws_shards_of_its_run() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../hardware-models");
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let models = names.filter(|path| path.extension().is_some_and(|end| end == "toml"));
    let mut models: Vec<String> =
        models.map(|path| path.file_stem().unwrap().to_string_lossy().into_owned()).collect();
    models.extend(registry::names().into_iter().map(str::to_owned));
    models.sort();
    assert!(models.len() >= 11, "{models:?}");
    for model in &models {
        // LUNSIM asks for a scenario of its own, which has four frames, and panels for photographs.
        let scenario = match model.as_str() {
            "lunsim" => "lunsim-roving",
            "panels" => "photo-drape",
            _ => "profile",
        };
        let drive = Drive::new(scenario, Some(model), 0..0);
        let frames = drive.opened.frames().min(3);
        expect_joins(&Drive { frames: 0..frames, ..drive }, model);
    }
}

#[test]
#[ignore = "long: .ci/long runs it"]
fn scenarios_with_memory_sun_roll_bodies_colour_and_light_points() {
    for scenario in ["rough-ride", "moving-sun", "full-drive", "colours", "night-landing", "overloaded-night"]
    {
        expect_joins(&Drive::new(scenario, None, 7..10), scenario);
    }
}
