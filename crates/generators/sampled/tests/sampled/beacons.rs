//! Calligraphic lamps that something hides (acceptance tests 7 and 9).

use crate::shots::{Shot, is_same_sum};
use generator::PlaneKind;
use light_points::Accumulation;
use raster::Pattern;
use scenario::LightPoint;

/// A beacon whose disc is 3.7 pixels wide, before a black sky.
fn beacon() -> (Shot, [f64; 2], f64) {
    let mut shot = Shot::new(32, 32, 370.0);
    shot.run.sampling.pattern = Pattern::Sixteen;
    let at = [16.3, 12.4];
    let distance = 100.0;
    let lamp = shot.lamp(0, at, distance / shot.eye().ray(at).length(), 1.0);
    shot.effects.lights = vec![LightPoint { calligraphic: true, ..lamp }];
    (shot, at, 3.7)
}

/// Sampling points of pattern `16` under the disc, and how many of them lie above a line of the screen.
fn uncovered(middle: [f64; 2], diameter: f64, line: f64) -> [f64; 2] {
    let mut counts = [0.0; 2];
    for pixel in 0..32 * 32 {
        for offset in Pattern::Sixteen.offsets() {
            let x = f64::from(pixel % 32) + f64::from(offset[0]) / 64.0;
            let y = f64::from(pixel / 32) + f64::from(offset[1]) / 64.0;
            if libm::hypot(x - middle[0], y - middle[1]) <= diameter / 2.0 {
                counts[0] += 1.0;
                counts[1] += f64::from(u8::from(y < line));
            }
        }
    }
    counts
}

#[test]
fn a_beacon_sets_behind_a_wall() {
    let (mut shot, at, diameter) = beacon();
    let area = std::f64::consts::PI * diameter * diameter / 4.0;
    let (mut last, mut shown) = (f64::INFINITY, 0);
    for step in 0..60 {
        // Lines between two rows of sampling points, and between two steps of a corner.
        let line = 15.0 - f64::from(step) / 12.0 - 1.0 / 1000.0;
        let wall = [[-1.0, line], [33.0, line], [33.0, 33.0], [-1.0, 33.0]];
        shot.effects.sheets = vec![shot.sheet(0, &wall, 50.0, [0.0; 3], 0.0)];
        let sum = shot.draw().sum(PlaneKind::Red);
        let [all, left] = uncovered(at, diameter, (line * 256.0 + 0.5).floor() / 256.0);
        if left == 0.0 {
            assert_eq!(sum, 0.0, "line {line}");
        } else {
            assert!(is_same_sum(sum, area * left / all), "line {line}: {sum}, not {left} of {all}");
        }
        assert!(sum <= last);
        shown += u32::from(sum > 0.0 && left < all);
        last = sum;
    }
    assert!(shown > 20 && last == 0.0, "{shown} {last}");
}

/// Green light of the far lamp behind a near one of intensity 0.8, as a share of its own.
fn far_share(numbers: [u32; 2], veil: Accumulation) -> f64 {
    let mut shot = Shot::new(32, 32, 300.0);
    shot.run.sampling.veil = veil;
    let at = [15.2, 14.7];
    let lamp = |id: u32, depth: f64, colour: [f64; 3], intensity: f64| {
        let lamp = shot.lamp(id, at, depth, 1.0);
        LightPoint { calligraphic: true, colour, intensity, ..lamp }
    };
    let near = lamp(numbers[0], 50.0, [1.0, 0.0, 0.0], 0.8);
    let far = lamp(numbers[1], 500.0, [0.0, 1.0, 0.0], 1.0);
    let mut green = |lights: Vec<LightPoint>| {
        shot.effects.lights = lights;
        shot.draw().sum(PlaneKind::Green)
    };
    let alone = green(vec![far]);
    green(vec![near, far]) / alone
}

#[test]
fn a_near_lamp_veils_one_in_line_with_it() {
    for numbers in [[0, 1], [1, 0]] {
        let share = far_share(numbers, Accumulation::Points);
        assert!((share - 0.2).abs() < 1e-7, "{share}");
        let share = far_share(numbers, Accumulation::StackOnly);
        assert!((share - 1.0).abs() < 1e-7, "{share}");
    }
}
