//! Ships, their motion, and four ways to hide the hull (section 7, check values 8.5).

use std::collections::BTreeMap;

use faces::ship::{Attitude, Hiding, Motion, Ship, Wave, Wedges, bow_gap, box_error};
use faces::{Mesh, Order, Turn, Warning, check_priorities};
use glam::DVec3;
use quantities::{Rate, radians};

use crate::near;

const SHIPS: [Ship; 2] = [Ship::LPH2, Ship::DD963];

fn extent(mesh: &Mesh) -> [DVec3; 2] {
    let places = || mesh.vertices().iter().map(|vertex| vertex.place);
    [places().fold(DVec3::INFINITY, DVec3::min), places().fold(DVec3::NEG_INFINITY, DVec3::max)]
}

#[test]
fn ships_have_their_dimensions_and_enough_faces() {
    let feet = [(592.0, 84.0, 27.0), (563.0, 55.0, 29.0)];
    for (ship, (length, beam, draught)) in SHIPS.iter().zip(feet) {
        near(ship.length, length * 0.3048);
        near(ship.beam, beam * 0.3048);
        near(ship.draught, draught * 0.3048);
        let whole = ship.to_the_keel("hull").expect("a ship");
        let above = ship.above_water("hull").expect("a ship");
        assert!(above.faces().len() >= 200 && whole.faces().len() > above.faces().len() + 150);
        let [low, high] = extent(&whole);
        near(high.x - low.x, ship.length);
        near(low.z, -ship.draught);
        near(extent(&above)[0].z, 0.0);
        assert!(high.y >= ship.beam / 2.0 && high.y == -low.y, "{high}");
    }
}

/// Volume of a closed surface (m3), and the sum of its faces as vectors (m2), which is 0 where it closes.
fn volume(mesh: &Mesh, faces: impl Iterator<Item = usize>) -> (f64, DVec3) {
    let (mut volume, mut area) = (0.0, DVec3::ZERO);
    for face in faces {
        let places = mesh.places(&mesh.faces()[face]);
        for k in 2..places.len() {
            // Left-handed axes: reversed cross product.
            let part = (places[k] - places[0]).cross(places[k - 1] - places[0]) / 2.0;
            volume += part.dot(places[0]) / 3.0;
            area += part;
        }
    }
    (volume, area)
}

#[test]
fn hulls_close_and_displace_water() {
    for ship in SHIPS {
        let mesh = ship.to_the_keel("hull").expect("a ship");
        let on_deck = 5 * ship.blocks.len() + ship.markings.len();
        let (volume, open) = volume(&mesh, on_deck..mesh.faces().len());
        assert!(open.length() < 1e-9, "{}: {open}", ship.name);
        let top = ship.levels[4].up;
        let block = volume / (ship.length * ship.beam * (ship.draught + top));
        assert!((0.5..1.1).contains(&block), "{}: {block}", ship.name);
    }
}

#[test]
fn the_bow_flares() {
    for ship in SHIPS {
        let [water, deck] = [2, 4].map(|k| ship.levels[k]);
        assert!(deck.entrance < water.entrance && deck.breadth >= water.breadth, "{}", ship.name);
        let mesh = ship.above_water("hull").expect("a ship");
        let downward = (0..mesh.faces().len()).filter(|&face| {
            let middle = mesh.places(&mesh.faces()[face])[0];
            middle.x > 0.6 * ship.length / 2.0 && mesh.normals()[face].z < -0.05
        });
        assert!(downward.count() > 20, "{}", ship.name);
    }
}

