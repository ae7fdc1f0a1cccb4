//! Where the drive of an exported scenario begins.

use std::sync::Arc;

use features::{Craters, Features};
use landscape::{Bank, Landscape};
use terrain_builder::{Export, Ground};

/// By how much the posts of the database may lie above the bank under a wheel (m). Chosen: well below the eye of a vehicle.
const MOST_ABOVE: f64 = 0.5;

/// Places that are looked at, from the middle outward: so many steps each way, each a share of the ground's side. Chosen.
const STEPS: i32 = 20;
const STEP_SHARE: f64 = 0.02;

/// The place (x north, y east; m, in the axes of the bank) nearest to the middle from which a drive of `length` (m) to the north stays above the
/// posts of the database. The vehicle stands on the bank with its craters, and these differ from the posts where craters were
/// converted. The middle, where there is no such place.
pub(crate) fn start(ground: &Ground, bank: &Bank, export: &Export, length: f64) -> [f64; 2] {
    let craters: Craters = export.craters.iter().map(|nearest| nearest.crater).collect();
    let driven = Landscape::new(bank.clone(), 1.0).with_features(Features::of(Arc::new(craters)));
    let [corner, far] = ground.description().grid.extent();
    let size = [0, 1].map(|axis| far[axis] - corner[axis]);
    let is_above = |[x, y]: [f64; 2]| {
        driven
            .height(x, y)
            .is_some_and(|height| ground.height([corner[0] + x, corner[1] + y]) - height <= MOST_ABOVE)
    };
    let is_free = |place: &[f64; 2]| {
        (0..=4).all(|part| is_above([place[0] + length * f64::from(part) / 4.0, place[1]]))
    };
    let mut steps: Vec<[i32; 2]> =
        (-STEPS..=STEPS).flat_map(|north| (-STEPS..=STEPS).map(move |east| [north, east])).collect();
    steps.sort_by_key(|[north, east]| north * north + east * east);
    let place =
        |steps: &[i32; 2]| [0, 1].map(|axis| size[axis] * (0.5 + STEP_SHARE * f64::from(steps[axis])));
    steps.iter().map(place).find(is_free).unwrap_or(size.map(|side| 0.5 * side))
}
