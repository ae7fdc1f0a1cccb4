//! Boards and seas: counts, two roads, contrast, added levels (acceptance tests 1, 2, 9 and 13).

use std::f64::consts::TAU;

use faces::{
    Animate, Board, Cone, Detail, FaceError, Group, Mean, Mesh, Pattern, Sea, SeaState, Turn, TurningSun,
    renumbered, steps_of,
};
use glam::DVec3;
use quantities::{Rate, radians};

use crate::{WHITE, near};

const FRAMES: u64 = 32;

fn rate() -> Rate {
    Rate::new(FRAMES, 1).expect("a frame rate")
}

fn sea(state: SeaState, mean: Mean) -> Sea {
    let board = Board::new(10.0, 0..20, 0..30).expect("a board");
    let cone = Cone::new(16, radians(75.0)).expect("a cone");
    Sea::of_state(state, (board, Pattern::Random { seed: 1 }, cone), (mean, WHITE), rate()).expect("a sea")
}

/// Brightness of all corners of a list in a frame.
fn corners(group: &Group, frame: u64) -> Vec<f64> {
    let sun = group.sun.vector(frame, DVec3::Z);
    (0..group.mesh.faces().len()).flat_map(|face| group.brightness(face, sun, false)).collect()
}

#[test]
fn counts_of_a_grid() {
    let board = Board::new(10.0, 0..20, 0..30).expect("a board");
    assert_eq!((board.triangles(), board.edges(), board.vertices()), (1200, 1850, 651));
    assert_eq!(board.grid().count(), 651);
    let mesh = sea(SeaState::Calm, Mean::AsReported).group("sea", 1, 600).expect("a list").mesh;
    assert_eq!((mesh.faces().len(), mesh.vertices().len()), (600, 651));
    assert!(mesh.normals().iter().all(|&normal| normal == DVec3::Z));
}

#[test]
fn diagonals_meet_at_every_second_vertex() {
    let mesh = sea(SeaState::Calm, Mean::AsReported).group("sea", 1, 600).expect("a list").mesh;
    let mut met = vec![0; mesh.vertices().len()];
    for face in mesh.faces() {
        [0, 2].iter().for_each(|&k| met[face.corners[k] as usize] += 1);
    }
    for row in 1..20 {
        for column in 1..30 {
            assert_eq!(met[row * 31 + column], if (row + column) % 2 == 0 { 4 } else { 0 }, "{row} {column}");
        }
    }
}

#[test]
fn boards_that_cannot_be() {
    for side in [0.0, -1.0, f64::NAN] {
        assert!(Board::new(side, 0..1, 0..1).is_err());
    }
    assert!(Board::new(1.0, 0..0, 0..1).is_err() && Board::new(1.0, 0..1, 2..2).is_err());
    assert!(Board::new(1.0, i64::MIN..i64::MAX, 0..1).is_err());
    let wide = Board::new(1.0, -(1 << 30)..1 << 30, -(1 << 30)..1 << 30).expect("a board, but not its faces");
    let found = wide.squares("sea", WHITE, Mesh::MOST_FACES, |_| unreachable!("no vertex is made"));
    assert!(matches!(found, Err(FaceError::TooMany { .. })), "{found:?}");
}

#[test]
fn a_ring_has_a_hole_and_a_rim() {
    let board = Board::new(1.0, -20..20, -20..20).expect("a board").ring(5.0, 15.0).expect("a ring");
    let flat =
        |vertex: faces::GridVertex| faces::Vertex::at(DVec3::new(vertex.place[0], vertex.place[1], 0.0));
    let mesh = board.squares("ring", WHITE, 1600, flat).expect("squares").mesh;
    for face in mesh.faces() {
        let middle = mesh.places(face).iter().sum::<DVec3>() / 4.0;
        assert!((5.0..=15.0).contains(&middle.length()), "{middle}");
    }
    let area = std::f64::consts::PI * (15.0 * 15.0 - 5.0 * 5.0);
    assert!((mesh.faces().len() as f64 - area).abs() < 0.03 * area, "{}", mesh.faces().len());
    for (inner, outer) in [(-1.0, 5.0), (5.0, 5.0), (0.0, f64::NAN)] {
        assert!(Board::new(1.0, 0..1, 0..1).expect("a board").ring(inner, outer).is_err());
    }
}

#[test]
fn both_roads_give_the_same_sea() {
    let sea = sea(SeaState::High, Mean::USUAL);
    let turned = sea.group("sea", 1, 600).expect("a list");
    // A quarter turn a second at 32 frames: 8 frames to a step of the table.
    for frame in [0, 8, 16, 56, 120, 136, 8 * 999] {
        let renumbered = sea.renumbered("sea", 1, 600, frame).expect("a list");
        let (one, other) = (corners(&turned, frame), corners(&renumbered, frame));
        assert_eq!(one.len(), 2400);
        assert!(one.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-12), "frame {frame}");
    }
    let between = corners(&sea.renumbered("sea", 1, 600, 4).expect("a list"), 4);
    assert!(corners(&turned, 4).iter().zip(&between).any(|(a, b)| (a - b).abs() > 0.01));
    assert_eq!((Animate::Sun.words(651), Animate::Normals.words(651)), (3, 1953));
    assert_eq!([0, 3, 16, 19].map(|steps| renumbered(2, steps, 16)), [2, 15, 2, 15]);
    assert_eq!([0.0, 0.03, 0.04, 0.96, 0.97].map(|part| steps_of(part, 16)), [0, 0, 1, 15, 0]);
}

