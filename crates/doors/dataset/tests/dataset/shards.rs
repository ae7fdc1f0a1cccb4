//! Shards joined are the data set that is made at once, byte for byte.

use std::fs;
use std::ops::Range;
use std::path::PathBuf;

use dataset::{DataFolder, DatasetError, Joined, join};

use crate::scene::{PLAN, Scene, control, files};

fn joined(scene: &Scene, folders: &[PathBuf], out: &str, most: u64) -> Result<Joined, DatasetError> {
    let out = DataFolder::claim(&scene.path(out))?;
    control(most, |control| join(folders, &out, control))
}

/// Shards of equal count, as `--shard` makes them.
fn shards(scene: &Scene, of: u64) -> Vec<PathBuf> {
    let cut = |shards: u64| shards * 9 / of;
    let make = |number: u64| {
        let name = format!("shard-{number}-of-{of}");
        scene.make(&name, cut(number - 1)..cut(number)).unwrap_or_else(|error| panic!("{error}"));
        scene.path(&name)
    };
    (1..=of).map(make).collect()
}

#[test]
fn one_two_and_three_shards_backwards_are_the_whole() {
    let scene = Scene::new(PLAN);
    let whole = files(&scene.make_all("whole"));
    for of in 1..=3 {
        let mut folders = shards(&scene, of);
        folders.reverse();
        let out = format!("joined-{of}");
        assert_eq!(
            joined(&scene, &folders, &out, u64::MAX).unwrap(),
            Joined::Whole { samples: 9, overlap: 0 }
        );
        assert!(files(&scene.path(&out)) == whole, "{of} shards");
    }
}

#[test]
fn overlap_gaps_and_interruptions() {
    let scene = Scene::new(PLAN);
    let whole = files(&scene.make_all("whole"));
    let make = |name: &str, samples: Range<u64>| {
        scene.make(name, samples).unwrap();
        scene.path(name)
    };
    let parts = [make("a", 0..4), make("b", 3..6), make("c", 7..9)];
    let gaps = joined(&scene, &parts, "out", u64::MAX).unwrap();
    assert!(
        matches!(&gaps, Joined::Gaps { gaps, plan } if gaps.len() == 1 && gaps[0] == (6..7) && plan.ends_with("plan.toml")),
        "{gaps:?}"
    );
    assert!(!scene.path("out").exists(), "nothing is written where samples are missing");
    let parts = [parts.as_slice(), &[make("d", 6..7)]].concat();
    assert_eq!(joined(&scene, &parts, "out", 2).unwrap(), Joined::Interrupted);
    let found = joined(&scene, &parts, "out", u64::MAX).unwrap();
    assert_eq!(found, Joined::Whole { samples: 9, overlap: 1 });
    assert!(files(&scene.path("out")) == whole);
}

#[test]
fn what_does_not_belong_together_is_refused() {
    let scene = Scene::new(PLAN);
    let [a, b] = [("a", 0..5), ("b", 5..9)].map(|(name, samples)| {
        scene.make(name, samples).unwrap();
        scene.path(name)
    });
    let said = |folders: &[PathBuf], out: &str| {
        joined(&scene, folders, out, u64::MAX).expect_err("refused").to_string()
    };
    assert!(said(&[a.clone(), a.clone()], "out").contains("given twice"));
    assert!(said(&[a.clone(), scene.path("gone")], "out").contains("no data set is finished here"));
    assert!(said(&[a.clone(), b.clone()], "a").contains("to be joined"));
    let name = fs::read_dir(b.join("train")).unwrap().next().unwrap().unwrap().path();
    let mut bytes = fs::read(&name).unwrap();
    bytes[500] ^= 1;
    fs::write(&name, bytes).unwrap();
    assert!(said(&[a.clone(), b.clone()], "out").contains("not as its record lists it"));
    fs::write(scene.path("plan.toml"), PLAN.replace("seed = 7", "seed = 8")).unwrap();
    scene.make("other", 5..9).unwrap();
    let said = said(&[a, scene.path("other")], "out");
    assert!(said.contains("not of one data set") && said.contains("plan.blake3"), "{said}");
    assert!(!scene.path("out").exists());
}
