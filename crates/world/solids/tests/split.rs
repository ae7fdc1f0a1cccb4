//! Shapes that are not convex, as convex solids that fill them.

use std::fmt::Write as _;

use glam::DVec3;
use solids::Solid;
use solids::shape_files::{self, Openness, Shape};

/// A closed shape by its outlines.
#[derive(Debug, Clone, Default)]
struct Outlines {
    places: Vec<[f64; 3]>,
    faces: Vec<Vec<usize>>,
}

impl Outlines {
    fn obj(&self) -> String {
        let mut text = String::new();
        for [x, y, z] in &self.places {
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
        for face in &self.faces {
            let corners: Vec<String> = face.iter().map(|corner| (corner + 1).to_string()).collect();
            writeln!(text, "f {}", corners.join(" ")).unwrap();
        }
        text
    }

    fn shape(&self) -> Shape {
        shape_files::parse("shape.obj", self.obj().as_bytes(), Openness::Closed).unwrap()
    }
}

/// A prism upwards on an outline that runs counter-clockwise.
fn prism(outline: &[[f64; 2]], height: f64) -> Outlines {
    let count = outline.len();
    let level = |z: f64| outline.iter().map(move |[x, y]| [*x, *y, z]);
    let side = |at: usize| vec![at, (at + 1) % count, count + (at + 1) % count, count + at];
    let lids = [(0..count).rev().collect(), (count..2 * count).collect()];
    Outlines { places: level(0.0).chain(level(height)).collect(), faces: lids.into_iter().chain((0..count).map(side)).collect() }
}

fn volume(solid: &Solid) -> f64 {
    let place = |corner: u32| solid.vertices()[corner as usize];
    let of = |face: &solids::Face| {
        let first = place(face.corners[0]);
        let area: DVec3 = face.corners.windows(2).map(|edge| (place(edge[0]) - first).cross(place(edge[1]) - first)).sum();
        // Body axes are left-handed.
        -area.dot(first) / 6.0
    };
    solid.faces().iter().map(of).sum()
}

#[test]
fn an_l_is_two_boxes() {
    let l = prism(&[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]], 0.5);
    let Shape { solids, notes, .. } = l.shape();
    assert_eq!(solids.len(), 2);
    assert!((solids.iter().map(volume).sum::<f64>() - 2.0).abs() < 1e-12);
    let said = "shape.obj: not convex: 1 shape split into 2 convex parts; the volume differs by ";
    assert!(notes.len() == 1 && notes[0].starts_with(said), "{notes:?}");
}

#[test]
fn real_shapes() {
    for name in ["curiosity_chassis.obj", "canadarm_joint.stl", "curiosity_chassis_hull.obj"] {
        let t = std::time::Instant::now();
        let r = shape_files::read(format!("/work/shared/data/meshes/{name}"), Openness::Closed);
        match r {
            Ok(s) => println!("{name} {} {:?} {:?}", s.solids.len(), s.notes, t.elapsed()),
            Err(e) => println!("{name} {e} {:?}", t.elapsed()),
        }
    }
}
