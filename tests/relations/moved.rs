//! The same scene elsewhere, larger, higher, mirrored, in another order: bit for bit, or to rounding.

use generator::{PlaneKind, Planes};
use landscape::{CornerWords, Level};
use lunoid_tests::{ComparedScene, Drawn, level_of, random};
use machine::Prepare;
use quantities::radians;
use scenario::{Curvature, Scalar};
use signal::Probe;

const SEEDS: std::ops::Range<u64> = 3000..3016;
const SCALARS: [Scalar; 2] = [Scalar::F32, Scalar::F64];

pub fn draw(scene: &ComparedScene) -> Drawn {
    scene.draw(1, &["*"]).unwrap()
}

/// Random ground on lengths that double precision holds exactly, with the eye in the middle of it: sums and
/// differences of places are exact, and no sweep leaves the problem area.
pub fn dyadic(seed: u64) -> ComparedScene {
    let mut scene = random::scene(seed);
    let old = &scene.level;
    let [north, east] = old.corners();
    let words = old.words().to_vec();
    let scale = 256.0 / old.region_size();
    scene.level =
        level_of(256.0, [1024.0, -512.0], [north, east], |m, n| words[m * east + n].map(|w| w * scale));
    let place = |axis: usize| {
        let regions = 0.5 * (scene.level.corners()[axis] - 1) as f64 + 0.171875 * axis as f64;
        scene.level.origin()[axis] + 256.0 * regions + 3.25
    };
    let (x, y) = (place(0), place(1));
    scene.stand(x, y, 12.0);
    scene.eye[2] = scene.eye[2].ceil();
    let reach = north.min(east) as f64 - 1.0;
    scene.range.end = 256.0 * (0.5 * reach - 0.2).max(0.3);
    scene.range.start = scene.range.end / 512.0;
    scene.laws.curvature = Curvature::None;
    scene
}

pub fn assert_same_bits(a: &Drawn, b: &Drawn, what: &str) {
    let bits = |drawn: &Drawn| drawn.picture.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
    assert!(bits(a) == bits(b), "{what}: pictures differ");
    assert_eq!(a.counts, b.counts, "{what}");
    assert_eq!(a.waveforms.len(), b.waveforms.len(), "{what}");
    // The number of a corner is its place in the grid that is stored.
    let waves = a.waveforms.iter().zip(&b.waveforms);
    for (a, b) in waves.filter(|(a, _)| a.signal.unit != signal::Unit::Corner) {
        let same = a.values.iter().zip(&b.values).all(|(a, b)| a.to_bits() == b.to_bits());
        assert!(same, "{what}: {} of sweep {} differs", a.signal.name, a.sweep);
    }
}

/// Share of the pixels that differ by more than rounding.
fn share_that_differs(a: &[f32], b: &[f32]) -> f64 {
    let off = a.iter().zip(b).filter(|(a, b)| (*a - *b).abs() > 1e-5).count();
    off as f64 / a.len() as f64
}

#[test]
fn moving_ground_and_eye_by_an_even_number_of_regions() {
    for seed in SEEDS {
        for scalar in SCALARS {
            let here = ComparedScene { scalar, ..dyadic(seed) };
            let there = ComparedScene { level: padded(&here.level, [2, 4]), ..moved(&here, [512.0, 1024.0]) };
            assert_same_bits(
                &draw(&here),
                &draw(&there),
                &format!("seed {seed}, {scalar:?}, moved in the lattice"),
            );
            let [x, y] = here.level.origin();
            let elsewhere = level_like(&here.level, here.level.region_size(), [x - 512.0, y + 2048.0], |w| w);
            let there = ComparedScene { level: elsewhere, ..moved(&here, [-512.0, 2048.0]) };
            assert_same_bits(
                &draw(&here),
                &draw(&there),
                &format!("seed {seed}, {scalar:?}, moved with its origin"),
            );
        }
    }
}

fn moved(scene: &ComparedScene, [north, east]: [f64; 2]) -> ComparedScene {
    let [x, y, h] = scene.eye;
    ComparedScene { eye: [x + north, y + east, h], ..scene.clone() }
}

