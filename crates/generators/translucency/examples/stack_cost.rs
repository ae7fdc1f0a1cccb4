//! What stacks cost: opaque features that cover whole sub-areas, with and without translucent sheets before them.
//!
//! `cargo run --release -p translucency --example stack_cost` prints nanoseconds a sampling point, pattern by pattern.

use std::hint::black_box;
use std::time::Instant;

use raster::{DistancePlane, Filter, Pattern, Sampling, Screen};
use translucency::{Capacity, Feature, Stack};

const SIZE: u32 = 128;
/// Frames of which the fastest counts.
const FRAMES: usize = 5;
/// Opaque features at each sampling point, far to near. All sheets lie before them, in no order.
const OPAQUE: u32 = 3;

fn feature(id: u32, translucency: f64) -> (Feature, DistancePlane) {
    let nearness = if translucency == 0.0 { id } else { 10 + id * 7 % 23 };
    let feature = Feature::surface(id, 0, [0.5; 3], translucency).expect("a feature in range");
    (feature, DistancePlane { slope: [1e-5, 2e-5], origin: 0.01 + 0.1 * f64::from(nearness) })
}

/// Nanoseconds a sampling point: of the fastest frame.
fn time(pattern: Pattern, sheets: u32, capacity: Capacity) -> f64 {
    let screen = Screen::new([SIZE; 2], 8).expect("a raster in range");
    let mut stack = Stack::new(Sampling::new(pattern), capacity, [0.0; 3]).expect("a black background");
    let weights = Filter::Box.weights(pattern);
    let opaque = (0..OPAQUE).map(|id| feature(id, 0.0));
    let features: Vec<_> = opaque.chain((0..sheets).map(|id| feature(3 + id, 0.9))).collect();
    let whole = u32::MAX >> (32 - stack.samples());
    let mut fastest = f64::INFINITY;
    for _ in 0..FRAMES {
        let begun = Instant::now();
        let mut sum = 0.0;
        for number in 0..screen.sub_areas() {
            stack.start(&screen.sub_area(number));
            for (feature, plane) in &features {
                stack.add(*feature, plane, (0..64).map(|pixel| (pixel, whole)));
            }
            sum += (0..64).map(|pixel| stack.colour(pixel, weights.of([0, 0]))[0]).sum::<f64>();
        }
        black_box(sum);
        fastest = fastest.min(begun.elapsed().as_secs_f64());
    }
    1e9 * fastest / (f64::from(SIZE * SIZE) * stack.samples() as f64)
}

fn main() {
    let four = Capacity::Separate { translucent: Some(4), lights: Some(1) };
    println!("nanoseconds a sampling point, {OPAQUE} opaque features at each, colours included");
    println!("pattern     none   1 sheet   20 sheets, K 4   20 sheets, no limit");
    for pattern in [Pattern::One, Pattern::Four, Pattern::Eight, Pattern::Sixteen, Pattern::Lattice32] {
        let [none, one, twenty] = [0, 1, 20].map(|sheets| time(pattern, sheets, four));
        let unlimited = time(pattern, 20, Capacity::UNLIMITED);
        println!("{:<9} {none:>6.2} {one:>9.2} {twenty:>16.1} {unlimited:>21.1}", pattern.name());
    }
}
