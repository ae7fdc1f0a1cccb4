//! Solids, hulls and bodies against brute force.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use proptest::collection::vec;
use proptest::prelude::{Strategy, prop_assert, prop_assert_eq, proptest};
use solids::{Body, Kind, Solid, SolidError};

fn tetrahedron() -> (Vec<DVec3>, Vec<(Vec<u32>, f64)>) {
    let vertices = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    let faces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
    (vertices, faces.iter().map(|face| (face.to_vec(), 0.5)).collect())
}

#[test]
fn faces_are_turned_outwards_whichever_way_they_are_given() {
    let (vertices, mut faces) = tetrahedron();
    let solid = Solid::new(vertices.clone(), faces.clone()).unwrap();
    faces[1].0.reverse();
    faces[3].0.rotate_left(1);
    let other = Solid::new(vertices, faces).unwrap();
    for (a, b) in solid.faces().iter().zip(other.faces()) {
        assert!((a.normal - b.normal).length() < 1e-15);
    }
    assert_eq!(solid.faces()[0].normal, DVec3::NEG_Z);
    assert!((solid.faces()[3].normal - DVec3::splat(1.0 / 3f64.sqrt())).length() < 1e-15);
}

#[test]
fn what_is_no_convex_solid_is_refused() {
    let (vertices, faces) = tetrahedron();
    let refused = |vertices: &[DVec3], faces: &[(Vec<u32>, f64)]| {
        Solid::new(vertices.to_vec(), faces.to_vec()).unwrap_err()
    };
    assert_eq!(refused(&vertices[..3], &faces), SolidError::TooSmall { vertices: 3, faces: 4 });
    assert_eq!(refused(&vertices, &faces[..3]), SolidError::TooSmall { vertices: 4, faces: 3 });
    let mut open = faces.clone();
    open[3].0 = vec![0, 1, 2];
    assert!(matches!(refused(&vertices, &open), SolidError::Open(..)));
    let mut index = faces.clone();
    index[2].0[1] = 4;
    assert_eq!(refused(&vertices, &index), SolidError::NoVertex { face: 2, vertex: 4, last: 3 });
    let mut twice = faces.clone();
    twice[2].0 = vec![0, 2, 2];
    assert!(matches!(refused(&vertices, &twice), SolidError::BadFace { face: 2, .. }));
    let mut bright = faces.clone();
    bright[1].1 = f64::NAN;
    assert!(matches!(refused(&vertices, &bright), SolidError::BadAlbedo { face: 1, .. }));
    let mut spare = vertices.clone();
    spare.push(DVec3::splat(0.1));
    assert_eq!(refused(&spare, &faces), SolidError::Unused { vertex: 4 });
    for bad in [f64::NAN, f64::INFINITY, 1e6] {
        let mut wild = vertices.clone();
        wild[1].x = bad;
        assert_eq!(refused(&wild, &faces), SolidError::BadVertex { vertex: 1 });
    }
    let mut line = vertices.clone();
    line[2] = DVec3::X * 2.0;
    assert!(matches!(refused(&line, &faces), SolidError::BadFace { .. } | SolidError::Flat));
}

/// A box whose vertex 7 is pulled by `pull`, as triangles.
fn pulled(pull: f64) -> Result<Solid, SolidError> {
    let corner = |index: u32| {
        let bit = |bit: u32| f64::from((index >> bit) & 1);
        DVec3::new(bit(0), bit(1), bit(2)) * (if index == 7 { 1.0 + pull } else { 1.0 })
    };
    let squares = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let halves = |square: &[u32; 4]| {
        // Split along the diagonal that does not end at vertex 7: if that is pulled outwards, there is a dent.
        let [a, b, c, d] = *square;
        [(vec![a, b, d], 1.0), (vec![b, c, d], 1.0)]
    };
    Solid::new((0..8).map(corner).collect(), squares.iter().flat_map(halves).collect())
}

