//! Height along a sweep: craters and two levels against the landscape itself, sample by sample.

use hardware_model::LevelSwitch;
use landscape::{Bank, Landscape, Level, basis};
use lunoid_tests::{Drawn, level_of};
use quantities::radians;
use scenario::Scalar;

use crate::landscape::set::{REGION, Set, craters, rolling, wave};

/// Ideal signals in f64.
const CLOSE: f64 = 1e-9;

/// Ground range at which the coarse level takes over (m).
const SWITCH: f64 = 120.0;

fn assert_close(found: f64, expected: f64, bound: f64, what: &str) {
    assert!((found - expected).abs() <= bound, "{what}: {found}, expected {expected}");
}

fn cratered(seed: u64) -> Set {
    let mut set = Set::over(rolling(seed, 4.0));
    set.pose.attitude.heading = radians(61.0 * seed as f64);
    (set.stage.settings.raster.sweeps, set.stage.settings.raster.columns) = (9, 9);
    let middle = set.foot();
    set.with_craters(craters(seed, 120, middle, 150.0, 30.0))
}

#[test]
fn craters_along_a_sweep_are_those_of_the_landscape() {
    for seed in [1, 2, 3] {
        let set = cratered(seed);
        let drawn = set.machine(&["tg.*", "fg.*", "mu.height", "sweep.range"]);
        let (mut inside, landscape) = (0, &set.stage.landscape);
        for sweep in 0..9 {
            let signal = |name: &str| wave(&drawn, sweep, name);
            let (terrain, feature, both) = (signal("tg.height"), signal("fg.height"), signal("mu.height"));
            let slopes = ["fg.slope.u", "fg.slope.v"].map(signal);
            for (sample, &range) in signal("sweep.range").iter().enumerate() {
                let what = format!("seed {seed}, sweep {sweep}, {range} m");
                let [x, y] = set.place(sweep, range);
                let (ground, rise) = (landscape.at(x, y).unwrap(), landscape.features().at(x, y));
                assert_close(terrain[sample] + feature[sample], ground.height, CLOSE, &what);
                assert_close(both[sample], ground.height, CLOSE, &what);
                // On a rim itself either side may count.
                if is_near_a_kink(&set, [x, y]) {
                    continue;
                }
                for axis in 0..2 {
                    assert_close(slopes[axis][sample], rise.slopes[axis], CLOSE, &what);
                }
                assert_eq!(signal("fg.present")[sample] == 1.0, rise.present, "{what}");
                inside += usize::from(rise.present);
            }
        }
        assert!(inside > 1000, "{inside} samples in craters");
    }
}

fn is_near_a_kink(set: &Set, [x, y]: [f64; 2]) -> bool {
    set.stage.landscape.features().craters().iter().any(|crater| {
        let rho = libm::hypot(x - crater.centre()[0], y - crater.centre()[1]);
        crater.kinks().any(|kink| (rho - kink).abs() < 1e-7)
    })
}

#[test]
fn in_f32_craters_keep_their_millimetres() {
    let mut set = cratered(4);
    set.stage.settings.scalar = Scalar::F32;
    let drawn = set.machine(&["fg.height", "sweep.range"]);
    for sweep in 0..9 {
        for (found, &range) in wave(&drawn, sweep, "fg.height").iter().zip(wave(&drawn, sweep, "sweep.range"))
        {
            let [x, y] = set.place(sweep, range);
            let expected = set.stage.landscape.features().at(x, y).height;
            assert_close(*found, expected, 1e-4, &format!("sweep {sweep}, {range} m"));
        }
    }
}

