//! Wishes that are refused, each with one error.

use glam::DVec3;
use ground_mesh::{GroundMesh, MeshError, Rings, Wish};

use super::{OUTER, two_levels};

const GOOD: Rings = Rings { half_side: 40.0, cells: 8 };

fn refused(eye: DVec3, rings: Rings) -> MeshError {
    GroundMesh::default().fill(&two_levels(), eye, rings).unwrap_err()
}

#[test]
fn an_eye_that_is_not_over_the_bank() {
    let inside = DVec3::new(100.0, 100.0, 10.0);
    let outside = [
        DVec3 { x: OUTER[0] - 0.01, ..inside },
        DVec3 { y: OUTER[3] + 0.01, ..inside },
        DVec3 { x: f64::NAN, ..inside },
        DVec3 { z: f64::NAN, ..inside },
        DVec3 { z: f64::INFINITY, ..inside },
    ];
    for eye in outside {
        let error = refused(eye, GOOD);
        assert!(matches!(error, MeshError::Eye { extent: OUTER, .. }), "{error}");
        assert!(error.to_string().contains("north -150 to 750 m and east -90 to 810 m"), "{error}");
    }
}

#[test]
fn rings_out_of_range() {
    let inside = DVec3::new(100.0, 100.0, 10.0);
    for half_side in [0.0, -1.0, 1e-9, 1e9, f64::NAN, f64::INFINITY] {
        let error = refused(inside, Rings { half_side, ..GOOD });
        assert!(matches!(error, MeshError::HalfSide { .. }), "{error}");
    }
    for cells in [0, 4, 10, 1 << 15, u32::MAX] {
        assert_eq!(refused(inside, Rings { cells, ..GOOD }), MeshError::Cells(cells));
    }
}

#[test]
fn figures_of_a_wish() {
    let wish = Wish { half_side: 40.0, most_cells: 16, focal: 1000.0, tolerance: 1.0 };
    for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for wish in [Wish { tolerance: value, ..wish }, Wish { focal: value, ..wish }] {
            let eye = DVec3::new(100.0, 100.0, 10.0);
            let error = GroundMesh::default().fit_where(&two_levels(), eye, &wish, |_| true).unwrap_err();
            assert!(matches!(error, MeshError::Figure { .. }), "{error}");
        }
    }
}
