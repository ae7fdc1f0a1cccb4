//! Shapes that are not convex, as convex solids that fill them.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::sync::Arc;

use diagnostics::ProblemList;
use glam::{DMat3, DVec3};
use proptest::collection::vec;
use proptest::prelude::{ProptestConfig, Strategy, prop_assert, prop_assert_eq, proptest};
use solids::shape_files::{self, Openness, Shape};
use solids::{Body, Kind, Solid};

/// A closed shape by its outlines, in the axes of an OBJ file.
#[derive(Debug, Clone, Default)]
struct Outlines {
    places: Vec<DVec3>,
    /// Counter-clockwise seen from outside.
    faces: Vec<Vec<usize>>,
}

impl Outlines {
    fn obj(&self) -> String {
        let mut text = String::new();
        for DVec3 { x, y, z } in &self.places {
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
        for face in &self.faces {
            let corners: Vec<String> = face.iter().map(|corner| (corner + 1).to_string()).collect();
            writeln!(text, "f {}", corners.join(" ")).unwrap();
        }
        text
    }

    fn read(&self) -> Result<Shape, ProblemList> {
        shape_files::parse("shape.obj", self.obj().as_bytes(), Openness::Closed)
    }

    /// Triangles of faces that are convex.
    fn triangles(&self) -> Vec<[DVec3; 3]> {
        let fan = |face: &Vec<usize>| {
            let place = |corner: usize| self.places[face[corner]];
            (1..face.len() - 1).map(|corner| [place(0), place(corner), place(corner + 1)]).collect::<Vec<_>>()
        };
        self.faces.iter().flat_map(fan).collect()
    }

    fn volume(&self) -> f64 {
        self.triangles().iter().map(|[a, b, c]| a.dot(b.cross(*c)) / 6.0).sum()
    }
}

/// A prism upwards on an outline that runs counter-clockwise.
fn prism(outline: &[[f64; 2]], height: f64) -> Outlines {
    let count = outline.len();
    let level = |z: f64| outline.iter().map(move |&[x, y]| DVec3::new(x, y, z));
    let side = |at: usize| vec![at, (at + 1) % count, count + (at + 1) % count, count + at];
    let lids = [(0..count).rev().collect(), (count..2 * count).collect()];
    Outlines {
        places: level(0.0).chain(level(height)).collect(),
        faces: lids.into_iter().chain((0..count).map(side)).collect(),
    }
}

/// Places on rings about the vertical, `around` each, and the squares between neighbours; rings and places close.
fn ring(around: usize, section: &[[f64; 2]]) -> Outlines {
    let angle = |at: usize| TAU * at as f64 / around as f64;
    let place = |at: usize, [radius, z]: [f64; 2]| {
        DVec3::new(radius * libm::cos(angle(at)), radius * libm::sin(angle(at)), z)
    };
    let places = (0..around).flat_map(|at| section.iter().map(move |&own| place(at, own))).collect();
    let number = |at: usize, own: usize| at % around * section.len() + own % section.len();
    let square = |at: usize, own: usize| {
        vec![number(at, own), number(at + 1, own), number(at + 1, own + 1), number(at, own + 1)]
    };
    let squares = (0..around).flat_map(|at| (0..section.len()).map(move |own| square(at, own)));
    Outlines { places, faces: squares.collect() }
}

/// A ball of triangles whose corners lie at given distances from its middle: seven rows of eight, and the poles.
fn spiky(radii: &[f64]) -> Outlines {
    const ROWS: usize = 7;
    const AROUND: usize = 8;
    let place = |row: usize, at: usize| {
        let [down, around] =
            [0.5 * TAU * (row + 1) as f64 / (ROWS + 1) as f64, TAU * at as f64 / AROUND as f64];
        radii[row * AROUND + at]
            * DVec3::new(
                libm::sin(down) * libm::cos(around),
                libm::sin(down) * libm::sin(around),
                libm::cos(down),
            )
    };
    let mut places: Vec<DVec3> =
        (0..ROWS).flat_map(|row| (0..AROUND).map(move |at| place(row, at))).collect();
    let [top, bottom] = [places.len(), places.len() + 1];
    places.extend([DVec3::Z * radii[ROWS * AROUND], -DVec3::Z * radii[ROWS * AROUND + 1]]);
    let number = |row: usize, at: usize| row * AROUND + at % AROUND;
    let mut faces = Vec::new();
    for at in 0..AROUND {
        faces.push(vec![top, number(0, at), number(0, at + 1)]);
        faces.push(vec![bottom, number(ROWS - 1, at + 1), number(ROWS - 1, at)]);
        for row in 0..ROWS - 1 {
            faces.push(vec![number(row, at), number(row + 1, at), number(row + 1, at + 1)]);
            faces.push(vec![number(row, at), number(row + 1, at + 1), number(row, at + 1)]);
        }
    }
    Outlines { places, faces }
}

fn volume(solid: &Solid) -> f64 {
    let place = |corner: u32| solid.vertices()[corner as usize];
    let of = |face: &solids::Face| {
        let first = place(face.corners[0]);
        let area: DVec3 =
            face.corners.windows(2).map(|edge| (place(edge[0]) - first).cross(place(edge[1]) - first)).sum();
        // Body axes are left-handed.
        -area.dot(first) / 6.0
    };
    solid.faces().iter().map(of).sum()
}

/// How far a place of the body lies behind the nearest face; negative outside.
fn depth(solid: &Solid, place: DVec3) -> f64 {
    let of = |face: &solids::Face| face.normal.dot(solid.vertices()[face.corners[0] as usize] - place);
    solid.faces().iter().map(of).fold(f64::INFINITY, f64::min)
}

/// Where a ray meets triangles: distances in lengths of the direction, and which way each triangle looks.
fn meetings(triangles: &[[DVec3; 3]], origin: DVec3, direction: DVec3) -> Vec<(f64, DVec3)> {
    let meet = |[a, b, c]: &[DVec3; 3]| {
        let normal = (b - a).cross(c - a);
        let distance = normal.dot(a - origin) / normal.dot(direction);
        let place = origin + distance * direction;
        let is_inside = [(a, b), (b, c), (c, a)]
            .iter()
            .all(|(from, to)| normal.dot((**to - **from).cross(place - **from)) > 0.0);
        (is_inside && distance > 0.0).then(|| (distance, normal.normalize()))
    };
    let mut met: Vec<_> = triangles.iter().filter_map(meet).collect();
    met.sort_by(|a, b| a.0.total_cmp(&b.0));
    met
}

/// From the axes of a file to those of bodies, and back.
fn flipped(place: DVec3) -> DVec3 {
    DVec3::new(place.x, -place.y, place.z)
}

/// Parts fill a shape: volumes agree to `room`, no two parts overlap, and rays see the shape's own faces and no other.
fn expect_filled(shape: &Outlines, parts: &[Solid], rays: &[(DVec3, DVec3)], room: f64) {
    let (whole, sum) = (shape.volume(), parts.iter().map(volume).sum::<f64>());
    assert!((sum / whole - 1.0).abs() < room, "{sum} of {whole}");
    let triangles = shape.triangles();
    let place = |part: &Solid| {
        Body::place(0, Kind::Culture, &Arc::new(part.clone()), DVec3::ZERO, &DMat3::IDENTITY, 1.0)
    };
    let bodies: Vec<Body> = parts.iter().map(place).collect();
    for &(origin, direction) in rays {
        let met = meetings(&triangles, origin, direction);
        let at = flipped(origin);
        // Odd meetings: inside.
        let held = parts.iter().filter(|part| depth(part, at) > 0.0).count();
        let is_near = parts.iter().any(|part| depth(part, at).abs() < 1e-6);
        assert!(is_near || held == met.len() % 2, "{origin}: in {held} parts, {} faces ahead", met.len());
        let far = origin - 20.0 * direction;
        let hits = bodies.iter().filter_map(|body| {
            let hit = body.first_hit(flipped(far), flipped(direction), 0.0)?;
            Some((hit.distance, flipped(body.normal(hit.face))))
        });
        let seen = hits.min_by(|a, b| a.0.total_cmp(&b.0));
        match (seen, meetings(&triangles, far, direction).first()) {
            (Some((distance, normal)), Some((expected, own))) => {
                assert!((distance - expected).abs() < 1e-6, "{far} {direction}: {distance} for {expected}");
                assert!(normal.distance(*own) < 1e-6, "{far} {direction}: {normal} for {own}");
            }
            (None, None) => {}
            (seen, expected) => panic!("{far} {direction}: {seen:?} for {expected:?}"),
        }
    }
}

fn rays() -> impl Strategy<Value = Vec<(DVec3, DVec3)>> {
    let place = || [-1.2..1.2f64, -1.2..1.2, -1.2..1.2].prop_map(DVec3::from_array);
    let ray = (place(), place()).prop_map(|(at, aim)| (at, (aim - at).normalize_or(DVec3::X)));
    vec(ray, 100)
}

const L: [[f64; 2]; 6] = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];

