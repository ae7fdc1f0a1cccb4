//! Rings that are chosen by a tolerance and a limit.

use glam::DVec3;
use ground_mesh::{FEWEST_CELLS, GroundMesh, MeshError, Wish};

use super::{Random, of_levels};

#[test]
fn a_tolerance_is_met_or_the_limit_is_kept() {
    let landscape = of_levels(vec![Random(2).level(100.0, [0.0; 2], [9, 9], 2.0)]);
    let eye = DVec3::new(400.0, 420.0, 12.0);
    let wish = Wish { half_side: 25.0, focal: 1000.0, tolerance: 4.0, most_triangles: 300_000 };
    let mut mesh = GroundMesh::default();
    let fitted = mesh.fit(&landscape, eye, &wish).unwrap();
    assert!(fitted.is_met && fitted.error.pixels <= 4.0 && fitted.rings.cells > FEWEST_CELLS, "{fitted:?}");
    let met = mesh.triangles().len();
    // A finer wish takes more triangles; a lower limit keeps it unmet, and says so.
    let limited = Wish { most_triangles: met - 1, ..wish };
    let fitted = mesh.fit(&landscape, eye, &limited).unwrap();
    assert!(!fitted.is_met && fitted.error.pixels > 4.0 && mesh.triangles().len() < met, "{fitted:?}");
    assert_eq!(mesh.height_error(&landscape, eye, 1000.0), fitted.error);
    let none = mesh.fit(&landscape, eye, &Wish { most_triangles: 10, ..wish });
    assert!(matches!(none, Err(MeshError::Triangles { limit: 10, needed }) if needed > 10));
}

#[test]
fn buffers_are_used_again() {
    let landscape = of_levels(vec![Random(2).level(100.0, [0.0; 2], [9, 9], 2.0)]);
    let wish = Wish { half_side: 25.0, focal: 1000.0, tolerance: 30.0, most_triangles: 100_000 };
    let mut mesh = GroundMesh::default();
    let rings = mesh.fit(&landscape, DVec3::new(400.0, 420.0, 12.0), &wish).unwrap().rings;
    let buffers = [mesh.vertices().as_ptr() as usize, mesh.triangles().as_ptr() as usize];
    for frame in 0..10 {
        mesh.fill(&landscape, DVec3::new(400.0 + f64::from(frame), 420.0, 12.0), rings).unwrap();
        assert_eq!([mesh.vertices().as_ptr() as usize, mesh.triangles().as_ptr() as usize], buffers);
    }
}
