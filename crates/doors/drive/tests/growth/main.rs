//! A step of a loop costs what a frame costs, however many steps are behind it: counted in memory asked for, which no other program disturbs.

use std::alloc::System;
use std::fs;

use drive::{Drive, EyePose, Loop, Wishes};
use quantities::unit_interval;
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static COUNTED: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

const SCENARIO: &str = include_str!("../scene.toml");

/// Steps whose memory is added up.
const PART: usize = 8;

/// Bytes that each of `parts` of a loop of `machine` asks for, on one thread.
fn asked(machine: &str, set: &[(&str, &str)], parts: usize) -> Vec<usize> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    fs::write(&path, SCENARIO).unwrap();
    let set = set.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    let wishes = Wishes { machine: Some(machine.into()), set, ..Wishes::default() };
    let drive = Drive::open(&path, &wishes, 1).unwrap_or_else(|error| panic!("{error}"));
    let start = drive.pose(0).unwrap();
    let mut driven = Loop::new(drive.into());
    let mut pose = start;
    let mut step = |number: usize| {
        let turned = EyePose { heading_deg: 40.0 * unit_interval(7, &[number as u64]), ..pose };
        driven.look(&turned).unwrap_or_else(|error| panic!("{error}"));
        pose.eye_m[0] += 0.1;
    };
    let part = |part: usize| {
        let region = Region::new(COUNTED);
        (part * PART..(part + 1) * PART).for_each(&mut step);
        region.change().bytes_allocated
    };
    (0..parts).map(part).collect()
}

#[test]
fn the_last_steps_of_a_loop_cost_what_the_second_ones_do() {
    let late = [("sampled.overload", "'late'")];
    let machines = [("pra-nominal", &[][..]), ("pra-overloaded", &[]), ("sampled", &late)];
    for (machine, set) in machines {
        let asked = asked(machine, set, 8);
        let (second, last) = (asked[1], asked[7]);
        assert!(last < second + second / 3, "{machine}: {asked:?}");
    }
}
