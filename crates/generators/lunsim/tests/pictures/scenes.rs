//! Scenes for the tests.

use std::sync::Arc;

use features::{Crater, Features, Shape};
use generator::{Generator, PlaneKind, Planes, PrepareError, Session, Stage};
use landscape::relief::Relief;
use landscape::{Attitude, Bank, Landscape, Sun};
use lunsim::{Hardware, Lunsim, Parameters};
use quantities::{Rate, radians};
use scenario::{Curvature, Display, FieldOfView, Laws, PixelRule, Pose, Scenery, ShadowFineness, View};
use signal::Probe;

/// What the program is asked for, and its run parameters.
#[derive(Debug, Clone)]
pub struct Given {
    pub view: View,
    pub parameters: Parameters,
}

impl Given {
    /// The program with the machines it ran on.
    pub fn program(&self) -> Lunsim {
        Lunsim { parameters: self.parameters, hardware: Hardware::shipped().unwrap() }
    }
}

/// The program on its ground.
#[derive(Debug, Clone)]
pub struct Scene {
    pub landscape: Arc<Landscape>,
    pub scenery: Arc<Scenery>,
    pub view: View,
    pub parameters: Parameters,
}

impl Scene {
    pub fn stage(&self) -> Stage {
        let Self { landscape, scenery, view, .. } = self.clone();
        Stage { landscape, scenery, view }
    }

    pub fn program(&self) -> Lunsim {
        Given { view: self.view.clone(), parameters: self.parameters }.program()
    }
}

/// A square picture of `side` pixels and a field of `field_deg`, codes fine enough not to be felt, with
/// remote shadow, on a flat Moon.
pub fn settings(side: u32, field_deg: f64, grid: u32) -> Given {
    let half = libm::tan(radians(0.5 * field_deg));
    let update = Rate::new(1, 1).unwrap();
    let view = View {
        columns: side,
        lines: side,
        field: FieldOfView { tan_half_width: half, tan_half_height: half },
        update,
        refresh: update,
        display: Display { white: 1.0, gamma: 1.0 },
        laws: Laws { curvature: Curvature::None, pixel_rule: PixelRule::Centre, ..Laws::default() },
        ranges: [1.0, 60_000.0],
        yoke: None,
        levels: None,
        shadows: Some(ShadowFineness::default()),
    };
    Given { view, parameters: Parameters { grid, intensity_codes: 256, restrictions: true } }
}

/// The same with what the program could not do.
pub fn unrestricted(settings: Given) -> Given {
    Given { parameters: Parameters { restrictions: false, ..settings.parameters }, ..settings }
}

/// Level ground of `side` (m) with craters.
pub fn plain(side: f64, craters: Vec<Crater>) -> Arc<Landscape> {
    relief(&Relief::flat(1, [side, side], side / 40.0), craters)
}

/// Ground of a relief with craters.
pub fn relief(relief: &Relief, craters: Vec<Crater>) -> Arc<Landscape> {
    let bank = Bank::new("test", vec![relief.build().unwrap()], None).unwrap();
    Arc::new(Landscape::new(bank, 1.0).with_features(Features::new(craters)))
}

/// A bowl (type 1).
pub fn bowl(centre: [f64; 2], r1: f64, depth: f64) -> Crater {
    Crater::new(centre, Shape::Bowl { r1 }, depth, 0.0).unwrap()
}

/// Sun, azimuth and elevation in degrees.
pub fn sun(azimuth: f64, elevation: f64) -> Sun {
    Sun { azimuth: radians(azimuth), elevation: radians(elevation) }
}

/// A pose; pitch and heading in degrees.
pub fn pose(eye: [f64; 3], pitch: f64, heading: f64) -> Pose {
    let attitude = Attitude { roll: 0.0, pitch: radians(pitch), heading: radians(heading) };
    Pose { time: 0.0, eye, attitude, yoke: 0.0 }
}

/// A scene under one sun.
pub fn stage(landscape: &Arc<Landscape>, sun: Sun, settings: &Given) -> Scene {
    Scene {
        landscape: Arc::clone(landscape),
        scenery: Arc::new(Scenery::still(sun)),
        view: settings.view.clone(),
        parameters: settings.parameters,
    }
}

/// The program made ready.
pub fn prepare(scene: Scene) -> Result<Box<dyn Session>, PrepareError> {
    scene.program().prepare(scene.stage())
}

/// All planes of one frame.
pub fn draw(landscape: &Arc<Landscape>, sun: Sun, settings: &Given, pose: &Pose) -> Planes {
    let [columns, lines] = [settings.view.columns, settings.view.lines].map(|count| count as usize);
    let mut planes = Planes::new(columns, lines, &PlaneKind::ALL);
    let session = prepare(stage(landscape, sun, settings)).unwrap();
    session.frame(0, pose, &mut planes, &mut Probe::off()).unwrap();
    planes
}

/// One value of a plane, as f64.
pub fn value(planes: &Planes, kind: PlaneKind, [column, line]: [usize; 2]) -> f64 {
    f64::from(planes.get(kind).unwrap()[line * planes.columns() + column])
}
