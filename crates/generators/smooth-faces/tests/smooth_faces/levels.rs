//! Levels of detail laid upon a list.

use faces::Detail;
use generator::PlaneKind;
use glam::DVec3;
use scenario::{FaceKind, FaceList};

use crate::shots::{PIXELS, draw, from_above, run, session, square, stage};

/// A sea of one brightness with a level upon it.
fn lists(detail: Detail, gain: f64) -> Vec<FaceList> {
    let at = DVec3::new(150.0, 100.0, 0.0);
    let sea = FaceList { kind: FaceKind::Sea, ..square("sea", at, 300.0, 10, [0.5; 3]) };
    let mut level = FaceList { kind: FaceKind::Level, ..square("level", at, 50.0, 5, [0.5; 3]) };
    level.group = level.group.detailed(detail).with_gain(gain);
    vec![sea, level]
}

/// Red in the middle and beside the level, and how many samples were clamped.
fn drawn(detail: Detail, gain: f64, order: faces::Order) -> (f32, f32, u64) {
    let run = smooth_faces::Parameters { order, ..run() };
    let session = session(stage(lists(detail, gain)), run);
    let (planes, counts) = draw(&*session, 0, &from_above());
    let red = planes.get(PlaneKind::Red).unwrap();
    (red[PIXELS / 2 * PIXELS + PIXELS / 2], red[0], counts["clamped"])
}

#[test]
fn levels_are_added_soft_or_replaced() {
    let base = 0.5 * 0.644_217_7_f32;
    for order in [faces::Order::Lists, faces::Order::Depth] {
        let expected = [
            (Detail::Add, 2.0 * base),
            (Detail::AddSoft, 1.0 - (1.0 - base) * (1.0 - base)),
            (Detail::Replace, base),
        ];
        for (detail, middle) in expected {
            let (found, beside, clamped) = drawn(detail, 1.0, order);
            assert!((found - middle).abs() < 1e-6, "{detail:?} {order:?}: {found} {middle}");
            assert!((beside - base).abs() < 1e-6 && clamped == 0, "{detail:?} {order:?}");
        }
        let (found, _, clamped) = drawn(Detail::Add, 3.0, order);
        assert_eq!(found, 1.0, "clamped at full scale");
        // 50 m of 120 m of the picture.
        let pixels = libm::pow(50.0 / 120.0 * PIXELS as f64, 2.0);
        assert!((clamped as f64 - pixels).abs() < 0.1 * pixels, "{clamped} of {pixels}");
    }
}

#[test]
fn a_level_behind_a_list_is_not_laid_upon_it() {
    let mut lists = lists(Detail::Add, 1.0);
    lists.push(square("ship", DVec3::new(150.0, 100.0, 10.0), 10.0, 1, [0.25; 3]));
    for order in [faces::Order::Lists, faces::Order::Depth] {
        let run = smooth_faces::Parameters { order, ..run() };
        let session = session(stage(lists.clone()), run);
        let (planes, _) = draw(&*session, 0, &from_above());
        let red = planes.get(PlaneKind::Red).unwrap()[PIXELS / 2 * PIXELS + PIXELS / 2];
        assert!((red - 0.25 * 0.644_217_7).abs() < 1e-6, "{order:?}: {red}");
    }
}