/// The same ground with more regions to the south and west, so that every index grows.
fn padded(level: &Level, by: [usize; 2]) -> Level {
    let [north, east] = level.corners();
    level_of(level.region_size(), level.origin(), [north + by[0], east + by[1]], |m, n| {
        let (m, n) = (m.saturating_sub(by[0]), n.saturating_sub(by[1]));
        level.words()[m * east + n]
    })
}

fn level_like(
    level: &Level,
    size: f64,
    origin: [f64; 2],
    change: impl Fn(CornerWords) -> CornerWords,
) -> Level {
    let [north, east] = level.corners();
    level_of(size, origin, [north, east], |m, n| change(level.words()[m * east + n]))
}

#[test]
fn scaling_all_lengths_by_a_power_of_two() {
    for seed in SEEDS {
        for scalar in SCALARS {
            let small = ComparedScene { scalar, ..dyadic(seed) };
            let origin = small.level.origin().map(|length| 8.0 * length);
            let level = level_like(&small.level, 8.0 * 256.0, origin, |words| words.map(|word| 8.0 * word));
            let mut large =
                ComparedScene { level, eye: small.eye.map(|length| 8.0 * length), ..small.clone() };
            large.range.start *= 8.0;
            large.range.end *= 8.0;
            if let scenario::RangeLaw::TwoRate { switch, .. } = &mut large.range.law {
                *switch *= 8.0;
            }
            let (small, mut large) = (draw(&small), draw(&large));
            for wave in large.waveforms.iter_mut().filter(|wave| wave.signal.unit == signal::Unit::Metre) {
                wave.values.iter_mut().for_each(|value| *value /= 8.0);
            }
            assert_same_bits(&small, &large, &format!("seed {seed}, {scalar:?}"));
        }
    }
}

#[test]
fn any_number_of_threads() {
    for seed in SEEDS {
        let mut scene = random::scene(seed);
        scene.sweeps = 61;
        scene.scalar = Scalar::F32;
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| draw(&scene))
        };
        let one = with(1);
        for threads in [2, 3] {
            assert_same_bits(&one, &with(threads), &format!("seed {seed}, {threads} threads"));
        }
    }
}

#[test]
fn frames_in_any_order_or_alone() {
    for seed in SEEDS {
        let mut scene = random::scene(seed);
        scene.loader.access = 25;
        scene.master_hz = 200_000;
        let session = scene.stage().prepare();
        let frame = |frame: u64| {
            let mut pose = scene.pose();
            pose.attitude.heading += radians(7.0) * frame as f64;
            let kinds = [PlaneKind::Intensity];
            let mut planes = Planes::new(scene.sweeps as usize, scene.lines as usize, &kinds);
            let counts = session.frame(frame, &pose, &mut planes, &mut Probe::off()).unwrap();
            let alone = scene.stage().prepare();
            let mut planes_alone = Planes::new(scene.sweeps as usize, scene.lines as usize, &kinds);
            let counts_alone = alone.frame(frame, &pose, &mut planes_alone, &mut Probe::off()).unwrap();
            assert_eq!((counts, &planes), (counts_alone, &planes_alone), "seed {seed}, frame {frame} alone");
            planes
        };
        let forwards: Vec<_> = (0..4).map(frame).collect();
        let backwards: Vec<_> = (0..4).rev().map(frame).collect();
        assert!(forwards.iter().eq(backwards.iter().rev()), "seed {seed}");
    }
}

#[test]
fn probing_changes_nothing() {
    for seed in SEEDS {
        let scene = random::scene(seed);
        let probed = draw(&scene);
        let blind = scene.draw(1, &[]).unwrap();
        assert_eq!((&probed.picture, probed.counts), (&blind.picture, blind.counts), "seed {seed}");
        let some = scene.draw(1, &["tg.*"]).unwrap();
        assert!(some.waveforms.len() < probed.waveforms.len());
        for wave in &some.waveforms {
            assert!(probed.waveforms.contains(wave), "seed {seed}: {} alone", wave.signal.name);
        }
    }
}

#[test]
fn adding_a_height_to_everything() {
    for seed in SEEDS {
        let low = random::scene(seed);
        let raise = |mut words: CornerWords| {
            words[0] += 64.0;
            words
        };
        let level = level_like(&low.level, low.level.region_size(), low.level.origin(), raise);
        let high = ComparedScene { level, eye: [low.eye[0], low.eye[1], low.eye[2] + 64.0], ..low.clone() };
        let (low, high) = (draw(&low), draw(&high));
        assert!(share_that_differs(&low.picture, &high.picture) == 0.0, "seed {seed}");
    }
}

