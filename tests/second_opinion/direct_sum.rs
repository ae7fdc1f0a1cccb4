//! The machine's signals against the direct sum over the bank (5.1): what the ground is, not how it is made.

use ::lockstep::bounds::F64;
use landscape::{Bank, Landscape};
use lunoid_tests::{ComparedScene, Lockstep, random};

/// Height, both slopes and reflectivity by direct evaluation at each sample that `interpret` has.
fn check(scene: &ComparedScene, what: &str) {
    let bank = Bank::new("direct", vec![scene.level.clone()], None).unwrap();
    let landscape = Landscape::new(bank, scene.albedo);
    let lockstep = Lockstep::run(scene, 0);
    let names = ["tg.height", "tg.slope.u", "tg.slope.v", "tg.reflectivity"];
    let mut scale = [0.0_f64; 4];
    let mut worst = [0.0_f64; 4];
    for (sweep, seen) in lockstep.sweeps.iter().enumerate() {
        let ranges = lockstep.machine(sweep, "sweep.range");
        for (sample, &range) in ranges[..seen.interpreter.samples].iter().enumerate() {
            let azimuth = direction(scene, sweep as u32);
            let place = [0, 1].map(|axis| scene.eye[axis] + range * azimuth[axis]);
            let Some(ground) = landscape.at(place[0], place[1]) else { continue };
            let light = ground.albedo * scene.sun.reflectivity(ground.slopes);
            let direct = [ground.height, ground.slopes[0], ground.slopes[1], light];
            for (k, name) in names.iter().enumerate() {
                let off = lockstep.machine(sweep, name)[sample] - direct[k];
                worst[k] = worst[k].max(off.abs());
                scale[k] = scale[k].max(direct[k].abs());
            }
        }
    }
    for (k, name) in names.iter().enumerate() {
        assert!(worst[k] <= F64 * scale[k], "{what}: {name} off by {:e} of {:e}", worst[k], scale[k]);
    }
}

fn direction(scene: &ComparedScene, sweep: u32) -> [f64; 2] {
    let fan = sweep_program::Fan::covering(scene.laws.projection, scene.pitch, &scene.field, scene.sweeps);
    let (sin, cos) = quantities::sin_cos(scene.heading);
    fan.expect("a moderate pitch").direction(sweep, [cos, sin])
}

#[test]
fn signals_are_the_ground_itself() {
    for seed in 2000..2080 {
        check(&random::scene(seed), &format!("seed {seed}"));
    }
}
