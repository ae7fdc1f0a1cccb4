//! Orientation: the matrix of the specification (7.2), its angles, and axes that are no rotation.

use glam::{DMat3, DVec3};
use photo_camera::{CameraError, Orientation};

use crate::{Random, thesis_camera};

#[test]
fn the_matrix_is_that_of_the_specification() {
    let expected = [
        [-0.895735188980704, 0.369689442833629, -0.246957864987255],
        [-0.058725244790364, -0.648993001866147, -0.758524507944917],
        [-0.440692428850342, -0.664934432396254, 0.603035972200546],
    ];
    for (row, expected) in thesis_camera().orientation().axes().into_iter().zip(expected) {
        assert!((row - DVec3::from(expected)).length() < 3e-15, "{row}");
    }
}

#[test]
fn three_angles_are_three_turns_one_after_the_other() {
    let mut random = Random(3);
    for _ in 0..500 {
        let angles: [f64; 3] = std::array::from_fn(|_| random.between(-3.0, 3.0));
        // The matrix takes a vector into turned axes: the inverse of a turn of the vector.
        let [omega, phi, kappa] = angles.map(|angle| -angle);
        let turns =
            DMat3::from_rotation_z(kappa) * DMat3::from_rotation_y(phi) * DMat3::from_rotation_x(omega);
        let vector = DVec3::new(random.unit(), random.unit(), random.unit());
        let found = Orientation::from_angles(angles).expect("finite angles").image(vector);
        assert!((found - turns * vector).length() < 1e-14);
    }
}

#[test]
fn angles_and_axes_give_the_same_orientation_also_straight_ahead() {
    let mut random = Random(4);
    for case in 0..500 {
        let phi = if case % 5 == 0 { std::f64::consts::FRAC_PI_2 } else { random.between(-1.5, 1.5) };
        let angles = [random.between(-3.0, 3.0), phi, random.between(-3.0, 3.0)];
        let orientation = Orientation::from_angles(angles).expect("finite angles");
        let of_axes = Orientation::from_axes(orientation.axes()).expect("a rotation");
        let again = Orientation::from_angles(of_axes.angles()).expect("finite angles");
        for (one, other) in orientation.axes().into_iter().zip(again.axes()) {
            assert!((one - other).length() < 1e-11, "{angles:?}");
        }
    }
}

#[test]
fn axes_that_are_no_rotation_are_refused_with_how_far_they_are_off() {
    let off = |axes| match Orientation::from_axes(axes) {
        Err(CameraError::NoRotation { what, off, .. }) => (what, off),
        other => panic!("{other:?}"),
    };
    let (what, by) = off([DVec3::X * 1.001, DVec3::Y, DVec3::Z]);
    assert!(what.contains("x axis") && (by - 0.001).abs() < 1e-12);
    let (what, by) = off([DVec3::X, DVec3::Y, DVec3::new(0.0, 0.6, 0.8)]);
    assert!(what.contains("y and z") && (by - 0.6).abs() < 1e-12);
    assert_eq!(off([DVec3::X, DVec3::Y, -DVec3::Z]), ("handedness", -2.0));
    assert!(off([DVec3::NAN, DVec3::Y, DVec3::Z]).1.is_nan());
    assert!(Orientation::from_axes([DVec3::X, DVec3::Y, DVec3::new(0.0, 5e-10, 1.0)]).is_ok());
    assert!(Orientation::from_directions([DVec3::X * 7.0, DVec3::Y * 0.1, DVec3::Z * 3.0]).is_ok());
    assert!(Orientation::from_directions([DVec3::ZERO, DVec3::Y, DVec3::Z]).is_err());
    assert!(Orientation::from_angles([0.0, f64::INFINITY, 0.0]).is_err());
}