#[test]
fn pitch_roll_and_the_box() {
    near(bow_gap(180.4416, radians(5.0)), 7.863260835288);
    near(bow_gap(180.4416, radians(10.0)), 15.666677507653);
    near(bow_gap(2.0 * 12.8016, radians(8.0)), 1.781638369250);
    near(box_error(1.0, radians(2.0)), 0.034920769492);
    near(box_error(1.0, radians(10.0)), 0.176326980708);
    // The ship turned by its attitude shows the same gaps.
    let bow = DVec3::new(90.2208, 0.0, 0.0);
    let pitched = Attitude { pitch: radians(5.0), ..Attitude::default() };
    near((pitched.turn(1.0) * bow).z, 7.863260835288);
    let rolled = Attitude { roll: radians(8.0), ..Attitude::default() };
    near((rolled.turn(1.0) * DVec3::new(0.0, 12.8016, 0.0)).z, -1.781638369250);
}

#[test]
fn attitudes_are_rotations_by_heading() {
    let level = Attitude::default();
    let east = level.turn(radians(90.0));
    assert!((east * DVec3::X).distance(DVec3::Y) < 1e-15 && (east * DVec3::Y).distance(-DVec3::X) < 1e-15);
    let any = Attitude { pitch: 0.1, roll: -0.3, heave: 2.0, sway: 3.0 };
    let turn = any.turn(2.0);
    assert!((turn.determinant() - 1.0).abs() < 1e-14);
    assert!((turn.transpose() * turn - glam::DMat3::IDENTITY).abs_diff_eq(glam::DMat3::ZERO, 1e-14));
    let origin = any.origin(DVec3::new(10.0, 20.0, 0.0), radians(90.0));
    assert!(origin.distance(DVec3::new(7.0, 20.0, 2.0)) < 1e-14, "{origin}");
}

#[test]
fn motion_is_a_sum_of_sines_that_closes() {
    let frames = Rate::new(30, 1).expect("a frame rate");
    let wave =
        |amplitude, rate, phase| Wave { amplitude, turn: Turn::new(rate, frames).expect("a turn"), phase };
    let motion = Motion {
        pitch: vec![wave(radians(4.0), [1, 8], 0.0), wave(radians(1.0), [1, 5], 0.5)],
        roll: vec![wave(radians(8.0), [1, 10], 0.0)],
        heave: vec![wave(1.5, [1, 6], 0.0)],
        ..Motion::default()
    };
    let at = motion.at(60);
    near(at.pitch, radians(4.0) * libm::sin(radians(90.0)) + radians(1.0) * libm::sin(radians(144.0) + 0.5));
    near(at.heave, 1.5 * libm::sin(radians(120.0)));
    assert_eq!((at.sway, motion.at(30 * 120)), (0.0, motion.at(0)));
    assert_eq!(motion.warnings(), []);
    let wild = Motion { pitch: vec![wave(radians(10.0), [1, 8], 0.0)], ..motion };
    let told = wild.warnings();
    assert!(matches!(told[..], [Warning::Beyond { motion: "pitch", .. }]), "{told:?}");
    assert_eq!(
        told[0].to_string(),
        "pitch reaches 10.00 deg: the study's limit for landing and take-off is 5.0 deg"
    );
}

#[test]
fn wedges_by_pitch() {
    let arranged = Ship::LPH2.arranged("lph", Hiding::Wedges(Wedges::USUAL), 1).expect("lists");
    let own = Ship::LPH2.above_water("lph").expect("a ship").faces().len();
    for (pitch, index) in
        [(0.4, 1), (0.5, 1), (2.0, 4), (5.0, 10), (-3.0, 0), (0.0, 0), (9.0, 10), (f64::NAN, 0)]
    {
        assert_eq!(Wedges::USUAL.index(pitch), index, "{pitch}");
        if pitch.is_nan() {
            continue;
        }
        let shown = arranged.ship.shown(0, |name| if name == "pitch" { pitch } else { f64::NAN });
        assert_eq!(shown.len(), own + if index > 0 { 20 } else { 0 }, "{pitch}");
        let deepest = |face: &usize| {
            let mesh = &arranged.ship.mesh;
            mesh.places(&mesh.faces()[*face]).iter().map(|place| place.z).fold(f64::INFINITY, f64::min)
        };
        let reached = shown.iter().map(deepest).fold(f64::INFINITY, f64::min);
        near(-reached, bow_gap(Ship::LPH2.length, radians(0.5 * index as f64)));
    }
}

