//! The order of effects in their lists and the number of threads change nothing (acceptance test 1).

use crate::shots::{Frame, Shot, level_ground};
use glam::DVec3;
use quantities::unit_interval;
use scenario::{LightPoint, LightSource, Medium, Overlay, Sheet};

/// Lamps, stars, sheets and overlays, many of them equally near.
fn crowded() -> Shot {
    let part = |what: u64, k: u64| unit_interval(7, &[what, k]);
    let mut shot = Shot::new(40, 32, 40.0);
    shot.ground = level_ground(2000.0, 0.5);
    shot.run.sampling.translucent = Some(2);
    let light = |id: u32| {
        let k = u64::from(id);
        let at = [40.0 * part(1, k), 32.0 * part(2, k)];
        let lamp = shot.lamp(id, at, [20.0, 10.0 + 20.0 * part(3, k)][id as usize % 2], 0.8);
        let star = LightSource::Star {
            direction: shot.eye().direction(at).normalize(),
            magnitude: 4.0 * part(4, k) - 2.0,
        };
        let source = if id.is_multiple_of(3) { star } else { lamp.source };
        LightPoint {
            source,
            colour: [part(5, k), part(6, k), part(7, k)],
            calligraphic: id % 5 < 2,
            intensity: 0.7,
            ..lamp
        }
    };
    shot.effects.lights = (0..120).map(light).collect();
    let sheet = |id: u32| {
        let k = u64::from(id);
        let colour = [part(11, k), part(12, k), part(13, k)];
        let [x, y] = [30.0 * part(14, k), 20.0 * part(15, k)];
        let corners = [[x, y], [x + 15.0, y], [x, y + 15.0]];
        let sheet = shot.sheet(id, &corners, 15.0, colour, 0.2 * f64::from(id % 4));
        let dust = Medium::Dust { kappa: 0.1, thickness: 3.0 };
        Sheet { medium: if id.is_multiple_of(5) { dust } else { sheet.medium }, ..sheet }
    };
    shot.effects.sheets = (0..20).map(sheet).collect();
    let overlay = |id: u32| Overlay {
        id,
        corners: vec![[-0.5, -0.9], [0.1, -0.9], [-0.5, -0.5]],
        colour: [part(20, u64::from(id)); 3],
        share: 0.5,
        priority: 0,
    };
    shot.effects.overlays = (0..3).map(overlay).collect();
    shot
}

/// Orders a list by a hash of its numbers.
fn shuffled<T>(list: Vec<T>, seed: u64) -> Vec<T> {
    let mut list: Vec<(f64, T)> =
        list.into_iter().zip(0..).map(|(one, k)| (unit_interval(seed, &[k]), one)).collect();
    list.sort_by(|a, b| a.0.total_cmp(&b.0));
    list.into_iter().map(|(_, one)| one).collect()
}

fn drawn_by(threads: usize, shot: &Shot) -> Frame {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| shot.draw())
}

#[test]
fn any_order_and_any_number_of_threads_give_the_same_bits() {
    let shot = crowded();
    let frame = drawn_by(1, &shot);
    for name in ["lost_lights", "lost_surfaces", "calligraphic"] {
        assert!(frame.counts[name] > 0, "{name}");
    }
    for seed in 0..6 {
        let mut other = shot.clone();
        other.effects.lights = shuffled(other.effects.lights, seed);
        other.effects.sheets = shuffled(other.effects.sheets, seed + 10);
        other.effects.overlays = shuffled(other.effects.overlays, seed + 20);
        assert!(drawn_by(1 + seed as usize % 2, &other) == frame, "seed {seed}");
    }
}

#[test]
fn of_two_lamps_at_one_place_the_lower_number_is_seen() {
    let mut shot = Shot::new(16, 16, 100.0);
    let place = shot.eye().place([8.0, 5.0], 30.0);
    let lamp = |id: u32, colour: [f64; 3]| LightPoint { colour, ..crate::shots::lamp(id, place, 2.0) };
    for order in [[4, 9], [9, 4]] {
        let colour = |id: u32| if id == 4 { DVec3::X.to_array() } else { DVec3::Y.to_array() };
        shot.effects.lights = order.map(|id| lamp(id, colour(id))).to_vec();
        let [red, green, _] = shot.draw().colour(5 * 16 + 8);
        assert!(red > 0.9 && green == 0.0, "{order:?}: {red} {green}");
    }
}
