//! The flight of the document's chapter 6 over ground in closed form: the range straight down, with switching and with morphing.

use lod_tiles::{Edges, Level, Levels, State, Stitch, Surface, Terrain};

const TAU: f64 = std::f64::consts::TAU;
const FRAMES: usize = 1801;

fn closed_form(x: f64, y: f64) -> f64 {
    300.0 * libm::sin(TAU * x / 7000.0) * libm::cos(TAU * y / 9000.0)
        + 80.0 * libm::sin(TAU * (x + 2.0 * y) / 6000.0 + 0.5)
        + 10.0 * libm::cos(TAU * (3.0 * x - y) / 6000.0)
}

/// 5 x 5 tiles of 33 x 33 posts, 100 m apart.
pub fn terrain() -> Terrain {
    let places: Vec<f64> = (0..161).map(|k| 100.0 * f64::from(k)).collect();
    let heights = places.iter().flat_map(|&y| places.iter().map(move |&x| closed_form(x, y))).collect();
    Terrain::new(5, [places.clone(), places.clone()], heights).unwrap()
}

pub fn levels() -> Levels {
    let levels = [15e3, 30e3, 60e3].map(|end| Level { end, share: 0.4 });
    Levels::new(5, levels.into()).unwrap()
}

pub fn moving(frame: usize) -> [f64; 3] {
    let t = frame as f64 / 30.0;
    [1000.0 + 14000.0 * t / 60.0, 2000.0 + 11000.0 * t / 60.0, 50000.0 - 49000.0 * t / 60.0]
}

fn hover(frame: usize) -> [f64; 3] {
    let t = frame as f64 / 30.0;
    [7171.0, 8229.0, 50000.0 - 49000.0 * t / 60.0]
}

/// How the ground is drawn.
#[derive(Clone, Copy)]
enum Way {
    Finest,
    Switching(Stitch),
    Morphing,
}

/// Height of the drawn surface under an eye, with the state of another eye.
fn height(terrain: &Terrain, way: Way, [x, y, _]: [f64; 3], of: [f64; 3]) -> f64 {
    let state = State::new(terrain, &levels(), of);
    let (state, stitch, edges) = match way {
        Way::Finest => {
            let finest = Levels::new(5, vec![Level { end: 1e9, share: 0.0 }]).unwrap();
            (State::new(terrain, &finest, of), Stitch::None, Edges::PerTile)
        }
        Way::Switching(stitch) => (state.switched(), stitch, Edges::PerTile),
        Way::Morphing => (state, Stitch::FineSide, Edges::Shared),
    };
    Surface { terrain, state: &state, levels: 3, edges, stitch }.under([x, y])
}

/// Range straight down in each frame, less that of the finest mesh.
fn excess(terrain: &Terrain, way: Way, eye: fn(usize) -> [f64; 3]) -> Vec<f64> {
    let of = |frame: usize| {
        let eye = eye(frame);
        height(terrain, Way::Finest, eye, eye) - height(terrain, way, eye, eye)
    };
    (0..FRAMES).map(of).collect()
}

/// Change from frame to frame.
fn jump(excess: &[f64], frame: usize) -> f64 {
    excess[frame + 1] - excess[frame]
}

fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-9, "found {found}, expected {expected}");
}

/// Frames in the order of their jumps, the largest first.
fn largest(excess: &[f64]) -> Vec<usize> {
    let mut frames: Vec<usize> = (0..FRAMES - 1).collect();
    frames.sort_by(|&a, &b| jump(excess, b).abs().total_cmp(&jump(excess, a).abs()));
    frames
}

#[test]
fn posts_are_those_of_the_check_values() {
    assert!((closed_form(3217.0, 4105.0) + 71.640020618723).abs() < 1e-11);
    assert!((closed_form(3200.0, 4100.0) + 78.296389110010).abs() < 1e-11);
}

#[test]
fn hovering_over_a_switch_jumps_by_a_metre() {
    let terrain = terrain();
    for stitch in [Stitch::FineSide, Stitch::None] {
        let excess = excess(&terrain, Way::Switching(stitch), hover);
        assert_eq!(largest(&excess)[..2], [727, 1278]);
        near(jump(&excess, 727).abs(), 1.173363741062);
        near(jump(&excess, 1278).abs(), 0.447634580332);
        near(rms(&excess), 1.059927359024);
    }
}

#[test]
fn hovering_over_a_morph_jumps_by_millimetres() {
    let excess = excess(&terrain(), Way::Morphing, hover);
    let largest = jump(&excess, largest(&excess)[0]).abs();
    near(largest, 0.005321401968);
    assert!(largest < 0.005323594751, "below the bound: pop x speed x time / zone");
    near(rms(&excess), 1.118896032230);
}

#[test]
fn a_moving_eye_sees_two_switches() {
    let terrain = terrain();
    let table = [
        (Way::Switching(Stitch::FineSide), [-2.597043863410, -1.249328980790], 2.474441673474),
        (Way::Switching(Stitch::None), [-3.276244679357, -1.249328980790], 2.473726594252),
        (Way::Morphing, [0.281468748162, 0.042180673445], 2.565776245244),
    ];
    for (way, jumps, expected) in table {
        let excess = excess(&terrain, way, moving);
        near(jump(&excess, 729), jumps[0]);
        near(jump(&excess, 1290), jumps[1]);
        near(rms(&excess), expected);
    }
}

/// A standing eye, with the levels of the frame before and of the frame.
fn pop(terrain: &Terrain, way: Way, frame: usize) -> f64 {
    let eye = moving(frame);
    (height(terrain, way, eye, moving(frame)) - height(terrain, way, eye, moving(frame - 1))).abs()
}

#[test]
fn a_standing_eye_sees_what_pops() {
    let terrain = terrain();
    near(pop(&terrain, Way::Switching(Stitch::FineSide), 730), 2.886463604536);
    near(pop(&terrain, Way::Switching(Stitch::None), 730), 3.565664420481);
    near(pop(&terrain, Way::Switching(Stitch::FineSide), 1291), 1.292837778592);
}

/// Before and after the levels change from those of the frame before to those of the frame, for a standing eye.
#[test]
fn levels_that_change_move_nothing_where_tiles_morph() {
    let (terrain, levels) = (terrain(), levels());
    let under = |eye: [f64; 3], change: [[f64; 3]; 2], is_switching: bool| {
        let state = State::at_change(&terrain, &levels, eye, change);
        let state = if is_switching { state.switched() } else { state };
        let surface = Surface {
            terrain: &terrain,
            state: &state,
            levels: 3,
            edges: Edges::Shared,
            stitch: Stitch::CoarseSide,
        };
        surface.under([eye[0], eye[1]])
    };
    let pop = |frame: usize, is_switching| {
        let (eye, before) = (moving(frame), moving(frame - 1));
        (under(eye, [eye, before], is_switching) - under(eye, [before, eye], is_switching)).abs()
    };
    let largest = (1..=1800).map(|frame| pop(frame, false)).fold(0.0, f64::max);
    assert!(largest < 1e-9, "{largest}");
    near(pop(730, true), 2.886463604536);
    near(pop(1291, true), 1.292837778592);
}
