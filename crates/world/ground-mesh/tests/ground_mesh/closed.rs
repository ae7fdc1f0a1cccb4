//! No cracks, no holes, nothing twice, nothing that swims.

use std::collections::HashMap;

use glam::DVec3;
use ground_mesh::{GroundMesh, Rings};
use landscape::Landscape;

use super::{OUTER, Random, corners, of_levels, two_levels};

/// How often each edge is used, by the numbers of its ends, the lower first.
fn edges(mesh: &GroundMesh) -> HashMap<[u32; 2], u32> {
    let mut uses = HashMap::new();
    for [p, q, r] in mesh.triangles() {
        for [from, to] in [[p, q], [q, r], [r, p]] {
            *uses.entry([*from.min(to), *from.max(to)]).or_default() += 1;
        }
    }
    uses
}

/// Twice the area of a triangle on the map, positive if its corners run counter-clockwise seen from above.
fn doubled_area([p, q, r]: [DVec3; 3]) -> f64 {
    let [u, v] = [q - p, r - p];
    u.y * v.x - u.x * v.y
}

#[track_caller]
fn assert_closed(mesh: &GroundMesh, extent: [f64; 4]) {
    let place = |number: u32| mesh.vertices()[number as usize].place;
    let [south, west, north, east] = extent;
    for (ends, uses) in edges(mesh) {
        let [from, to] = ends.map(place);
        let lies_on = |from: f64, to: f64, borders: [f64; 2]| from == to && borders.contains(&from);
        let is_border = lies_on(from.x, to.x, [south, north]) || lies_on(from.y, to.y, [west, east]);
        assert_eq!(uses, if is_border { 1 } else { 2 }, "{from} to {to}");
    }
    let areas = corners(mesh).map(doubled_area);
    assert!(areas.clone().all(|area| area > 0.0));
    let (sum, whole) = (areas.sum::<f64>(), 2.0 * (north - south) * (east - west));
    assert!((sum / whole - 1.0).abs() < 1e-12, "{sum} of {whole}");
    // No two vertices at one place: they would hide a crack from the count of edges.
    let mut places: Vec<_> =
        mesh.vertices().iter().map(|v| [v.place.x, v.place.y].map(f64::to_bits)).collect();
    places.sort_unstable();
    assert!(places.windows(2).all(|pair| pair[0] != pair[1]));
}

#[test]
fn every_inner_edge_has_two_triangles_from_any_eye() {
    let (landscape, mut random, mut mesh) = (two_levels(), Random(1), GroundMesh::default());
    for round in 0..100 {
        let cells = [8, 12, 16, 20][round % 4];
        let rings = Rings { half_side: random.between(3.0, 120.0), cells };
        mesh.fill(&landscape, random.eye(OUTER), rings).unwrap();
        assert_closed(&mesh, OUTER);
    }
    // At the borders, and with one ring over all.
    let [south, west, north, east] = OUTER;
    for (x, y) in [(south, west), (south, east), (north, west), (north, east)] {
        for half_side in [10.0, 900.0] {
            mesh.fill(&landscape, DVec3::new(x, y, 9.0), Rings { half_side, cells: 8 }).unwrap();
            assert_closed(&mesh, OUTER);
        }
    }
}

#[test]
fn rings_are_fine_near_and_coarse_far() {
    let (landscape, eye) = (two_levels(), DVec3::new(200.0, 250.0, 10.0));
    let (mut mesh, rings) = (GroundMesh::default(), Rings { half_side: 40.0, cells: 16 });
    mesh.fill(&landscape, eye, rings).unwrap();
    let (mut finest, mut coarsest) = (f64::INFINITY, 0.0f64);
    for corners in corners(&mesh) {
        let sides = [0, 1, 2].map(|k| (corners[k] - corners[(k + 1) % 3]).truncate().length());
        let longest = sides.into_iter().fold(0.0, f64::max);
        // A square of half side 40 reaches to 35 m at least, and cells double with it.
        let away = corners.map(|corner| (corner - eye).truncate().abs().max_element());
        let away = away.into_iter().fold(f64::INFINITY, f64::min);
        assert!(longest <= 2.0 * 2.5 * (2.0 * away / 35.0).max(1.0), "{longest} at {away}");
        (finest, coarsest) = (finest.min(longest), coarsest.max(longest));
    }
    assert!(finest < 3.6 && coarsest > 35.0, "{finest} to {coarsest}");
}

/// From any eye, all vertices lie on one grid of the finest step, or on the northern or eastern border.
#[test]
fn vertices_stay_while_the_eye_moves() {
    let (landscape, rings) = (two_levels(), Rings { half_side: 50.0, cells: 8 });
    let mut random = Random(3);
    for _ in 0..20 {
        let mut mesh = GroundMesh::default();
        mesh.fill(&landscape, random.eye(OUTER), rings).unwrap();
        let step = rings.finest_step();
        for vertex in mesh.vertices() {
            let [x, y] = [vertex.place.x - OUTER[0], vertex.place.y - OUTER[1]].map(|at| at / step);
            let is_border = vertex.place.x == OUTER[2] || vertex.place.y == OUTER[3];
            assert!(is_border || (x == x.round() && y == y.round()), "{x} {y}");
        }
    }
}

#[test]
fn vertices_are_the_closed_form() {
    let (landscape, mut mesh) = (two_levels(), GroundMesh::default());
    mesh.fill(&landscape, DVec3::new(300.0, 300.0, 5.0), Rings { half_side: 30.0, cells: 8 }).unwrap();
    for vertex in mesh.vertices() {
        let ground = landscape.at(vertex.place.x, vertex.place.y).unwrap();
        assert_eq!((vertex.place.z, vertex.slopes), (ground.height, ground.slopes));
        assert_eq!(vertex.albedo, landscape.albedo_at(vertex.place.x, vertex.place.y));
    }
}

#[test]
fn where_levels_leave_a_corner_free_there_are_no_triangles() {
    let mut random = Random(9);
    let beside =
        [random.level(10.0, [0.0, 0.0], [11, 11], 2.0), random.level(20.0, [80.0, 80.0], [6, 6], 2.0)];
    let landscape: Landscape = of_levels(beside.into());
    let mut mesh = GroundMesh::default();
    mesh.fill(&landscape, DVec3::new(90.0, 90.0, 5.0), Rings { half_side: 20.0, cells: 8 }).unwrap();
    for corners in corners(&mesh) {
        assert!(corners.iter().all(|at| landscape.at(at.x, at.y).is_some()));
    }
    let area: f64 = corners(&mesh).map(doubled_area).sum();
    // Both squares less their overlap; cells at the free corners may be missing.
    let whole = 2.0 * (100.0 * 100.0 + 100.0 * 100.0 - 20.0 * 20.0);
    assert!(area <= whole * (1.0 + 1e-12) && area > 0.8 * whole, "{area} of {whole}");
}

#[test]
fn any_number_of_threads_makes_the_same_mesh() {
    let (landscape, eye) = (two_levels(), DVec3::new(260.0, 310.0, 12.0));
    let made = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut mesh = GroundMesh::default();
            mesh.fill(&landscape, eye, Rings { half_side: 30.0, cells: 16 }).unwrap();
            let error = mesh.height_error(&landscape, eye, 800.0);
            (mesh.vertices().to_vec(), mesh.triangles().to_vec(), error)
        })
    };
    let one = made(1);
    for threads in [2, 3, 8] {
        assert!(made(threads) == one);
    }
}
