//! Which list wins a sample.

use faces::{Face, Group, Mesh, Order};
use generator::PlaneKind;
use glam::DVec3;
use scenario::OtherSide;
use smooth_faces::Parameters;

use crate::shots::{PIXELS, draw, from_above, pose, run, session, square, stage};

/// Red in the middle of a picture from above, and how often the orders disagree.
fn middle(lists: Vec<scenario::FaceList>, order: Order) -> (f32, u64) {
    let session = session(stage(lists), Parameters { order, ..run() });
    let (planes, counts) = draw(&*session, 0, &from_above());
    let red = planes.get(PlaneKind::Red).unwrap()[PIXELS / 2 * PIXELS + PIXELS / 2];
    (red, counts["disagreements"])
}

fn squares(priorities: [i32; 2]) -> Vec<scenario::FaceList> {
    let at = |up: f64| DVec3::new(150.0, 100.0, up);
    let [near, far] = priorities;
    vec![
        square("near", at(20.0), 40.0, near, [1.0, 0.0, 0.0]),
        square("far", at(0.0), 60.0, far, [0.0, 0.0, 1.0]),
    ]
}

#[test]
fn the_lower_number_wins_by_lists_and_the_nearer_face_by_depth() {
    let lit = 0.644_217_7;
    assert!((middle(squares([1, 2]), Order::Lists).0 - lit).abs() < 1e-6);
    assert_eq!(middle(squares([1, 2]), Order::Lists).1, 0);
    let (red, disagreements) = middle(squares([2, 1]), Order::Lists);
    assert_eq!(red, 0.0, "the far list hides the near one");
    // The near square is 40 m of 100 m of the picture at its height.
    let pixels = libm::pow(40.0 / 100.0 * PIXELS as f64, 2.0);
    assert!((disagreements as f64 - pixels).abs() < 0.1 * pixels, "{disagreements} of {pixels}");
    let (red, of_depth) = middle(squares([2, 1]), Order::Depth);
    assert!((red - lit).abs() < 1e-6);
    assert_eq!(of_depth, disagreements, "the count is the same under both orders");
}

/// Threads share out the faces of a long list; the face stored first wins all the same.
#[test]
fn of_a_thousand_faces_in_one_place_the_first_one_shows() {
    let mut list = square("pile", DVec3::new(150.0, 100.0, 0.0), 60.0, 1, [1.0, 0.0, 0.0]);
    let below = Face::flat(vec![0, 1, 2, 3], [0.0, 0.0, 1.0]);
    let faces = [&list.group.mesh.faces()[..1], &vec![below; 999]].concat();
    let mesh = Mesh::load("pile", list.group.mesh.vertices().to_vec(), faces).unwrap().mesh;
    list.group = Group::new("pile", mesh, 1);
    for order in [Order::Lists, Order::Depth] {
        let (red, disagreements) = middle(vec![list.clone()], order);
        assert!((red - 0.644_217_7).abs() < 1e-6 && disagreements == 0, "{order:?}: {red}");
    }
}

#[test]
fn lists_change_places_beyond_their_plane() {
    let mut lists = squares([5, 10]);
    // From the north of its plane the near square is after the far one.
    lists[0].carrier = scenario::Carrier::Fixed { place: DVec3::new(150.0, 100.0, 0.0), heading: 0.0 };
    lists[0].group.mesh = square("near", DVec3::Z * 20.0, 40.0, 5, [1.0, 0.0, 0.0]).group.mesh;
    lists[0].other_side = Some(OtherSide { towards: -DVec3::X, priority: 20 });
    let session = session(stage(lists), run());
    let red = |north: f64| {
        let (planes, _) = draw(&*session, 0, &pose([north, 100.0, 120.0], 0.0, -90.0));
        planes.get(PlaneKind::Red).unwrap()[PIXELS / 2 * PIXELS + PIXELS / 2]
    };
    assert!(red(149.0) > 0.6, "from the south");
    assert_eq!(red(151.0), 0.0, "from the north");
}

#[test]
fn a_face_through_the_eye_is_clipped_and_never_mirrored() {
    let session =
        session(stage(vec![square("sea", DVec3::new(150.0, 100.0, 0.0), 400.0, 1, [1.0; 3])]), run());
    let (planes, _) = draw(&*session, 0, &pose([150.0, 100.0, 2.0], 30.0, 0.0));
    let labels = planes.get(PlaneKind::Label).unwrap();
    let sky = f32::from(generator::Label::Sky.code());
    assert!(labels[..PIXELS * PIXELS / 2].iter().all(|label| *label == sky), "above the horizon");
    assert!(labels[PIXELS * (PIXELS / 2 + 2)..].iter().all(|label| *label != sky), "below it");
}
