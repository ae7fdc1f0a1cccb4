//! From a stage and wishes to a photograph.

use std::sync::Arc;

use exact::Exact;
use generator::{Generator, PlaneKind, Planes, Stage};
use glam::DVec3;
use landscape::{Landscape, Sun};
use photo_camera::{Axes, CameraFile, Image, Light};
use picture::GreyPicture;
use scenario::{Curvature, Laws, PixelRule, Projection, ShadowFineness, View};
use signal::Probe;

use crate::light::coded;
use crate::truth::truth;
use crate::{MakeError, Stand, Wishes};

/// A photograph with its truth.
#[derive(Debug, Clone)]
pub struct Made {
    /// Codes of the photograph.
    pub picture: GreyPicture,
    /// Camera, axes, sun and grey curve, as the text of the camera file gives them back.
    pub file: CameraFile,
    /// East, north, up (m) of the ground that each pixel shows, line by line; none where it shows something else.
    pub ground: Vec<Option<DVec3>>,
    /// The ground that was photographed.
    pub landscape: Arc<Landscape>,
    /// Where the camera stands.
    pub stand: Stand,
    /// Sun at the time of the photograph.
    pub sun: Sun,
    /// Largest distance from the centre of a pixel to the projection of its ground point (pixels).
    pub residual: f64,
}

/// Makes the photograph of `stage` by `exact`, on the threads of the current pool.
///
/// # Errors
/// If the wishes make no photograph of this ground, or `exact` cannot draw it.
pub fn make(stage: &Stage, wishes: &Wishes) -> Result<Made, MakeError> {
    let stand = Stand::new(&stage.landscape, wishes)?;
    let sun = stage.scenery.sun(wishes.time);
    let planes = drawn(stage, &stand, wishes)?;
    let ground = truth(&stage.landscape, &stand, &planes);
    if ground.iter().all(Option::is_none) {
        let [columns, lines] = wishes.size;
        return Err(MakeError::NoGround { columns, lines });
    }
    let picture = coded(planes.get(PlaneKind::Intensity).unwrap_or(&[]), wishes)?;
    let file = read_back(&stand, sun, wishes)?;
    let residual = residual(&file, &ground, picture.columns());
    Ok(Made { picture, file, ground, landscape: Arc::clone(&stage.landscape), stand, sun, residual })
}

/// Light and labels of the picture.
fn drawn(stage: &Stage, stand: &Stand, wishes: &Wishes) -> Result<Planes, MakeError> {
    let [columns, lines] = wishes.size;
    let view = &stage.view;
    let laws = Laws {
        projection: Projection::Exact,
        curvature: Curvature::None,
        pixel_rule: PixelRule::Centre,
        ..view.laws
    };
    let view = View {
        columns,
        lines,
        field: stand.field,
        laws,
        ranges: [0.0, f64::INFINITY],
        levels: None,
        shadows: view.shadows.map(|fineness| ShadowFineness { reach: None, ..fineness }),
        ..view.clone()
    };
    // The camera is not the vehicle, and what burns or hangs before it is no ground.
    let scenery = Arc::new((*stage.scenery).clone().with_vehicle(None).with_effects(Vec::new()));
    let session = Exact.prepare(Stage { landscape: Arc::clone(&stage.landscape), scenery, view })?;
    let kinds = [PlaneKind::Intensity, PlaneKind::Label];
    let mut planes = Planes::new(columns as usize, lines as usize, &kinds);
    session.frame(0, &stand.pose, &mut planes, &mut Probe::off()).map_err(MakeError::Frame)?;
    Ok(planes)
}

/// The camera file as whoever reads its text has it.
fn read_back(stand: &Stand, sun: Sun, wishes: &Wishes) -> Result<CameraFile, MakeError> {
    let grey = [wishes.transfer.white(), wishes.transfer.gamma()].map(decimal);
    let light = Light::new(Some([sun.azimuth, sun.elevation]), Some(grey)).map_err(|(_, error)| error)?;
    let file = CameraFile { camera: stand.camera, axes: Axes::Landscape, light };
    CameraFile::read("camera.json", &file.write()).map_err(MakeError::ReadBack)
}

/// The shortest decimal number that rounds to `value`: 2.2, not 2.200000048.
fn decimal(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::from(value))
}

/// Largest distance (pixels) from a pixel's centre to the projection of its ground point.
fn residual(file: &CameraFile, ground: &[Option<DVec3>], columns: usize) -> f64 {
    let seen = ground.iter().enumerate().filter_map(|(at, point)| Some((at, (*point)?)));
    let distance = |(at, point): (usize, DVec3)| match file.camera.project(point) {
        Image::Front { pixel: [i, j], .. } => {
            let centre = [(at % columns) as f64 + 0.5, (at / columns) as f64 + 0.5];
            libm::hypot(i - centre[0], j - centre[1])
        }
        Image::Behind { .. } => f64::INFINITY,
    };
    seen.map(distance).fold(0.0, f64::max)
}
