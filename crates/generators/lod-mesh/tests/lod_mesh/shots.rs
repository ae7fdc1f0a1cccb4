//! Pictures of rough ground from any eye.

use std::sync::Arc;

use generator::{Generator, PlaneKind, Planes, Session, Stage};
use landscape::relief::{Relief, Undulation};
use landscape::{Attitude, Bank, Landscape, Sun};
use lod_mesh::{Hardware, LodMesh, Parameters};
use quantities::{Rate, radians};
use scenario::{Curvature, Display, FieldOfView, Laws, Pose, Scenery, View};
use signal::Probe;

/// Side of the ground (m).
pub const SIDE: f64 = 1600.0;

/// Rough ground seen by a square picture with a view of 53 degrees.
pub fn stage(pixels: u32) -> Stage {
    let undulation = Undulation { rms_height: 14.0, hurst: 0.5, longest: 400.0, shortest: 60.0, waves: 96 };
    let relief = Relief { undulation: Some(undulation), ..Relief::flat(11, [SIDE, SIDE], 20.0) };
    let landscape = Landscape::new(Bank::new("test", vec![relief.build().unwrap()], None).unwrap(), 0.8);
    let sun = Sun { azimuth: radians(75.0), elevation: radians(35.0) };
    let rate = Rate::new(10, 1).unwrap();
    Stage {
        landscape: Arc::new(landscape),
        scenery: Arc::new(Scenery::still(sun)),
        view: View {
            columns: pixels,
            lines: pixels,
            field: FieldOfView { tan_half_width: 0.5, tan_half_height: 0.5 },
            update: rate,
            refresh: rate,
            display: Display { white: 1.0, gamma: 1.0 },
            laws: Laws { curvature: Curvature::None, ..Laws::default() },
            ranges: [1.0, 5000.0],
            yoke: None,
            levels: None,
            shadows: None,
        },
    }
}

/// Tiles of 8 cells of 10 m, whose three levels morph between 0 and 900 m.
pub fn run() -> Parameters {
    Parameters {
        order: 3,
        spacing: Some(10.0),
        levels: Some(3),
        ranges: vec![450.0, 900.0, 1350.0],
        ..Parameters::default()
    }
}

/// The generator on the computer that ships.
pub fn generator(run: Parameters) -> LodMesh {
    LodMesh { parameters: run, hardware: Hardware::shipped().unwrap() }
}

pub fn session(stage: Stage, run: Parameters) -> Box<dyn Session> {
    generator(run).prepare(stage).unwrap()
}

/// An eye at a place (north, east, up; m), with heading and pitch (deg).
pub fn pose(eye: [f64; 3], heading: f64, pitch: f64) -> Pose {
    let attitude = Attitude { roll: 0.0, pitch: radians(pitch), heading: radians(heading) };
    Pose { time: 0.0, eye, attitude, yoke: 0.0 }
}

/// The picture of a pose with all planes.
pub fn draw(session: &dyn Session, pixels: usize, pose: &Pose) -> Planes {
    let mut planes =
        Planes::new(pixels, pixels, &[PlaneKind::Intensity, PlaneKind::Label, PlaneKind::Distance]);
    session.frame(0, pose, &mut planes, &mut Probe::off()).unwrap();
    planes
}

/// How many pixels show sky.
pub fn sky(planes: &Planes) -> usize {
    let sky = f32::from(generator::Label::Sky.code());
    planes.get(PlaneKind::Label).unwrap().iter().filter(|label| **label == sky).count()
}
