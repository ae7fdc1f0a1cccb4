use super::craters::Crater;
use super::{Craters, Massif, Meander, Relief, ReliefError, Rille, Undulation};
use crate::Level;
use std::f64::consts::PI;

/// Every kind of part, close together.
fn everything(region_size: f64) -> Relief {
    let undulation = Undulation { rms_height: 4.0, hurst: 0.9, longest: 300.0, shortest: 40.0, waves: 60 };
    let craters =
        Craters { smallest_radius: 18.0, largest_radius: 60.0, density: 0.2, subdued: 0.03, fresh: 0.2 };
    let massif = Massif { at: [90.0, 110.0], height: 30.0, radius: 90.0, detail: 40.0, ruggedness: 0.6 };
    let meander = Some(Meander { swing: 15.0, length: 120.0 });
    let rille = Rille { through: [30.0, 60.0], azimuth: 0.4, width: 60.0, depth: 12.0, meander };
    Relief {
        tilt: [0.01, -0.02],
        undulation: Some(undulation),
        craters: Some(craters),
        massifs: vec![massif],
        rilles: vec![rille],
        ..Relief::flat(11, [200.0, 200.0], region_size)
    }
}

fn mare(hurst: f64) -> Undulation {
    Undulation { rms_height: 20.0, hurst, longest: 10_000.0, shortest: 100.0, waves: 600 }
}

/// Central differences of order 6 for derivative 0, 1, 2, weights of offsets -3..=3.
const STENCILS: [[f64; 7]; 3] = [
    [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
    [-1.0 / 60.0, 3.0 / 20.0, -3.0 / 4.0, 0.0, 3.0 / 4.0, -3.0 / 20.0, 1.0 / 60.0],
    [1.0 / 90.0, -3.0 / 20.0, 1.5, -49.0 / 18.0, 1.5, -3.0 / 20.0, 1.0 / 90.0],
];

/// `d^p d^q h` at a corner of the fine level, in units of its regions.
fn difference(fine: &Level, corner: [usize; 2], p: usize, q: usize) -> f64 {
    let east = fine.corners()[1];
    let height = |i: usize, j: usize| fine.words()[(corner[0] + i - 3) * east + corner[1] + j - 3][0];
    let along = |i: usize| (0..7).map(|j| STENCILS[q][j] * height(i, j)).sum::<f64>();
    (0..7).map(|i| STENCILS[p][i] * along(i)).sum()
}

#[test]
fn words_are_the_derivatives_of_the_heights() {
    let (coarse, fine) = (everything(10.0).build().unwrap(), everything(0.5).build().unwrap());
    let mut largest = [0.0f64; 9];
    let mut worst = [0.0f64; 9];
    for (m, n) in (1..20).flat_map(|m| (1..20).map(move |n| (m, n))) {
        let words = &coarse.words()[m * 21 + n];
        for index in 0..9 {
            let factor = [1.0, 20.0, 400.0][index / 3] * [1.0, 20.0, 400.0][index % 3];
            let expected = difference(&fine, [20 * m, 20 * n], index / 3, index % 3) * factor;
            largest[index] = largest[index].max(words[index].abs());
            worst[index] = worst[index].max((words[index] - expected).abs());
        }
    }
    for index in 0..9 {
        let relative = worst[index] / largest[index];
        // The foot of a massif has no fifth derivative: stencils across it are good to 5e-4 in the fourth.
        assert!(relative < 1e-3, "word {index}: {relative:e} of {}", largest[index]);
    }
}

#[test]
fn the_ground_does_not_depend_on_the_region_size() {
    let (coarse, fine) = (everything(10.0).build().unwrap(), everything(5.0).build().unwrap());
    for (m, n) in (0..21).flat_map(|m| (0..21).map(move |n| (m, n))) {
        let scaled = Level::scale_words(&fine.words()[2 * m * 41 + 2 * n], 2.0);
        for (found, expected) in coarse.words()[m * 21 + n].iter().zip(scaled) {
            assert!((found - expected).abs() < 1e-9, "corner ({m}, {n})");
        }
    }
}

#[test]
fn same_seed_same_bits_on_any_number_of_threads() {
    let built = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| everything(4.0).build().unwrap())
    };
    let one = built(1);
    assert_eq!(one, built(3));
    let other = Relief { seed: 12, ..everything(4.0) }.build().unwrap();
    assert_ne!(one, other);
}

