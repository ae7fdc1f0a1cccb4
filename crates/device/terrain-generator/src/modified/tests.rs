use super::{ModifiedTerrainGenerator, Overlap};
use crate::programs::program;
use crate::{OUT_OF_SIGHT, Profile, TerrainGenerator};
use hardware_model::BlendWeight;
use landscape::{Level, Photometry, Sun, SweepLight};
use signal::LANES;
use sweep_program::SweepProgram;

const EYE: [f64; 2] = [310.0, 290.0];
/// Height of the eye (m).
const DATUM: f64 = 3.5;
const SUN: Sun = Sun { azimuth: 1.0, elevation: 0.3 };

/// Derivatives 0 to 2 of three cubics, products of which are the ground.
fn cubics(z: f64) -> [[f64; 3]; 2] {
    let z = z / 1000.0;
    [
        [z * z * z - z, (3.0 * z * z - 1.0) / 1e3, 6.0 * z / 1e6],
        [0.5 + z * (2.0 - z), (2.0 - 2.0 * z) / 1e3, -2.0 / 1e6],
    ]
}

/// `h = 20 p(x) q(y) + 9 q(x) p(y)` and its derivatives, index `3 p + q`.
fn ground([x, y]: [f64; 2]) -> [f64; 9] {
    let ([px, qx], [py, qy]) = (cubics(x), cubics(y));
    std::array::from_fn(|k| 20.0 * px[k / 3] * qy[k % 3] + 9.0 * qx[k / 3] * py[k % 3])
}

/// That ground, raised by `lift`, on a level.
fn level(region_size: f64, corners: usize, lift: f64) -> Level {
    let words = (0..corners * corners).map(|index| {
        let place = [index / corners, index % corners].map(|k| k as f64 * region_size);
        let mut words = Level::scale_words(&ground(place), region_size);
        words[0] += lift;
        words
    });
    Level::new(region_size, [0.0; 2], [corners; 2], words.collect()).unwrap()
}

fn direction(lane: usize) -> [f64; 2] {
    let (sin, cos) = quantities::sin_cos(0.2 + 0.17 * lane as f64);
    [cos, sin]
}

fn ranges() -> Vec<f64> {
    (1..=1100).map(f64::from).collect()
}

/// Light of a place that is seen under `sight` along a sweep.
fn shade(slopes: [f64; 2], [cos, sin]: [f64; 2], sight: f64) -> f64 {
    let slant = (1.0 + sight * sight).sqrt();
    SUN.shade(slopes, [-cos, -sin, -sight].map(|part| part / slant), Photometry::LunarLambert)
}

struct Scene {
    levels: [Level; 2],
    ranges: Vec<f64>,
    programs: [[SweepProgram; LANES]; 2],
    light: [SweepLight; LANES],
}

impl Scene {
    /// A fine level of 1600 m in regions of 100 m, a coarse one of 2400 m in regions of 400 m, `lift` higher.
    fn new(lift: f64) -> Self {
        let (levels, ranges) = ([level(100.0, 17, 0.0), level(400.0, 7, lift)], ranges());
        let of = |level: &Level| std::array::from_fn(|lane| program(level, EYE, direction(lane), &ranges));
        let light =
            std::array::from_fn(|lane| SweepLight::new(&SUN, 0.8, Photometry::LunarLambert, direction(lane)));
        let programs = levels.each_ref().map(of);
        Self { levels, ranges, programs, light }
    }

    fn generator(&self, level: usize) -> TerrainGenerator<'_> {
        let level = &self.levels[level];
        let (buffer, region_size) = (level.words(), level.region_size());
        TerrainGenerator { buffer, region_size, ranges: &self.ranges, datum: DATUM }
    }

    fn alone(&self, level: usize) -> Profile<f64> {
        let mut profile = Profile::default();
        self.generator(level).run(&self.programs[level], &self.light, &mut profile);
        profile
    }

    fn run(&self, switch: [f64; LANES], blend: f64) -> (Profile<f64>, f64) {
        let [fine, coarse] = [0, 1].map(|level| self.generator(level));
        let both =
            ModifiedTerrainGenerator { fine, coarse, blend, weight: BlendWeight::Quintic, slope_term: true };
        let (mut profile, mut overlap) = (Profile::default(), Overlap::default());
        let [fine, coarse] = &self.programs;
        // Twice: what the buffers held must not matter.
        for _ in 0..2 {
            both.run(fine, coarse, &[f64::INFINITY; LANES], &self.light, &mut profile, &mut overlap);
        }
        let step = both.run(fine, coarse, &switch, &self.light, &mut profile, &mut overlap);
        (profile, step)
    }
}

