//! More stars than a field has time for.

use light_points::{BeamBudget, BeamPoint};

fn stars() -> Vec<BeamPoint> {
    let light = |id: u32| f64::from(id.wrapping_mul(2_654_435_761) >> 22) / 1024.0;
    let place = |id: u32| [f64::from(id % 60), f64::from(id / 60)];
    (0..3000).map(|id| BeamPoint { id, place: place(id), light: light(id) }).collect()
}

#[test]
fn three_thousand_stars_fit_a_thirtieth_of_a_second() {
    let budget = BeamBudget::default();
    let mut points = stars();
    assert!(budget.drop_faintest(&mut points, 1_000_000_000 / 30).is_empty());
    assert_eq!(points, stars());
    assert_eq!(3000 * (budget.jump_ns + budget.dwell_ns), 30_000_000);
}

#[test]
fn of_a_sixtieth_the_faintest_1334_are_dropped() {
    let mut points = stars();
    let dropped = BeamBudget::default().drop_faintest(&mut points, 1_000_000_000 / 60);
    assert_eq!((points.len(), dropped.len()), (1666, 1334));
    let faintest = points
        .iter()
        .map(|point| (point.light, u32::MAX - point.id))
        .reduce(|a, b| if a < b { a } else { b });
    let brightest = dropped
        .iter()
        .map(|point| (point.light, u32::MAX - point.id))
        .reduce(|a, b| if a > b { a } else { b });
    assert!(brightest < faintest, "{brightest:?} {faintest:?}");
    assert!(points.is_sorted_by_key(|point| point.id), "the order is kept");
}
