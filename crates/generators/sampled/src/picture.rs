//! From a scene to a picture: all sub-areas, then the beam.

use generator::{FrameError, Label, PlaneKind, Planes};
use glam::DVec3;
use quantities::luminance;
use raster::Screen;
use rayon::prelude::*;
use scenario::View;
use translucency::{FeatureError, Losses};

use crate::beam::Beam;
use crate::camera::Camera;
use crate::hardware::Hardware;
use crate::overload::{self, LostEntry};
use crate::parameters::Parameters;
use crate::reading::Reading;
use crate::scene::Scene;
use crate::tile::{SIDE, Sampler, Tile};

/// A picture in linear light, and what it took.
#[derive(Default)]
pub struct Picture {
    /// Colour of each pixel (linear red, green, blue), row by row.
    pub colours: Vec<[f64; 3]>,
    /// Nearest opaque surface of each pixel: how near (1/m), and what it is.
    pub surfaces: Vec<(f64, Label)>,
    /// What the limits of the stacks lost.
    pub losses: Losses,
    /// What the beam draws.
    pub beam: Beam,
    /// Entries of all lists.
    pub entries: u64,
    /// Entries that found no place in the lists, by sub-area.
    pub lost: Vec<LostEntry>,
    /// Readings of all sub-areas, where they are asked for.
    pub readings: Vec<Reading>,
    /// Sub-areas that show an earlier frame, where there are any.
    pub earlier: Option<Earlier>,
}

/// Sub-areas of a picture that show an earlier frame.
pub struct Earlier {
    /// Camera of the earlier frame.
    camera: Camera,
    /// Whether each sub-area shows it, in raster order.
    areas: Vec<bool>,
}

impl Picture {
    /// Shows `earlier`, seen by `camera`, in the sub-areas that are told; black without a picture.
    pub fn show_earlier(
        &mut self,
        earlier: Option<&Picture>,
        camera: Camera,
        areas: Vec<bool>,
        screen: &Screen,
    ) {
        let [width, _] = screen.size().map(|pixels| pixels as usize);
        for at in 0..self.colours.len() {
            if areas[area_of(at, width)] {
                self.colours[at] = earlier.map_or([0.0; 3], |earlier| earlier.colours[at]);
                self.surfaces[at] = earlier.map_or((0.0, Label::Sky), |earlier| earlier.surfaces[at]);
            }
        }
        self.earlier = Some(Earlier { camera, areas });
    }

    /// Ray (1 long along the view axis) of a pixel, by the camera of the frame that is shown there.
    fn ray(&self, scene: &Scene, at: usize, columns: usize) -> DVec3 {
        let earlier = self.earlier.as_ref().filter(|earlier| earlier.areas[area_of(at, columns)]);
        let camera = earlier.map_or(&scene.camera, |earlier| &earlier.camera);
        camera.ray([(at % columns) as f64 + 0.5, (at / columns) as f64 + 0.5])
    }
}

/// Number of the sub-area that holds a pixel of a picture of `columns`.
pub fn area_of(at: usize, columns: usize) -> usize {
    (at / columns / SIDE) * columns.div_ceil(SIDE) + at % columns / SIDE
}

/// Draws every sub-area of a scene, and decides what the beam draws over them; reads the sub-areas off if `is_read`.
///
/// # Errors If a light is no number.
pub fn draw(
    scene: &Scene,
    screen: &Screen,
    run: &Parameters,
    hardware: &Hardware,
    view: &View,
    frame: u64,
    is_read: bool,
) -> Result<Picture, FrameError> {
    let refused = |error: FeatureError| FrameError::Refused { frame, reason: error.to_string() };
    let (lists, lost) = overload::lists(scene, screen, run.overload, &hardware.memory);
    let reading = |sampler: &Sampler, number: usize| {
        let area = screen.sub_area(number);
        is_read.then(|| Reading::of(sampler.stack(), scene, &lists, &area, number))
    };
    let drawn: Result<Vec<(Tile, Option<Reading>)>, FeatureError> = (0..screen.sub_areas())
        .into_par_iter()
        .map_init(
            || Sampler::new(run),
            |sampler, number| match sampler {
                Ok(sampler) => {
                    let tile = sampler.draw(scene, &lists, screen, number)?;
                    Ok((tile, reading(sampler, number)))
                }
                Err(error) => Err(*error),
            },
        )
        .collect();
    let (tiles, readings): (Vec<Tile>, Vec<Option<Reading>>) = drawn.map_err(refused)?.into_iter().unzip();
    let mut picture = join(&tiles, screen, usize::from(run.filter != raster::Filter::Box));
    picture.entries = lists.entries() as u64;
    picture.lost = lost;
    picture.readings = readings.into_iter().flatten().collect();
    let points = &scene.lights.points;
    picture.beam = Beam::new(points, &tiles, run, hardware, (1e9 / view.update.hertz()) as u64);
    Ok(picture)
}

