//! Once warm, sweeps are drawn without asking for memory: a frame of four times the work asks no more often.

use machine::Prepare;
use std::alloc::System;

use benchmarks::{Choice, TimedScene};
use hardware_model::Economy;
use signal::Probe;
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static COUNTED: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// How often the third frame of a scene asks for memory, on one thread.
fn asked(scenario: &str, economy: Economy, raster: [u32; 2]) -> usize {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    let scene = TimedScene::shipped(scenario, &Choice { raster: Some(raster), economy, ..Choice::default() });
    let (mut planes, pose) = (scene.planes(), scene.pose);
    let session = scene.stage.prepare();
    let mut draw = || {
        let region = Region::new(COUNTED);
        let counts = pool.install(|| session.frame(0, &pose, &mut planes, &mut Probe::off()));
        assert!(counts.expect("drawn by the tests")["samples"] > 0);
        let change = region.change();
        change.allocations + change.reallocations
    };
    draw();
    draw();
    draw()
}

/// One test, so that no other asks at the same time.
#[test]
fn sweeps_ask_for_no_memory() {
    for scenario in ["first-light", "range-programmes"] {
        expect_at_most(scenario, Economy::Bounded, 0.1);
    }
    // More sweeps meet more boundaries of shadow: the one list of them doubles a few times more.
    expect_at_most("craters", Economy::Bounded, 0.2);
    // At the default quality there are lists of craters in sight too: each doubling of the sweeps asks 11 to 19 times more, and
    // more samples do not.
    expect_at_most("craters", Economy::Normal, 0.6);
    // Words that take time on two levels, and bodies, of which lists grow as more sweeps meet them.
    for scenario in ["nominal-drive", "full-drive"] {
        expect_at_most(scenario, Economy::Bounded, 2.0);
    }
}

/// Four times the sweeps with four times the samples: at most so many requests more for each sweep more.
fn expect_at_most(scenario: &str, economy: Economy, a_sweep: f64) {
    let [few, many] = [[16, 125], [64, 500]].map(|raster| asked(scenario, economy, raster));
    println!("{scenario}: {few} and {many}");
    let most = few as f64 + a_sweep * (64 - 16) as f64;
    assert!(many as f64 <= most, "{scenario}: {few} times at 16 sweeps, {many} times at 64");
}