#[test]
fn four_ways_and_two_wrong_orders() {
    let sea = [0.0, 0.1, 0.2];
    let ways = [
        (Hiding::Waterline, [5, 6], false, Order::Lists),
        (Hiding::Box { gap: 1.0, sea }, [6, 7], true, Order::Lists),
        (Hiding::Wedges(Wedges::USUAL), [5, 6], true, Order::Lists),
        (Hiding::Exact, [5, 6], true, Order::Depth),
        (Hiding::SeaFirst, [6, 5], false, Order::Lists),
        (Hiding::DeepHull, [5, 6], true, Order::Lists),
    ];
    for (hiding, [ship, water], is_deep, order) in ways {
        let made = Ship::DD963.arranged("dd", hiding, 5).expect("lists");
        assert_eq!((made.ship.priority, made.sea, made.order), (ship, water, order), "{hiding:?}");
        assert_eq!(extent(&made.ship.mesh)[0].z < -1.0, is_deep, "{hiding:?}");
        let surround = made.surround.iter().map(|list| (list.name.as_str(), list.priority));
        let lists = [("dd", made.ship.priority), ("sea", made.sea)].into_iter().chain(surround);
        assert_eq!(check_priorities(lists), Ok(()));
        assert_eq!(made.surround.is_some(), matches!(hiding, Hiding::Box { .. }));
    }
}

#[test]
fn the_box_is_open_at_the_top_and_holds_the_hull() {
    let made = Ship::DD963.arranged("dd", Hiding::Box { gap: 2.0, sea: [0.1; 3] }, 1).expect("lists");
    let surround = made.surround.expect("a box");
    assert_eq!((surround.mesh.faces().len(), surround.name.as_str()), (5, "dd-box"));
    let [low, high] = extent(&surround.mesh);
    assert_eq!(high.z, 0.0);
    near(high.x, Ship::DD963.length / 2.0 + 2.0);
    near(low.y, -Ship::DD963.beam / 2.0 - 2.0);
    near(low.z, -Ship::DD963.draught - 2.0);
    for (face, normal) in surround.mesh.faces().iter().zip(surround.mesh.normals()) {
        assert!(surround.mesh.places(face)[0].dot(*normal) > 0.0 && normal.z <= 0.0, "{normal}");
    }
}

#[test]
fn hidings_out_of_range() {
    let refused = |hiding| Ship::DD963.arranged("dd", hiding, 1).is_err();
    assert!(
        refused(Hiding::Box { gap: 0.0, sea: [0.1; 3] }) && refused(Hiding::Box { gap: 1.0, sea: [1.1; 3] })
    );
    for (step_deg, count) in [(0.0, 10), (-1.0, 10), (f64::NAN, 10), (0.5, 0), (0.5, 101)] {
        assert!(refused(Hiding::Wedges(Wedges { step_deg, count })), "{step_deg} {count}");
    }
}

#[test]
fn inner_edges_of_a_hull_have_two_faces() {
    let mesh = Ship::LPH2.to_the_keel("hull").expect("a ship");
    let mut edges: BTreeMap<[[u64; 3]; 2], i32> = BTreeMap::new();
    let bits = |place: DVec3| place.to_array().map(|part| (part + 0.0).to_bits());
    for face in mesh.faces().iter().skip(5 * Ship::LPH2.blocks.len() + Ship::LPH2.markings.len()) {
        let places = mesh.places(face);
        for k in 0..places.len() {
            let (from, to) = (bits(places[k]), bits(places[(k + 1) % places.len()]));
            let (key, sense) = if from < to { ([from, to], 1) } else { ([to, from], -1) };
            *edges.entry(key).or_insert(0) += sense;
        }
    }
    assert!(edges.len() > 400 && edges.values().all(|&sense| sense == 0));
}
