use std::fs;

use replay::{Outcome, ReplayError};
use tempfile::tempdir;

use crate::stage::{Wish, content, differences};

fn drawn(outcome: &Outcome) -> u64 {
    match outcome {
        Outcome::Finished { drawn, .. } => *drawn,
        Outcome::Interrupted { .. } => panic!("interrupted"),
    }
}

#[test]
fn the_same_bytes_for_any_number_of_threads() {
    let at = tempdir().unwrap();
    for threads in [1, 2, 5] {
        Wish { threads, ..Wish::default() }.run(&at.path().join(threads.to_string())).unwrap();
    }
    for other in ["2", "5"] {
        assert_eq!(differences(&at.path().join("1"), &at.path().join(other)), Vec::<String>::new());
    }
}

#[test]
fn an_interrupted_run_goes_on_to_the_same_bytes() {
    let at = tempdir().unwrap();
    let whole = at.path().join("whole");
    Wish::default().run(&whole).unwrap();
    // Later, the frames on their way when the run is told to end may be all that are left.
    for after in 0..9 {
        let out = at.path().join(format!("cut-{after}"));
        let cut = Wish { cancel_after: Some(after), ..Wish::default() }.run(&out).unwrap();
        let Outcome::Interrupted { done, of: 12 } = cut else { panic!("after {after}: {cut:?}") };
        // Frames on their way, at most one a carrier, are finished.
        assert!((after..after + 4).contains(&done), "after {after}: {done} done");
        assert_eq!(out.exists(), done > 0);
        let resumed = Wish::default().run(&out).unwrap();
        assert_eq!(drawn(&resumed), 12 - done);
        assert_eq!(differences(&whole, &out), Vec::<String>::new());
    }
}

#[test]
fn the_same_command_again_redoes_nothing() {
    let at = tempdir().unwrap();
    Wish::default().run(at.path()).unwrap();
    let when = |name: &str| fs::metadata(at.path().join(name)).unwrap().modified().unwrap();
    let names: Vec<String> = content(at.path()).into_keys().chain(["performance.json".into()]).collect();
    let before: Vec<_> = names.iter().map(|name| when(name)).collect();
    assert_eq!(drawn(&Wish::default().run(at.path()).unwrap()), 0);
    assert_eq!(names.iter().map(|name| when(name)).collect::<Vec<_>>(), before);
}

#[test]
fn missing_and_damaged_files_are_made_again() {
    let at = tempdir().unwrap();
    let (whole, out) = (at.path().join("whole"), at.path().join("out"));
    Wish::default().run(&whole).unwrap();
    Wish::default().run(&out).unwrap();
    let frame = |n: u64| out.join(format!("frames/frame-{n:06}.png"));
    fs::remove_file(frame(2)).unwrap();
    let mut bytes = fs::read(frame(7)).unwrap();
    *bytes.last_mut().unwrap() ^= 1;
    fs::write(frame(7), bytes).unwrap();
    fs::write(frame(9), "").unwrap();
    fs::write(out.join("contact-sheet.png"), "x").unwrap();
    fs::remove_file(out.join("poses.csv")).unwrap();
    assert_eq!(drawn(&Wish::default().run(&out).unwrap()), 3);
    assert_eq!(differences(&whole, &out), Vec::<String>::new());
}

#[test]
fn a_killed_run_leaves_nothing_that_stays() {
    let at = tempdir().unwrap();
    let (whole, out) = (at.path().join("whole"), at.path().join("out"));
    Wish::default().run(&whole).unwrap();
    Wish { cancel_after: Some(3), ..Wish::default() }.run(&out).unwrap();
    // As after kill -9: a line cut short, half a frame, a frame that is not in the journal, a lock.
    let journal = out.join("frames.journal");
    let text = fs::read_to_string(&journal).unwrap();
    fs::write(&journal, &text[..text.len() - 20]).unwrap();
    fs::write(out.join("frames/.frame-000008.png.77-1.tmp"), "half").unwrap();
    fs::copy(whole.join("frames/frame-000004.png"), out.join("frames/frame-000010.png")).unwrap();
    fs::copy(whole.join("frames/frame-000004.png"), out.join("frames/frame-000500.png")).unwrap();
    fs::write(out.join(".run.json.77-2.tmp"), "half").unwrap();
    fs::write(out.join(".lunoid.lock"), "77").unwrap();
    Wish::default().run(&out).unwrap();
    assert_eq!(differences(&whole, &out), Vec::<String>::new());
}

#[test]
fn the_range_of_frames_may_grow() {
    let at = tempdir().unwrap();
    let (whole, out) = (at.path().join("whole"), at.path().join("out"));
    Wish::default().run(&whole).unwrap();
    for (frames, expected) in [(4..6, 2), (6..12, 6), (0..5, 4), (3..7, 0)] {
        assert_eq!(drawn(&Wish { frames: frames.clone(), ..Wish::default() }.run(&out).unwrap()), expected);
    }
    assert_eq!(differences(&whole, &out), Vec::<String>::new());
    let part = at.path().join("part");
    Wish { frames: 0..2, ..Wish::default() }.run(&part).unwrap();
    let gap = Wish { frames: 5..7, ..Wish::default() }.run(&part);
    assert!(matches!(gap, Err(ReplayError::Gap { .. })), "{gap:?}");
    assert!(matches!(Wish { frames: 3..3, ..Wish::default() }.run(&part), Err(ReplayError::NoFrames(_))));
}

#[test]
fn a_frame_alone_is_the_frame_of_the_whole_run() {
    let at = tempdir().unwrap();
    let (whole, alone) = (at.path().join("whole"), at.path().join("alone"));
    Wish::default().run(&whole).unwrap();
    Wish { frames: 7..8, ..Wish::default() }.run(&alone).unwrap();
    let name = "frames/frame-000007.png";
    assert_eq!(content(&whole)[name], content(&alone)[name]);
}
