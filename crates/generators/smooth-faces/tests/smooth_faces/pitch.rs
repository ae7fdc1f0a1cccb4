//! Ways to hide the hull of a ship that pitches, against the hull that `exact` cuts by the water (test 10 of the specification).

use std::f64::consts::FRAC_PI_2;

use exact::Exact;
use faces::ship::{Hiding, Motion, Ship, Wave, Wedges, bow_gap, box_error};
use faces::{Group, Order, Turn};
use generator::{Generator, Label, PlaneKind, Planes, Session, Stage};
use glam::DVec3;
use quantities::radians;
use scenario::{Carrier, DrawnBy, FaceKind, FaceList, FaceLists, FieldOfView, Pose, Scenery, ShipCourse};
use signal::Probe;
use smooth_faces::Parameters;

use crate::shots::{pose, rate, run, session, square, stage};

/// Distance of the eye from the middle plane of the ship (m).
const AWAY: f64 = 300.0;
/// Where the ship lies (m).
const SHIP: [f64; 2] = [1000.0, 1000.0];
/// Columns and lines of the pictures.
pub const SIZE: [usize; 2] = [300, 200];
/// Distance of the box from the hull (m).
const GAP: f64 = 8.0;

const SEA: [f64; 3] = [0.1, 0.24, 0.36];

fn ship_list(group: Group, motion: Motion, drawn_by: DrawnBy) -> FaceList {
    let course = ShipCourse {
        start: DVec3::new(SHIP[0], SHIP[1], 0.0),
        heading: 0.0,
        speed: 0.0,
        frames: rate(),
        motion,
        origin: DVec3::ZERO,
        yaw: 0.0,
    };
    let carrier = Carrier::Ship(course);
    FaceList { drawn_by, ..FaceList::new(group, FaceKind::Ship, carrier) }
}

/// An assault ship at a pitch (deg) on a sea of one face; and which face wins in the machine.
pub fn ship_at_sea(hiding: Hiding, pitch: f64) -> (Stage, Order) {
    let pitched = Wave { amplitude: radians(pitch), turn: Turn::STILL, phase: FRAC_PI_2 };
    let motion = || Motion { pitch: vec![pitched], ..Motion::default() };
    let arranged = Ship::LPH2.arranged("ship", hiding, 10).unwrap();
    let is_true = hiding == Hiding::Exact;
    let mut sea = square("sea", DVec3::new(SHIP[0], SHIP[1], 0.0), 1900.0, arranged.sea, SEA);
    sea.kind = FaceKind::Sea;
    let by = if is_true { DrawnBy::All } else { DrawnBy::Machines };
    let mut lists = vec![sea, ship_list(arranged.ship, motion(), by)];
    let surround =
        |group| FaceList { kind: FaceKind::Sea, ..ship_list(group, Motion::default(), DrawnBy::Machines) };
    lists.extend(arranged.surround.map(surround));
    if !is_true {
        let whole = Ship::LPH2.arranged("ship", Hiding::Exact, 10).unwrap().ship;
        lists.push(ship_list(whole, motion(), DrawnBy::Exact));
    }
    let mut stage = stage(Vec::new());
    let lists = FaceLists { lists, by_depth: is_true, ..FaceLists::default() };
    let sun = stage.scenery.sun(0.0);
    stage.scenery = std::sync::Arc::new(Scenery::still(sun).with_face_lists(std::sync::Arc::new(lists)));
    [stage.view.columns, stage.view.lines] = SIZE.map(|pixels| pixels as u32);
    (stage, arranged.order)
}

fn field(stage: &mut Stage, [tan_half_width, tan_half_height]: [f64; 2]) {
    stage.view.field = FieldOfView { tan_half_width, tan_half_height };
}

/// From starboard, `AWAY` m from a place `forward` m of amidships, that much below the horizon (deg).
pub fn abeam(forward: f64, elevation: f64) -> Pose {
    let height = AWAY * libm::tan(radians(elevation));
    pose([SHIP[0] + forward, SHIP[1] + AWAY, height], 270.0, -elevation)
}

pub fn labels(session: &dyn Session, pose: &Pose) -> Vec<u8> {
    let mut planes = Planes::new(SIZE[0], SIZE[1], &[PlaneKind::Label]);
    session.frame(0, pose, &mut planes, &mut Probe::off()).unwrap();
    planes.get(PlaneKind::Label).unwrap().iter().map(|code| *code as u8).collect()
}

/// Labels of the machine and of `exact`.
fn both((stage, order): (Stage, Order), pose: &Pose) -> [Vec<u8>; 2] {
    let truth = labels(&*Exact.prepare(stage.clone()).unwrap(), pose);
    [labels(&*session(stage, Parameters { order, ..run() }), pose), truth]
}

