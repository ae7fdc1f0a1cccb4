//! Seeded shapes of rocks.
//!
//! Four habits take turns: angular (broken, no two faces alike), slabby (flat top, low), rounded (worn), blocky
//! (a box with broken corners). A shape is the hull of seeded points; its greatest horizontal extent is 1, so
//! the scale of a placed body is the size of the rock in metres. The foot point lies above the lowest vertex by
//! a tenth to a quarter of the height: a rock is sunk into the soil that it has gathered.

use std::f64::consts::TAU;

use glam::DVec3;
use quantities::{sin_cos, unit_interval};

use crate::{Solid, SolidError};

/// Number of rock shapes of one seed.
pub const SHAPES: usize = 12;

/// The [`SHAPES`] shapes of a seed.
///
/// # Errors
/// None of the shapes of [`unit_interval`] is known to degenerate; one that did is refused, not drawn.
pub fn shapes(seed: u64) -> Result<Vec<Solid>, SolidError> {
    (0..SHAPES).map(|index| shape(Dice { seed, shape: index as u64 }, index)).collect()
}

/// Randomness of one shape.
#[derive(Debug, Clone, Copy)]
struct Dice {
    seed: u64,
    shape: u64,
}

/// Names the use of a hash.
const SHAPE: u64 = u64::from_be_bytes(*b"rocks-sh");

impl Dice {
    /// A number in `[low, high)`, named by point and use.
    fn between(&self, low: f64, high: f64, point: u64, part: u64) -> f64 {
        low + (high - low) * unit_interval(self.seed, &[SHAPE, self.shape, point, part])
    }
}

fn shape(dice: Dice, index: usize) -> Result<Solid, SolidError> {
    let points = match index % 4 {
        0 => angular(dice),
        1 => slabby(dice),
        2 => rounded(dice),
        _ => blocky(dice),
    };
    let rough = Solid::hull(&points, 1.0)?;
    let solid = Solid::hull(&seated(rough.vertices(), dice), 1.0)?;
    // Fresh faces are brighter than worn ones, by a few hundredths.
    solid.painted(|normal| {
        let word = |part: f64| part.to_bits();
        let share = unit_interval(dice.seed, &[SHAPE, dice.shape, word(normal.x), word(normal.y)]);
        0.8 + 0.12 * share
    })
}

/// Evenly spread directions (golden spiral), each moved a little.
fn directions(dice: Dice, count: u64, stray: f64) -> impl Iterator<Item = (u64, DVec3)> {
    const GOLDEN_TURN: f64 = TAU * 0.381_966_011_250_105_1;
    (0..count).map(move |point| {
        let z = 1.0 - (2.0 * point as f64 + 1.0) / count as f64;
        let (sin, cos) = sin_cos(GOLDEN_TURN * point as f64 + dice.between(0.0, TAU, u64::MAX, 0));
        let across = (1.0 - z * z).sqrt();
        let moved = DVec3::from_array([0, 1, 2].map(|part| dice.between(-stray, stray, point, part)));
        (point, DVec3::new(across * cos, across * sin, z) + moved)
    })
}

fn angular(dice: Dice) -> Vec<DVec3> {
    let squash = DVec3::new(1.0, dice.between(0.65, 0.9, 0, 8), dice.between(0.55, 0.85, 0, 9));
    let lean = dice.between(-0.35, 0.35, 0, 10);
    let jagged = |(point, direction): (u64, DVec3)| {
        let place = direction.normalize() * dice.between(0.7, 1.0, point, 4) * squash;
        DVec3::new(place.x + lean * place.z, place.y, place.z)
    };
    directions(dice, 13, 0.35).map(jagged).collect()
}

fn slabby(dice: Dice) -> Vec<DVec3> {
    let (sides, wide) = (7, dice.between(0.55, 0.8, 0, 8));
    let thickness = dice.between(0.3, 0.45, 0, 9);
    let tilt = [10, 11].map(|part| dice.between(-0.12, 0.12, 0, part));
    let rings = [(0.78, thickness), (1.0, 0.55 * thickness), (0.9, -0.6 * thickness)];
    let corner = move |(ring, (radius, height)): (usize, (f64, f64))| {
        (0..sides).map(move |side| {
            let point = 16 * ring as u64 + side;
            let turn = TAU * (side as f64 + dice.between(-0.3, 0.3, side, 0)) / sides as f64;
            let (sin, cos) = sin_cos(turn);
            let radius = radius * dice.between(0.8, 1.0, side, 1) * dice.between(0.95, 1.0, point, 2);
            let [x, y] = [radius * cos, wide * radius * sin];
            // The top ring stays in one tilted plane: a flat facet.
            let uneven = if ring == 0 { 0.0 } else { dice.between(-0.15, 0.15, point, 3) * thickness };
            DVec3::new(x, y, height + uneven + tilt[0] * x + tilt[1] * y)
        })
    };
    rings.into_iter().enumerate().flat_map(corner).collect()
}

