//! The same frames in whatever way the command draws them (trust 3.11): by each of its builds, any number of threads,
//! probed, every frame alone, from the last to the first, and killed and resumed.
//!
//! `cargo run -p lunoid-tests --example determinism` builds the command three times first: for debugging, for release, and for
//! release with all vectors that this processor has. It fails at the first scenario that has two outcomes.

mod builds;
mod ways;

use std::collections::{BTreeMap, BTreeSet};
use std::process::ExitCode;

use lunoid_tests::breaks::root;

use builds::{Build, builds};
use ways::{Drawing, FRAMES, Frames, WAYS};

/// A scenario under a machine, with more options of `lunoid replay`.
struct Case {
    scenario: &'static str,
    machine: &'static str,
    options: &'static [&'static str],
}

const fn case(scenario: &'static str, machine: &'static str, options: &'static [&'static str]) -> Case {
    Case { scenario, machine, options }
}

const CASES: &[Case] = &[
    case("first-light", "ideal", &[]),
    case("craters", "ideal", &[]),
    case("landing-site", "ideal", &["--scalar", "f64"]),
    case("rough-ride", "modern-analog", &[]),
    case("nominal-drive", "pra-nominal", &[]),
    case("nominal-drive", "pra-nominal", &["--scalar", "f64"]),
];

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let builds = builds(&root())?;
    let told: Vec<&str> = builds.iter().map(|build| &*build.name).collect();
    println!("{} builds: {}", builds.len(), told.join("; "));
    let (mut kills, mut inside) = (0, 0);
    for case in CASES {
        let outcomes = outcomes(case, &builds, |was_inside| {
            kills += 1;
            inside += usize::from(was_inside);
        })?;
        let Case { scenario, machine, options } = case;
        let what = format!("{scenario}, {machine} {}", options.join(" "));
        let ways: Vec<_> = outcomes.values().collect();
        let [ways] = &ways[..] else { return Err(format!("{what}: {} outcomes: {ways:#?}", ways.len())) };
        let pictures: BTreeSet<_> = outcomes.keys().flat_map(BTreeMap::values).collect();
        if pictures.len() < 2 {
            return Err(format!("{what}: all frames are alike, which shows nothing"));
        }
        let last = pictures.last().map_or("", |hash| &hash[..12]);
        println!(
            "{what}: {} ways of drawing {FRAMES} frames, one outcome (one hash of it: {last})",
            ways.len()
        );
    }
    println!("{inside} of {kills} kills came between the first frame and the last");
    Ok(())
}

/// What came out, and by which ways; `killed` is told of every kill whether it came inside the run.
fn outcomes(
    case: &Case,
    builds: &[Build],
    mut killed: impl FnMut(bool),
) -> Result<BTreeMap<Frames, Vec<String>>, String> {
    let mut found: BTreeMap<Frames, Vec<String>> = BTreeMap::new();
    let folder = || tempfile::tempdir().map_err(|error| error.to_string());
    for build in builds {
        // Boundaries of shadow by this build: its first way makes them.
        let shadows = folder()?;
        for way in WAYS {
            let folder = folder()?;
            let drawing = Drawing { build, case, folder: folder.path(), shadows: shadows.path() };
            let frames = drawing.draw(way, &mut killed)?;
            found.entry(frames).or_default().push(format!("{}, {way:?}", build.name));
        }
    }
    Ok(found)
}