fn wrong([drawn, truth]: &[Vec<u8>; 2]) -> usize {
    drawn.iter().zip(truth).filter(|(drawn, truth)| drawn != truth).count()
}

const WAYS: [Hiding; 4] =
    [Hiding::Waterline, Hiding::Box { gap: GAP, sea: SEA }, Hiding::Wedges(Wedges::USUAL), Hiding::Exact];

/// The table of docs/blocks/smooth-faces.md.
#[test]
fn pixels_wrong_by_pitch_and_way_of_hiding() {
    let row = |pitch: f64| {
        WAYS.map(|way| {
            let (mut stage, order) = ship_at_sea(way, pitch);
            field(&mut stage, [0.4, 0.4 * SIZE[1] as f64 / SIZE[0] as f64]);
            wrong(&both((stage, order), &abeam(0.0, 5.0)))
        })
    };
    let table: Vec<[usize; 4]> = [-10.0, -5.0, -2.0, 0.0, 2.0, 5.0, 10.0].map(row).to_vec();
    let documented = [
        [1921, 235, 1921, 0],
        [1083, 247, 1083, 0],
        [444, 242, 444, 0],
        [0, 243, 0, 0],
        [457, 243, 274, 0],
        [1101, 241, 654, 0],
        [1942, 219, 1448, 0],
    ];
    assert_eq!(table, documented);
}

/// Hull that shows below the water amidships: pixels of one column, in metres of height.
#[test]
fn the_error_of_the_box_grows_with_the_elevation_of_the_eye() {
    for elevation in [5.0, 10.0, 15.0, 20.0] {
        let (mut stage, order) = ship_at_sea(Hiding::Box { gap: GAP, sea: SEA }, 0.0);
        let half = 0.1;
        field(&mut stage, [half * SIZE[0] as f64 / SIZE[1] as f64, half]);
        let [drawn, truth] = both((stage, order), &abeam(0.0, elevation));
        let column = |labels: &[u8]| -> Vec<bool> {
            let ship = |line: usize| labels[line * SIZE[0] + SIZE[0] / 2] == Label::Ship.code();
            (0..SIZE[1]).map(ship).collect()
        };
        let (drawn, truth) = (column(&drawn), column(&truth));
        assert!(truth.iter().any(|is_ship| *is_ship), "the ship is seen");
        let pixels = drawn.iter().zip(&truth).filter(|(drawn, truth)| **drawn && !**truth).count();
        // The side of the hull is nearer than its middle plane.
        let side =
            AWAY / libm::cos(radians(elevation)) - Ship::LPH2.beam / 2.0 * libm::cos(radians(elevation));
        let metres = 2.0 * half / SIZE[1] as f64 * side / libm::cos(radians(elevation));
        // The sight line passes the rim of the box.
        let height = AWAY * libm::tan(radians(elevation));
        let at_rim = libm::atan(height / (AWAY - Ship::LPH2.beam / 2.0 - GAP));
        let expected = box_error(GAP, at_rim) / metres;
        assert!((pixels as f64 - expected).abs() <= 1.0, "{elevation}: {pixels} {expected}");
    }
}

/// Height of the lowest part of a hull that ends at the waterline, at its stem.
#[test]
fn the_bow_floats_by_the_sine_of_the_pitch() {
    for pitch in [2.0, 5.0, 10.0] {
        let (mut stage, order) = ship_at_sea(Hiding::Waterline, pitch);
        let half = 0.1;
        field(&mut stage, [half * SIZE[0] as f64 / SIZE[1] as f64, half]);
        let pixel = 2.0 * half / SIZE[1] as f64 * AWAY;
        let height = 10.0;
        // A pixel and a half behind the stem.
        let stem = Ship::LPH2.length / 2.0 * libm::cos(radians(pitch)) - 1.5 * pixel;
        let eye = pose([SHIP[0] + stem, SHIP[1] + AWAY, height], 270.0, 0.0);
        let [drawn, _] = both((stage, order), &eye);
        let ship = |line: &usize| drawn[line * SIZE[0] + SIZE[0] / 2] == Label::Ship.code();
        let lowest = (0..SIZE[1]).rev().find(ship).unwrap();
        let found = height - (lowest as f64 + 1.0 - SIZE[1] as f64 / 2.0) * pixel;
        let expected = bow_gap(Ship::LPH2.length, radians(pitch));
        assert!((found - expected).abs() <= pixel, "{pitch}: {found} {expected}");
    }
}
