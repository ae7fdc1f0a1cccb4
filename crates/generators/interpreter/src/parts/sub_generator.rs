//! One sub-generator of the feature generator, with a crater in it (sheet of the feature generator).
//!
//! Both squarers and their sum are off, so circles are ellipses, a little off. For one sweep that is a crater with another foot and
//! other radii: the least of the sum of squares along the sweep says which.

use features::{Crater, Shape};

use super::comparator::ComparatorFigures;
use super::kit::Kit;

/// Sub-generators of a type that differ from one another where there may be any number.
const MOST: u32 = 64;

/// A squarer is off by at most this.
const LARGEST: f64 = 0.5;

/// An offset leaves at least this of the square of a radius.
const SMALLEST: f64 = 1e-4;

/// What is off about a sub-generator.
#[derive(Debug, Clone, Copy, Default)]
pub struct SubGeneratorFigures {
    /// Scale errors of the squarers of north and east.
    squarers: [f64; 2],
    /// Offset of their sum (share of the square of the footprint's radius).
    offset: f64,
    /// Offset of the comparator of the footprint (the same).
    pub threshold: f64,
    /// What the parabola multiplies by.
    pub gain: f64,
    /// Time constant of the chain (steps).
    pub tau: f64,
}

impl SubGeneratorFigures {
    /// Number `number` of the sub-generators of a crater type (1 to 3), of which there are `limit`.
    pub fn of(kit: &Kit<'_>, kind: u32, number: u32, limit: Option<u32>) -> Self {
        let number = (number % limit.unwrap_or(MOST).clamp(1, MOST)) as usize;
        let feature = kit.analog.feature;
        let name = |figure: &str| format!("fg.{kind}.{figure}");
        let error =
            |figure: &str| kit.drawn.error(&name(figure), number, feature.error).clamp(-LARGEST, LARGEST);
        Self {
            squarers: [error("square-x"), error("square-y")],
            offset: error("sum"),
            threshold: ComparatorFigures::of(kit, &name("comparator"), number).offset,
            gain: 1.0 + error("parabola"),
            tau: kit.lag(&name("bandwidth"), number, feature.bandwidth),
        }
    }
}

/// Part of a crater, from the outside inwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Zone {
    /// The place lies beyond the footprint.
    Outside,
    /// Between the outer foot of the rim and the hollow.
    Ring,
    /// Bowl, or floor and wall.
    Hollow,
}

/// A crater as a sub-generator has it on one sweep.
#[derive(Debug, Clone, Copy)]
pub struct Passage {
    /// Shape and place of the crater.
    pub crater: Crater,
    /// Ground range at which the sweep is nearest to its centre (m).
    pub middle: f64,
    /// Distance of the centre to the right of the sweep (m).
    pub side: f64,
}

impl Passage {
    /// `crater` in a sub-generator, on a sweep from `foot` (north, east; m) along `direction` (cosine, sine).
    pub fn of(figures: &SubGeneratorFigures, crater: &Crater, foot: [f64; 2], [cos, sin]: [f64; 2]) -> Self {
        let [north, east] = [0, 1].map(|axis| crater.centre()[axis] - foot[axis]);
        let (middle, side) = (north * cos + east * sin, east * cos - north * sin);
        // From the centre to the place of the sweep that lies o behind the middle: (side sin + o cos, o sin - side cos).
        let [x, y] = figures.squarers.map(|error| 1.0 + error);
        let square = x * cos * cos + y * sin * sin;
        let half = side * sin * cos * (x - y);
        let rest = side * side * (x * sin * sin + y * cos * cos);
        let nearest = (rest - half * half / square).max(0.0);
        Self {
            crater: reshaped(crater, figures.offset, square).unwrap_or(*crater),
            middle: middle - half / square,
            side: (nearest / square).sqrt().copysign(side),
        }
    }

    /// Ground ranges at which the sweep enters and leaves its circles, with the zones before and behind; the outermost circle first.
    pub fn crossings(&self) -> Vec<(f64, [Zone; 2])> {
        let mut crossings = Vec::new();
        let mut outside = Zone::Outside;
        let (outer, foot) = (self.crater.outer(), self.crater.foot());
        for (radius, inside) in
            [(outer, if outer > foot { Zone::Ring } else { Zone::Hollow }), (foot, Zone::Hollow)]
        {
            let [enters, leaves] = self.chord(radius * radius);
            if inside != outside && enters < leaves {
                crossings.extend([(enters, [outside, inside]), (leaves, [inside, outside])]);
                outside = inside;
            }
        }
        crossings
    }

    /// Ground ranges between which the sweep is within a circle of which the square is told (m).
    pub fn chord(&self, square: f64) -> [f64; 2] {
        let half = (square - self.side * self.side).max(0.0).sqrt();
        [self.middle - half, self.middle + half]
    }

    /// How near the sweep is to the centre at a range (m): 1 in the middle, 0 on the edge of the footprint and outside.
    pub fn nearness(&self, range: f64) -> f64 {
        let rho = libm::hypot(range - self.middle, self.side);
        (1.0 - (rho / self.crater.outer()) * (rho / self.crater.outer())).max(0.0)
    }

    /// Height, slope along and slope across at a range (m) by the law of a zone.
    pub fn law(&self, zone: Zone, range: f64) -> [f64; 3] {
        let (along, across) = (range - self.middle, -self.side);
        let rho = libm::hypot(along, across);
        let [height, outwards] = profile(&self.crater, zone, rho);
        // In the middle of a bowl the slope is 0 in every direction.
        let share = if rho > 0.0 { outwards / rho } else { 0.0 };
        [height, share * along, share * across]
    }
}

/// The crater that its squarers and their sum make of one; `square` is what they make of 1 m along the sweep.
fn reshaped(crater: &Crater, offset: f64, square: f64) -> Option<Crater> {
    let off = offset * crater.outer() * crater.outer();
    let circle = |radius: f64| ((radius * radius - off).max(SMALLEST * radius * radius) / square).sqrt();
    let shallower = |radius: f64| crater.depth() * (1.0 - off / (radius * radius)).max(0.0);
    let (shape, depth) = match crater.shape() {
        Shape::Bowl { r1 } => (Shape::Bowl { r1: circle(r1) }, shallower(r1)),
        Shape::RimmedBowl { r1, r2 } => (Shape::RimmedBowl { r1: circle(r1), r2: circle(r2) }, shallower(r1)),
        Shape::FlatFloor { r1, r2, r3 } => {
            (Shape::FlatFloor { r1: circle(r1), r2: circle(r2), r3: circle(r3) }, crater.depth())
        }
    };
    Crater::new(crater.centre(), shape, depth, crater.rim()).ok()
}

/// Height and its derivative outwards by the law of a zone (section 9).
fn profile(crater: &Crater, zone: Zone, rho: f64) -> [f64; 2] {
    let (floor, foot, outer) = (crater.floor(), crater.foot(), crater.outer());
    match zone {
        Zone::Outside => [0.0; 2],
        Zone::Hollow => {
            let up = (rho - floor).max(0.0) / (foot - floor);
            [crater.depth() * (up * up - 1.0), 2.0 * crater.depth() * up / (foot - floor)]
        }
        Zone::Ring => {
            let from_crest = (2.0 * rho - foot - outer) / (outer - foot);
            let rim = crater.rim();
            [rim * (1.0 - from_crest * from_crest), -4.0 * rim * from_crest / (outer - foot)]
        }
    }
}
