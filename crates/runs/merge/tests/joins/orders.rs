use std::path::PathBuf;

use front_door::Wishes;
use picture::Depth;
use replay::Pictures;
use tempfile::tempdir;

use crate::drive::{Drive, GREY, expect_equal, join_until, joined};
use merge::Outcome;

/// The scene that most tests draw: a mission of one second with turns beyond the vehicle's limits.
fn drive() -> Drive {
    Drive::new("first-light", None, 3..17)
}

#[test]
fn any_number_of_shards_in_any_order_is_the_run_of_one_machine() {
    let at = tempdir().unwrap();
    let (drive, whole) = (drive(), at.path().join("whole"));
    drive.whole(&whole);
    for of in [1, 2, 7, 13] {
        let mut folders = drive.shards(of, at.path());
        let forward = at.path().join(format!("forward-{of}"));
        let found = joined(&folders, &forward);
        assert_eq!((found.frames, found.overlap, found.left_check_out), (3..17, 0, false));
        expect_equal(&whole, &forward, &format!("{of} shards"));
        folders.reverse();
        let backward = at.path().join(format!("backward-{of}"));
        joined(&folders, &backward);
        expect_equal(&whole, &backward, &format!("{of} shards backwards"));
    }
}

#[test]
fn a_shard_that_was_drawn_twice_counts_once() {
    let at = tempdir().unwrap();
    let (drive, whole) = (drive(), at.path().join("whole"));
    drive.whole(&whole);
    let mut folders = drive.shards(7, at.path());
    let twice = at.path().join("twice");
    drive.shard(3, 7, &twice);
    folders.insert(1, twice);
    // An ordinary run of some frames, over the cuts of several shards.
    let part = at.path().join("part");
    drive.draw(4..12, None, &part);
    folders.push(part);
    let out = at.path().join("joined");
    assert_eq!(joined(&folders, &out).overlap, 2 + 8);
    expect_equal(&whole, &out, "with overlap");
}

#[test]
fn what_was_joined_joins_again() {
    let at = tempdir().unwrap();
    let (drive, whole) = (drive(), at.path().join("whole"));
    drive.whole(&whole);
    let folders = drive.shards(2, at.path());
    let halves: Vec<PathBuf> = folders.iter().map(|folder| folder.with_extension("half")).collect();
    for (folder, half) in folders.iter().zip(&halves) {
        let range = replay::HeldRun::read(folder).unwrap().range;
        let outcome =
            crate::drive::join_frames(std::slice::from_ref(folder), Some(&(range[0]..range[1])), half);
        assert!(matches!(outcome, Ok(Outcome::Joined(_))), "{outcome:?}");
    }
    let out = at.path().join("joined");
    joined(&halves, &out);
    expect_equal(&whole, &out, "joined from joined halves");
    // The same once more changes nothing.
    joined(&halves, &out);
    expect_equal(&whole, &out, "joined twice");
}

#[test]
fn refreshed_frames_films_and_sixteen_bits() {
    let at = tempdir().unwrap();
    let mut drive = Drive::with(
        "first-light",
        &Wishes {
            sweeps: Some(24),
            samples: Some(40),
            set: vec![("raster.update_hz".into(), "10".into()), ("raster.refresh_hz".into(), "30".into())],
            ..Wishes::default()
        },
        0..8,
    );
    for (name, pictures) in [
        ("refresh", Pictures { refresh: true, film: true, ..GREY }),
        ("sixteen", Pictures { depth: Depth::Sixteen, film: true, ..GREY }),
    ] {
        drive.pictures = pictures;
        let at = at.path().join(name);
        drive.whole(&at.join("whole"));
        let folders = drive.shards(3, &at);
        joined(&folders, &at.join("joined"));
        expect_equal(&at.join("whole"), &at.join("joined"), name);
    }
}

#[test]
fn joining_that_was_told_to_end_goes_on() {
    let at = tempdir().unwrap();
    let (drive, whole) = (drive(), at.path().join("whole"));
    drive.whole(&whole);
    let folders = drive.shards(2, at.path());
    // Later, the frame on its way when joining is told to end may be all that is left.
    for most in [1, 5, 9] {
        let out = at.path().join(format!("until-{most}"));
        let outcome = join_until(&folders, None, &out, most);
        let Ok(Outcome::Interrupted { done, of: 14 }) = outcome else { panic!("{outcome:?}") };
        assert!((most..14).contains(&done), "{done} of {most}");
        // An unfinished run, that replay would go on in as well.
        let said = replay::HeldRun::read(&out).unwrap_err().to_string();
        assert!(said.contains("not finished"), "{said}");
        joined(&folders, &out);
        expect_equal(&whole, &out, &format!("after {most} frames"));
    }
}

#[test]
fn a_run_goes_on_where_joining_was_left() {
    let at = tempdir().unwrap();
    let (drive, whole) = (drive(), at.path().join("whole"));
    drive.whole(&whole);
    let folders = drive.shards(2, at.path());
    let out = at.path().join("out");
    join_until(&folders, None, &out, 4).unwrap();
    drive.whole(&out);
    expect_equal(&whole, &out, "drawn to its end");
}
