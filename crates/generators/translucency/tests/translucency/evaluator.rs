//! A second evaluator: sorts all that covers a sampling point and composes without limits, far to near.

use std::cmp::Reverse;

use super::Placed;

/// Distance on a scale that whole numbers sort: places of the tests are whole metres.
fn whole(distance: f64) -> u64 {
    assert_eq!(distance, distance.round());
    distance as u64
}

/// Colour of a set over a background: each feature's own light, and its share of what lies behind.
pub fn composed(set: &[Placed], background: [f64; 3], priority: impl Fn(&Placed) -> i32) -> [f64; 3] {
    let mut order: Vec<&Placed> = set.iter().collect();
    order.sort_by_key(|placed| (whole(placed.distance), Reverse(priority(placed)), placed.feature.id()));
    order.iter().rev().fold(background, |behind, placed| {
        let own = placed.feature.own_light();
        std::array::from_fn(|i| own[i] + placed.feature.translucency() * behind[i])
    })
}
