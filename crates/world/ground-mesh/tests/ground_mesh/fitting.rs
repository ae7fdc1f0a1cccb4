//! Rings that are chosen by a tolerance and a limit.

use glam::DVec3;
use ground_mesh::{FEWEST_CELLS, GroundMesh, Rings, Wish};

use super::{Random, of_levels};

#[test]
fn a_tolerance_is_met_by_the_coarsest_rings_that_do_or_the_limit_is_kept() {
    let landscape = of_levels(vec![Random(2).level(100.0, [0.0; 2], [9, 9], 2.0)]);
    let eye = DVec3::new(400.0, 420.0, 12.0);
    let wish = Wish { half_side: 25.0, most_cells: 200, focal: 1000.0, tolerance: 4.0 };
    let mut mesh = GroundMesh::default();
    let fitted = mesh.fit_where(&landscape, eye, &wish, |_| true).unwrap();
    assert!(fitted.is_met && fitted.rings.cells > FEWEST_CELLS, "{fitted:?}");
    assert!(mesh.height_error(&landscape, eye, 1000.0).pixels <= 4.0);
    // The coarser ones do not.
    let coarser = Rings { cells: fitted.rings.cells / 2, ..fitted.rings };
    mesh.fill(&landscape, eye, coarser).unwrap();
    assert!(mesh.height_error(&landscape, eye, 1000.0).pixels > 4.0);
    // A lower limit keeps the wish unmet, and says so. One that is no power of 2 is tried too.
    let limited = |most_cells| Wish { most_cells, ..wish };
    let unmet = mesh.fit_where(&landscape, eye, &limited(coarser.cells), |_| true).unwrap();
    assert_eq!((unmet.rings, unmet.is_met), (coarser, false));
    let last = mesh.fit_where(&landscape, eye, &limited(coarser.cells + 4), |_| true).unwrap();
    assert_eq!(last.rings.cells, coarser.cells + 4);
}

/// What is not wanted may be as rough as it likes.
#[test]
fn only_the_wanted_blocks_are_held_to_the_tolerance() {
    let mut words = vec![[0.0; 9]; 81];
    words[80] = [40.0; 9];
    let landscape = of_levels(vec![landscape::Level::new(100.0, [0.0; 2], [9, 9], words).unwrap()]);
    let eye = DVec3::new(400.0, 420.0, 12.0);
    let wish = Wish { half_side: 25.0, most_cells: 32, focal: 1000.0, tolerance: 0.1 };
    let mut mesh = GroundMesh::default();
    let cells = |mesh: &mut GroundMesh, north: f64| {
        mesh.fit_where(&landscape, eye, &wish, |[_, high]| high[0] <= north).unwrap().rings.cells
    };
    assert_eq!((cells(&mut mesh, 800.0), cells(&mut mesh, 600.0)), (32, FEWEST_CELLS));
}

#[test]
fn buffers_are_used_again() {
    let landscape = of_levels(vec![Random(2).level(100.0, [0.0; 2], [9, 9], 2.0)]);
    let wish = Wish { half_side: 25.0, most_cells: 64, focal: 1000.0, tolerance: 30.0 };
    let mut mesh = GroundMesh::default();
    let rings = mesh.fit_where(&landscape, DVec3::new(400.0, 420.0, 12.0), &wish, |_| true).unwrap().rings;
    let buffers = [mesh.vertices().as_ptr() as usize, mesh.triangles().as_ptr() as usize];
    for frame in 0..10 {
        mesh.fill(&landscape, DVec3::new(400.0 + f64::from(frame), 420.0, 12.0), rings).unwrap();
        assert_eq!([mesh.vertices().as_ptr() as usize, mesh.triangles().as_ptr() as usize], buffers);
    }
}