/// Power of a profile at `cycles` over its length, under a Hann window.
fn power(profile: &[f64], cycles: f64) -> f64 {
    let count = profile.len() as f64;
    let (mut real, mut imaginary) = (0.0, 0.0);
    for (index, height) in profile.iter().enumerate() {
        let turn = 2.0 * PI * index as f64 / count;
        let windowed = height * (1.0 - libm::cos(turn));
        real += windowed * libm::cos(turn * cycles);
        imaginary += windowed * libm::sin(turn * cycles);
    }
    real * real + imaginary * imaginary
}

/// Slope of the least-squares line through points (x, y).
fn fitted_slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |part: fn(&(f64, f64)) -> f64| points.iter().map(part).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    covariance / points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum::<f64>()
}

#[test]
fn profiles_have_the_hurst_exponent_asked_for() {
    // 51 km profiles, power at wavelengths 250 m to 5 km, mean over seeds: slope -(2 H + 1).
    let cycles: Vec<f64> = (0..24).map(|i| 10.0 * libm::pow(20.0, f64::from(i) / 23.0)).collect();
    for hurst in [0.5, 0.7, 0.9] {
        let mut powers = vec![0.0; cycles.len()];
        for seed in 0..24 {
            let undulation = Some(mare(hurst));
            let relief = Relief { undulation, ..Relief::flat(seed, [30.0, 51_210.0], 30.0) };
            let level = relief.build().unwrap();
            let profile: Vec<f64> = level.words()[..level.corners()[1]].iter().map(|w| w[0]).collect();
            for (sum, &cycles) in powers.iter_mut().zip(&cycles) {
                *sum += power(&profile, cycles);
            }
        }
        let points: Vec<(f64, f64)> =
            cycles.iter().zip(&powers).map(|(c, p)| (libm::log(*c), libm::log(*p))).collect();
        let found = (-fitted_slope(&points) - 1.0) / 2.0;
        assert!((found - hurst).abs() < 0.08, "asked {hurst}, found {found}");
    }
}

#[test]
fn height_and_slope_have_the_spread_asked_for() {
    let undulation = Undulation { shortest: 600.0, ..mare(0.8) };
    let relief = Relief { undulation: Some(undulation), ..Relief::flat(5, [60_000.0; 2], 200.0) };
    let level = relief.build().unwrap();
    let mean_square =
        |law: fn(&[f64; 9]) -> f64| level.words().iter().map(law).sum::<f64>() / level.words().len() as f64;
    let height = mean_square(|w| w[0] * w[0]).sqrt();
    let slope = mean_square(|w| w[1] * w[1] + w[3] * w[3]).sqrt() / 200.0;
    assert!((height / 20.0 - 1.0).abs() < 0.05, "rms height {height}");
    assert!((slope / undulation.rms_slope() - 1.0).abs() < 0.05, "rms slope {slope}");
}

#[test]
fn a_crater_has_the_depth_and_rim_of_its_closed_form() {
    let crater = Crater::new([400.0, 400.0], 100.0, 0.2);
    let relief = Relief::flat(0, [800.0, 800.0], 50.0);
    let grid = relief.grid().unwrap();
    let mut words = vec![[0.0; 9]; 17 * 17];
    super::craters::add_to(&[crater], &grid, &mut words);
    let (floor, rim) = (words[8 * 17 + 8], words[10 * 17 + 8]);
    assert!((rim[0] - floor[0] - 40.0).abs() < 1e-12, "rim to floor is 0.2 diameters");
    assert!((rim[0] / crater.depth - libm::exp(-2.0)).abs() < 1e-15);
    assert!(rim[3].abs() < 1e-12 && rim[6] < 0.0, "the rim is a crest");
    let volume: f64 = words.iter().map(|w| w[0]).sum::<f64>() * 50.0 * 50.0;
    assert!(volume.abs() < 1e-6 * 40.0 * 100.0 * 100.0, "the rim holds what the bowl lost: {volume}");
}

