//! A second evaluator: one sampling point at a time, by crossing numbers in whole steps, from tables of its own.

use raster::{Pattern, Sampling, Screen};

use crate::random::Random;
use crate::{covered, triangle};

/// Offsets in 1/32 pixel, as they were published; halves for the lattice.
fn offsets(pattern: Pattern) -> Vec<[f64; 2]> {
    let of = |text: &str| {
        let numbers: Vec<f64> = text.split_whitespace().map(|word| word.parse().expect("a number")).collect();
        numbers.chunks(2).map(|pair| [pair[0], pair[1]]).collect()
    };
    let sixteen = "19 19 15 11 11 21 25 15 7 13 21 27 27 23 23 7 13 29 17 3 9 5 5 25 1 17 31 9 29 31 3 1";
    match pattern {
        Pattern::One => of("16 16"),
        Pattern::Four => of("12 4 28 12 4 20 20 28"),
        Pattern::Eight => of("18 10 14 22 26 18 10 6 6 26 2 14 22 30 30 2"),
        Pattern::Sixteen => of(sixteen),
        Pattern::OffCentre16 => of(sixteen).into_iter().map(|[x, y]: [f64; 2]| [x - 1.0, y - 1.0]).collect(),
        Pattern::Grid16 => {
            (0..16).map(|i| [8.0 * f64::from(i % 4) + 4.0, 8.0 * f64::from(i / 4) + 4.0]).collect()
        }
        Pattern::Lattice32 => (0..32).map(|k| [f64::from(k) + 0.5, f64::from(7 * k % 32) + 0.5]).collect(),
    }
}

/// Whole steps of 1/256 pixel: below 2^22 on the largest raster, so that products of two fit with room.
fn whole(pixels: f64) -> i64 {
    (pixels * 256.0 + 0.5).floor() as i64
}

/// Whether a ray from the point to the left crosses the outline an odd number of times. The point counts as one that lies a
/// trace to the right of where it is, and a lesser trace below: this is the top-left rule.
pub fn is_inside(corners: &[[f64; 2]; 3], point: [f64; 2]) -> bool {
    let [x, y] = point.map(whole);
    let mut crossings = 0;
    for i in 0..3 {
        let ([x1, y1], [x2, y2]) = (corners[i].map(whole), corners[(i + 1) % 3].map(whole));
        if (y1 <= y) != (y2 <= y) {
            // x1 + (y - y1) (x2 - x1) / (y2 - y1) <= x
            let (num, den) = ((y - y1) * (x2 - x1), y2 - y1);
            crossings += i32::from(if den > 0 { num <= (x - x1) * den } else { num >= (x - x1) * den });
        }
    }
    crossings % 2 == 1
}

/// Bits of the pixel's samples that a triangle covers.
fn bits(corners: &[[f64; 2]; 3], places: impl Iterator<Item = [f64; 2]>) -> u32 {
    places.enumerate().map(|(i, place)| u32::from(is_inside(corners, place)) << i).sum()
}

/// Holds a scene to the second evaluator, with the places of the samples of a pixel; returns how many are covered.
fn agree(
    size: [u32; 2],
    side: u32,
    scene: &[[[f64; 2]; 3]],
    sampling: &Sampling,
    places: impl Fn([i32; 2]) -> Vec<[f64; 2]>,
) -> usize {
    let screen = Screen::new(size, side).expect("a screen");
    let kept: Vec<_> = (0..scene.len()).filter(|&i| triangle(scene[i]).is_some()).collect();
    let triangles: Vec<_> = kept.iter().filter_map(|&i| triangle(scene[i])).collect();
    let mut found = covered(&screen, &triangles, sampling);
    found.sort_unstable();
    let mut expected = Vec::new();
    for pixel in (0..size[0]).flat_map(|x| (0..size[1]).map(move |y| [x, y])) {
        let places = places(pixel.map(|at| at as i32));
        for (number, &i) in kept.iter().enumerate() {
            let mask = bits(&scene[i], places.iter().copied());
            if mask != 0 {
                expected.push((pixel, number as u32, mask));
            }
        }
        let flat = (0..scene.len()).filter(|i| !kept.contains(i));
        flat.for_each(|i| assert_eq!(bits(&scene[i], places.iter().copied()), 0, "{:?}", scene[i]));
    }
    assert_eq!(found, expected, "{} on {size:?} by {side}", sampling.pattern().name());
    expected.iter().map(|(.., mask)| mask.count_ones() as usize).sum()
}

#[test]
fn a_thousand_random_scenes_agree_sample_by_sample() {
    let mut random = Random(36);
    let mut samples = 0;
    for scene in 0..1000 {
        let pattern = Pattern::ALL[scene % Pattern::ALL.len()];
        let size = [1 + random.below(40), 1 + random.below(40)];
        let side = if random.below(2) == 0 { 8 } else { 1 + random.below(8) };
        let triangles: Vec<_> = (0..1 + random.below(20)).map(|_| random.triangle(40.0)).collect();
        let table = offsets(pattern);
        let places = |pixel: [i32; 2]| {
            let place = |[x, y]: &[f64; 2]| [f64::from(pixel[0]) + x / 32.0, f64::from(pixel[1]) + y / 32.0];
            table.iter().map(place).collect()
        };
        samples += agree(size, side, &triangles, &Sampling::new(pattern), places);
        if let Some(turned) = Sampling::turned(pattern) {
            samples += agree(size, side, &triangles, &turned, |pixel| turned.places(pixel).collect());
        }
    }
    assert!(samples > 5_000_000, "only {samples} samples were covered");
}

#[test]
fn corners_of_the_largest_raster_are_exact() {
    let (low, high) = (-8.0, 8200.0);
    let scene = [
        [[low, low], [high, low], [low, high]],
        [[low, high], [high, low], [high, high]],
        [[low, low], [high, high - 1.0 / 256.0], [high, high]],
    ];
    let triangles = scene.map(|corners| triangle(corners).expect("an area"));
    let screen = Screen::new([8192, 8192], 8).expect("a screen");
    let mut coverage = raster::Coverage::default();
    for pattern in Pattern::ALL {
        let sampling = Sampling::new(pattern);
        for place in [[0, 0], [1023, 0], [0, 1023], [512, 511], [511, 512], [1023, 1023], [300, 723]] {
            let area = screen.sub_area(place[1] * 1024 + place[0]);
            for (corners, triangle) in scene.iter().zip(&triangles) {
                coverage.find(triangle, &area, &sampling);
                for pixel in 0..64 {
                    let at = [area.columns().start + pixel as u32 % 8, area.rows().start + pixel as u32 / 8];
                    assert_eq!(
                        coverage.mask(pixel),
                        bits(corners, sampling.places(at.map(|at| at as i32))),
                        "{at:?} {corners:?}"
                    );
                }
            }
        }
    }
}
