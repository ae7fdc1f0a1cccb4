//! The fit against closed forms: known banks, polynomials, walls, holes, threads.

use landscape::{CornerWords, Level};
use quantities::unit_interval;
use survey::{Affine, Area, Elevation, Frame, Stiffness, Survey, SurveyError, SurveyOptions, survey};

/// Heights of `height(north, east)` on a grid of spacing 1 m, line 0 in the south.
fn ground(lines: usize, columns: usize, height: impl Fn(f64, f64) -> f64) -> Elevation {
    let at = |index: usize| height((index / columns) as f64, (index % columns) as f64);
    let heights = (0..lines * columns).map(at).collect();
    let affine = Affine { first: [0.0; 2], step: [1.0; 2] };
    Elevation::new(lines, columns, heights, affine, Frame::Plane(None))
}

fn fitted(elevation: &Elevation, options: &SurveyOptions) -> Survey {
    survey(elevation, options, &mut |_| {}).unwrap()
}

/// All samples used, next to no smoothing.
fn exact(region_size: f64) -> SurveyOptions {
    let mut options = SurveyOptions::new(region_size);
    options.held_out = 0.0;
    options.stiffness.smoothing = 1e-4;
    options.tolerance = 1e-14;
    options
}

fn random_level(regions: usize, size: f64) -> Level {
    let words: Vec<CornerWords> = (0..(regions + 1) * (regions + 1))
        .map(|corner| {
            std::array::from_fn(|word| 20.0 * unit_interval(5, &[corner as u64, word as u64]) - 10.0)
        })
        .collect();
    Level::new(size, [0.0; 2], [regions + 1; 2], words).unwrap()
}

fn height_of(level: &Level, north: f64, east: f64) -> f64 {
    let (region, local) = level.locate(north, east).unwrap();
    level.height_and_slopes(region, local)[0]
}

#[test]
fn a_known_bank_comes_back() {
    let level = random_level(5, 16.0);
    let elevation = ground(81, 81, |north, east| height_of(&level, north, east) - 1100.0);
    let found = fitted(&elevation, &exact(16.0));
    let report = &found.report.levels[0];
    assert!(report.rms < 1e-9 * 1100.0, "{report:#?}");
    for (found, expected) in found.bank.finest().words().iter().zip(level.words()) {
        for word in 0..9 {
            let expected = expected[word] - if word == 0 { 1100.0 } else { 0.0 };
            assert!((found[word] - expected).abs() < 1e-6, "{found:?} {expected:?}");
        }
    }
}

#[test]
fn polynomials_of_degree_five_are_reproduced() {
    for (p, q) in [(5, 0), (0, 5), (5, 5), (3, 4), (1, 1), (0, 0)] {
        let power = |x: f64, n: usize| (0..n).map(|_| x).product::<f64>();
        let height = |north: f64, east: f64| 7.0 * power(north / 30.0 - 1.0, p) * power(east / 30.0 - 1.0, q);
        let found = fitted(&ground(61, 61, height), &exact(20.0));
        let report = &found.report.levels[0];
        assert!(report.worst.residual.abs() < 1e-7, "x^{p} y^{q}: {report:#?}");
        // Also between the samples.
        let at = |x: f64, y: f64| height_of(found.bank.finest(), x, y) - height(x, y);
        assert!(at(33.3, 18.7).abs() < 1e-7 && at(0.25, 59.75).abs() < 1e-7, "x^{p} y^{q}");
    }
}

#[test]
fn default_smoothing_hardly_touches_waves_of_four_regions() {
    let wave = |north: f64, east: f64| 5.0 * libm::sin(north * 0.157) * libm::cos(east * 0.157);
    let report = &fitted(&ground(101, 101, wave), &SurveyOptions::new(10.0)).report;
    assert!(report.levels[0].rms < 2e-3, "{report:#?}");
}

#[test]
fn threads_do_not_change_a_bit() {
    let rough = |north: f64, east: f64| {
        if north > 20.0 && north < 40.0 && east > 10.0 && east < 30.0 {
            return f64::NAN;
        }
        8.0 * unit_interval(2, &[(north / 3.0) as u64, (east / 3.0) as u64])
    };
    let elevation = ground(97, 83, rough);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mut options = SurveyOptions::new(7.0);
        options.levels = vec![1, 3];
        pool.install(|| fitted(&elevation, &options))
    };
    let (one, two) = (with(1), with(2));
    assert_eq!(one.bank, two.bank);
    assert_eq!(format!("{:?}", one.report), format!("{:?}", two.report));
    assert!(one.residuals.values.iter().zip(&two.residuals.values).all(|(a, b)| a.to_bits() == b.to_bits()));
}