#[test]
fn an_l_is_two_boxes_and_a_note_says_so() {
    let Shape { solids, notes, .. } = prism(&L, 0.5).read().unwrap();
    assert_eq!(solids.len(), 2);
    assert!(solids.iter().all(|solid| (solid.vertices().len(), solid.faces().len()) == (8, 6)));
    let volumes: f64 = solids.iter().map(volume).sum();
    assert!((volumes - 2.0).abs() < 1e-12, "{volumes}");
    let said = "shape.obj: not convex: 1 shape split into 2 convex parts; the volume differs by 0.0e0 of it at most, \
                corners lie 0.0e0 m outside at most";
    assert_eq!(notes, [said]);
}

#[test]
fn a_ring_is_as_many_parts_as_it_has_corners() {
    let square = [[0.6, -0.2], [1.0, -0.2], [1.0, 0.2], [0.6, 0.2]];
    let solids = ring(8, &square).read().unwrap().solids;
    assert_eq!(solids.len(), 8);
}

/// A hole through a ring is seen through, and no wall between two parts is seen.
#[test]
fn rays_see_a_ring_and_through_it() {
    let square = [[0.6, -0.2], [1.0, -0.2], [1.0, 0.2], [0.6, 0.2]];
    let shape = ring(12, &square);
    let solids = shape.read().unwrap().solids;
    let grid = (0..40).flat_map(|x| (0..40).map(move |y| [x, y].map(|n| f64::from(n) * 0.06173 - 1.2)));
    let rays: Vec<_> =
        grid.map(|[x, y]| (DVec3::new(x, y, 0.013), DVec3::new(0.1, 0.07, -1.0).normalize())).collect();
    expect_filled(&shape, &solids, &rays, 1e-12);
}

