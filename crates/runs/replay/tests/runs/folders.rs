use std::fs;
use std::path::Path;

use files::{FileError, FolderError};
use replay::{Outcome, ReplayError, RunFolder};
use tempfile::tempdir;

use crate::stage::{Wish, differences};

fn fresh() -> Wish {
    Wish { fresh: true, ..Wish::default() }
}

#[test]
fn another_run_is_refused_unless_fresh() {
    let at = tempdir().unwrap();
    let (whole, out) = (at.path().join("whole"), at.path().join("out"));
    let other = Wish::default().in_place_of("elevation_deg = 15", "elevation_deg = 16");
    other.run(&out).unwrap();
    fs::write(out.join("notes.txt"), "mine").unwrap();
    fs::write(out.join("frames/notes.txt"), "mine").unwrap();
    let before = fs::read(out.join("run.json")).unwrap();
    let refused = Wish::default().run(&out);
    assert!(matches!(refused, Err(ReplayError::OtherRun { .. })), "{refused:?}");
    assert_eq!(fs::read(out.join("run.json")).unwrap(), before);

    Wish::default().run(&whole).unwrap();
    fresh().run(&out).unwrap();
    assert_eq!(differences(&whole, &out), ["frames/notes.txt", "notes.txt"]);
}

#[test]
fn an_unfinished_other_run_is_refused_too() {
    let at = tempdir().unwrap();
    Wish { cancel_after: Some(2), ..Wish::default() }.run(at.path()).unwrap();
    let refused = Wish::default().in_place_of("seed = 3", "seed = 4").run(at.path());
    assert!(matches!(refused, Err(ReplayError::OtherRun { .. })), "{refused:?}");
}

#[test]
fn what_decides_the_pixels_decides_the_run() {
    let at = tempdir().unwrap();
    Wish { frames: 0..1, ..Wish::default() }.run(at.path()).unwrap();
    let one = || Wish { frames: 0..1, ..Wish::default() };
    let mut sixteen = one();
    sixteen.pictures.depth = picture::Depth::Sixteen;
    let others = [
        sixteen,
        one().in_place_of("t_s = 5", "t_s = 6"),
        one().in_place_of("sweeps = 40", "sweeps = 41"),
        one().in_place_of("[raster]", "[run]\nscalar = \"f64\"\n[raster]"),
        one().in_place_of("[raster]", "[display]\ngamma = 2\n[raster]"),
        one().in_place_of("[raster]", "[laws]\ncurvature = \"none\"\n[raster]"),
        one().in_place_of("[raster]", "[vehicle]\neye_height_m = 2\n[raster]"),
        one().in_place_of("[landscape.generated]", "[landscape]\nalbedo = 0.5\n[landscape.generated]"),
    ];
    for (index, other) in others.iter().enumerate() {
        let refused = other.run(at.path());
        assert!(matches!(refused, Err(ReplayError::OtherRun { .. })), "{index}: {refused:?}");
    }
    // A comment, a title, a longer mission are the same run.
    let same = one().in_place_of("frames = 12", "frames = 40 # more").in_place_of("Nothing but", "Just");
    assert!(matches!(same.run(at.path()), Ok(Outcome::Finished { drawn: 0, .. })));
}

#[test]
fn foreign_folders_are_left_alone() {
    let at = tempdir().unwrap();
    let out = at.path();
    fs::write(out.join("thesis.tex"), "mine").unwrap();
    let refused = Wish::default().run(out);
    assert!(
        matches!(&refused, Err(ReplayError::Foreign { found, .. }) if found == "thesis.tex"),
        "{refused:?}"
    );
    assert_eq!(fs::read_dir(out).unwrap().count(), 1);
    fresh().run(out).unwrap();
    assert_eq!(fs::read_to_string(out.join("thesis.tex")).unwrap(), "mine");
}

#[test]
fn a_file_that_no_run_wrote_is_never_replaced() {
    let at = tempdir().unwrap();
    for name in ["poses.csv", "run.json", "index.html"] {
        let out = at.path().join(name);
        fs::create_dir(&out).unwrap();
        fs::write(out.join(name), "mine").unwrap();
        for wish in [Wish::default(), fresh()] {
            let refused = wish.run(&out);
            assert!(matches!(refused, Err(ReplayError::WouldReplace { .. })), "{refused:?}");
        }
        assert_eq!(fs::read_to_string(out.join(name)).unwrap(), "mine");
    }
}