/// Regions of 10 m, a disc without data six regions wide in a field of rough ground.
#[test]
fn a_hole_of_six_regions_stays_smooth_and_bounded() {
    let rough = |north: f64, east: f64| {
        let wave = |k: u64| {
            let turn = std::f64::consts::TAU * unit_interval(9, &[k]);
            let length = 8.0 * libm::pow(1.6, (k % 7) as f64);
            let along = north * libm::cos(turn) + east * libm::sin(turn);
            0.05 * length * libm::sin(std::f64::consts::TAU * along / length + 40.0 * turn)
        };
        0.2 * north + (0..21).map(wave).sum::<f64>()
    };
    let hole = |north: f64, east: f64| {
        let (a, b) = (north - 103.0, east - 98.0);
        if a * a + b * b < 900.0 { f64::NAN } else { rough(north, east) }
    };
    let report = fitted(&ground(201, 201, hole), &SurveyOptions::new(10.0)).report;
    let level = &report.levels[0];
    let inside = level.in_voids.unwrap();
    println!("data {:?}, in the hole {inside:?}, ground slope {:.3}", report.height, level.slope);
    let [low, high] = report.height;
    assert!(inside.regions >= 12, "{inside:?}");
    assert!(inside.height[0] > low && inside.height[1] < high, "{inside:?} against {low} {high}");
    assert!(inside.slope < 2.0, "{inside:?}");
    assert!(level.condition_of_voids < 30.0 && level.iterations < 60, "{level:#?}");
}

#[test]
fn samples_beside_a_void_outweigh_what_fills_it() {
    let bowl = |north: f64, east: f64| {
        let (a, b) = (north - 50.0, east - 50.0);
        if a * a + b * b < 400.0 { f64::NAN } else { 0.02 * (a * a + b * b) }
    };
    let rms = |filled_weight: f64| {
        let mut options = SurveyOptions::new(10.0);
        options.held_out = 0.0;
        options.stiffness.filled_weight = filled_weight;
        fitted(&ground(101, 101, bowl), &options).report.levels[0].rms
    };
    let (default, equal) = (rms(Stiffness::default().filled_weight), rms(1.0));
    assert!(default < 0.7 * equal, "{default} against {equal}");
}

/// Wall of 80 deg around a plateau: the fit rings a little and stays whole.
#[test]
fn a_plateau_with_a_steep_wall_is_kept() {
    let plateau = |north: f64, east: f64| {
        let (a, b) = (north - 80.0, east - 80.0);
        let outside = (a * a + b * b).sqrt() - 40.0;
        (-outside * 5.671).clamp(0.0, 30.0)
    };
    let found = fitted(&ground(161, 161, plateau), &SurveyOptions::new(8.0));
    let level = &found.report.levels[0];
    println!(
        "rms {:.3}, worst {:?}, heights {:?}, slope {:.2}",
        level.rms, level.worst, level.height, level.slope
    );
    assert!(level.height[0] > -5.0 && level.height[1] < 35.0, "{level:#?}");
    assert!(level.slope > 3.0 && level.slope < 9.0, "{level:#?}");
    // Two regions from the wall the ground is flat again.
    assert!((height_of(found.bank.finest(), 80.0, 80.0) - 30.0).abs() < 0.05);
    assert!(height_of(found.bank.finest(), 8.0, 80.0).abs() < 0.05);
}

#[test]
fn a_plane_is_kept_through_holes_and_ragged_edges() {
    let plane = |north: f64, east: f64| 4.0 + 0.3 * north - 0.7 * east;
    let torn = |north: f64, east: f64| {
        if north + east < 30.0 || (north - 50.0).abs() < 9.0 { f64::NAN } else { plane(north, east) }
    };
    let found = fitted(&ground(94, 77, torn), &SurveyOptions::new(9.0));
    let level = found.bank.finest();
    for (north, east) in [(2.0, 3.0), (50.0, 40.0), (93.0, 76.0), (98.0, 80.0)] {
        assert!((height_of(level, north, east) - plane(north, east)).abs() < 1e-6, "{north} {east}");
    }
}

#[test]
fn held_out_samples_are_not_seen() {
    // White noise: samples held out scatter as the noise, used ones less, for the fit follows them.
    let noise = |north: f64, east: f64| unit_interval(4, &[north as u64, east as u64]) - 0.5;
    let mut options = SurveyOptions::new(4.0);
    options.held_out = 0.2;
    let level = fitted(&ground(120, 120, noise), &options).report.levels.remove(0);
    let share = level.held_out as f64 / (level.held_out + level.used) as f64;
    assert!((share - 0.2).abs() < 0.02, "{share}");
    let sigma = (1.0 / 12.0_f64).sqrt();
    assert!(level.held_out_rms.unwrap() > sigma, "{level:#?}");
    assert!(level.rms < 0.8 * sigma, "{level:#?}");
}

