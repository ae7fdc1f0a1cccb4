//! Published check values of the stack.

use translucency::{Capacity, Feature};

use super::{Placed, assert_colour, separate, stacked};

fn surface(id: u32, distance: f64, translucency: f64, colour: [f64; 3]) -> Placed {
    Placed { distance, feature: Feature::surface(id, 0, colour, translucency).unwrap() }
}

/// A light that hides as much as it shines.
fn lamp(id: u32, distance: f64, intensity: f64, colour: [f64; 3]) -> Placed {
    let feature = Feature::light(id, 0, colour, intensity, 1.0 - intensity).unwrap();
    Placed { distance, feature }
}

fn ground(distance: f64) -> Placed {
    surface(9, distance, 0.0, [0.4, 0.35, 0.3])
}

#[track_caller]
fn assert_stack(placed: &[Placed], weights: &[f64], colour: [f64; 3]) {
    let stack = stacked(separate(4, 1), placed);
    let found: Vec<f64> = stack.layers(0).map(|layer| layer.weight()).collect();
    assert_eq!(found.len(), weights.len());
    assert!(found.iter().zip(weights).all(|(a, b)| (a - b).abs() < 1e-15), "{found:?}");
    assert_colour(stack.colour_at(0), colour, 1e-15);
    assert_eq!(stack.surface_at(0).map(|(feature, _)| feature.id()), Some(9));
}

#[test]
fn three_stacks_near_to_far() {
    let (first, second) = ([0.9, 0.8, 0.6], [0.2, 0.2, 0.3]);
    let [near, far] = [surface(1, 10.0, 0.7, first), surface(2, 20.0, 0.5, second)];
    assert_stack(&[near, far, ground(30.0)], &[0.3, 0.35, 0.35], [0.48, 0.4325, 0.39]);
    let [near, far] = [surface(2, 10.0, 0.5, second), surface(1, 20.0, 0.7, first)];
    assert_stack(&[near, far, ground(30.0)], &[0.5, 0.15, 0.35], [0.375, 0.3425, 0.345]);
    let [near, light] = [surface(1, 10.0, 0.7, first), lamp(2, 20.0, 0.35, [1.0, 0.9, 0.7])];
    assert_stack(&[near, light, ground(30.0)], &[0.3, 0.245, 0.455], [0.697, 0.61975, 0.488]);
}

fn order_set() -> [Placed; 7] {
    let red = |value: f64| [value, 0.0, 0.0];
    [
        surface(1, 10.0, 0.7, red(0.9)),
        surface(6, 12.0, 0.9, red(0.6)),
        lamp(3, 15.0, 0.35, red(1.0)),
        lamp(4, 18.0, 0.8, red(0.5)),
        surface(2, 20.0, 0.5, red(0.2)),
        surface(5, 30.0, 0.0, red(0.4)),
        surface(7, 40.0, 0.0, red(0.1)),
    ]
}

/// All orders of seven things, by Heap's algorithm.
fn for_all_orders(items: &mut [Placed; 7], count: usize, visit: &mut impl FnMut(&[Placed; 7])) {
    if count <= 1 {
        return visit(items);
    }
    for i in 0..count {
        for_all_orders(items, count - 1, visit);
        items.swap(if count.is_multiple_of(2) { i } else { 0 }, count - 1);
    }
}

#[test]
fn every_order_of_arrival_gives_the_same_bits() {
    let published = [
        (separate(4, 1), 0.65535),
        (separate(1, 1), 0.697),
        (separate(4, 2), 0.72087),
        (separate(4, 0), 0.501),
    ];
    for (capacity, red) in published {
        let (first, mut orders) = (stacked(capacity, &order_set()), 0);
        assert_colour(first.colour_at(0), [red, 0.0, 0.0], 1e-15);
        for_all_orders(&mut order_set(), 7, &mut |order| {
            let stack = stacked(capacity, order);
            assert_eq!(stack.colour_at(0), first.colour_at(0));
            assert_eq!(stack.losses(), first.losses());
            let lost = |stack: &translucency::Stack| {
                stack.loss_at(0).map(|loss| loss.nearest.map(|lost| lost.map(|(feature, _)| feature.id())))
            };
            assert_eq!(lost(&stack), lost(&first));
            orders += 1;
        });
        assert_eq!(orders, 5040);
    }
}

#[test]
fn what_is_lost_has_a_name() {
    let lost = |capacity| {
        let stack = stacked(capacity, &order_set());
        let loss = stack.loss_at(0)?;
        Some(loss.nearest.map(|lost| lost.map(|(feature, _)| feature.id())))
    };
    assert_eq!(lost(separate(4, 2)), None);
    assert_eq!(lost(separate(4, 1)), Some([None, Some(4)]));
    assert_eq!(lost(separate(1, 1)), Some([Some(6), Some(4)]));
    assert_eq!(lost(separate(4, 0)), Some([None, Some(3)]));
}

#[test]
fn in_a_shared_stack_lamps_push_out_the_dust() {
    let set = order_set();
    // Of five the nearest three are kept: sheets 1 and 6, lamp 3.
    let shared = stacked(Capacity::Shared(Some(3)), &set);
    let kept: Vec<u32> = shared.layers(0).map(|layer| layer.feature.id()).collect();
    assert_eq!(kept, [1, 6, 3, 5]);
    let lost = shared.loss_at(0).unwrap().nearest.map(|lost| lost.map(|(feature, _)| feature.id()));
    assert_eq!(lost, [Some(2), Some(4)]);
}

#[test]
fn lamp_through_two_sheets() {
    let sheets = [surface(1, 10.0, 0.7, [0.0; 3]), surface(2, 20.0, 0.5, [0.0; 3])];
    let light = lamp(3, 30.0, 0.8, [1.0; 3]);
    let stack = stacked(separate(4, 1), sheets.iter().chain([&light]));
    assert_colour(stack.colour_at(0), [0.35 * 0.8; 3], 1e-12);
    // By a beam: the same share, the point itself not in the stack.
    let stack = stacked(separate(4, 1), &sheets);
    assert!((stack.through(0, 1.0 / 30.0, &light.feature) - 0.35).abs() < 1e-12);
}

#[test]
fn a_point_behind_the_ground_has_no_share_and_the_key_decides_beside_it() {
    let stack = stacked(separate(4, 1), &[surface(1, 10.0, 0.5, [1.0; 3]), ground(30.0)]);
    let point = |id, priority| Feature::light(id, priority, [1.0; 3], 1.0, 0.0).unwrap();
    assert_eq!(stack.through(0, 1.0 / 31.0, &point(1, 0)), 0.0);
    assert_eq!(stack.through(0, 1.0 / 30.0, &point(10, 0)), 0.0);
    assert_eq!(stack.through(0, 1.0 / 30.0, &point(8, 0)), 0.5);
    assert_eq!(stack.through(0, 1.0 / 30.0, &point(10, 1)), 0.5);
    assert_eq!(stack.through(0, f64::INFINITY, &point(8, 0)), 1.0);
}

/// Extinction 0.05 a metre over 10 m and 40 m, as the page of dust has it.
#[test]
fn dust_of_the_check_values() {
    for (translucency, red) in
        [(0.606530659712633, 0.393469340287367), (0.135335283236613, 0.864664716763387)]
    {
        let stack = stacked(separate(4, 1), &[surface(1, 5.0, translucency, [1.0, 0.0, 0.0])]);
        assert_colour(stack.colour_at(0), [red, 0.0, 0.0], 1e-15);
    }
}
