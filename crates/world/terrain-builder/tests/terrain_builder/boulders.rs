//! Boulders: forms, burial and bodies.

use terrain_builder::{Boulder, Shape};

use crate::near;

fn boulder(shape: Shape, burial: f64) -> Boulder {
    Boulder::new([30.0, 40.0], 2.0, shape, burial, [11, 3]).unwrap()
}

#[test]
fn the_buried_share_of_the_height_lies_below_the_ground() {
    for shape in [Shape::Sphere, Shape::Cube, Shape::Rock(14), Shape::Rock(4)] {
        for burial in [0.0, 0.25, 0.9] {
            let boulder = boulder(shape, burial);
            let body = boulder.body(1, 100.0).unwrap();
            let heights: Vec<_> = body.vertices().map(|corner| corner.z).collect();
            let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
            let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let [bottom, top] = boulder.span().unwrap();
            near(100.0 + boulder.lift().unwrap() + bottom, 100.0 - burial * (top - bottom), 1e-12);
            // Corners of the polyhedron of a sphere leave out the poles.
            let slack = if shape == Shape::Sphere { 0.04 } else { 1e-9 };
            near(low, 100.0 - burial * (top - bottom), slack);
            near(high - low, top - bottom, 2.0 * slack);
        }
    }
}

#[test]
fn a_sphere_reaches_two_radii_and_a_cube_one() {
    assert_eq!(boulder(Shape::Sphere, 0.0).span().unwrap(), [-2.0, 2.0]);
    assert_eq!(boulder(Shape::Cube, 0.0).span().unwrap(), [-1.0, 1.0]);
    near(boulder(Shape::Sphere, 0.0).lift().unwrap(), 2.0, 0.0);
}

#[test]
fn a_rock_has_as_many_faces_as_asked_and_reaches_its_radius() {
    for faces in [4, 5, 6, 8, 14, 30, 64] {
        for number in 0..40 {
            let rock = Boulder::new([0.0; 2], 3.0, Shape::Rock(faces), 0.0, [5, number]).unwrap();
            let body = rock.body(1, 0.0).unwrap();
            assert_eq!(body.solid.faces().len(), faces as usize, "rock {number}");
            let middle = glam::DVec3::new(0.0, 0.0, rock.lift().unwrap());
            let reach = body.vertices().map(|corner| corner.distance(middle)).fold(0.0, f64::max);
            near(reach, 3.0, 1e-9);
        }
    }
}

#[test]
fn seeds_turn_and_form_rocks() {
    let other = Boulder::new([30.0, 40.0], 2.0, Shape::Rock(14), 0.25, [11, 4]).unwrap();
    let rock = boulder(Shape::Rock(14), 0.25);
    assert_ne!(rock.yaw(), other.yaw());
    let solid = |boulder: &Boulder| boulder.body(1, 0.0).unwrap().solid;
    assert_ne!(solid(&rock).vertices(), solid(&other).vertices());
    assert_eq!(solid(&rock).vertices(), solid(&boulder(Shape::Rock(14), 0.25)).vertices());
}

#[test]
fn bad_boulders_are_refused_by_their_key() {
    let refused = |radius, shape, burial| {
        Boulder::new([0.0; 2], radius, shape, burial, [0, 0]).expect_err("refused").key
    };
    assert_eq!(refused(0.0, Shape::Sphere, 0.0), "radius_m");
    assert_eq!(refused(f64::NAN, Shape::Sphere, 0.0), "radius_m");
    assert_eq!(refused(1.0, Shape::Cube, 0.95), "burial");
    assert_eq!(refused(1.0, Shape::Cube, f64::NAN), "burial");
    assert_eq!(refused(1.0, Shape::Rock(3), 0.0), "faces");
}
