//! Common convex solids, such as a box.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::{Solid, SolidError};

impl Solid {
    /// The box between two corners (m).
    ///
    /// # Errors
    /// If it has no volume.
    pub fn boxed(low: DVec3, high: DVec3, albedo: f64) -> Result<Self, SolidError> {
        let pick = |bit: usize, a: f64, b: f64| if bit == 0 { a } else { b };
        let corner = |index: usize| {
            DVec3::new(
                pick(index & 1, low.x, high.x),
                pick(index & 2, low.y, high.y),
                pick(index & 4, low.z, high.z),
            )
        };
        Self::hull(&(0..8).map(corner).collect::<Vec<_>>(), albedo)
    }

    /// The octahedron with a corner in the middle of each side of the box between two corners (m).
    ///
    /// # Errors
    /// If it has no volume.
    pub fn octahedron(low: DVec3, high: DVec3, albedo: f64) -> Result<Self, SolidError> {
        let middle = (low + high) / 2.0;
        let at = |axis: usize, end: DVec3| {
            let mut corner = middle;
            corner[axis] = end[axis];
            corner
        };
        let corners: Vec<DVec3> = (0..3).flat_map(|axis| [at(axis, low), at(axis, high)]).collect();
        Self::hull(&corners, albedo)
    }

    /// A prism or frustum of `sides` sides about the axis between two points; radii (m) at the corners there. A
    /// radius of 0 makes a point. One side's corner lies towards the part of `up` that is square to the axis.
    ///
    /// # Errors If it has no volume or fewer than 3 sides.
    pub fn prism(
        [from, to]: [DVec3; 2],
        [radius_from, radius_to]: [f64; 2],
        up: DVec3,
        sides: u32,
        albedo: f64,
    ) -> Result<Self, SolidError> {
        let mut points = ring(from, to - from, radius_from, up, sides);
        points.extend(ring(to, to - from, radius_to, up, sides));
        Self::hull(&points, albedo)
    }

    /// A thin square strut between two points, `width` across (m).
    ///
    /// # Errors
    /// If it has no volume.
    pub fn strut(from: DVec3, to: DVec3, width: f64, albedo: f64) -> Result<Self, SolidError> {
        let half_diagonal = width * std::f64::consts::FRAC_1_SQRT_2;
        Self::prism([from, to], [half_diagonal; 2], (to - from).any_orthogonal_vector(), 4, albedo)
    }
}

/// Corners of a regular polygon around `middle`, square to `axis`, the first towards `up`.
fn ring(middle: DVec3, axis: DVec3, radius: f64, up: DVec3, sides: u32) -> Vec<DVec3> {
    let axis = axis.normalize_or(DVec3::Z);
    let across = axis.cross(up).normalize_or(axis.any_orthonormal_vector());
    let first = across.cross(axis);
    let at = |side: u32| {
        let (sin, cos) = quantities::sin_cos(TAU * f64::from(side) / f64::from(sides));
        middle + first * (radius * cos) + across * (radius * sin)
    };
    (0..sides).map(at).collect()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use crate::{Solid, SolidError};

    #[test]
    fn a_box_has_six_faces_whose_normals_point_outwards() {
        let solid = Solid::boxed(DVec3::new(-1.0, -2.0, 0.0), DVec3::new(1.0, 2.0, 3.0), 0.5).unwrap();
        assert_eq!((solid.vertices().len(), solid.faces().len()), (8, 6));
        let middle = DVec3::new(0.0, 0.0, 1.5);
        for face in solid.faces() {
            let corners: Vec<_> =
                face.corners.iter().map(|&corner| solid.vertices()[corner as usize]).collect();
            assert!(face.normal.dot(corners[0] - middle) > 0.9);
            // Body axes are left-handed: counter-clockwise from outside has its cross product inwards.
            let cross = (corners[1] - corners[0]).cross(corners[2] - corners[1]);
            assert!(cross.dot(face.normal) < 0.0);
            assert_eq!(face.corners.len(), 4);
        }
        assert_eq!(solid.size(), 29f64.sqrt());
        assert_eq!(solid.radius(), 14f64.sqrt());
    }

    #[test]
    fn prisms_and_cones() {
        let wheel = Solid::prism([DVec3::ZERO, DVec3::Y], [0.4, 0.4], DVec3::Z, 16, 1.0).unwrap();
        assert_eq!((wheel.vertices().len(), wheel.faces().len()), (32, 18));
        let cone = Solid::prism([DVec3::ZERO, DVec3::Z], [0.4, 0.0], DVec3::X, 5, 1.0).unwrap();
        assert_eq!((cone.vertices().len(), cone.faces().len()), (6, 6));
        let strut = Solid::strut(DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0), 0.05, 1.0).unwrap();
        assert_eq!((strut.vertices().len(), strut.faces().len()), (8, 6));
    }

    #[test]
    fn nothing_with_no_volume() {
        assert_eq!(Solid::boxed(DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0), 1.0), Err(SolidError::Flat));
        assert!(Solid::boxed(DVec3::ZERO, DVec3::ZERO, 1.0).is_err());
        assert!(Solid::boxed(DVec3::ZERO, DVec3::splat(f64::NAN), 1.0).is_err());
        assert!(Solid::prism([DVec3::ZERO, DVec3::Z], [1.0; 2], DVec3::X, 2, 1.0).is_err());
        assert!(Solid::boxed(DVec3::ZERO, DVec3::ONE, 1.5).is_err());
    }
}
