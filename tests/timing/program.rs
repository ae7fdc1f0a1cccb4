//! LUNSIM held to its baselines, as a job of a 360/65 and an SC 4020.

use generator::Stage;
use lunoid_tests::Shipped;
use lunsim::{Hardware, Lunsim, Parameters, Program};
use timing::{Comparison, TimingRecord, Tolerance, compare};

const EXHIBITS: [&str; 2] = ["lunsim-landing", "lunsim-sun"];

/// A baseline and the same frames timed anew.
fn held(name: &str, hardware: Hardware, parameters: Parameters) -> Comparison {
    let baseline = timing::read(crate::timing::baselines::path(name, lunsim::ROW.name))
        .unwrap_or_else(|e| panic!("{e}"));
    let shipped = Shipped::read(name, None);
    let stage: Stage = shipped.stage().stage();
    let program = Program::new(stage, &Lunsim { parameters, hardware }).expect("an exhibit");
    let timed = |frame: u64| program.frame(frame, &shipped.pose(frame).pose).expect("a shipped frame");
    let found = TimingRecord {
        scenario: shipped.scenario.title.clone(),
        machine: lunsim::ROW.name.into(),
        // The hash of the inputs is the command's, which `crates/doors/lunoid/tests` holds to the same baseline.
        frames: baseline.frames.iter().map(|frame| timed(frame.frame)).collect(),
        ..baseline.clone()
    };
    compare(&baseline, &found, &Tolerance::default())
}

#[test]
fn exhibits_hold_their_baselines() {
    for name in EXHIBITS {
        let comparison = held(name, Hardware::shipped().unwrap(), Parameters::default());
        assert!(comparison.is_met(), "{}", comparison.text(20));
        assert_eq!(comparison.frames.len(), 4);
    }
}

/// A nanosecond of one operation, a code less, a coarser grid: each is found, and named.
#[test]
fn whatever_changes_is_named() {
    let (shipped, usual) = (Hardware::shipped().unwrap(), Parameters::default());
    let slower = held("lunsim-sun", Hardware { divide: shipped.divide + 1, ..shipped }, usual);
    let text = slower.text(1000);
    assert!(text.contains("+tasks.cpu.projection.ticks") && !text.contains("pieces"), "{text}");
    let codes = held("lunsim-sun", shipped, Parameters { intensity_codes: 15, ..usual });
    assert!(codes.text(1000).contains("+events_blake3"), "{}", codes.text(10));
    let coarse = held("lunsim-sun", shipped, Parameters { grid: 512, ..usual });
    assert!(coarse.text(1000).contains("+tasks.cpu.march.pieces: 262144"), "{}", coarse.text(10));
}