fn far_apart(a: &Profile<f64>, b: &Profile<f64>) -> f64 {
    let signals = [(&a.height, &b.height), (&a.along, &b.along), (&a.across, &b.across)];
    let both = signals.into_iter().chain([(&a.reflectivity, &b.reflectivity)]);
    let lanes = both.flat_map(|(a, b)| a.iter().zip(b).flat_map(|(a, b)| a.0.into_iter().zip(b.0)));
    lanes.fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs()))
}

#[test]
fn one_ground_on_two_levels_is_one_profile() {
    let scene = Scene::new(0.0);
    let fine = scene.alone(0);
    for (sample, &range) in scene.ranges.iter().enumerate() {
        for lane in 0..LANES {
            let [cos, sin] = direction(lane);
            let words = ground([EYE[0] + cos * range, EYE[1] + sin * range]);
            assert!((fine.height[sample][lane] - (words[0] - DATUM)).abs() < 1e-11);
            assert!((fine.along[sample][lane] - (words[3] * cos + words[1] * sin)).abs() < 1e-13);
            assert!((fine.across[sample][lane] - (words[1] * cos - words[3] * sin)).abs() < 1e-13);
            let shade = 0.8 * shade([words[3], words[1]], [cos, sin], (words[0] - DATUM) / range);
            assert!((fine.reflectivity[sample][lane].max(0.0) - shade).abs() < 1e-6);
        }
    }
    for blend in [0.0, 150.0] {
        let (joined, step) = scene.run(std::array::from_fn(|lane| 500.0 + 20.5 * lane as f64), blend);
        assert!(far_apart(&joined, &fine) < 1e-11);
        assert!(step < 1e-11, "{step}");
    }
}

#[test]
fn without_a_blend_both_signals_switch_within_one_sample() {
    let scene = Scene::new(2.5);
    let (fine, coarse) = (scene.alone(0), scene.alone(1));
    let (joined, step) = scene.run(std::array::from_fn(|lane| 400.0 + 50.0 * lane as f64), 0.0);
    assert!((step - 2.5).abs() < 1e-11);
    for (sample, &range) in scene.ranges.iter().enumerate() {
        for lane in 0..LANES {
            let expected = if range <= 400.0 + 50.0 * lane as f64 { &fine } else { &coarse };
            assert!((joined.height[sample][lane] - expected.height[sample][lane]).abs() < 1e-11);
            assert!((joined.reflectivity[sample][lane] - expected.reflectivity[sample][lane]).abs() < 1e-11);
        }
    }
}

/// Lift of 2.5 m over 200 m: height and slope without a jump, slope the derivative of height.
#[test]
fn a_blend_is_smooth() {
    let scene = Scene::new(2.5);
    let (fine, coarse) = (scene.alone(0), scene.alone(1));
    let (joined, step) = scene.run([600.0; LANES], 200.0);
    assert!((step - 2.5).abs() < 1e-11);
    // Slope of the smooth-step is at most 15/8, its bend at most 5.78.
    let (steepest, sharpest) = (1.875 * 2.5 / 200.0, 5.78 * 2.5 / 4e4);
    for lane in 0..LANES {
        let at = |sample: usize| {
            let lift = joined.height[sample][lane] - fine.height[sample][lane];
            [lift, joined.along[sample][lane] - fine.along[sample][lane]]
        };
        for sample in 1..1099 {
            let ([before, slope_before], [lift, slope], [after, _]) =
                (at(sample - 1), at(sample), at(sample + 1));
            assert!((-1e-11..=2.5 + 1e-11).contains(&lift));
            assert!(slope <= steepest + 1e-11 && (slope - slope_before).abs() <= sharpest + 1e-11);
            assert!((0.5 * (after - before) - slope).abs() < 2e-5, "sample {sample}: {slope}");
        }
        assert_eq!(joined.height[399][lane], fine.height[399][lane]);
        assert!((joined.height[599][lane] - coarse.height[599][lane]).abs() < 1e-11);
    }
}

#[test]
fn each_level_alone_is_its_generator_alone() {
    let scene = Scene::new(2.5);
    let (joined, step) = scene.run([f64::INFINITY; LANES], 300.0);
    // The fine profile reaches beyond the last sample in no lane: all end within 1100 m or show all of it.
    assert_eq!(scene.alone(0).height[1000], joined.height[1000]);
    assert_eq!(step, 0.0);
    let (joined, step) = scene.run([0.5; LANES], 0.0);
    assert_eq!(far_apart(&joined, &scene.alone(1)), 0.0);
    assert_eq!(step, 0.0);
}