#[test]
fn a_shape_that_is_inside_out_is_turned_and_a_note_says_so() {
    let mut shape = prism(&L, 0.5);
    shape.faces.iter_mut().for_each(|face| face.reverse());
    let Shape { solids, notes, .. } = shape.read().unwrap();
    assert_eq!(solids, prism(&L, 0.5).read().unwrap().solids);
    assert!(notes[1].contains("inside out, or turned both ways round: faces of 1 shape"), "{notes:?}");
    shape.faces[3].reverse();
    assert_eq!(shape.read().unwrap().notes, notes);
}

#[test]
fn what_cannot_be_split_is_refused_by_name() {
    let refused = |shape: &Outlines| shape.read().unwrap_err().to_string();
    // One corner of a ball is pulled through the middle and out on the other side.
    let mut radii = [0.8; 58];
    radii[20] = -1.5;
    let said = refused(&spiky(&radii));
    assert!(said.contains("crosses itself"), "{said}");
    let mut branching = prism(&L, 0.5);
    branching.places.push(DVec3::new(9.0, 9.0, 9.0));
    branching.faces.push(vec![0, 1, 12]);
    assert!(
        refused(&branching)
            .contains("branching: the edge between vertex 1 (line 1) and vertex 2 (line 2) has 3 faces")
    );
    let mut open = prism(&L, 0.5);
    open.faces.pop();
    let said = refused(&open);
    assert!(
        said.contains("not closed: the edge between vertex ") && said.contains("`open = true`"),
        "{said}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn parts_of_a_spiky_ball_fill_it(radii in vec(0.3..1.0f64, 58), rays in rays()) {
        let shape = spiky(&radii);
        let Shape { solids, notes, .. } = shape.read().unwrap();
        prop_assert!(solids.len() > 1 && notes.len() == 1);
        // What is thinner than a ten-millionth of the size is left out.
        expect_filled(&shape, &solids, &rays, 1e-8);
    }

    #[test]
    fn parts_of_a_star_fill_it(radii in vec(0.2..1.0f64, 5..14), height in 0.1..1.0f64) {
        let count = radii.len() as f64;
        let corner = |(at, radius): (usize, &f64)| {
            let angle = TAU * at as f64 / count;
            [radius * libm::cos(angle), radius * libm::sin(angle)]
        };
        let outline: Vec<[f64; 2]> = radii.iter().enumerate().map(corner).collect();
        let area: f64 = outline.iter().zip(outline.iter().cycle().skip(1)).map(|(a, b)| 0.5 * (a[0] * b[1] - a[1] * b[0])).sum();
        let solids = prism(&outline, height).read().unwrap().solids;
        let volumes: f64 = solids.iter().map(volume).sum();
        prop_assert!((volumes / (area * height) - 1.0).abs() < 1e-9, "{} {}", volumes, area * height);
        prop_assert_eq!(solids.iter().all(|solid| !solid.is_open()), true);
    }
}

