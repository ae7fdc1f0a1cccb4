//! Shapes of each kind (table in the module above). All are proportional to the radius of the rim crest.

use super::Kind;
use super::draw::{Draw, Purpose};
use crate::Shape;
use crate::craters::{BROAD, SHARP};

/// Shape, depth and rim height (m) of a crater of a rim-crest radius (m).
pub(super) fn draw(kind: &Kind, radius: f64, draw: &Draw) -> (Shape, f64, f64) {
    let diameter = 2.0 * radius;
    let share = |low, high| draw.between(Purpose::Depth, low, high);
    match kind {
        Kind::Fresh => {
            let spread = share(0.9, 1.1);
            (rimmed(radius, SHARP), 0.16 * spread * diameter, 0.036 * spread * diameter)
        }
        Kind::Degraded => {
            let depth = share(0.02, 0.12);
            let rim = 0.02 * (depth / 0.12) * (depth / 0.12);
            match draw.unit(Purpose::Type) * 3.0 < 1.0 {
                true => (Shape::Bowl { r1: radius }, depth * diameter, 0.0),
                false => (rimmed(radius, BROAD), depth * diameter, rim * diameter),
            }
        }
        Kind::FlatFloored => {
            let depth = share(0.06, 0.085);
            let r2 = inner_foot(radius, SHARP);
            let r1 = r2 * draw.between(Purpose::Floor, 0.3, 0.4);
            (Shape::FlatFloor { r1, r2, r3: SHARP * r2 }, depth * diameter, depth / 3.0 * diameter)
        }
        Kind::Secondaries(_) => {
            let depth = share(0.04, 0.08);
            (rimmed(radius, SHARP), depth * diameter, 0.2 * depth * diameter)
        }
    }
}

/// Returns the outer radius of a shape (m).
pub(super) fn outer(shape: &Shape) -> f64 {
    match *shape {
        Shape::Bowl { r1 } => r1,
        Shape::RimmedBowl { r2, .. } => r2,
        Shape::FlatFloor { r3, .. } => r3,
    }
}

/// Outer radius over radius of the rim crest, at most.
pub(super) fn largest_outer(kind: &Kind) -> f64 {
    let broadest = if *kind == Kind::Degraded { BROAD } else { SHARP };
    broadest * inner_foot(1.0, broadest)
}

fn rimmed(radius: f64, broad: f64) -> Shape {
    let r1 = inner_foot(radius, broad);
    Shape::RimmedBowl { r1, r2: broad * r1 }
}

/// The crest stands in the middle between the feet of the rim.
fn inner_foot(radius: f64, broad: f64) -> f64 {
    2.0 * radius / (1.0 + broad)
}