#[test]
fn one_run_at_a_time() {
    let at = tempdir().unwrap();
    let out = at.path().join("out");
    let first = RunFolder::claim(&out, false).unwrap();
    let second = RunFolder::claim(&out, false);
    let process = std::process::id().to_string();
    assert!(
        matches!(&second, Err(ReplayError::Claim(FolderError::Locked { holder, .. })) if *holder == process),
        "{second:?}"
    );
    Wish::default().run_in(&first).unwrap();
    drop(first);
    RunFolder::claim(&out, false).unwrap();
    assert!(!out.join(".lunoid.lock").exists());
}

#[test]
fn a_claim_without_a_run_leaves_nothing() {
    let at = tempdir().unwrap();
    drop(RunFolder::claim(&at.path().join("a/b/c"), false).unwrap());
    assert_eq!(fs::read_dir(at.path()).unwrap().count(), 0);
    let file = at.path().join("file");
    fs::write(&file, "").unwrap();
    assert!(matches!(RunFolder::claim(&file, false), Err(ReplayError::Claim(FolderError::NoFolder { .. }))));
    assert!(matches!(
        RunFolder::claim(&file.join("below"), false),
        Err(ReplayError::Claim(FolderError::System { .. }))
    ));
}

/// A folder comes to stand where a file should be written, for each file of a run in turn.
#[test]
fn a_failing_write_is_one_error_and_can_be_resumed() {
    let at = tempdir().unwrap();
    let whole = at.path().join("whole");
    Wish::default().run(&whole).unwrap();
    let names = ["frames/frame-000000.png", "frames/frame-000005.png", "frames/frame-000011.png"];
    for (index, name) in names.iter().enumerate() {
        let out = at.path().join(index.to_string());
        let folder = RunFolder::claim(&out, false).unwrap();
        let failed = Wish { blocked: Some(name), ..Wish::default() }.run_in(&folder);
        let Err(ReplayError::File(FileError::IsFolder { path, .. })) = failed else { panic!("{failed:?}") };
        assert_eq!(path, out.join(name));
        assert!(!out.join("run.json").exists());
        drop(folder);
        resume(&whole, &out, name);
    }
    for (index, name) in ["poses.csv", "contact-sheet.png", "run.json"].iter().enumerate() {
        let out = at.path().join(format!("late-{index}"));
        let folder = RunFolder::claim(&out, false).unwrap();
        let failed = Wish { blocked: Some(name), ..Wish::default() }.run_in(&folder);
        assert!(failed.is_err(), "{name}");
        drop(folder);
        resume(&whole, &out, name);
    }
}

fn resume(whole: &Path, out: &Path, blocked: &str) {
    fs::remove_dir(out.join(blocked)).unwrap();
    Wish::default().run(out).unwrap();
    assert_eq!(differences(whole, out), Vec::<String>::new(), "{blocked}");
}

#[test]
fn damaged_records_are_said_to_be_so() {
    let at = tempdir().unwrap();
    Wish { frames: 0..1, ..Wish::default() }.run(at.path()).unwrap();
    let record = at.path().join("run.json");
    let text = fs::read_to_string(&record).unwrap();
    let other_time = text.replacen("\"time_s\": 0.0", "\"time_s\": 0.5", 1);
    assert_ne!(other_time, text);
    for damaged in [&text[..text.len() / 2], &text.replace("lunoid.run/2", "lunoid.run/9"), &other_time] {
        fs::write(&record, damaged).unwrap();
        let refused = Wish::default().run(at.path());
        assert!(matches!(refused, Err(ReplayError::Record { .. })), "{refused:?}");
    }
    Wish { frames: 0..1, ..fresh() }.run(at.path()).unwrap();
}

/// A name is no proof: a file of somebody else is neither removed nor replaced.
#[test]
fn files_that_only_have_a_name_of_a_run_stay() {
    let at = tempdir().unwrap();
    Wish { frames: 0..1, ..Wish::default() }.run(at.path()).unwrap();
    for name in ["frames/frame-000007.png", "animation.png", "index.html"] {
        let path = at.path().join(name);
        fs::write(&path, "mine").unwrap();
        Wish { frames: 0..1, ..Wish::default() }.run(at.path()).unwrap();
        let refused = fresh().run(at.path());
        assert!(
            matches!(&refused, Err(ReplayError::WouldReplace { found, .. }) if found == name),
            "{refused:?}"
        );
        assert_eq!(fs::read_to_string(&path).unwrap(), "mine");
        fs::remove_file(path).unwrap();
    }
    assert!(at.path().join("run.json").is_file());
}