/// Rolling ground of fine regions in the middle of coarser ones, which hold it less well.
fn two_levels(seed: u64, switch: LevelSwitch) -> Set {
    let fine = rolling(seed, 4.0);
    let corner = |m: usize, n: usize| {
        let place = |index: usize| (4.0 * REGION * index as f64 - 8.0 * REGION).clamp(0.0, 16.0 * REGION);
        let (region, local) = fine.locate(place(m), place(n)).unwrap();
        let mut words = [0.0; 9];
        words[0] = fine.height_and_slopes(region, local)[0];
        words
    };
    let coarse = level_of(4.0 * REGION, [-8.0 * REGION; 2], [9; 2], corner);
    let mut set = Set::over(fine.clone());
    let bank = Bank::new("two", vec![fine, coarse], None).unwrap();
    set = set.dressed(|ground| Landscape::new(bank, ground.albedo()));
    set.stage.settings.levels = Some(switch);
    set.stage.settings.range.end = 300.0;
    set
}

fn on(level: &Level, [x, y]: [f64; 2]) -> [f64; 3] {
    let (region, local) = level.locate(x, y).unwrap();
    let [height, u, v] = level.height_and_slopes(region, local);
    [height, u / level.region_size(), v / level.region_size()]
}

fn heights(drawn: &Drawn, sweep: u32) -> impl Iterator<Item = (f64, f64)> {
    wave(drawn, sweep, "sweep.range").iter().copied().zip(wave(drawn, sweep, "mu.height").iter().copied())
}

#[test]
fn the_levels_follow_one_another_by_ground_range() {
    for (seed, blend) in [(1, 0.0), (2, 40.0), (3, 120.0)] {
        let set = two_levels(seed, LevelSwitch { range: SWITCH, blend });
        let [fine, coarse] = [0, 1].map(|index| set.stage.landscape.bank().levels()[index].clone());
        let drawn = set.machine(&["mu.height", "sweep.range"]);
        let mut largest = 0.0_f64;
        for sweep in 0..set.stage.settings.raster.sweeps {
            for (range, height) in heights(&drawn, sweep) {
                let place = set.place(sweep, range);
                let far = on(&coarse, place)[0];
                let expected = if range >= SWITCH {
                    far
                } else if range <= SWITCH - blend {
                    on(&fine, place)[0]
                } else {
                    let weight = basis::values((range - SWITCH + blend) / blend)[0];
                    weight * on(&fine, place)[0] + (1.0 - weight) * far
                };
                assert_close(height, expected, CLOSE, &format!("seed {seed}, sweep {sweep}, {range} m"));
                if range < SWITCH {
                    largest = largest.max((on(&fine, place)[0] - far).abs());
                }
            }
        }
        assert!(largest > 0.5, "the levels are one and the same: {largest}");
    }
}

/// The rise of the profile over the step that holds the switch, and the difference of the levels there (m): the largest
/// of all sweeps.
fn step_at_the_switch(set: &Set, drawn: &Drawn) -> [f64; 2] {
    let levels = set.stage.landscape.bank().levels();
    let mut largest = [0.0_f64; 2];
    for sweep in 0..set.stage.settings.raster.sweeps {
        let profile: Vec<_> = heights(drawn, sweep).collect();
        let last = profile.partition_point(|(range, _)| *range < SWITCH);
        let rise = profile[last].1 - profile[last - 1].1;
        let [fine, coarse] = [0, 1].map(|index| on(&levels[index], set.place(sweep, SWITCH))[0]);
        largest = [largest[0].max(rise.abs()), largest[1].max((fine - coarse).abs())];
    }
    largest
}

#[test]
fn a_blend_takes_the_step_away_and_the_record_says_how_large_it_is() {
    let [sudden, blended] = [0.0, 40.0].map(|blend| {
        let set = two_levels(5, LevelSwitch { range: SWITCH, blend });
        let drawn = set.machine(&["mu.height", "sweep.range"]);
        let told = 1e-3 * drawn.counts["level_step_mm"] as f64;
        let [rise, difference] = step_at_the_switch(&set, &drawn);
        // Measured at the last fine sample, up to 0.8 m before the switch.
        assert!((told - difference).abs() < 0.05, "{told} m in the record, {difference} m at the switch");
        [rise, difference]
    });
    // Ground of less than 1:4 over a sample's 0.8 m.
    assert!(sudden[1] > 0.5 && (sudden[0] - sudden[1]).abs() < 0.2, "{sudden:?}");
    assert!(blended[0] < 0.2, "{blended:?}");
}