#[test]
fn the_film_of_a_sea_closes_to_the_bit() {
    let group = sea(SeaState::Moderate, Mean::USUAL).group("sea", 1, 600).expect("a list");
    // A fifth of a turn a second at 32 frames closes after 160.
    let bits = |frame| corners(&group, frame).into_iter().map(f64::to_bits).collect::<Vec<_>>();
    assert_eq!(bits(3), bits(163));
    assert_ne!(bits(3), bits(83));
}

#[test]
fn contrast_of_the_states() {
    for state in SeaState::ALL {
        for mean in [Mean::AsReported, Mean::USUAL] {
            let light = corners(&sea(state, mean).group("sea", 1, 600).expect("a list"), 0);
            let low = light.iter().copied().fold(f64::INFINITY, f64::min);
            let high = light.iter().copied().fold(0.0, f64::max);
            near((high - low) / (high + low), state.contrast());
            let uniform = light.iter().all(|one| one.to_bits() == light[0].to_bits());
            assert_eq!(uniform, state == SeaState::Calm);
        }
    }
}

#[test]
fn seas_overlap_to_the_bit() {
    let whole = sea(SeaState::High, Mean::USUAL);
    let part = Sea { board: Board::new(10.0, 5..9, 7..20).expect("a board"), ..whole.clone() };
    let [whole, part] = [whole, part].map(|sea| sea.group("sea", 1, 600).expect("a list"));
    let mut compared = 0;
    for (face, of) in part.mesh.faces().iter().enumerate() {
        let places = part.mesh.places(of);
        let same = |other: &usize| whole.mesh.places(&whole.mesh.faces()[*other]) == places;
        let other = (0..600).find(same).expect("the same square");
        let sun = part.sun.vector(11, DVec3::Z);
        assert_eq!(part.brightness(face, sun, false), whole.brightness(other, sun, false));
        compared += 1;
    }
    assert_eq!(compared, 4 * 13);
}

#[test]
fn a_wake_is_smaller_and_faster() {
    let sea = sea(SeaState::High, Mean::AsReported);
    let wake = sea.wake(Board::new(5.0, 0..4, 0..4).expect("a board"), WHITE, rate()).expect("a wake");
    assert_eq!(wake.sun.turn(), Turn::new([2, 1], rate()).expect("a turn"));
    assert_eq!((wake.gain, wake.numbers().len()), (0.5, 25));
    assert_eq!((sea.warnings(), wake.warnings()), (vec![], vec![]));
    let slow = Rate::new(30, 1).expect("a rate");
    let stepping = sea.wake(wake.board.clone(), WHITE, slow).expect("a wake").warnings();
    assert!(matches!(stepping[..], [faces::Warning::Stepping { .. }]), "{stepping:?}");
    assert!(sea.wake(Board::new(10.0, 0..4, 0..4).expect("a board"), WHITE, rate()).is_err());
    assert!(sea.wake(wake.board.clone(), WHITE, Rate::new(3, 1).expect("a rate")).is_err());
}

#[test]
fn levels_are_added_clamped_or_soft() {
    let cone = Cone::new(16, radians(75.0)).expect("a cone");
    let at = |number, azimuth, elevation| {
        faces::brightness(cone.normal(number), faces::sun_vector(azimuth, radians(elevation)))
    };
    let (below, above) = (at(5, 0.7 * TAU / 4.0, 60.0), 0.5 * at(3, 1.4 * TAU, 50.0));
    near(below, 0.920561065594065);
    near(above, 0.389389703654);
    let added = Detail::Add.combine(below, above);
    assert_eq!((added.intensity, added.is_clamped), (1.0, true));
    near(below + above, 1.309950769248);
    assert!(!Detail::Add.combine(0.5, 0.5).is_clamped);
    near(Detail::AddSoft.combine(below, above).intensity, 1.0 - (1.0 - below) * (1.0 - above));
    assert!(Detail::AddSoft.combine(1.0, 1.0).intensity <= 1.0);
    assert_eq!(Detail::Replace.combine(0.9, 0.2).intensity, 0.2);
}

/// Power of a sample's intensity at whole hertz 1 to 8, over 4 s.
fn spectrum(detail: Detail) -> Vec<f64> {
    let cone = Cone::new(16, radians(75.0)).expect("a cone");
    let sun = |turns, elevation| {
        TurningSun::new(radians(elevation), 0.0, Turn::new(turns, rate()).expect("a turn")).expect("a sun")
    };
    let (sea, wake) = (sun([1, 1], 60.0), sun([2, 1], 50.0));
    let frame = |n| {
        let level = |sun: &TurningSun, number| faces::brightness(cone.normal(number), sun.vector(n));
        detail.combine(0.6 * level(&sea, 5), 0.4 * level(&wake, 3)).intensity
    };
    let film: Vec<f64> = (0..4 * FRAMES).map(frame).collect();
    let power = |hertz: u64| {
        let part = |n: usize, light: &f64| {
            let (sin, cos) = libm::sincos(TAU * (hertz * n as u64) as f64 / FRAMES as f64);
            [light * cos, light * sin]
        };
        let sum = film.iter().enumerate().map(|(n, light)| part(n, light));
        let [a, b] = sum.fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
        libm::hypot(a, b) / film.len() as f64
    };
    (1..=8).map(power).collect()
}

#[test]
fn added_levels_show_both_rates_and_replaced_ones_one() {
    let shows = |detail: Detail| -> Vec<usize> {
        let found = spectrum(detail);
        (0..8).filter(|&k| found[k] > 1e-9).map(|k| k + 1).collect()
    };
    assert_eq!(shows(Detail::Add), [1, 2]);
    assert_eq!(shows(Detail::Replace), [2]);
    // The product of the soft sum adds the beats: the sum and the difference of both rates.
    assert_eq!(shows(Detail::AddSoft), [1, 2, 3]);
}
