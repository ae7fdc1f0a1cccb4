//! Flat convex polygons, as people write their corners.

use glam::DVec3;

/// How far, in diameters, a corner may be from where a flat convex polygon would have it. Chosen: what is lost in decimals.
const TOLERANCE: f64 = 1e-6;

/// Why corners are no flat convex polygon. Corners count from 0, as elements of a file do.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum PolygonFault {
    /// Two corners in one place.
    #[error("corners {0} and {1} are in one place")]
    Coincide(usize, usize),
    /// Corners on one line, or edges that cross so that nothing is left.
    #[error("it has no area: its corners lie on one line, or its edges cross")]
    NoArea,
    /// A corner beside the plane of the others.
    #[error("corner {corner} is {distance:.3e} m beside the plane of the polygon")]
    NotFlat {
        /// Number of the corner.
        corner: usize,
        /// How far it is from the plane (m).
        distance: f64,
    },
    /// Corners that do not go around a convex polygon in their order.
    #[error("corner {corner} is on the outer side of the edge that begins at corner {edge}")]
    NotConvex {
        /// Number of the corner.
        corner: usize,
        /// Number of the corner at which the edge begins.
        edge: usize,
    },
}

/// Whether `corners` (m, 3 or more) go around a flat convex polygon, in either sense.
///
/// # Errors
/// The first thing that is wrong.
pub fn check(corners: &[DVec3]) -> Result<(), PolygonFault> {
    let diameter = pairs(corners).map(|(a, b)| corners[a].distance(corners[b])).fold(0.0, f64::max);
    let tolerance = TOLERANCE * diameter;
    let meets = |&(a, b): &(usize, usize)| corners[a].distance(corners[b]) <= tolerance;
    if let Some((a, b)) = pairs(corners).find(meets) {
        return Err(PolygonFault::Coincide(a, b));
    }
    let edges = || corners.iter().zip(corners.iter().cycle().skip(1));
    let twice_area: DVec3 = edges().map(|(a, b)| (*a - corners[0]).cross(*b - corners[0])).sum();
    if twice_area.length() <= tolerance * diameter {
        return Err(PolygonFault::NoArea);
    }
    let normal = twice_area.normalize();
    let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
    for (corner, at) in corners.iter().enumerate() {
        let distance = (*at - middle).dot(normal).abs();
        if distance > tolerance {
            return Err(PolygonFault::NotFlat { corner, distance });
        }
    }
    for (edge, (from, to)) in edges().enumerate() {
        let inwards = normal.cross(*to - *from).normalize();
        if let Some(corner) = corners.iter().position(|at| (*at - *from).dot(inwards) < -tolerance) {
            return Err(PolygonFault::NotConvex { corner, edge });
        }
    }
    Ok(())
}

/// Numbers of every two corners.
fn pairs(corners: &[DVec3]) -> impl Iterator<Item = (usize, usize)> {
    let count = corners.len();
    (0..count).flat_map(move |a| (a + 1..count).map(move |b| (a, b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checked(corners: &[[f64; 3]]) -> Result<(), PolygonFault> {
        check(&corners.iter().copied().map(DVec3::from_array).collect::<Vec<_>>())
    }

    #[test]
    fn flat_convex_polygons_are_taken_in_both_senses() {
        let mut slanted =
            vec![[0.0, 0.0, 0.0], [8.0, 0.0, 4.0], [8.0, 6.0, 4.0], [4.0, 6.0, 2.0], [0.0, 6.0, 0.0]];
        assert_eq!(checked(&slanted), Ok(()));
        slanted.reverse();
        assert_eq!(checked(&slanted), Ok(()));
        // Within 1e-6 of its diameter it is flat.
        slanted[0][2] += 9e-6;
        assert_eq!(checked(&slanted), Ok(()));
    }

    #[test]
    fn each_fault_is_named() {
        use PolygonFault::{Coincide, NoArea, NotConvex, NotFlat};
        assert_eq!(checked(&[[0.0; 3], [1.0, 0.0, 0.0]]), Err(NoArea));
        assert_eq!(checked(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0; 3]]), Err(Coincide(0, 2)));
        assert_eq!(checked(&[[7.0; 3]; 4]), Err(Coincide(0, 1)));
        assert_eq!(checked(&[[0.0; 3], [1.0, 1.0, 0.0], [3.0, 3.0, 0.0]]), Err(NoArea));
        let bent = [[0.0; 3], [4.0, 0.0, 0.0], [4.0, 4.0, 1.0], [0.0, 4.0, 0.0]];
        assert!(matches!(checked(&bent), Err(NotFlat { corner: 0, .. })));
        let dented = [[0.0; 3], [4.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 4.0, 0.0]];
        assert_eq!(checked(&dented), Err(NotConvex { corner: 3, edge: 1 }));
        // Five corners of a star: each edge turns left, and the edges cross.
        let around = |k: usize| {
            let angle = 144.0_f64.to_radians() * k as f64;
            [libm::cos(angle), libm::sin(angle), 0.0]
        };
        assert!(matches!(checked(&[0, 1, 2, 3, 4].map(around)), Err(NotConvex { .. })));
        let twice = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        assert_eq!(checked(&twice), Err(Coincide(0, 3)));
    }
}
