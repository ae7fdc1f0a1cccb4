//! `lunoid netlist`: a chain of parts as a circuit, and what ngspice makes of it.

use std::process::Command;

use serde_json::Value;

use crate::scene::{Scene, lunoid};

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

/// A converter settles within the sample, and has pulses, a bow and a smoother. The ramp behind it agrees with the circuit. Function generators
/// do not: they see the ramp at samples alone.
#[test]
fn a_ramp_of_stairs_is_what_the_circuit_makes_of_it() {
    let scene = Scene::new();
    let stairs =
        ["dac_bits=8", "settle_ns=6000", "smoother_ns=1500", "glitch_v_ns=2000", "nonlinearity_pct=0.5"];
    let keys = stairs.map(|key| format!("sweep.{key}"));
    let sets: Vec<&str> = keys.iter().flat_map(|key| ["--set", key]).collect();
    if Command::new("ngspice").arg("--version").output().is_err() {
        eprintln!("SKIPPED: ngspice is not installed; the stairs were not run");
        return;
    }
    let told = scene.expect(1, &[CHAIN, SLOW, &sets, &["--check", "--json"]].concat()).0;
    let told: Value = serde_json::from_str(&told).unwrap();
    let ramps = told["signals"].as_array().unwrap().iter();
    let ramps: Vec<&Value> =
        ramps.filter(|signal| signal["signal"].as_str().unwrap().starts_with("sweep.")).collect();
    assert_eq!(ramps.len(), 2, "{told}");
    for ramp in ramps {
        assert!(ramp["instants"].as_u64().unwrap() > 1000 && ramp["norm"].as_f64().unwrap() < 0.1, "{ramp}");
    }
}

/// A simulator that gives up on its way is no comparison: the instant is told, and what it says.
#[cfg(unix)]
#[test]
fn a_simulator_that_stops_is_told() {
    use std::os::unix::fs::PermissionsExt;

    let scene = Scene::new();
    let folder = scene.join("tools");
    std::fs::create_dir(&folder).unwrap();
    let tool = folder.join("ngspice");
    // Two points of a time and seven nodes, and half of another.
    let script = "#!/bin/sh\necho 'Timestep too small' >&2\n\
                  { printf 'No. Variables: 8\\nBinary:\\n'; head -c 160 /dev/zero; } >\"$3\"\nexit 1\n";
    std::fs::write(&tool, script).unwrap();
    std::fs::set_permissions(&tool, PermissionsExt::from_mode(0o755)).unwrap();
    let path = format!("{}:{}", folder.display(), std::env::var("PATH").unwrap());
    let asked = [CHAIN, SLOW, &["--check"]].concat();
    let output = lunoid().current_dir(scene.path()).args(asked).env("PATH", path).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(3), "{said}");
    assert!(said.contains("ngspice stopped at 0.000e0 of ") && said.contains("Timestep too small"), "{said}");
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
