//! LUNSIM held to its baselines, as a job of a 360/65 and an SC 4020.

use lunoid_tests::Shipped;
use lunsim::{Hardware, Program};
use timing::{Comparison, TimingRecord, Tolerance, compare};

const EXHIBITS: [&str; 2] = ["lunsim-landing", "lunsim-sun"];

/// A baseline and the same frames timed anew.
fn held(name: &str, hardware: Hardware, change: impl FnOnce(&mut Shipped)) -> Comparison {
    let baseline = timing::read(crate::baselines::path(name, lunsim::NAME)).unwrap_or_else(|e| panic!("{e}"));
    let mut shipped = Shipped::read(name, None);
    change(&mut shipped);
    let program = Program::new(shipped.stage(), hardware).expect("an exhibit");
    let timed = |frame: u64| program.frame(frame, &shipped.pose(frame).pose).expect("a shipped frame");
    let found = TimingRecord {
        scenario: shipped.scenario.title.clone(),
        machine: lunsim::NAME.into(),
        // The hash of the inputs is the command's, which `crates/lunoid/tests` holds to the same baseline.
        frames: baseline.frames.iter().map(|frame| timed(frame.frame)).collect(),
        ..baseline.clone()
    };
    compare(&baseline, &found, &Tolerance::default())
}

#[test]
fn exhibits_hold_their_baselines() {
    for name in EXHIBITS {
        let comparison = held(name, Hardware::shipped().unwrap(), |_| {});
        assert!(comparison.is_met(), "{}", comparison.text(20));
        assert_eq!(comparison.frames.len(), 4);
    }
}

/// A nanosecond of one operation, a code less, a coarser grid: each is found, and named.
#[test]
fn whatever_changes_is_named() {
    let shipped = Hardware::shipped().unwrap();
    let slower = held("lunsim-sun", Hardware { divide: shipped.divide + 1, ..shipped }, |_| {});
    let text = slower.text(1000);
    assert!(text.contains("+tasks.cpu.projection.ticks") && !text.contains("pieces"), "{text}");
    let codes = held("lunsim-sun", shipped, |run| run.settings.lunsim.intensity_codes = 15);
    assert!(codes.text(1000).contains("+events_blake3"), "{}", codes.text(10));
    let coarse = held("lunsim-sun", shipped, |run| run.settings.lunsim.grid = 512);
    assert!(coarse.text(1000).contains("+tasks.cpu.march.pieces: 262144"), "{}", coarse.text(10));
}
