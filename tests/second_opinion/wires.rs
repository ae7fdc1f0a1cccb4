//! Main signals behind output amplifiers, in lockstep: the law, and the order in which signals flow.

use control_plane::MachineStage;
use hardware_model::WireParts;
use lockstep::{Engines, Report};
use lunoid_tests::{ComparedScene, Dice, random};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Scalar;

/// The scene with amplifiers as they fall: bands from a hundredth of the sample rate on, with and without a limit of slew.
fn report(seed: u64, scene: &ComparedScene) -> Report {
    let mut dice = Dice::new(seed ^ 0x7769_7265);
    let stage = scene.stage();
    let mut settings = stage.settings.clone();
    let rate = settings.timebase.sample_rate().hertz();
    let bandwidth = Some(rate * libm::pow(10.0, dice.between(-2.0, 1.0)));
    let slew = Some(rate * libm::pow(10.0, dice.between(-3.0, 0.0)));
    let [band, bound] = dice.choose(&[[true, false], [false, true], [true, true]]);
    let driven = std::array::from_fn(|_| dice.count(0, 3) > 0);
    settings.analog.wires =
        WireParts { bandwidth: bandwidth.filter(|_| band), slew: slew.filter(|_| bound), driven };
    let engines = Engines::new(MachineStage { settings, ..stage });
    engines.compare(1, &scene.pose(), 0..scene.sweeps).expect("a pose that can be drawn")
}

fn agree(seeds: std::ops::Range<u64>, make: impl Fn(u64) -> ComparedScene + Sync) -> Report {
    let reports: Vec<_> = seeds.into_par_iter().map(|seed| (seed, report(seed, &make(seed)))).collect();
    let mut sum = Report::default();
    let mut differences = Vec::new();
    for (seed, report) in reports {
        differences.extend(report.first_difference().map(|difference| format!("seed {seed}: {difference}")));
        sum.add(report);
    }
    assert!(differences.is_empty(), "{} scenes differ:\n{}", differences.len(), differences.join("\n"));
    sum
}

#[test]
fn amplifiers_agree_over_open_ground() {
    let found = agree(8000..8080, random::scene);
    for signal in
        ["tg.height", "tg.slope.u", "tg.reflectivity", "mu.height", "mu.reflectivity", "dpp.hold", "sm.video"]
    {
        assert!(found.signals[signal].samples > 10_000, "{signal}: {:?}", found.signals[signal]);
    }
    agree(8080..8120, |seed| ComparedScene { scalar: Scalar::F32, ..random::scene(seed) });
}

#[test]
fn amplifiers_agree_on_the_terrain_below_craters_and_on_sweeps_beside_them() {
    let found = agree(8200..8240, random::landscape);
    let light = &found.signals["mu.reflectivity"];
    assert!(light.samples > 0 && !light.not_compared.is_empty(), "{light:?}");
}
