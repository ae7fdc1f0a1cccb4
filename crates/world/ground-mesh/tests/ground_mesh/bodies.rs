//! Bodies as triangles: closed, outwards, as large as the body.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use ground_mesh::body_triangles;
use solids::{Body, Kind, Solid};

use super::Random;

/// Six times the volume under a triangle; axes are left-handed, so triangles that look outwards make it negative.
fn volume([p, q, r]: [DVec3; 3]) -> f64 {
    p.dot(q.cross(r))
}

#[test]
fn triangles_of_a_box_look_outwards_and_enclose_it() {
    let solid = Solid::boxed(DVec3::new(-1.0, -2.0, 0.0), DVec3::new(1.0, 2.0, 3.0), 0.4).unwrap();
    let body =
        Body::place(1, Kind::Culture, &Arc::new(solid), DVec3::new(5.0, 6.0, 7.0), &DMat3::IDENTITY, 2.0);
    let triangles: Vec<_> = body_triangles(&body).collect();
    assert_eq!(triangles.len(), 12);
    let sum: f64 = triangles.iter().map(|triangle| volume(triangle.corners)).sum();
    assert!((sum / -6.0 - 24.0 * 8.0).abs() < 1e-9, "{sum}");
    for triangle in triangles {
        let [p, q, r] = triangle.corners;
        assert!((q - p).cross(r - p).normalize().dot(triangle.normals[0]) < -1.0 + 1e-12);
        assert_eq!((triangle.normals, triangle.albedo), ([body.normal(triangle.face); 3], [0.4; 3]));
    }
}

#[test]
fn triangles_of_any_rock_are_closed() {
    let mut random = Random(4);
    for _ in 0..50 {
        let mut point = || DVec3::new(random.unit(), random.unit(), random.unit());
        let points: Vec<DVec3> = (0..20).map(|_| point()).collect();
        let solid = Arc::new(Solid::hull(&points, 0.5).unwrap());
        let body = Body::place(1, Kind::Rock, &solid, DVec3::new(3.0, 2.0, 1.0), &DMat3::IDENTITY, 1.5);
        let mut uses = std::collections::HashMap::new();
        for triangle in body_triangles(&body) {
            let corners = triangle.corners.map(|corner| corner.to_array().map(f64::to_bits));
            for k in 0..3 {
                // Every edge is run through once in each direction.
                assert!(uses.insert([corners[k], corners[(k + 1) % 3]], ()).is_none());
            }
        }
        assert!(uses.keys().all(|[from, to]| uses.contains_key(&[*to, *from])));
    }
}
