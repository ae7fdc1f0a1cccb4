//! Craters that are small beside the cells.

use std::collections::HashMap;

use features::{Crater, Features, Shape, kept_share};
use glam::DVec3;
use ground_mesh::{GroundMesh, Rings, Vertex};
use landscape::{Landscape, Level};

use super::{OUTER, Random, corners, of_levels, two_levels};

/// Craters of 0.5 to 60 m over two levels.
fn cratered() -> Landscape {
    let mut random = Random(21);
    let crater = |_| {
        let r2 = 0.5 * libm::exp2(random.between(0.0, 7.0));
        let centre = [random.between(OUTER[0], OUTER[2]), random.between(OUTER[1], OUTER[3])];
        Crater::new(centre, Shape::RimmedBowl { r1: 0.7 * r2, r2 }, 0.2 * r2, 0.04 * r2).unwrap()
    };
    two_levels().with_features(Features::new((0..4000).map(crater).collect()))
}

fn by_place(mesh: &GroundMesh) -> HashMap<[u64; 2], Vertex> {
    mesh.vertices()
        .iter()
        .map(|vertex| ([vertex.place.x, vertex.place.y].map(f64::to_bits), *vertex))
        .collect()
}

/// The spacing of a vertex is the side of the largest cell that has it as a corner.
#[test]
fn on_the_border_of_two_rings_the_coarser_one_rules() {
    let (landscape, mut mesh, mut random) = (two_levels(), GroundMesh::default(), Random(5));
    for cells in [8, 12, 16] {
        let rings = Rings { half_side: random.between(20.0, 90.0), cells };
        mesh.fill(&landscape, random.eye(OUTER), rings).unwrap();
        let mut largest = HashMap::<u32, f64>::new();
        for (numbers, places) in mesh.triangles().iter().zip(corners(&mesh)) {
            let [p, q, r] = places;
            let extent = p.max(q).max(r) - p.min(q).min(r);
            let cell = extent.x.min(extent.y);
            numbers.iter().for_each(|number| {
                let known = largest.entry(*number).or_default();
                *known = known.max(cell);
            });
        }
        for (number, cell) in largest {
            let vertex = mesh.vertices()[number as usize];
            // Cells at the northern and eastern border are cut.
            let is_cut =
                vertex.place.x > OUTER[2] - vertex.spacing || vertex.place.y > OUTER[3] - vertex.spacing;
            let off = vertex.spacing - cell;
            assert!(off.abs() < 1e-9 * cell || is_cut && off > 0.0, "{vertex:?}: cell of {cell} m");
        }
    }
}

#[test]
fn vertices_are_the_ground_as_their_spacing_shows_it() {
    let (landscape, mut mesh) = (cratered(), GroundMesh::default());
    mesh.fill(&landscape, DVec3::new(300.0, 300.0, 5.0), Rings { half_side: 30.0, cells: 16 }).unwrap();
    let mut faded = 0;
    for Vertex { place, slopes, spacing, .. } in mesh.vertices() {
        let ground = landscape.at_spacing(place.x, place.y, *spacing).unwrap();
        assert_eq!((place.z, slopes), (ground.height, &ground.slopes));
        faded += u32::from(landscape.height(place.x, place.y) != Some(place.z));
    }
    assert!(faded > 100, "{faded}");
}

/// What is wanted decides no value: a part of the mesh is a part of the whole.
#[test]
fn a_vertex_has_one_value_whatever_blocks_are_wanted() {
    let (landscape, mut random) = (cratered(), Random(6));
    let (mut whole, mut part) = (GroundMesh::default(), GroundMesh::default());
    for _ in 0..10 {
        let (eye, rings) = (random.eye(OUTER), Rings { half_side: random.between(10.0, 90.0), cells: 12 });
        whole.fill(&landscape, eye, rings).unwrap();
        let side = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        let is_wanted =
            |[low, _]: [[f64; 2]; 2]| (low[0] - eye.x) * side[0] + (low[1] - eye.y) * side[1] > 0.0;
        part.fill_where(&landscape, eye, rings, is_wanted).unwrap();
        let all = by_place(&whole);
        assert!(part.vertices().len() < whole.vertices().len());
        for (place, vertex) in by_place(&part) {
            assert_eq!(all[&place], vertex);
        }
    }
}

/// A bowl of outer radius 6 m on level ground: whole in cells of 3 m, smaller in those of 4 m, gone in those of 6 m.
#[test]
fn a_crater_fades_as_its_cells_grow_and_the_error_tells_it() {
    let flat = of_levels(vec![Level::new(50.0, [0.0; 2], [9, 9], vec![[0.0; 9]; 81]).unwrap()]);
    let crater = Crater::new([200.0, 200.0], Shape::Bowl { r1: 6.0 }, 1.0, 0.0).unwrap();
    let landscape = flat.with_features(Features::new(vec![crater]));
    let (mut mesh, eye) = (GroundMesh::default(), DVec3::new(200.0, 200.0, 50.0));
    for (side, share) in [(3.0, 1.0), (4.0, 0.5), (5.0, kept_share(1.2)), (6.0, 0.0)] {
        mesh.fill(&landscape, eye, Rings { half_side: 64.0 * side, cells: 64 }).unwrap();
        for vertex in mesh.vertices() {
            let [x, y] = [vertex.place.x, vertex.place.y].map(|at| at - 200.0);
            let depth = (1.0 - (x * x + y * y) / 36.0).max(0.0);
            assert!((vertex.place.z + share * depth).abs() < 1e-12, "{side} m: {vertex:?}");
        }
        let error = mesh.height_error(&landscape, eye, 1000.0).metres;
        assert!(error >= 0.9 * (1.0 - share) && error < 1.2, "{side} m: {error} m");
    }
}