/// Parts wear the colours and normals of the faces that they were cut from.
#[test]
fn parts_keep_colours_and_normals() {
    let shape = prism(&L, 0.5);
    let mut text = String::new();
    for DVec3 { x, y, z } in &shape.places {
        // Red at the foot, blue at the top.
        writeln!(text, "v {x} {y} {z} {} 0 {}", 1.0 - 2.0 * z, 2.0 * z).unwrap();
    }
    text += "vn 0.1 0 1\n";
    for (number, face) in shape.faces.iter().enumerate() {
        let normal = if number == 1 { "//1" } else { "" };
        let corners: Vec<String> = face.iter().map(|corner| format!("{}{normal}", corner + 1)).collect();
        writeln!(text, "f {}", corners.join(" ")).unwrap();
    }
    let solids = shape_files::parse("l.obj", text.as_bytes(), Openness::Closed).unwrap().solids;
    let full = shape_files::ALBEDO;
    for solid in &solids {
        for (number, face) in solid.faces().iter().enumerate() {
            let place = solid.vertices()[face.corners[0] as usize];
            let expected = match face.normal.z {
                1.0 => [0.0, 0.0, full],
                -1.0 => [full, 0.0, 0.0],
                _ => [0.5 * full, 0.0, 0.5 * full],
            };
            let is_between = face.normal.z == 0.0 && solid.albedo(number) == [full; 3];
            assert!(is_between || solid.albedo(number) == expected, "{face:?} {:?}", solid.albedo(number));
            let tilt = if face.normal.z == 1.0 { DVec3::new(0.1, 0.0, 1.0).normalize() } else { face.normal };
            assert!(solid.normal_at(number, place).distance(tilt) < 1e-12, "{face:?}");
        }
    }
}