fn rounded(dice: Dice) -> Vec<DVec3> {
    let squash = DVec3::new(1.0, dice.between(0.75, 0.95, 0, 8), dice.between(0.6, 0.8, 0, 9));
    let worn =
        |(point, direction): (u64, DVec3)| direction.normalize() * dice.between(0.93, 1.0, point, 4) * squash;
    directions(dice, 22, 0.12).map(worn).collect()
}

fn blocky(dice: Dice) -> Vec<DVec3> {
    let half = DVec3::new(1.0, dice.between(0.6, 0.85, 0, 8), dice.between(0.5, 0.75, 0, 9));
    let taper = dice.between(0.0, 0.25, 0, 10);
    let broken_corner = |corner: u64| {
        let sign = DVec3::from_array([1, 2, 4].map(|bit| if corner & bit == 0 { -1.0 } else { 1.0 }));
        let narrow = 1.0 - taper * (0.5 + 0.5 * sign.z);
        let whole = sign * half * DVec3::new(narrow, narrow, 1.0);
        let chip = move |axis: usize| {
            let mut point = whole;
            point[axis] -= sign[axis] * half[axis] * dice.between(0.1, 0.5, corner, axis as u64);
            point
        };
        // Two chips on each corner keep the sides of the block flat.
        [chip(0), chip(if corner.is_multiple_of(3) { 2 } else { 1 })]
    };
    (0..8).flat_map(broken_corner).collect()
}

/// Scaled to a horizontal extent of 1 about the origin, and sunk.
fn seated(points: &[DVec3], dice: Dice) -> Vec<DVec3> {
    let low = points.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = points.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
    let extent = (high - low).truncate().max_element();
    let sunk = dice.between(0.1, 0.25, 0, 15) * (high.z - low.z);
    let foot = ((low + high) * 0.5).truncate().extend(low.z + sunk);
    points.iter().map(|&point| (point - foot) / extent).collect()
}

#[cfg(test)]
mod tests {
    use super::{SHAPES, shapes};

    #[test]
    fn twelve_shapes_of_any_seed_are_solids_of_unit_extent_that_sit_in_the_ground() {
        for seed in 0..50 {
            let shapes = shapes(seed).unwrap();
            assert_eq!(shapes.len(), SHAPES);
            for (index, shape) in shapes.iter().enumerate() {
                let faces = shape.faces().len();
                assert!((12..=40).contains(&faces), "seed {seed}, shape {index}: {faces} faces");
                let span = |axis: usize| {
                    let along = shape.vertices().iter().map(|vertex| vertex[axis]);
                    along.clone().fold(f64::INFINITY, f64::min)..along.fold(f64::NEG_INFINITY, f64::max)
                };
                let (x, y, z) = (span(0), span(1), span(2));
                assert!(((x.end - x.start).max(y.end - y.start) - 1.0).abs() < 1e-12);
                let sunk = -z.start / (z.end - z.start);
                assert!((0.1..0.25).contains(&sunk), "{sunk}");
                assert!(z.end < 1.0 && z.end > 0.1);
            }
        }
    }

    #[test]
    fn slabs_and_blocks_have_flat_facets() {
        let shapes = shapes(3).unwrap();
        let corners =
            |shape: usize| shapes[shape].faces().iter().map(|face| face.corners.len()).max().unwrap();
        assert!(corners(1) >= 5 && corners(3) >= 5, "{} {}", corners(1), corners(3));
    }

    #[test]
    fn seeds_differ_and_repeat() {
        assert_eq!(shapes(1).unwrap(), shapes(1).unwrap());
        assert_ne!(shapes(1).unwrap()[0], shapes(2).unwrap()[0]);
    }
}
