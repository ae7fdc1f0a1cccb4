//! The cartridges of this folder, by the crate that runs them; the file is described in `README.md`.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use cartridge::{Cartridge, Engine, Outcome, Summary, of_folder};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

/// Fewer are a loss (trust, 3.1).
const LEAST: usize = 30;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("cartridges")
}

fn cartridges() -> Vec<Cartridge> {
    of_folder(&folder()).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_answer_is_right_and_every_overlay_is_noticed() {
    let run = |cartridge: &Cartridge| cartridge.run().unwrap_or_else(|error| panic!("{error}"));
    let outcomes: Vec<Outcome> = cartridges().par_iter().map(run).collect();
    let faults: Vec<String> = outcomes.iter().flat_map(Outcome::faults).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let summary = Summary::of(&outcomes);
    println!("{summary:#?}");
    assert_eq!((summary.passed, summary.overlays_caught), (summary.cartridges, summary.overlays));
    assert!(summary.cartridges >= LEAST, "{}", summary.cartridges);
    assert!(summary.worst_tolerance_used <= 1.0 && summary.worst_tolerance_used > 0.0);
}

#[test]
fn every_folder_is_carried() {
    let entries = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path());
    let folders = entries.filter(|path| path.is_dir());
    let folders: BTreeSet<_> =
        folders.map(|path| path.file_name().unwrap().to_str().unwrap().to_owned()).collect();
    let carried: BTreeSet<_> = cartridge::CARRIED.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(folders, carried);
    let read: BTreeSet<_> = cartridges().into_iter().map(|cartridge| cartridge.name).collect();
    assert_eq!(read, carried, "a folder without a cartridge.toml");
}

#[test]
fn every_engine_has_cartridges() {
    let all = cartridges();
    for engine in Engine::all() {
        let count = all.iter().filter(|cartridge| cartridge.engines().contains(&engine)).count();
        let is_guest = matches!(engine, Engine::Generator(name) if name != registry::judge().name);
        assert!(count >= if is_guest { 1 } else { 5 }, "{}: {count}", engine.word());
    }
}
