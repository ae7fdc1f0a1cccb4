//! Lists of faces over ground and bodies: area, depth, brightness in space, suns, levels, the cut at the water.

use std::sync::Arc;

use exact::Exact;
use faces::{Detail, Face, Group, Mesh, SunProgramme, Turn, TurningSun, Vertex};
use generator::{Generator, Label, PlaneKind, Planes, Stage};
use glam::DVec3;
use hardware_model::Settings;
use quantities::radians;
use scenario::{
    Carrier, Curvature, DrawnBy, FaceKind, FaceList, FaceLists, Laws, PixelRule, Pose, Projection, Scenery,
};
use signal::Probe;

use crate::scenes::{landscape, laws, plane, planes, pose, settings, standing_box, sun, value};

const PIXELS: [u32; 2] = [41, 31];
const MIDDLE: usize = 15 * 41 + 20;

fn usual() -> Settings {
    let laws = laws(Projection::Exact, Curvature::None, PixelRule::Centre);
    settings(PIXELS[0], PIXELS[1], laws, [1.0, 150.0])
}

/// A list of a kind, of one face by its corners (north, east, up; m), red and flat unless it is changed.
fn list(kind: FaceKind, corners: &[[f64; 3]], change: impl FnOnce(Face) -> Face) -> FaceList {
    let vertices = corners.iter().map(|at| Vertex::at(DVec3::from_array(*at))).collect();
    of_vertices(kind, vertices, change)
}

fn of_vertices(kind: FaceKind, vertices: Vec<Vertex>, change: impl FnOnce(Face) -> Face) -> FaceList {
    let corners = (0..vertices.len() as u32).collect();
    let face = change(Face::flat(corners, [1.0, 0.0, 0.0]));
    let mesh = Mesh::load("face", vertices, vec![face]).unwrap().mesh;
    FaceList::new(Group::new("face", mesh, 1), kind, Carrier::Map(0.0))
}

/// A square of a side about a place, seen from above.
fn square([north, east, up]: [f64; 3], side: f64) -> Vec<[f64; 3]> {
    let half = side / 2.0;
    [[-half, -half], [-half, half], [half, half], [half, -half]]
        .map(|[x, y]| [north + x, east + y, up])
        .to_vec()
}

fn scenery(lists: Vec<FaceList>) -> Scenery {
    let lists = FaceLists { lists, ..FaceLists::default() };
    Scenery::still(sun(180.0, 30.0)).with_face_lists(Arc::new(lists))
}

/// Over level ground of 200 m x 200 m at height 0.
fn drawn(lists: Vec<FaceList>, pose: &Pose) -> Planes {
    drawn_of(scenery(lists), pose)
}

fn drawn_of(scenery: Scenery, pose: &Pose) -> Planes {
    planes(&landscape(plane(50.0, [4, 4], 0.0, [0.0; 2]), 0.5), scenery, &usual(), pose)
}

/// From `height` m straight down on the middle.
fn from_above(height: f64) -> Pose {
    pose([100.0, 100.0, height], -90.0, 0.0)
}

/// Light of red less that of blue, which ground does not have, in all pixels.
fn redness(planes: &Planes) -> f64 {
    let red = |index| value(planes, PlaneKind::Red, index) - value(planes, PlaneKind::Blue, index);
    (0..(PIXELS[0] * PIXELS[1]) as usize).map(red).sum()
}

/// Area of a pixel of the view-plane.
fn pixel_area() -> f64 {
    let field = usual().raster.field;
    4.0 * field.tan_half_width * field.tan_half_height / f64::from(PIXELS[0] * PIXELS[1])
}

#[test]
fn a_face_has_its_area_and_the_light_of_its_sun() {
    // 7.3 m at 50 m: neither the sides nor the place go by pixels.
    let found = drawn(
        vec![list(FaceKind::Effect, &square([100.7, 99.1, 30.0], 7.3), |face| face)],
        &from_above(80.0),
    );
    let expected = 0.5 * (7.3 / 50.0) * (7.3 / 50.0) / pixel_area();
    assert!((redness(&found) - expected).abs() < 1e-4 * expected, "{} {expected}", redness(&found));
}

#[test]
fn a_sun_of_its_own_lights_a_list() {
    let mut face = list(FaceKind::Effect, &square([100.0, 100.0, 30.0], 20.0), |face| face);
    let own = TurningSun::new(radians(50.0), 0.0, Turn::STILL).unwrap();
    face.group = face.group.under(SunProgramme::Turning(own));
    let found = drawn(vec![face], &from_above(80.0));
    let expected = libm::sin(radians(50.0));
    assert!((value(&found, PlaneKind::Red, MIDDLE) - expected).abs() < 1e-7);
}