/// `scene` over the reflected map, which begins at the origin; eye, heading and sun are still to be reflected.
fn reflected(
    scene: &ComparedScene,
    corner: impl Fn(usize, usize) -> CornerWords,
    corners: [usize; 2],
) -> ComparedScene {
    ComparedScene { level: level_of(scene.level.region_size(), [0.0; 2], corners, corner), ..scene.clone() }
}

/// The picture with left and right exchanged.
fn mirrored(picture: &[f32], columns: usize) -> Vec<f32> {
    picture.chunks(columns).flat_map(|row| row.iter().rev().copied()).collect()
}

/// Draws the reflection of each seed's scene; at least half of the pictures must not be their own images, or the
/// relation says nothing.
fn check_reflection(reflection: impl Fn(&ComparedScene) -> ComparedScene) {
    let mut lopsided = 0;
    for seed in SEEDS {
        let scene = random::scene(seed);
        let (picture, image) = (draw(&scene).picture, draw(&reflection(&scene)).picture);
        let share = share_that_differs(&picture, &mirrored(&image, scene.sweeps as usize));
        assert!(share == 0.0, "seed {seed}: {share} of the pixels differ");
        lopsided += u32::from(share_that_differs(&picture, &image) > 0.0);
    }
    assert!(lopsided >= 8, "only {lopsided} pictures are not their own images");
}

#[test]
fn mirroring_north() {
    check_reflection(|scene| {
        let ([north, east], [_, west_edge, north_edge, _]) = (scene.level.corners(), scene.level.extent());
        let corner = |m: usize, n: usize| {
            let words = scene.level.words()[(north - 1 - m) * east + n];
            std::array::from_fn(|k| if k / 3 == 1 { -words[k] } else { words[k] })
        };
        let mut image = reflected(scene, corner, [north, east]);
        image.eye = [north_edge - scene.eye[0], scene.eye[1] - west_edge, scene.eye[2]];
        image.heading = radians(180.0) - scene.heading;
        image.sun.azimuth = radians(180.0) - scene.sun.azimuth;
        image
    });
}

#[test]
fn mirroring_east() {
    check_reflection(|scene| {
        let ([north, east], [south_edge, _, _, east_edge]) = (scene.level.corners(), scene.level.extent());
        let corner = |m: usize, n: usize| {
            let words = scene.level.words()[m * east + (east - 1 - n)];
            std::array::from_fn(|k| if k % 3 == 1 { -words[k] } else { words[k] })
        };
        let mut image = reflected(scene, corner, [north, east]);
        image.eye = [scene.eye[0] - south_edge, east_edge - scene.eye[1], scene.eye[2]];
        image.heading = -scene.heading;
        image.sun.azimuth = -scene.sun.azimuth;
        image
    });
}

#[test]
fn exchanging_north_and_east() {
    check_reflection(|scene| {
        let ([north, east], [south_edge, west_edge, ..]) = (scene.level.corners(), scene.level.extent());
        let corner = |m: usize, n: usize| {
            let words = scene.level.words()[n * east + m];
            std::array::from_fn(|k| words[3 * (k % 3) + k / 3])
        };
        let mut image = reflected(scene, corner, [east, north]);
        image.eye = [scene.eye[1] - west_edge, scene.eye[0] - south_edge, scene.eye[2]];
        image.heading = radians(90.0) - scene.heading;
        image.sun.azimuth = radians(90.0) - scene.sun.azimuth;
        image
    });
}

#[test]
fn a_faster_loader_is_never_later() {
    let mut some = false;
    for seed in SEEDS {
        let mut scene = random::scene(seed);
        scene.master_hz = 30 * u64::from(scene.sweeps * scene.samples);
        let late: Vec<u64> = [0, 1, 3, 10, 40]
            .into_iter()
            .map(|ticks| {
                scene.loader.access = ticks;
                draw(&scene).counts["late_words"]
            })
            .collect();
        assert!(late.is_sorted(), "seed {seed}: {late:?}");
        assert_eq!(late[0], 0, "seed {seed}: wired transfers are never late");
        some |= late[4] > 0;
    }
    assert!(some, "no loader was late in any scene");
}