/// Puts sub-areas together, in their order.
fn join(tiles: &[Tile], screen: &Screen, reach: usize) -> Picture {
    let [width, height] = screen.size().map(|pixels| pixels as usize);
    let mut sums = vec![([0.0; 3], 0.0); width * height];
    let mut surfaces = vec![(0.0, Label::Sky); width * height];
    let mut losses = Losses::default();
    for (number, tile) in tiles.iter().enumerate() {
        let area = screen.sub_area(number);
        let (columns, rows) = (area.columns(), area.rows());
        for (k, surface) in tile.surfaces.iter().enumerate() {
            let [row, column] = [k / columns.len(), k % columns.len()];
            surfaces[(rows.start as usize + row) * width + columns.start as usize + column] = *surface;
        }
        let across = columns.len() + 2 * reach;
        for (k, (colour, weight)) in tile.colours.iter().enumerate() {
            let x = (columns.start as usize + k % across).wrapping_sub(reach);
            let y = (rows.start as usize + k / across).wrapping_sub(reach);
            if x < width && y < height {
                let (sum, weights) = &mut sums[y * width + x];
                *sum = [sum[0] + colour[0], sum[1] + colour[1], sum[2] + colour[2]];
                *weights += weight;
            }
        }
        losses = losses.and(tile.losses);
    }
    // Beyond the border of the screen there are no sampling points: the others weigh more.
    let colours = sums
        .into_iter()
        .map(|([red, green, blue], weight)| [red / weight, green / weight, blue / weight])
        .collect();
    Picture { colours, surfaces, losses, ..Picture::default() }
}

/// Fills the planes that a caller wants, except for the overload map.
pub fn fill(picture: &Picture, scene: &Scene, planes: &mut Planes) {
    for kind in PLANES.iter().copied().filter(|kind| *kind != PlaneKind::Overload) {
        let columns = planes.columns();
        let Some(values) = planes.get_mut(kind) else { continue };
        values.par_iter_mut().enumerate().for_each(|(at, value)| {
            *value = match kind {
                PlaneKind::Red => picture.colours[at][0] as f32,
                PlaneKind::Green => picture.colours[at][1] as f32,
                PlaneKind::Blue => picture.colours[at][2] as f32,
                PlaneKind::Label => f32::from(picture.surfaces[at].1.code()),
                PlaneKind::Range => range(picture.surfaces[at].0, picture.ray(scene, at, columns)),
                PlaneKind::Distance => distance(picture.surfaces[at].0, picture.ray(scene, at, columns)),
                _ => luminance(picture.colours[at]) as f32,
            };
        });
    }
}

/// The planes that the generator fills.
pub const PLANES: &[PlaneKind] = &[
    PlaneKind::Intensity,
    PlaneKind::Range,
    PlaneKind::Label,
    PlaneKind::Red,
    PlaneKind::Green,
    PlaneKind::Blue,
    PlaneKind::Distance,
    PlaneKind::Overload,
];

/// Ground range (m) of a surface that is as near as `q` (1/m).
fn range(q: f64, ray: DVec3) -> f32 {
    if q > 0.0 { (ray.truncate().length() / q) as f32 } else { PlaneKind::Range.sky() }
}

/// Distance (m) of the same.
fn distance(q: f64, ray: DVec3) -> f32 {
    if q > 0.0 { (ray.length() / q) as f32 } else { PlaneKind::Distance.sky() }
}
