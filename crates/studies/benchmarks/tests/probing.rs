//! Probing nothing costs nothing, and probing one signal of one sweep next to nothing.

use std::path::Path;

use benchmarks::instructions_of;

/// Part of the instructions of a frame that probing nothing may take.
const BOUND: f64 = 0.005;
/// Part of them that one signal of one sweep may add.
const ONE: f64 = 0.03;

fn count(kernel: &str) -> Option<f64> {
    match instructions_of(Path::new(env!("CARGO_BIN_EXE_instructions")), kernel, &["--run", kernel]) {
        Ok(count) => Some(count.instructions as f64),
        Err(error) if error.is_of_place() => {
            eprintln!("SKIPPED: {error}");
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// What `scene` takes when it is probed as `how` says, over what it takes without probes; none where they cannot be counted.
fn ratio(scene: &str, how: &str) -> Option<f64> {
    let [probed, without] = [how, "no-probe"].map(|how| count(&format!("{scene}/{how}")));
    Some(probed? / without?)
}

fn expect_nothing_for_nothing(scene: &str) {
    let Some(ratio) = ratio(scene, "probe-off") else { return };
    println!("{scene}: {ratio:.6}");
    assert!((ratio - 1.0).abs() < BOUND, "{scene}: {ratio}");
}

#[test]
#[cfg_attr(
    debug_assertions,
    ignore = "instructions are those of a release build: cargo test --profile counted -p benchmarks"
)]
fn probing_nothing_takes_the_instructions_of_a_machine_without_probes() {
    expect_nothing_for_nothing("first-light");
}

#[test]
#[cfg_attr(
    debug_assertions,
    ignore = "instructions are those of a release build: cargo test --profile counted -p benchmarks"
)]
fn one_signal_of_one_sweep_takes_next_to_nothing() {
    let Some(ratio) = ratio("nominal-drive", "probe-one") else { return };
    println!("nominal-drive: {ratio:.6}");
    assert!(ratio < 1.0 + ONE, "{ratio}");
}

#[test]
fn a_kernel_that_is_not_there_is_said_so() {
    let error =
        instructions_of(Path::new(env!("CARGO_BIN_EXE_instructions")), "nothing", &["--run", "nothing"])
            .unwrap_err();
    assert!(error.is_of_place() || error.to_string().contains("no kernel of this name"), "{error}");
}