#[test]
fn the_middle_of_a_pixel_tells_range_height_normal_and_label() {
    for (kind, label) in
        [(FaceKind::Sea, Label::Sea), (FaceKind::Wake, Label::Wake), (FaceKind::Ship, Label::Ship)]
    {
        let wall = [[130.0, 80.0, -9.0], [130.0, 120.0, -9.0], [130.0, 120.0, 9.0], [130.0, 80.0, 9.0]];
        let found =
            drawn(vec![list(kind, &wall, |face| face.both_sides())], &pose([100.0, 100.0, 4.0], 0.0, 0.0));
        let told = |kind| value(&found, kind, MIDDLE);
        assert!(
            (told(PlaneKind::Range) - 30.0).abs() < 1e-5 && (told(PlaneKind::Distance) - 30.0).abs() < 1e-5
        );
        assert!(
            (told(PlaneKind::Height) - 4.0).abs() < 1e-6 && (told(PlaneKind::NormalNorth) + 1.0).abs() < 1e-6
        );
        assert_eq!(told(PlaneKind::Label), f64::from(label.code()));
    }
}

#[test]
fn a_one_sided_face_is_not_seen_from_behind() {
    let mut corners = square([100.0, 100.0, 30.0], 20.0);
    corners.reverse();
    let terrain = f64::from(Label::Terrain.code());
    let found = drawn(vec![list(FaceKind::Effect, &corners, |face| face)], &from_above(80.0));
    assert_eq!(value(&found, PlaneKind::Label, MIDDLE), terrain);
    let found = drawn(vec![list(FaceKind::Effect, &corners, Face::both_sides)], &from_above(80.0));
    assert_ne!(value(&found, PlaneKind::Label, MIDDLE), terrain);
    assert!((value(&found, PlaneKind::Red, MIDDLE) - 0.5).abs() < 1e-7, "the normal is reversed");
}

/// Brightness 1 at 10 m and 0 at 90 m from the eye, along the ground: the pixel that shows a distance has the brightness of the distance.
#[test]
fn brightness_is_linear_in_space() {
    let to_sun = DVec3::from_array(sun(180.0, 30.0).direction());
    let across = to_sun.cross(DVec3::Y).normalize();
    let vertex = |[north, east]: [f64; 2], normal| Vertex {
        place: DVec3::new(north, east, 0.5),
        normal: Some(normal),
    };
    let corners =
        [([20.0, 0.0], to_sun), ([20.0, 200.0], to_sun), ([100.0, 200.0], across), ([100.0, 0.0], across)];
    let vertices = corners.map(|(at, normal)| vertex(at, normal)).to_vec();
    let road = of_vertices(FaceKind::Effect, vertices, |face| Face::smooth(face.corners, face.colour));
    let found = drawn(vec![road], &pose([10.0, 100.0, 4.5], -10.0, 0.0));
    let mut worst: (f64, u32) = (0.0, 0);
    for line in 0..PIXELS[1] {
        let index = (line * PIXELS[0] + 20) as usize;
        let range = value(&found, PlaneKind::Range, index);
        // Pixels far away show more than 1 m of the road each.
        if value(&found, PlaneKind::Label, index) == f64::from(Label::Wake.code())
            && (12.0..40.0).contains(&range)
        {
            let expected = 1.0 - (range - 10.0) / 80.0;
            worst = (worst.0.max((value(&found, PlaneKind::Red, index) - expected).abs()), worst.1 + 1);
        }
    }
    assert!(worst.0 < 2e-3 && worst.1 > 5, "{worst:?}");
}

#[test]
fn levels_are_laid_upon_the_sea_and_the_sea_upon_ground_of_its_height() {
    let expected = [
        (Detail::Add, 1.0, Label::Sea),
        (Detail::AddSoft, 0.75, Label::Sea),
        (Detail::Replace, 0.5, Label::Wake),
    ];
    for (detail, red, label) in expected {
        let sea = list(FaceKind::Sea, &square([100.0, 100.0, 0.0], 150.0), |face| face);
        let mut level = list(FaceKind::Level, &square([100.0, 100.0, 0.0], 20.0), |face| face);
        level.group = level.group.detailed(detail);
        level.group.priority = -1;
        let found = drawn(vec![sea, level], &from_above(80.0));
        assert!((value(&found, PlaneKind::Red, MIDDLE) - red).abs() < 1e-6, "{detail:?}");
        assert_eq!(value(&found, PlaneKind::Blue, MIDDLE), 0.0, "no ground");
        assert_eq!(value(&found, PlaneKind::Label, MIDDLE), f64::from(label.code()));
        assert!((value(&found, PlaneKind::Red, 0) - 0.5).abs() < 1e-6, "the sea beside the level");
    }
}

