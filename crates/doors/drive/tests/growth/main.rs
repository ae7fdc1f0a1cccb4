//! A step of a loop costs what a frame costs, however many steps are behind it: counted in memory asked for, which no other program disturbs.

use std::alloc::System;
use std::fs;
use std::ops::Range;
use std::sync::Arc;

use drive::{Drive, Loop, Wishes};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static COUNTED: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

const SCENARIO: &str = include_str!("../scene.toml");

/// Frames of the path, and the last of them, whose memory is added up.
const FRAMES: [Range<u64>; 2] = [0..40, 32..40];

/// The scene by `machine`, with more frames and keys that are set, drawn by one thread.
fn drive(machine: &str, set: &[(&str, &str)]) -> Arc<Drive> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    let text = SCENARIO.replace("frames = 4", &format!("frames = {}", FRAMES[0].end));
    fs::write(&path, text).unwrap();
    let set = set.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    let wishes = Wishes { machine: Some(machine.into()), set, ..Wishes::default() };
    Arc::new(Drive::open(&path, &wishes, 1).unwrap_or_else(|error| panic!("{error}")))
}

/// Bytes that `draw` asks for in the last frames, one frame after another.
fn asked(mut draw: impl FnMut(u64)) -> usize {
    let [all, last] = FRAMES;
    (all.start..last.start).for_each(&mut draw);
    let region = Region::new(COUNTED);
    last.for_each(&mut draw);
    region.change().bytes_allocated
}

#[test]
fn a_step_of_a_loop_costs_what_a_frame_of_the_path_costs() {
    let late = [("sampled.overload", "'late'")];
    let machines = [("ideal", &[][..]), ("pra-nominal", &[]), ("pra-overloaded", &[]), ("sampled", &late)];
    for (machine, set) in machines {
        let drive = drive(machine, set);
        let frames = asked(|frame| drop(drive.frame(frame).unwrap()));
        let mut driven = Loop::new(Arc::clone(&drive));
        let steps = asked(|frame| drop(driven.look(&drive.pose(frame).unwrap()).unwrap()));
        assert!(steps < frames + frames / 4, "{machine}: {steps} bytes, {frames} of frames of the path");
    }
}