#[test]
fn craters_follow_the_size_frequency_law() {
    let craters =
        Craters { smallest_radius: 20.0, largest_radius: 400.0, density: 0.08, subdued: 0.03, fresh: 0.2 };
    let drawn = craters.draw(3, [0.0; 2], [8_000.0, 4_000.0]);
    let area = (8_000.0 + 1_600.0) * (4_000.0 + 1_600.0);
    for radius in [25.0, 50.0, 100.0, 200.0] {
        let found = drawn.iter().filter(|c| c.radius > radius).count() as f64;
        let larger = |r: f64| 0.08 * area / (4.0 * r * r);
        let expected = larger(radius) - larger(400.0);
        assert!((found - expected).abs() <= 1.5, "{found} above {radius} m, law {expected}");
    }
    assert!(drawn.iter().all(|c| (0.02..0.18).contains(&(c.depth / c.radius / 2.0))));
}

fn refused(relief: Relief) -> String {
    let error = relief.check().unwrap_err();
    assert_eq!(relief.build().map(|_| ()).map_err(|e| e.to_string()), Err(error.to_string()));
    error.to_string()
}

#[test]
fn parameters_out_of_range_are_named() {
    let good = everything(10.0);
    assert_eq!(good.check(), Ok(()));
    let of = |change: fn(&mut Relief)| {
        let mut relief = everything(10.0);
        change(&mut relief);
        refused(relief)
    };
    assert_eq!(of(|r| r.region_size = f64::NAN), "region_size = NaN: expected a finite number above 0");
    assert_eq!(of(|r| r.extent[1] = 205.0), "extent east = 205: expected a whole number of regions of 10 m");
    assert_eq!(of(|r| r.tilt[0] = 2.0), "tilt north = 2: expected -1 to 1");
    let hurst = |r: &mut Relief| r.undulation.as_mut().unwrap().hurst = 1.4;
    assert_eq!(of(hurst), "undulation.hurst = 1.4: expected 0 to 1");
    assert!(of(|r| r.undulation.as_mut().unwrap().shortest = 29.0).starts_with("undulation.shortest = 29"));
    assert!(of(|r| r.undulation.as_mut().unwrap().waves = 0).starts_with("undulation.waves = 0"));
    assert!(of(|r| r.craters.as_mut().unwrap().smallest_radius = 14.0).contains("smallest_radius = 14"));
    assert!(of(|r| r.craters.as_mut().unwrap().fresh = 0.5).contains("craters.fresh = 0.5"));
    assert!(of(|r| r.massifs[0].height = f64::INFINITY).starts_with("massifs[0].height = inf"));
    assert!(of(|r| r.rilles[0].through[0] = f64::NAN).starts_with("rilles[0].through north = NaN"));
    assert!(of(|r| r.rilles[0].meander.as_mut().unwrap().length = 0.0).contains("meander.length"));
}

#[test]
fn sizes_beyond_memory_are_refused_before_they_are_made() {
    let wide = Relief::flat(0, [1e12, 1e12], 1.0);
    assert!(matches!(wide.check(), Err(ReliefError::TooManyCorners { .. })));
    // Craters whose rims might reach in from 40 km around.
    let craters =
        Craters { smallest_radius: 15.0, largest_radius: 20_000.0, density: 1.0, subdued: 0.1, fresh: 0.2 };
    let many = Relief { craters: Some(craters), ..Relief::flat(0, [1_000.0; 2], 10.0) };
    assert!(matches!(many.check(), Err(ReliefError::TooManyCraters(_))));
}

/// Straight, it is the same profile all along.
#[test]
fn a_straight_rille_runs_along_its_azimuth() {
    let rille = Rille { through: [400.0, 400.0], azimuth: 0.0, width: 100.0, depth: 12.0, meander: None };
    let level = Relief { rilles: vec![rille], ..Relief::flat(1, [800.0; 2], 20.0) }.build().unwrap();
    let at = |x: f64, y: f64| {
        let (region, place) = level.locate(x, y).unwrap();
        level.height_and_slopes(region, place)[0]
    };
    for x in [10.0, 250.0, 777.0] {
        assert!((at(x, 400.0) + 12.0).abs() < 1e-9, "{}", at(x, 400.0));
        assert!((at(x, 380.0) - at(x, 420.0)).abs() < 1e-9);
        assert!((at(x, 370.0) - at(133.0, 370.0)).abs() < 1e-9);
        assert!(at(x, 40.0).abs() < 1e-3, "{}", at(x, 40.0));
    }
}