/// A wall of 20 m that stands half below the water, with nothing before its lower half.
#[test]
fn a_hull_is_cut_by_the_water() {
    let wall = [[130.0, 0.0, -10.0], [130.0, 200.0, -10.0], [130.0, 200.0, 10.0], [130.0, 0.0, 10.0]];
    let rows = |kind| {
        let lists = vec![
            list(kind, &wall, Face::both_sides),
            FaceList {
                carrier: Carrier::Map(2.0),
                ..list(FaceKind::Sea, &square([10.0, 10.0, 0.0], 1.0), |face| face)
            },
        ];
        let found = planes(
            &landscape(plane(50.0, [4, 4], -40.0, [0.0; 2]), 0.5),
            scenery(lists),
            &usual(),
            &pose([100.0, 100.0, 2.0], 0.0, 0.0),
        );
        let label = f64::from(Label::of_faces(kind).code());
        let is_it = |line: &u32| value(&found, PlaneKind::Label, (line * PIXELS[0] + 20) as usize) == label;
        let lines: Vec<u32> = (0..PIXELS[1]).filter(is_it).collect();
        [lines[0], lines[lines.len() - 1]]
    };
    // The eye is 2 m high, as is the water: the cut is the horizon.
    let (hull, foam) = (rows(FaceKind::Ship), rows(FaceKind::Wake));
    assert!(hull[0] == foam[0] && hull[1] <= 15 && foam[1] > 20, "{hull:?} {foam:?}");
}

#[test]
fn bodies_and_ground_hide_faces_behind_them_and_share_pixels_with_them() {
    let wall = [[130.0, 60.0, -9.0], [130.0, 140.0, -9.0], [130.0, 140.0, 20.0], [130.0, 60.0, 20.0]];
    let eye = pose([100.0, 100.0, 4.0], 0.0, 0.0);
    let alone = drawn(vec![list(FaceKind::Ship, &wall, Face::both_sides)], &eye);
    let before = scenery(vec![list(FaceKind::Ship, &wall, Face::both_sides)])
        .with_bodies(vec![standing_box(1, [115.0, 100.0, 0.0], 2.0, 8.0)]);
    let found = drawn_of(before, &eye);
    assert_eq!(value(&found, PlaneKind::Label, MIDDLE), f64::from(Label::Culture.code()));
    assert!(redness(&found) < redness(&alone));
    // The wall reaches below the ground, which cuts it at 30 m: 24 m of 4 m and 20 m of height over the ground stay.
    let field = usual().raster.field;
    let top = field.tan_half_height.min(16.0 / 30.0);
    let height = top + 4.0 / 30.0;
    let width = 2.0 * field.tan_half_width.min(40.0 / 30.0);
    let expected = libm::cos(radians(30.0)) * height * width / pixel_area();
    assert!((redness(&alone) / expected - 1.0).abs() < 2e-3, "{} {expected}", redness(&alone));
}

#[test]
fn lists_of_machines_are_not_drawn() {
    let face = list(FaceKind::Ship, &square([100.0, 100.0, 30.0], 20.0), |face| face);
    let found = drawn(vec![FaceList { drawn_by: DrawnBy::Machines, ..face }], &from_above(80.0));
    assert_eq!(redness(&found), 0.0);
}

#[test]
fn explain_names_faces_near_to_far() {
    let lists = vec![
        list(FaceKind::Wake, &square([100.0, 100.0, 30.0], 20.0), |face| face),
        list(FaceKind::Sea, &square([100.0, 100.0, 0.0], 90.0), |face| face),
    ];
    let settings = usual();
    let stage = Stage {
        landscape: landscape(plane(50.0, [4, 4], 0.0, [0.0; 2]), 0.5),
        scenery: Arc::new(scenery(lists)),
        view: settings.view(),
    };
    let session = Exact.prepare(stage).unwrap();
    let facts = session.explain(0, &from_above(80.0), [20, 15]).unwrap();
    let told: Vec<&str> =
        facts.iter().filter(|fact| fact.what == "face").map(|fact| fact.value.as_str()).collect();
    assert_eq!(told.len(), 2);
    assert!(
        told[0].starts_with("0 of face (wake or effect): depth 50.000 m, brightness 0.5000 between"),
        "{}",
        told[0]
    );
    assert!(told[1].starts_with("0 of face (sea): depth 80.000 m"), "{}", told[1]);
    assert!(session.omissions().is_empty());
    // Effects know faces: the frame is drawn whole.
    let mut planes = Planes::new(PIXELS[0] as usize, PIXELS[1] as usize, &[PlaneKind::Label]);
    session.frame(0, &from_above(80.0), &mut planes, &mut Probe::off()).unwrap();
}

/// A square of 100 m whose corners stand on the lunoid lies below the curved ground in its middle.
#[test]
fn a_sea_hides_curved_ground_of_its_height() {
    let laws = Laws { curvature: Curvature::Exact, ..usual().laws };
    let settings = Settings { laws, ..usual() };
    let sea = list(FaceKind::Sea, &square([100.0, 100.0, 0.0], 190.0), |face| face);
    let ground = landscape(plane(50.0, [4, 4], 0.0, [0.0; 2]), 0.5);
    let found = planes(&ground, scenery(vec![sea]), &settings, &pose([10.0, 100.0, 3.0], -10.0, 0.0));
    for line in 16..PIXELS[1] {
        let index = (line * PIXELS[0] + 20) as usize;
        let is_far = value(&found, PlaneKind::Range, index) > 180.0;
        assert!(is_far || value(&found, PlaneKind::Label, index) == f64::from(Label::Sea.code()), "{line}");
    }
}