/// Each edge of the faces that are left is run through once each way, but those of the lid.
#[test]
fn a_box_without_its_lid_is_open() {
    let corner =
        |index: u32| DVec3::new(f64::from(index & 1), f64::from(index >> 1 & 1), f64::from(index >> 2));
    let sides = [[0, 1, 3, 2], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let open = Solid::new((0..8).map(corner).collect(), sides.map(|side| (side.to_vec(), 1.0)).to_vec());
    assert!(matches!(open, Err(SolidError::Open(4..=7, 4..=7))), "{open:?}");
}

#[test]
fn a_dent_is_found_with_its_depth_and_rounding_passes() {
    assert!(pulled(-0.2).is_ok());
    assert!(pulled(0.0).is_ok(), "triangles in one plane");
    assert!(pulled(1e-6).is_ok(), "rounded by a file");
    match pulled(0.2) {
        Err(SolidError::NotConvex { outside, .. }) => assert!(outside > 0.05, "{outside}"),
        other => panic!("{other:?}"),
    }
    let (mut vertices, _) = tetrahedron();
    vertices.push(DVec3::new(1.0, 1.0, 0.01));
    let faces = [vec![0, 1, 4, 2], vec![0, 1, 3], vec![1, 4, 3], vec![4, 2, 3], vec![2, 0, 3]];
    let bent = Solid::new(vertices, faces.into_iter().map(|face| (face, 1.0)).collect());
    assert_eq!(bent, Err(SolidError::BadFace { face: 0, what: "corners not in one plane" }));
}

fn place() -> impl Strategy<Value = DVec3> {
    [-3.0..3.0f64, -3.0..3.0, -1.0..2.0].prop_map(DVec3::from_array)
}

/// Whether a point lies in a body, by its planes.
fn holds(body: &Body, point: DVec3, slack: f64) -> bool {
    (0..body.normals().len()).all(|face| body.normal(face).dot(point - body.on_face(face)) <= slack)
}

fn placed(points: &[DVec3]) -> Option<Body> {
    let solid = Arc::new(Solid::hull(points, 0.9).ok()?);
    let turn = DMat3::from_rotation_z(0.7) * DMat3::from_rotation_x(0.3);
    Some(Body::place(1, Kind::Rock, &solid, DVec3::new(5.0, 2.0, 1.0), &turn, 1.5))
}

proptest! {
    #[test]
    fn a_hull_holds_all_its_points_and_is_closed(points in vec(place(), 4..60)) {
        let solid = Solid::hull(&points, 1.0).unwrap();
        for face in solid.faces() {
            let on_face = solid.vertices()[face.corners[0] as usize];
            prop_assert!(points.iter().all(|point| face.normal.dot(*point - on_face) < 1e-8));
        }
        // Euler: vertices - edges + faces = 2.
        let edges: usize = solid.faces().iter().map(|face| face.corners.len()).sum();
        prop_assert_eq!(solid.vertices().len() + solid.faces().len(), edges / 2 + 2);
    }

    #[test]
    fn points_on_a_lattice_join_to_flat_facets(corners in vec([0..4i32, 0..4, 0..4], 4..40)) {
        let points: Vec<DVec3> =
            corners.iter().map(|corner| DVec3::from_array(corner.map(f64::from)) * 0.1).collect();
        match Solid::hull(&points, 1.0) {
            Ok(solid) => {
                let normals = solid.faces().iter().map(|face| face.normal);
                let normals: Vec<DVec3> = normals.collect();
                let alike = |at: usize| normals[..at].iter().any(|other| other.dot(normals[at]) > 1.0 - 1e-9);
                prop_assert!(!(0..normals.len()).any(alike), "two faces in one plane");
            }
            Err(error) => {
                // Then all points lie in one plane: every volume of four is 0.
                let first = points[0];
                for a in &points { for b in &points { for c in &points {
                    prop_assert!((*a - first).cross(*b - first).dot(*c - first).abs() < 1e-9, "{}", error);
                }}}
            }
        }
    }

    #[test]
    fn a_ray_enters_where_marching_finds_the_body(points in vec(place(), 6..30), origin in place(), aim in place()) {
        let Some(body) = placed(&points) else { return Ok(()) };
        let origin = origin * 5.0;
        let direction = (body.centre + aim - origin).normalize();
        let steps = 4000;
        let step = 40.0 / f64::from(steps);
        let at = |number: i32| origin + direction * (step * f64::from(number));
        let marched = (0..steps).find(|&number| holds(&body, at(number), 0.0));
        match (body.first_hit(origin, direction, 0.0), marched) {
            (Some(hit), Some(number)) if number > 0 => {
                prop_assert!((hit.distance - step * f64::from(number)).abs() <= step);
                let met = origin + direction * hit.distance;
                prop_assert!(body.normal(hit.face).dot(met - body.on_face(hit.face)).abs() < 1e-9);
                prop_assert!(body.normal(hit.face).dot(direction) < 0.0);
            }
            // A ray that begins within enters nothing.
            (None, Some(number)) => prop_assert_eq!(number, 0),
            // Marching steps over a corner.
            (Some(hit), _) => prop_assert!(holds(&body, origin + direction * hit.distance, 1e-9)),
            (None, None) => {}
        }
    }

    /// Corners are where the bounding sphere is met.
    #[test]
    fn a_ray_to_a_place_just_within_a_corner_enters(points in vec(place(), 6..30), origin in place()) {
        let Some(body) = placed(&points) else { return Ok(()) };
        let origin = body.centre + (origin + DVec3::splat(0.01)).normalize() * 3.0 * body.radius;
        let middle = body.vertices().sum::<DVec3>() / body.vertices().len() as f64;
        for vertex in body.vertices() {
            let within = vertex + (middle - vertex) * 1e-3;
            prop_assert!(body.first_hit(origin, within - origin, 0.0).is_some(), "{}", vertex);
        }
    }

    #[test]
    fn the_bounding_sphere_bounds(points in vec(place(), 6..30)) {
        let Some(body) = placed(&points) else { return Ok(()) };
        let (centre, radius) = (body.centre, body.radius);
        prop_assert!(body.vertices().all(|vertex| vertex.distance(centre) <= radius));
        prop_assert!(body.vertices().any(|vertex| vertex.distance(centre) >= radius * (1.0 - 1e-12)));
        prop_assert!(body.vertices().all(|vertex| vertex.distance(body.foot) <= 1.5 * body.solid.radius() + 1e-9));
    }
}

#[test]
fn light_of_a_box() {
    let solid = Arc::new(Solid::boxed(DVec3::ZERO, DVec3::ONE, 0.5).unwrap());
    let body = Body::place(0, Kind::Culture, &solid, DVec3::ZERO, &DMat3::IDENTITY, 2.0);
    let sun = DVec3::new(0.6, 0.0, 0.8);
    for (face, light) in body.reflectivities(sun).enumerate() {
        let normal = body.normal(face);
        let expected = if normal.x > 0.9 {
            0.3
        } else if normal.z > 0.9 {
            0.4
        } else {
            0.0
        };
        assert!((light - expected).abs() < 1e-15, "{normal}: {light}");
    }
    assert_eq!((solid.size(), body.radius), (3f64.sqrt(), 3f64.sqrt()));
}

#[test]
fn rays_and_a_box() {
    let solid = Arc::new(Solid::boxed(DVec3::ZERO, DVec3::ONE, 0.5).unwrap());
    let body = Body::place(0, Kind::Culture, &solid, DVec3::ZERO, &DMat3::IDENTITY, 2.0);
    let hit = |origin: [f64; 3], direction: DVec3, from: f64| {
        body.first_hit(DVec3::from_array(origin), direction, from)
            .map(|hit| (hit.distance, body.normal(hit.face)))
    };
    assert_eq!(hit([-1.0, 1.0, 1.0], DVec3::X, 0.0), Some((1.0, DVec3::NEG_X)));
    assert_eq!(hit([-1.0, 1.0, 1.0], DVec3::X * 0.5, 0.0), Some((2.0, DVec3::NEG_X)));
    assert_eq!(hit([-1.0, 1.0, 1.0], DVec3::X, 1.5), None, "it is inside by then");
    assert_eq!(hit([1.0, 1.0, 1.0], DVec3::X, 0.0), None, "it begins inside");
    assert_eq!(hit([3.0, 1.0, 1.0], DVec3::X, 0.0), None, "it is behind");
    assert_eq!(hit([-1.0, 3.0, 1.0], DVec3::X, 0.0), None, "it passes beside, parallel to a face");
    assert_eq!(hit([1.0, 1.0, 2.0], DVec3::new(0.6, 0.0, 0.8), 0.0), None, "it leaves from a face");
}