#[test]
fn levels_share_origin_and_data() {
    let hill = |north: f64, east: f64| 3.0 * libm::sin(north / 25.0) + 2.0 * libm::cos(east / 30.0);
    let mut options = SurveyOptions::new(10.0);
    options.levels = vec![1, 2, 5];
    let found = fitted(&ground(123, 95, hill), &options);
    let sizes: Vec<f64> = found.bank.levels().iter().map(Level::region_size).collect();
    assert_eq!(sizes, [10.0, 20.0, 50.0]);
    for level in found.bank.levels() {
        assert_eq!(level.origin(), [0.0; 2]);
        assert!(level.extent()[2] >= 122.0 && level.extent()[3] >= 94.0);
        assert!((height_of(level, 61.0, 47.0) - hill(61.0, 47.0)).abs() < 0.05);
    }
}

#[test]
fn lines_from_north_to_south_are_turned() {
    let heights = (0..40 * 30).map(|index| (39 - index / 30) as f64 + 0.1 * (index % 30) as f64).collect();
    let affine = Affine { first: [5039.0, -200.0], step: [-1.0, 1.0] };
    let elevation = Elevation::new(40, 30, heights, affine, Frame::Plane(None));
    let mut options = exact(5.0);
    options.area = Area::Metres { south: 5010.0, west: -190.0, north: 5030.0, east: -175.0 };
    let found = fitted(&elevation, &options);
    assert!((height_of(found.bank.finest(), 0.0, 0.0) - 11.0).abs() < 1e-6);
    assert!((height_of(found.bank.finest(), 20.0, 15.0) - 32.5).abs() < 1e-6);
    let worst = found.report.levels[0].worst;
    assert!(worst.in_file[0] >= 9 && worst.in_file[0] <= 29, "{worst:?}");
    assert_eq!(found.report.samples, [21, 16]);
}

#[test]
fn unusable_options_are_refused() {
    let flat = ground(30, 30, |_, _| 1.0);
    let refused = |change: &dyn Fn(&mut SurveyOptions)| {
        let mut options = SurveyOptions::new(5.0);
        change(&mut options);
        survey(&flat, &options, &mut |_| {}).unwrap_err()
    };
    assert!(matches!(
        refused(&|o| o.region_size = f64::NAN),
        SurveyError::Option { option: "region size", .. }
    ));
    assert!(matches!(refused(&|o| o.region_size = 31.0), SurveyError::Option { option: "region size", .. }));
    assert!(matches!(refused(&|o| o.region_size = 1e-3), SurveyError::TooManyRegions { .. }));
    assert!(matches!(refused(&|o| o.levels = vec![2, 4]), SurveyError::Option { option: "levels", .. }));
    assert!(matches!(refused(&|o| o.held_out = 0.9), SurveyError::Option { .. }));
    assert!(matches!(refused(&|o| o.tolerance = 0.0), SurveyError::Option { .. }));
    let hard = Stiffness { smoothing: -1.0, ..Stiffness::default() };
    assert!(matches!(refused(&|o| o.stiffness = hard), SurveyError::Option { option: "smoothing", .. }));
    let outside = Area::Metres { south: 10.0, west: 0.0, north: 50.0, east: 20.0 };
    assert!(matches!(refused(&|o| o.area = outside), SurveyError::AreaOutside { .. }));
    let empty = Area::Metres { south: 10.0, west: 0.0, north: f64::NAN, east: 20.0 };
    assert!(matches!(refused(&|o| o.area = empty), SurveyError::AreaOutside { .. }));
    let centre = Area::Centred { latitude: 0.0, longitude: 0.0, size: [10.0; 2], plane: Default::default() };
    assert!(matches!(refused(&|o| o.area = centre), SurveyError::AreaKind { .. }));
    let void = ground(30, 30, |_, _| f64::NAN);
    let all_void = survey(&void, &SurveyOptions::new(5.0), &mut |_| {});
    assert!(matches!(all_void, Err(SurveyError::AllVoid { .. })));
}

#[test]
fn more_coefficients_than_samples_is_said() {
    let hill = |north: f64, east: f64| 3.0 * libm::sin(north / 15.0) + 2.0 * libm::cos(east / 20.0);
    let found = fitted(&ground(41, 41, hill), &SurveyOptions::new(2.0));
    assert!(
        found.report.warnings.iter().any(|w| w.contains("coefficients for")),
        "{:?}",
        found.report.warnings
    );
    assert!(found.report.levels[0].rms < 0.01, "{:#?}", found.report);
}
