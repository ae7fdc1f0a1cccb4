//! A camera that hardly moves: what jumps in the picture is a pop.

use generator::PlaneKind;
use lod_mesh::{GroundLight, Parameters, Transition};
use scenario::Curvature;

use crate::shots::{draw, pose, run, session, stage};

const PIXELS: usize = 64;

/// Largest change of the intensity and of the distance (m) as a camera over the middle of a tile sinks by 2 micrometres, through the
/// distance at which the tile changes its level.
fn jumps(run: Parameters) -> [f64; 2] {
    let stage = stage(PIXELS as u32);
    let [x, y] = [760.0, 760.0];
    let ground = stage.landscape.at_spacing(x, y, 10.0).unwrap().height;
    let session = session(stage, run);
    let picture = |above: f64| draw(&*session, PIXELS, &pose([x, y, ground + above], 0.0, -90.0));
    let [before, behind] = [450.000_001, 449.999_999].map(picture);
    [PlaneKind::Intensity, PlaneKind::Distance].map(|kind| {
        let pairs = before.get(kind).unwrap().iter().zip(behind.get(kind).unwrap());
        pairs.map(|(a, b)| f64::from((a - b).abs())).fold(0.0, f64::max)
    })
}

#[test]
fn light_of_a_map_does_not_pop() {
    let [light, _] = jumps(run());
    assert!(light < 0.5 / 255.0, "{light}");
}

#[test]
fn a_switch_is_a_jump_in_distance() {
    let switch = Parameters { transition: Transition::Switch, ..run() };
    let [_, morphing] = jumps(run());
    let [_, switching] = jumps(switch);
    // A pixel is 7 m here. On an edge of two facets the grid of 1/256 pixel decides which of them is seen, 3 cm aside.
    assert!(morphing < 0.06 && switching > 1.0, "{morphing} {switching}");
}

#[test]
fn live_light_pops_where_levels_switch() {
    let live = Parameters { light: GroundLight::Live, transition: Transition::Switch, ..run() };
    let [light, _] = jumps(live);
    assert!(light > 5.0 / 255.0, "{light}");
}

#[test]
fn a_sounding_is_the_distance_in_the_picture_and_tells_a_switch() {
    let switch = Parameters { transition: Transition::Switch, ..run() };
    let stage = stage(PIXELS as u32);
    let ground = stage.landscape.at_spacing(760.0, 760.0, 10.0).unwrap().height;
    // Straight above a vertex that the next level lacks.
    let at = |above: f64| pose([750.0, 750.0, ground + above], 0.0, -90.0);
    let [before, behind] = [455.0, 445.0].map(at);
    let sounding = |run: &Parameters, levels| {
        session(stage.clone(), run.clone()).sounding(0, &before, levels).unwrap().unwrap()
    };
    let own = sounding(&switch, [&before; 2]);
    let planes = draw(&*session(stage.clone(), switch.clone()), PIXELS, &before);
    let middle = planes.get(PlaneKind::Distance).unwrap()[PIXELS / 2 * PIXELS + PIXELS / 2];
    assert!((own - f64::from(middle)).abs() < 8.0, "{own} {middle}");
    let pop =
        |run: &Parameters| (sounding(run, [&before, &behind]) - sounding(run, [&behind, &before])).abs();
    assert!(pop(&switch) > 0.5 && pop(&run()) < 1e-9, "{} {}", pop(&switch), pop(&run()));
}

/// On a body that bends, a level that is wholly the next one lies on the next one's chords.
#[test]
fn the_drop_of_the_lunoid_morphs_too() {
    let mut stage = stage(PIXELS as u32);
    stage.view.laws.curvature = Curvature::Parabolic;
    let ground = stage.landscape.at_spacing(755.0, 752.0, 10.0).unwrap().height;
    let session = session(stage, run());
    let at = |up: f64| pose([755.0, 752.0, ground + up], 0.0, -90.0);
    let [before, behind] = [455.0, 445.0].map(at);
    let sounding = |levels| session.sounding(0, &before, levels).unwrap().unwrap();
    let pop: f64 = sounding([&before, &behind]) - sounding([&behind, &before]);
    assert!(pop.abs() < 1e-9, "{pop}");
}
