//! From a scene to a picture: all sub-areas, then the beam.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use generator::{FrameError, Label, PlaneKind, Planes};
use glam::DVec3;
use light_points::{BeamBudget, Share};
use quantities::luminance;
use raster::{Lists, Screen};
use rayon::prelude::*;
use scenario::View;
use translucency::{FeatureError, Losses};

use crate::band::Band;
use crate::beam::Beam;
use crate::camera::Camera;
use crate::parameters::Parameters;
use crate::reading::Reading;
use crate::scene::Scene;
use crate::tile::{SIDE, Sampler, Tile};

/// Rows of sub-areas that are drawn before they are put into the picture. Chosen: enough work for all threads, and little memory.
const ROWS: usize = 8;

/// Sub-areas that a thread draws one after another, with the same stacks. Chosen: few enough that threads end together.
const RUN: usize = 8;

/// A picture in linear light, and what it took.
#[derive(Default)]
pub struct Picture {
    /// Colour of each pixel (linear red, green, blue), row by row, as exact as planes.
    pub colours: Vec<[f32; 3]>,
    /// Nearest opaque surface of each pixel: how near (1/m), and what it is.
    pub surfaces: Vec<(f32, Label)>,
    /// What the limits of the stacks lost.
    pub losses: Losses,
    /// What the beam draws.
    pub beam: Beam,
    /// Entries of all lists.
    pub entries: u64,
    /// Readings of all sub-areas, where they are asked for.
    pub readings: Vec<Reading>,
    /// Sub-areas that show an earlier frame, where there are any.
    earlier: Option<Earlier>,
}

/// Sub-areas of a picture that show an earlier frame.
struct Earlier {
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
    lists: &Lists,
    screen: &Screen,
    run: &Parameters,
    budget: BeamBudget,
    view: &View,
    frame: u64,
    is_read: bool,
) -> Result<Picture, FrameError> {
    let refused = |error: FeatureError| FrameError::Refused { frame, reason: error.to_string() };
    let reading = |sampler: &Sampler, number: usize| {
        let area = screen.sub_area(number);
        is_read.then(|| Reading::of(sampler.stack(), scene, lists, &area, number))
    };
    let idle = Mutex::new(Vec::new());
    let draw_run = |first: usize, tiles: &mut [Drawn]| -> Result<(), FeatureError> {
        let waiting = idle.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let mut sampler = waiting.map_or_else(|| Sampler::new(run), Ok)?;
        for (number, drawn) in (first..).zip(tiles) {
            sampler.draw(scene, lists, (screen, number), &mut drawn.tile)?;
            drawn.reading = reading(&sampler, number);
        }
        idle.lock().unwrap_or_else(PoisonError::into_inner).push(sampler);
        Ok(())
    };
    let mut gathered = Gathered::new(screen, run, lists);
    let [columns, rows] = screen.counts().map(|count| count as usize);
    // While rows are drawn, those before them are put into the picture. Both keep their memory: what one thread allocates and another
    // one frees makes threads wait for each other.
    let [mut next, mut before] =
        [0; 2].map(|_| (0..ROWS * columns).map(|_| Drawn::default()).collect::<Vec<_>>());
    let mut waiting = 0..0;
    for row in (0..rows).step_by(ROWS) {
        let numbers = row * columns..(row + ROWS).min(rows) * columns;
        let drawn = &mut next[..numbers.len()];
        let (drawn, ()) = rayon::join(
            || {
                let runs = drawn.par_chunks_mut(RUN).enumerate();
                runs.map(|(run, drawn)| draw_run(numbers.start + run * RUN, drawn)).collect::<Result<(), _>>()
            },
            || gathered.add(waiting, &mut before),
        );
        drawn.map_err(refused)?;
        std::mem::swap(&mut next, &mut before);
        waiting = numbers;
    }
    gathered.add(waiting, &mut before);
    let Gathered { mut picture, shares, .. } = gathered;
    let points = &scene.lights.points;
    picture.beam = Beam::new(points, shares, run, budget, (1e9 / view.update.hertz()) as u64);
    Ok(picture)
}

/// A sub-area, and its reading where that is asked for.
#[derive(Default)]
struct Drawn {
    tile: Tile,
    reading: Option<Reading>,
}

/// Sub-areas that were drawn, put together.
struct Gathered<'a> {
    screen: &'a Screen,
    picture: Picture,
    band: Band,
    /// Sub-area, number of the calligraphic point, and what becomes of it there.
    shares: Vec<(u32, u32, Share)>,
}

impl<'a> Gathered<'a> {
    /// An empty picture of a screen.
    fn new(screen: &'a Screen, run: &Parameters, lists: &Lists) -> Self {
        let pixels = screen.size().iter().map(|pixels| *pixels as usize).product();
        let picture = Picture {
            colours: Vec::with_capacity(pixels),
            surfaces: Vec::with_capacity(pixels),
            entries: lists.entries() as u64,
            ..Picture::default()
        };
        let band = Band::new(screen, usize::from(run.filter != raster::Filter::Box));
        Self { screen, picture, band, shares: Vec::new() }
    }

    /// Adds the sub-areas of some rows, in their order; takes their shares and readings away.
    fn add(&mut self, numbers: Range<usize>, drawn: &mut [Drawn]) {
        if numbers.is_empty() {
            return;
        }
        for (number, Drawn { tile, reading }) in numbers.zip(drawn) {
            self.band.add(tile, &self.screen.sub_area(number));
            self.picture.losses = self.picture.losses.and(tile.losses);
            self.picture.readings.extend(reading.take());
            let of_area = |(point, share)| (number as u32, point, share);
            self.shares.extend(tile.shares.drain(..).map(of_area));
        }
        self.band.hand_over(&mut self.picture.colours, &mut self.picture.surfaces);
    }
}

/// Fills those of [`PLANES`] that a caller wants.
pub fn fill(picture: &Picture, scene: &Scene, planes: &mut Planes) {
    for kind in PLANES {
        let columns = planes.columns();
        let Some(values) = planes.get_mut(kind) else { continue };
        values.par_iter_mut().enumerate().for_each(|(at, value)| {
            *value = match kind {
                PlaneKind::Red => picture.colours[at][0],
                PlaneKind::Green => picture.colours[at][1],
                PlaneKind::Blue => picture.colours[at][2],
                PlaneKind::Label => f32::from(picture.surfaces[at].1.code()),
                PlaneKind::Range => range(picture.surfaces[at].0, picture.ray(scene, at, columns)),
                PlaneKind::Distance => distance(picture.surfaces[at].0, picture.ray(scene, at, columns)),
                _ => {
                    let [red, green, blue] = picture.colours[at];
                    luminance([f64::from(red), f64::from(green), f64::from(blue)]) as f32
                }
            };
        });
    }
}

/// The planes that are filled.
pub const PLANES: [PlaneKind; 7] = [
    PlaneKind::Intensity,
    PlaneKind::Range,
    PlaneKind::Label,
    PlaneKind::Red,
    PlaneKind::Green,
    PlaneKind::Blue,
    PlaneKind::Distance,
];

/// Ground range (m) of a surface that is as near as `q` (1/m).
fn range(q: f32, ray: DVec3) -> f32 {
    if q > 0.0 { (ray.truncate().length() / f64::from(q)) as f32 } else { PlaneKind::Range.sky() }
}

/// Distance (m) of the same.
fn distance(q: f32, ray: DVec3) -> f32 {
    if q > 0.0 { (ray.length() / f64::from(q)) as f32 } else { PlaneKind::Distance.sky() }
}