/// Far ground around `everything(5.0)`: a long swell, a mountain that reaches into the fine level, craters.
fn around(region_size: f64) -> Relief {
    let swell = Undulation { rms_height: 3.0, hurst: 0.9, longest: 900.0, shortest: 400.0, waves: 12 };
    let craters =
        Craters { smallest_radius: 64.0, largest_radius: 90.0, density: 0.2, subdued: 0.03, fresh: 0.2 };
    let massif = Massif { at: [240.0, 40.0], height: 50.0, radius: 260.0, detail: 125.0, ruggedness: 0.4 };
    Relief {
        undulation: Some(swell),
        craters: Some(craters),
        massifs: vec![massif],
        ..Relief::flat(12, [680.0, 840.0], region_size)
    }
}

/// Largest difference of word `index` between both levels where they share corners, in fine units.
fn largest_step([fine, coarse]: &[Level; 2], index: usize) -> f64 {
    let ratio = coarse.region_size() / fine.region_size();
    let mut largest = 0.0f64;
    for (m, n) in (0..coarse.corners()[0]).flat_map(|m| (0..coarse.corners()[1]).map(move |n| (m, n))) {
        let at = [0, 1].map(|axis| coarse.origin()[axis] + coarse.region_size() * [m, n][axis] as f64);
        let Some(([i, j], [u, v])) = fine.locate(at[0], at[1]) else { continue };
        let corner = (i + u.round() as usize) * fine.corners()[1] + j + v.round() as usize;
        let expected = Level::scale_words(&fine.words()[corner], ratio)[index];
        largest = largest.max((coarse.words()[m * coarse.corners()[1] + n][index] - expected).abs());
    }
    largest
}

#[test]
fn both_levels_are_one_ground_where_regions_hold_all_of_it() {
    let levels = everything(5.0).build_two(&around(10.0)).unwrap();
    assert_eq!((levels[0].origin(), levels[1].origin()), ([0.0; 2], [-240.0, -320.0]));
    for index in 0..9 {
        let step = largest_step(&levels, index);
        assert!(step < 1e-9, "word {index}: {step:e}");
    }
}

#[test]
fn the_step_is_what_the_coarse_regions_cannot_hold() {
    // Regions of 40 m hold waves of 120 m, craters of 60 m, massifs of 240 m: of `everything` the long waves alone.
    let undulation = everything(5.0).undulation.unwrap();
    let small = Relief { undulation: None, tilt: [0.0; 2], ..everything(5.0) };
    let levels = small.build_two(&around(40.0)).unwrap();
    let alone = small.build().unwrap();
    let highest = alone.words().iter().map(|words| words[0].abs()).fold(0.0, f64::max);
    let step = largest_step(&levels, 0);
    assert!(step > 0.5 * highest && step <= highest + 1e-9, "{step} of {highest}");
    // Waves from 40 m to 120 m of a spectrum to 300 m hold a known share of its variance.
    let waves = Relief { undulation: Some(undulation), ..Relief::flat(11, [200.0, 200.0], 5.0) };
    let levels = waves.build_two(&Relief::flat(1, [1000.0, 1000.0], 40.0)).unwrap();
    let step = largest_step(&levels, 0);
    assert!(step > 0.1 && step < 2.0 * undulation.rms_height, "{step}");
}

#[test]
fn levels_that_do_not_fit_around_one_another_are_refused() {
    let name = |coarse: Relief| match everything(5.0).build_two(&coarse) {
        Err(ReliefError::Parameter { name, .. }) => name,
        other => panic!("{other:?}"),
    };
    assert_eq!(name(Relief::flat(1, [600.0, 600.0], 7.5)), "coarse.region_size");
    assert_eq!(name(Relief::flat(1, [600.0, 600.0], 5.0)), "coarse.region_size");
    assert_eq!(name(Relief::flat(1, [200.0, 600.0], 10.0)), "coarse.extent north");
    assert_eq!(name(Relief::flat(1, [600.0, 592.0], 8.0 * 5.0)), "extent east");
    // Half a region of 5 m too far: no coarse corner would lie on a fine one.
    assert_eq!(name(Relief::flat(1, [405.0, 405.0], 15.0)), "coarse.extent north");
}
