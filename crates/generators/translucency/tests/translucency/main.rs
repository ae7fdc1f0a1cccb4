//! Stacks against check values, against an evaluator that knows no limit, and against what limits may lose.

mod check_values;
mod evaluator;
mod limits;
mod random_sets;
mod surfaces;

use raster::{DistancePlane, Pattern, Sampling, Screen, SubArea};
use translucency::{Capacity, Feature, Stack};

/// A feature at one distance (m) over one sampling point.
#[derive(Clone, Copy)]
struct Placed {
    distance: f64,
    feature: Feature,
}

/// The plane of all points equally far (m).
fn at_distance(distance: f64) -> DistancePlane {
    DistancePlane { slope: [0.0; 2], origin: 1.0 / distance }
}

fn first_area(side: u32) -> SubArea {
    Screen::new([side, side], side).unwrap().sub_area(0)
}

/// A stack of one sampling point with features that arrive in this order.
fn stacked<'a>(capacity: Capacity, placed: impl IntoIterator<Item = &'a Placed>) -> Stack {
    let mut stack = Stack::new(Sampling::new(Pattern::One), capacity, [0.0; 3]).unwrap();
    stack.start(&first_area(1));
    for Placed { distance, feature } in placed {
        stack.add(*feature, &at_distance(*distance), [(0, 1)]);
    }
    stack
}

fn separate(translucent: u32, lights: u32) -> Capacity {
    Capacity::Separate { translucent: Some(translucent), lights: Some(lights) }
}

#[track_caller]
fn assert_colour(found: [f64; 3], expected: [f64; 3], room: f64) {
    assert!((0..3).all(|i| (found[i] - expected[i]).abs() <= room), "{found:?}, expected {expected:?}");
}

/// Splitmix64: random numbers that are the same in every run.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ mixed >> 31) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, end: u32) -> u32 {
        (self.unit() * f64::from(end)) as u32
    }

    fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last as u32 + 1) as usize);
        }
    }

    fn colour(&mut self) -> [f64; 3] {
        [0; 3].map(|_| self.unit())
    }

    /// Any feature of a set: opaque, translucent, a light of at most intensity 1.3, or one that hides nothing. Distances and
    /// priorities are few, so that many are equal.
    fn placed(&mut self, id: u32) -> Placed {
        let (priority, colour) = (self.below(2) as i32, self.colour());
        let feature = match self.below(8) {
            0 => Feature::surface(id, priority, colour, 0.0),
            1..5 => Feature::surface(id, priority, colour, self.unit()),
            5 | 6 => {
                let intensity = 1.3 * self.unit();
                Feature::light(id, priority, colour, intensity, 1.0 - intensity.min(1.0))
            }
            _ => Feature::light(id, priority, colour, self.unit(), 1.0),
        };
        Placed { distance: f64::from(1 + self.below(12)), feature: feature.unwrap() }
    }

    fn set(&mut self, most: u32) -> Vec<Placed> {
        (0..self.below(most + 1)).map(|id| self.placed(id)).collect()
    }
}
