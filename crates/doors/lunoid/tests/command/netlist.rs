//! `lunoid netlist`: a chain of parts as a circuit, and what ngspice makes of it.

use std::process::Command;

use serde_json::Value;

use crate::scene::Scene;

/// Samples so near one another that what is straight between them for the machine is nearly straight in the circuit.
const CHAIN: &[&str] =
    &["netlist", "tiny.toml", "--frame", "1", "--sweep", "5", "--samples", "640", "--out", "chain.cir"];

/// Parts slow enough for the samples of the scene: a time constant that is wrong by a third shows.
const SLOW: &[&str] = &[
    "-m",
    "pra-parts",
    "--set",
    "multiplier.bandwidth_mhz=0.06",
    "--set",
    "multiplying_dac.bandwidth_mhz=0.03",
];

#[test]
fn a_chain_runs_in_ngspice_and_agrees() {
    let scene = Scene::new();
    let told = scene.expect(0, &[CHAIN, SLOW].concat()).0;
    assert!(told.contains("ngspice -b"), "{told}");
    if Command::new("ngspice").arg("--version").output().is_err() {
        eprintln!("SKIPPED: ngspice is not installed; the circuit was written and not run");
        return;
    }
    let told = scene.expect(0, &[CHAIN, SLOW, &["--check", "--json"]].concat()).0;
    let told: Value = serde_json::from_str(&told).unwrap();
    let signals = told["signals"].as_array().unwrap();
    assert_eq!(signals.len(), 7);
    for signal in signals {
        assert!(signal["instants"].as_u64().unwrap() > 40, "{signal}");
        assert!(signal["norm"].as_f64().unwrap() <= 1.0, "{signal}");
    }
}

/// Parts of the light as slow, each with an error that is seen.
const LIGHT: [&str; 9] = [
    "multiplier_error_pct=0.25",
    "multiplier_scale_error_pct=0.2",
    "multiplier_bandwidth_mhz=0.06",
    "summer_bandwidth_mhz=0.06",
    "root_error_pct=0.5",
    "root_bandwidth_mhz=0.06",
    "divider_error_pct=0.5",
    "divider_bandwidth_mhz=0.1",
    "saturation_v=11",
];

#[test]
fn the_light_runs_in_ngspice_and_agrees() {
    let scene = Scene::new();
    let keys = LIGHT.map(|key| format!("reflectivity.{key}"));
    let sets = keys.iter().flat_map(|key| ["--set", key]);
    let asked: Vec<&str> =
        CHAIN.iter().copied().chain(["-m", "pra-parts", "--block", "light"]).chain(sets).collect();
    scene.expect(0, &asked);
    if Command::new("ngspice").arg("--version").output().is_err() {
        eprintln!("SKIPPED: ngspice is not installed; the circuit was written and not run");
        return;
    }
    let told: Value =
        serde_json::from_str(&scene.expect(0, &[&asked, &["--check", "--json"][..]].concat()).0).unwrap();
    let signals = told["signals"].as_array().unwrap();
    assert_eq!(signals.len(), 8);
    for signal in signals {
        assert!(signal["instants"].as_u64().unwrap() > 400, "{signal}");
        assert!(signal["norm"].as_f64().unwrap() <= 1.0, "{signal}");
    }
}

/// A stage of light without parts.
const IDEAL_LIGHT: &[&str] = &[
    "--set=reflectivity.multiplier_bandwidth_mhz=unlimited",
    "--set=reflectivity.summer_bandwidth_mhz=unlimited",
    "--set=reflectivity.root_bandwidth_mhz=unlimited",
    "--set=reflectivity.divider_bandwidth_mhz=unlimited",
    "--set=reflectivity.saturation_v=unlimited",
];

#[test]
fn what_has_no_circuit_is_refused() {
    let scene = Scene::new();
    for (wrong, words) in [
        (&["-m", "ideal"][..], "this model has an ideal terrain generator"),
        (&["-m", "pra-parts", "--block", "coarse"], "expected a scenario with two levels"),
        (&["-m", "pra-parts", "--block", "mixing-unit"], "possible values: fine, coarse, light"),
        (
            &[&["-m", "pra-parts", "--block", "light"][..], IDEAL_LIGHT].concat()[..],
            "this model makes light by the law",
        ),
        (&["-m", "exact"], "only the hybrid machine has such a circuit"),
        (&["-m", "pra-parts", "--json"], "--check"),
    ] {
        let (out, err) = scene.expect(2, &[CHAIN, wrong].concat());
        assert!(out.is_empty() && err.contains(words), "{wrong:?}: {err}");
    }
    let far =
        ["netlist", "tiny.toml", "--frame", "1", "--sweep", "40", "--out", "chain.cir", "-m", "pra-parts"];
    let (_, err) = scene.expect(2, &far);
    assert!(err.contains("a frame has sweeps 0..40"), "{err}");
}
