//! Random sets: order, sum of weights, the evaluator without limits, the bound on what limits lose.

use raster::{Pattern, Sampling};
use translucency::{Capacity, Feature, Stack};

use super::evaluator::composed;
use super::{Placed, Random, assert_colour, at_distance, first_area, separate, stacked};

const BACKGROUND: [f64; 3] = [0.05, 0.1, 0.2];

fn stacked_over_background(capacity: Capacity, set: &[Placed]) -> Stack {
    let mut stack = Stack::new(Sampling::new(Pattern::One), capacity, BACKGROUND).unwrap();
    stack.start(&first_area(1));
    set.iter().for_each(|placed| stack.add(placed.feature, &at_distance(placed.distance), [(0, 1)]));
    stack
}

/// Sets whose priorities are known: features do not tell theirs, so each is made anew from its id.
fn prioritised(random: &mut Random) -> Vec<(Placed, i32)> {
    let set = random.set(24);
    let again = |placed: Placed| {
        let (id, tau) = (placed.feature.id(), placed.feature.translucency());
        let priority = id as i32 % 3 - 1;
        let colour = [f64::from(id) / 24.0, 0.5, 0.25];
        let feature = match placed.feature.kind() {
            translucency::Kind::Surface => Feature::surface(id, priority, colour, tau),
            translucency::Kind::Light => Feature::light(id, priority, colour, 1.0 - tau, tau),
        };
        (Placed { feature: feature.unwrap(), ..placed }, priority)
    };
    set.into_iter().map(again).collect()
}

#[test]
fn without_limits_the_sum_is_that_of_the_evaluator() {
    let mut random = Random(1);
    for _ in 0..1000 {
        let set = prioritised(&mut random);
        let placed: Vec<Placed> = set.iter().map(|(placed, _)| *placed).collect();
        let priority = |of: &Placed| set[of.feature.id() as usize].1;
        let stack = stacked_over_background(Capacity::UNLIMITED, &placed);
        assert_colour(stack.colour_at(0), composed(&placed, BACKGROUND, priority), 1e-14);
        assert_eq!(stack.loss_at(0), None);
    }
}

#[test]
fn weights_and_rest_sum_to_one() {
    let mut random = Random(2);
    for _ in 0..1000 {
        let set: Vec<Placed> = prioritised(&mut random).into_iter().map(|(placed, _)| placed).collect();
        let stack = stacked_over_background(separate(3, 2), &set);
        let weights: f64 = stack.layers(0).map(|layer| layer.weight()).sum();
        let rest = stack.layers(0).last().map_or(1.0, |layer| layer.rest());
        assert!((weights + rest - 1.0).abs() < 1e-14, "{weights} and {rest}");
    }
}

/// Features of one id, too: some sets have twins that differ by colour alone.
#[test]
fn any_order_of_arrival_stores_the_same() {
    let mut random = Random(3);
    for _ in 0..1000 {
        let mut set = random.set(20);
        if let Some(&first) = set.first() {
            let twin = Feature::surface(first.feature.id(), 0, random.colour(), random.unit()).unwrap();
            set.push(Placed { feature: twin, ..first });
        }
        for capacity in [separate(2, 1), separate(0, 0), Capacity::Shared(Some(3)), Capacity::UNLIMITED] {
            let first = stacked(capacity, &set);
            for _ in 0..4 {
                random.shuffle(&mut set);
                let stack = stacked(capacity, &set);
                assert!(stack.layers(0).eq(first.layers(0)));
                assert_eq!(stack.loss_at(0), first.loss_at(0));
                assert_eq!(stack.colour_at(0), first.colour_at(0));
            }
        }
    }
}

#[test]
fn limits_lose_no_more_than_the_bound() {
    let mut random = Random(4);
    let (mut lossy, mut tightest) = (0, 0.0f64);
    for _ in 0..1000 {
        let set = random.set(24);
        let whole = stacked_over_background(Capacity::UNLIMITED, &set).colour_at(0);
        for capacity in [separate(2, 1), separate(1, 1), separate(0, 0), Capacity::Shared(Some(3))] {
            let stack = stacked_over_background(capacity, &set);
            let colour = stack.colour_at(0);
            let bound = stack.loss_at(0).map_or([0.0; 3], |loss| loss.bound);
            for i in 0..3 {
                let error = (colour[i] - whole[i]).abs();
                assert!(error <= bound[i] + 1e-14, "off by {error}, bound {}", bound[i]);
                tightest = tightest.max(error / bound[i].max(1e-9));
            }
            assert_eq!(stack.losses().bound, bound);
            lossy += u32::from(stack.loss_at(0).is_some());
        }
    }
    // The bound says something: sets lose, and some of them nearly as much.
    assert!(lossy > 1000 && tightest > 0.8, "{lossy} sets, {tightest}");
}
