//! Rough ground under one photograph from above, seen from any eye.

use std::sync::Arc;

use generator::{Generator, PlaneKind, Planes, Session, Stage};
use glam::DVec3;
use landscape::relief::{Relief, Undulation};
use landscape::{Attitude, Bank, Landscape, Sun};
use panels::{Hardware, Panels, Parameters};
use photo_camera::{Affine, Axes, Camera, Light, Orientation};
use photograph::{Photograph, Placement};
use picture::{Depth, GreyPicture};
use quantities::{Rate, radians};
use scenario::{Curvature, Display, FieldOfView, Laws, Pose, Scenery, View};
use signal::Probe;

/// Side of the ground (m).
pub const SIDE: f64 = 400.0;

/// Sun of scenario and photograph: azimuth and elevation (rad).
pub const SUN: [f64; 2] = [1.2, 0.7];

/// Ground with hills of so many metres.
pub fn landscape(rms_height: f64) -> Landscape {
    let undulation = Undulation { rms_height, hurst: 0.8, longest: 200.0, shortest: 60.0, waves: 64 };
    let undulation = (rms_height > 0.0).then_some(undulation);
    let relief = Relief { undulation, ..Relief::flat(3, [SIDE; 2], 10.0) };
    Landscape::new(Bank::new("test", vec![relief.build().unwrap()], None).unwrap(), 0.5)
}

/// A photograph of so many pixels a side from a height (m) above the middle: a tenth of a milliradian times 10 a pixel.
pub fn photograph(pixels: usize, height: f64, share: impl Fn(f64, f64) -> f64) -> Photograph {
    let at = |pixel: usize| (pixel as f64 + 0.5) / pixels as f64;
    let codes = (0..pixels * pixels).map(|pixel| share(at(pixel % pixels), at(pixel / pixels)) * 65_535.0);
    let codes = codes.map(|code| code.round() as u16).collect();
    let picture = GreyPicture::new(pixels, pixels, Depth::Sixteen, codes).unwrap();
    let orientation = Orientation::from_axes([DVec3::X, DVec3::Y, DVec3::Z]).unwrap();
    let half = 100.0 * pixels as f64 / 2.0;
    let affine = Affine::new([100.0, 0.0, -half], [0.0, -100.0, half]).unwrap();
    let centre = DVec3::new(SIDE / 2.0, SIDE / 2.0, height);
    let camera = Camera::new(0.1, [0.0; 2], centre, orientation, affine).unwrap();
    let placement = Placement::Camera { camera, axes: Axes::Landscape };
    Photograph::new(picture, placement, Light::new(Some(SUN), None).unwrap()).unwrap()
}

/// Waves of light that are many pixels long.
pub fn waves(x: f64, y: f64) -> f64 {
    0.4 + 0.2 * quantities::sin_cos(14.0 * x + 5.0 * y).0 + 0.1 * quantities::sin_cos(9.0 * y - 4.0 * x).0
}

/// A stage seen by a square picture of so many pixels and half a field (tangent).
pub fn stage(landscape: Landscape, photographs: Vec<Photograph>, pixels: u32, half: f64) -> Stage {
    let sun = Sun { azimuth: SUN[0], elevation: SUN[1] };
    let rate = Rate::new(10, 1).unwrap();
    Stage {
        landscape: Arc::new(landscape.with_photographs(photographs.into())),
        scenery: Arc::new(Scenery::still(sun)),
        view: View {
            columns: pixels,
            lines: pixels,
            field: FieldOfView { tan_half_width: half, tan_half_height: half },
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

/// Posts 5 m apart.
pub fn run() -> Parameters {
    Parameters { spacing: Some(5.0), ..Parameters::default() }
}

/// The generator with run parameters, on the computer that ships.
pub fn panels(parameters: Parameters) -> Panels {
    Panels { parameters, hardware: Hardware::shipped().unwrap() }
}

pub fn session(stage: Stage, run: Parameters) -> Box<dyn Session> {
    panels(run).prepare(stage).unwrap()
}

/// An eye at a place (north, east, up; m), with heading and pitch (deg).
pub fn pose(eye: [f64; 3], heading: f64, pitch: f64) -> Pose {
    let attitude = Attitude { roll: 0.0, pitch: radians(pitch), heading: radians(heading) };
    Pose { time: 0.0, eye, attitude, yoke: 0.0 }
}

/// The picture of a pose: light, labels, distance.
pub fn draw(session: &dyn Session, pixels: usize, pose: &Pose) -> Planes {
    let kinds = [PlaneKind::Intensity, PlaneKind::Label, PlaneKind::Distance];
    let mut planes = Planes::new(pixels, pixels, &kinds);
    session.frame(0, pose, &mut planes, &mut Probe::off()).unwrap();
    planes
}

/// Light of all pixels.
pub fn light(planes: &Planes) -> &[f32] {
    planes.get(PlaneKind::Intensity).unwrap()
}

/// How many pixels show sky.
pub fn sky(planes: &Planes) -> usize {
    let sky = f32::from(generator::Label::Sky.code());
    planes.get(PlaneKind::Label).unwrap().iter().filter(|label| **label == sky).count()
}