#[test]
fn ends_of_either_profile_are_respected() {
    let mut scene = Scene::new(2.5);
    scene.programs[0][3].end_range = 350.25;
    scene.programs[1][5].end_range = 420.0;
    let (fine, coarse) = (scene.alone(0), scene.alone(1));
    let (joined, step) = scene.run([500.0; LANES], 100.0);
    assert!((step - 2.5).abs() < 1e-11);
    // The fine ground of lane 3 ends at 350.25 m: it goes over there.
    assert_eq!(joined.height[249][3], fine.height[249][3]);
    assert!((joined.height[350][3] - coarse.height[350][3]).abs() < 1e-11);
    // The coarse ground of lane 5 ends before the switch: it stays fine.
    assert!(joined.height.iter().zip(&fine.height).all(|(joined, fine)| joined[5] == fine[5]));
    assert!(joined.height.iter().all(|height| height.0.iter().all(|&height| height != OUT_OF_SIGHT)));
}

/// Height and slope along the sweep, at 400 to 600 m, of planes that rise along it: `[height, slope]` of both levels at `range`.
fn blended_planes(planes: [[f64; 2]; 2], range: f64, weight: BlendWeight, slope_term: bool) -> [f64; 2] {
    const FOOT: [f64; 2] = [103.0, 611.0];
    let [cos, sin] = direction(0);
    let plane = |[height, slope]: [f64; 2], region_size: f64, corners: usize| {
        let words = (0..corners * corners).map(|index| {
            let [north, east] = [index / corners, index % corners].map(|k| k as f64 * region_size);
            let along = (north - FOOT[0]) * cos + (east - FOOT[1]) * sin;
            let mut words = [0.0; 9];
            words[0] = height + slope * (along - range);
            (words[3], words[1]) = (slope * cos * region_size, slope * sin * region_size);
            words
        });
        Level::new(region_size, [0.0; 2], [corners; 2], words.collect()).unwrap()
    };
    let levels = [plane(planes[0], 100.0, 13), plane(planes[1], 400.0, 4)];
    let ranges: Vec<f64> = (1..=1000).map(f64::from).collect();
    let light = std::array::from_fn(|_| SweepLight::new(&SUN, 0.8, Photometry::Lambert, [cos, sin]));
    let programs =
        levels.each_ref().map(|level| std::array::from_fn(|_| program(level, FOOT, [cos, sin], &ranges)));
    let [fine, coarse] = levels.each_ref().map(|level| TerrainGenerator {
        buffer: level.words(),
        region_size: level.region_size(),
        ranges: &ranges,
        datum: 0.0,
    });
    let both = ModifiedTerrainGenerator { fine, coarse, blend: 200.0, weight, slope_term };
    let (mut profile, mut overlap) = (Profile::<f64>::default(), Overlap::default());
    both.run(&programs[0], &programs[1], &[600.0; LANES], &light, &mut profile, &mut overlap);
    let sample = range as usize - 1;
    for lane in 0..LANES {
        assert!(profile.across[sample][lane].abs() < 1e-12, "the slope across has no third product");
    }
    [profile.height[sample][3], profile.along[sample][3]]
}

/// Check values of the terrain builder's specification (its table 9.5), by both weights.
#[test]
fn a_blend_has_the_heights_and_slopes_of_its_law() {
    let (quintic, cubic) = (BlendWeight::Quintic, BlendWeight::Cubic);
    for (weight, range, height, slope) in [
        (quintic, 400.0, 12.4, 0.031),
        (quintic, 450.0, 12.317_187_5, 0.026_367_187_5),
        (quintic, 500.0, 12.0, 0.0215),
        (quintic, 600.0, 11.6, 0.027),
        (cubic, 400.0, 12.4, 0.031),
        (cubic, 450.0, 12.275, 0.025_875),
        (cubic, 500.0, 12.0, 0.023),
        (cubic, 575.0, 11.634_375, 0.024_546_875),
        (cubic, 600.0, 11.6, 0.027),
    ] {
        let found = blended_planes([[12.4, 0.031], [11.6, 0.027]], range, weight, true);
        assert!((found[0] - height).abs() < 1e-11, "{range} m: {found:?}");
        assert!((found[1] - slope).abs() < 1e-12, "{range} m: {found:?}");
    }
}

/// Slopes mixed as heights are: what is missing is `s' (h_coarse - h_fine)`, 15/8 of the mean rate in the middle.
#[test]
fn without_its_slope_term_a_blend_has_the_slope_of_neither_ground() {
    for (range, rate) in
        [(400.0, 0.0), (450.0, 30.0 / 256.0 * 9.0 / 200.0), (500.0, 1.875 / 200.0), (600.0, 0.0)]
    {
        let planes = [[12.4, 0.031], [11.6, 0.027]];
        let [with, without] =
            [true, false].map(|term| blended_planes(planes, range, BlendWeight::Quintic, term));
        assert_eq!(with[0], without[0], "{range} m: heights are blended either way");
        let missing = without[1] - with[1];
        assert!((missing - 0.8 * rate).abs() < 1e-12, "{range} m: {missing}");
    }
}
