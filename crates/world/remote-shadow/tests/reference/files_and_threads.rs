//! The answer depends on the question alone.

use crate::common::cratered;
use landscape::Sun;
use quantities::radians;
use remote_shadow::{Resolution, ShadowBank, Tile};
use std::fs;
#[cfg(unix)]
use std::path::Path;
use std::sync::Arc;

const EYE: [f64; 2] = [300.0, 340.0];
/// As many bytes as there may be.
const ALL: u64 = u64::MAX;

fn resolution() -> Resolution {
    Resolution { finest: 0.5, angle: 1e-2 }
}

fn sun(azimuth: f64) -> Sun {
    Sun { azimuth: radians(azimuth), elevation: radians(4.0) }
}

fn ask(bank: &ShadowBank, azimuth: f64) -> Vec<Arc<Tile>> {
    bank.around(&sun(azimuth), EYE, 200.0, None)
}

#[test]
fn neither_order_nor_threads_change_a_bit() {
    let landscape = Arc::new(cratered(4));
    let fresh = ShadowBank::new(landscape.clone(), resolution());
    let expected = ask(&fresh, 50.0);
    assert!(expected.iter().map(|tile| tile.outlines.segments().count()).sum::<usize>() > 100);
    let used = ShadowBank::new(landscape, resolution());
    for azimuth in [10.0, 50.0, 90.0, 130.0, 170.0] {
        used.around(&sun(azimuth), [200.0, 200.0], 150.0, None);
    }
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    assert_eq!(one.install(|| ask(&used, 50.0)), expected);
    assert_eq!(ask(&used, 50.0), expected);
}

#[test]
fn a_sector_shows_the_tiles_of_the_whole() {
    let bank = ShadowBank::new(Arc::new(cratered(4)), resolution());
    let whole = ask(&bank, 50.0);
    let edges = [radians(20.0), radians(70.0)].map(|edge| {
        let (sin, cos) = quantities::sin_cos(edge);
        [cos, sin]
    });
    let part = bank.around(&sun(50.0), EYE, 200.0, Some(edges));
    assert!(part.len() < whole.len() / 2);
    assert!(part.iter().all(|tile| whole.contains(tile)));
}

#[test]
fn tiles_are_kept_on_disk_and_damaged_ones_are_made_anew() {
    let folder = tempfile::tempdir().unwrap();
    let landscape = Arc::new(cratered(4));
    let bank = || ShadowBank::new(landscape.clone(), resolution()).with_cache(folder.path(), ALL);
    let files =
        || -> Vec<_> { fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().path()).collect() };
    let expected = ask(&bank(), 50.0);
    assert_eq!(files().len(), 1);
    assert_eq!(ask(&bank(), 50.0), expected);
    assert_eq!(files().len(), 1, "nothing was left to compute");

    let path = files().remove(0);
    let mut bytes = fs::read(&path).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(&path, &bytes).unwrap();
    assert_eq!(ask(&bank(), 50.0), expected);
    bytes.truncate(middle);
    fs::write(&path, &bytes).unwrap();
    assert_eq!(ask(&bank(), 50.0), expected);

    let other = ShadowBank::new(Arc::new(cratered(5)), resolution()).with_cache(folder.path(), ALL);
    assert_ne!(ask(&other, 50.0), expected, "other ground, other tiles");
}

#[test]
fn a_folder_that_cannot_be_written_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "x").unwrap();
    let bank = ShadowBank::new(Arc::new(cratered(4)), resolution()).with_cache(&file, ALL);
    assert!(!ask(&bank, 50.0).is_empty());
    assert!(bank.take_cache_failure().is_some());
    assert!(bank.take_cache_failure().is_none());
}

#[test]
fn a_folder_is_made_when_there_is_something_to_keep() {
    let folder = tempfile::tempdir().unwrap();
    let kept = folder.path().join("shadows");
    let bank = ShadowBank::new(Arc::new(cratered(4)), resolution()).with_cache(&kept, ALL);
    assert!(!kept.exists());
    ask(&bank, 50.0);
    let size = |entry: fs::DirEntry| entry.metadata().unwrap().len();
    let sizes: Vec<u64> = fs::read_dir(&kept).unwrap().map(|entry| size(entry.unwrap())).collect();
    assert_eq!(sizes.len(), 1);
    // A byte short of room for as much again: what is kept stays, and nothing comes to it.
    let full = ShadowBank::new(Arc::new(cratered(4)), resolution()).with_cache(&kept, sizes[0] + 1);
    ask(&full, 90.0);
    assert_eq!(fs::read_dir(&kept).unwrap().count(), 1);
    assert!(bank.take_cache_failure().is_none() && full.take_cache_failure().is_none());
}

#[test]
fn a_reader_leaves_the_folder_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let bank = || ShadowBank::new(Arc::new(cratered(4)), resolution());
    let kept = folder.path().join("shadows");
    let expected = ask(&bank().with_cache(&kept, 0), 50.0);
    assert!(!kept.exists());
    ask(&bank().with_cache(&kept, ALL), 50.0);
    let reader = bank().with_cache(&kept, 0);
    assert_eq!(ask(&reader, 50.0), expected);
    ask(&reader, 90.0);
    assert_eq!(fs::read_dir(&kept).unwrap().count(), 1);
}

#[test]
#[cfg(unix)]
fn links_lead_nowhere() {
    let folder = tempfile::tempdir().unwrap();
    let [kept, linked] = ["kept", "linked"].map(|name| folder.path().join(name));
    let bank = || ShadowBank::new(Arc::new(cratered(4)), resolution());
    ask(&bank().with_cache(&kept, ALL), 50.0);
    let link = std::os::unix::fs::symlink::<&Path, &Path>;
    link(&kept, &linked).unwrap();
    // A bank that had read through the link would lack nothing, and so would keep nothing.
    let through = bank().with_cache(&linked, ALL);
    ask(&through, 50.0);
    assert!(through.take_cache_failure().is_some_and(|failure| failure.to_string().contains("a link")));
    assert_eq!(fs::read_dir(&kept).unwrap().count(), 1, "nothing is written through a link");
    let file = fs::read_dir(&kept).unwrap().next().unwrap().unwrap();
    let other = folder.path().join("other");
    fs::create_dir(&other).unwrap();
    link(&file.path(), &other.join(file.file_name())).unwrap();
    let through = bank().with_cache(&other, ALL);
    ask(&through, 50.0);
    assert!(through.take_cache_failure().is_some_and(|failure| failure.to_string().contains("a link")));
}
