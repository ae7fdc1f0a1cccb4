//! Lists of faces over nothing, seen from any eye.

use std::sync::Arc;

use faces::{Board, Cone, Face, Group, Mean, Mesh, Pattern, Sea, SeaState, Vertex};
use generator::{FrameCounts, Generator, PlaneKind, Planes, Session, Stage};
use glam::DVec3;
use landscape::relief::Relief;
use landscape::{Attitude, Bank, Landscape, Sun};
use quantities::{Rate, radians};
use scenario::{
    Carrier, Curvature, Display, FaceKind, FaceList, FaceLists, FieldOfView, Laws, Pose, Scenery, View,
};
use signal::Probe;
use smooth_faces::{Hardware, Parameters, SmoothFaces};

/// Frames of a second.
pub const FRAMES: u64 = 30;

/// Pixels of a side of the pictures.
pub const PIXELS: usize = 60;

pub fn rate() -> Rate {
    Rate::new(FRAMES, 1).unwrap()
}

/// Lists over flat ground at height 0, seen with a view of 53 degrees.
pub fn stage(lists: Vec<FaceList>) -> Stage {
    let relief = Relief::flat(3, [2000.0; 2], 100.0);
    let landscape = Landscape::new(Bank::new("test", vec![relief.build().unwrap()], None).unwrap(), 0.5);
    let sun = Sun { azimuth: 1.2, elevation: 0.7 };
    let lists = FaceLists { lists, ..FaceLists::default() };
    Stage {
        landscape: Arc::new(landscape),
        scenery: Arc::new(Scenery::still(sun).with_face_lists(Arc::new(lists))),
        view: View {
            columns: PIXELS as u32,
            lines: PIXELS as u32,
            field: FieldOfView { tan_half_width: 0.5, tan_half_height: 0.5 },
            update: rate(),
            refresh: rate(),
            display: Display { white: 1.0, gamma: 1.0 },
            laws: Laws { curvature: Curvature::None, ..Laws::default() },
            ranges: [1.0, 5000.0],
            yoke: None,
            levels: None,
            shadows: None,
        },
    }
}

/// No ground, faces by their lists.
pub fn run() -> Parameters {
    Parameters { ground: None, order: faces::Order::Lists, ..Parameters::default() }
}

/// A sea of squares of 10 m over 200 m x 300 m: 651 vertices.
pub fn sea(state: SeaState, pattern: Pattern) -> Sea {
    board_sea(Board::new(10.0, 0..20, 0..30).unwrap(), state, pattern)
}

/// A sea of squares of 6 m under a table of 4096 normals, which goes on in every frame.
pub fn fine_sea(rows: i64, columns: i64) -> Sea {
    let board = Board::new(6.0, 0..rows, 0..columns).unwrap();
    let cone = Cone::new(4096, radians(75.0)).unwrap();
    let random = Pattern::Random { seed: 1 };
    Sea::of_state(SeaState::High, (board, random, cone), (Mean::USUAL, [1.0; 3]), rate()).unwrap()
}

pub fn board_sea(board: Board, state: SeaState, pattern: Pattern) -> Sea {
    let cone = Cone::new(16, radians(75.0)).unwrap();
    Sea::of_state(state, (board, pattern, cone), (Mean::USUAL, [1.0; 3]), rate()).unwrap()
}

/// The list of a sea at height 0.
pub fn sea_list(sea: &Sea) -> FaceList {
    let group = sea.group("sea", 30_000, usize::MAX).unwrap();
    let carrier = Carrier::Map(0.0);
    FaceList { sea: Some(sea.clone()), ..FaceList::new(group, FaceKind::Sea, carrier) }
}

/// A square of a side (m) about a place, whose normal is up, as a list of a priority.
pub fn square(name: &str, at: DVec3, side: f64, priority: i32, colour: [f64; 3]) -> FaceList {
    let half = side / 2.0;
    let corners = [[-half, -half], [-half, half], [half, half], [half, -half]];
    let vertices = corners.map(|[north, east]| Vertex::at(at + DVec3::new(north, east, 0.0))).to_vec();
    let mesh = Mesh::load(name, vertices, vec![Face::flat(vec![0, 1, 2, 3], colour)]).unwrap().mesh;
    let group = Group::new(name, mesh, priority);
    FaceList::new(group, FaceKind::Effect, Carrier::Map(0.0))
}

/// The gear that ships.
pub fn gear() -> Hardware {
    Hardware::shipped().unwrap()
}

pub fn session(stage: Stage, parameters: Parameters) -> Box<dyn Session> {
    session_on(stage, parameters, gear())
}

pub fn session_on(stage: Stage, parameters: Parameters, hardware: Hardware) -> Box<dyn Session> {
    SmoothFaces { parameters, hardware }.prepare(stage).unwrap()
}

/// An eye at a place (north, east, up; m), with heading and pitch (deg).
pub fn pose(eye: [f64; 3], heading: f64, pitch: f64) -> Pose {
    let attitude = Attitude { roll: 0.0, pitch: radians(pitch), heading: radians(heading) };
    Pose { time: 0.0, eye, attitude, yoke: 0.0 }
}

/// Straight down onto the middle of the sea.
pub fn from_above() -> Pose {
    pose([150.0, 100.0, 120.0], 0.0, -90.0)
}

/// The picture of a frame: light, red, labels, distance; and its counts.
pub fn draw(session: &dyn Session, frame: u64, pose: &Pose) -> (Planes, FrameCounts) {
    let kinds = [PlaneKind::Intensity, PlaneKind::Red, PlaneKind::Label, PlaneKind::Distance];
    let mut planes = Planes::new(PIXELS, PIXELS, &kinds);
    let counts = session.frame(frame, pose, &mut planes, &mut Probe::off()).unwrap();
    (planes, counts)
}

/// Light of all pixels of a frame.
pub fn light(session: &dyn Session, frame: u64, pose: &Pose) -> Vec<f32> {
    draw(session, frame, pose).0.get(PlaneKind::Intensity).unwrap().to_vec()
}

/// Largest difference between two pictures.
pub fn apart(a: &[f32], b: &[f32]) -> f32 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}
