//! One sub-area: all its sampling points at once, then its pixels.

use generator::Label;
use glam::DVec3;
use light_points::{Share, Veil, mask_under};
use raster::{Coverage, DistancePlane, Filter, Lists, Sampling, Screen, SubArea, Weights};
use scenario::{Sheet, SkyDisc};
use translucency::{Feature, FeatureError, Losses, Stack};

use crate::camera::Camera;
use crate::faces::{Mapped, Surface};
use crate::ground_map::GroundMap;
use crate::lights::Point;
use crate::parameters::Parameters;
use crate::scene::{DISC_PRIORITY, Scene};

/// Pixels of a row of sub-areas, as coverage counts them.
pub const SIDE: usize = 8;

/// What a sub-area comes to.
#[derive(Debug, Default, Clone)]
pub struct Tile {
    /// Colours with their weights: of its own pixels, and of those around it where the filter reaches there; row by row.
    pub colours: Vec<([f64; 3], f64)>,
    /// Nearest opaque surface of its own pixels: how near (1/m), and what it is.
    pub surfaces: Vec<(f64, Label)>,
    /// Shares of calligraphic points, by number.
    pub shares: Vec<(u32, Share)>,
    /// What its limits lost.
    pub losses: Losses,
}

/// Stacks and buffers of one thread, used for sub-area after sub-area.
pub struct Sampler {
    sampling: Sampling,
    coverage: Coverage,
    weights: Weights,
    stack: Stack,
    veil: Veil,
    /// How many pixels the filter reaches beyond one: 0 or 1.
    reach: usize,
}

impl Sampler {
    /// A sampler for run parameters.
    ///
    /// # Errors If the background is no light.
    pub fn new(run: &Parameters) -> Result<Self, FeatureError> {
        let sampling = run.sampling();
        Ok(Self {
            coverage: Coverage::default(),
            weights: run.filter.weights(run.pattern),
            stack: Stack::new(sampling.clone(), run.capacity(), [0.0; 3])?,
            veil: Veil::new(SIDE * SIDE * sampling.count(), run.veil),
            reach: usize::from(run.filter != Filter::Box),
            sampling,
        })
    }

    /// The stacks of a sub-area after [`Sampler::fill`].
    pub fn stack(&self) -> &Stack {
        &self.stack
    }

    /// Draws a sub-area into `tile`, whatever that has been.
    ///
    /// # Errors If a light is no number.
    pub fn draw(
        &mut self,
        scene: &Scene,
        lists: &Lists,
        (screen, number): (&Screen, usize),
        tile: &mut Tile,
    ) -> Result<(), FeatureError> {
        let area = screen.sub_area(number);
        self.fill(scene, lists, &area, number)?;
        self.read_out(scene, &area, number, &mut tile.shares);
        self.colours(&area, &mut tile.colours);
        self.surfaces(scene, &area, &mut tile.surfaces);
        tile.losses = self.stack.losses();
        Ok(())
    }

    /// Puts all features of a sub-area into its stacks, calligraphic points apart.
    ///
    /// # Errors If a light is no number.
    pub fn fill(
        &mut self,
        scene: &Scene,
        lists: &Lists,
        area: &SubArea,
        number: usize,
    ) -> Result<(), FeatureError> {
        self.stack.start(area);
        for &face in lists.of(number) {
            self.coverage.find(&scene.faces.triangles[face as usize], area, &self.sampling);
            // Most far triangles lie between the sampling points.
            if self.coverage.pixels().next().is_none() {
                continue;
            }
            let Some((plane, surface)) = scene.faces.seen(face, &scene.camera) else { continue };
            match surface {
                Surface::Ready(feature) => self.stack.add(feature, &plane, self.coverage.pixels()),
                Surface::Mapped(ground) => {
                    let Some(map) = &scene.ground_map else { continue };
                    for (pixel, mask) in self.coverage.pixels() {
                        let feature = mapped(ground, map, &plane, &scene.camera, middle(area, pixel))?;
                        self.stack.add(feature, &plane, [(pixel, mask)]);
                    }
                }
                Surface::Dust(sheet) => {
                    let (sheet, id) = &scene.dust[sheet as usize];
                    dust(&mut self.stack, &self.coverage, &plane, sheet, *id, area, &scene.camera)?;
                }
            }
        }
        for (nearness, (disc, id)) in scene.discs.iter().enumerate() {
            self.disc(disc, *id, DISC_PRIORITY - nearness as i32, area, &scene.camera)?;
        }
        for &point in scene.lights.of(number) {
            let point = &scene.lights.points[point as usize];
            if !point.is_calligraphic {
                self.stack.add(point.feature, &point.plane(), under(point, area, &self.sampling));
            }
        }
        Ok(())
    }

    /// A disc of the sky: each pixel has the mean colour of the sampling points that the disc covers there.
    fn disc(
        &mut self,
        disc: &SkyDisc,
        id: u32,
        priority: i32,
        area: &SubArea,
        camera: &Camera,
    ) -> Result<(), FeatureError> {
        let middle = [area.columns(), area.rows()].map(|range| f64::from(range.start + range.end) / 2.0);
        let reach = disc.angular_diameter / 2.0 + farthest_angle(area, middle, camera);
        if camera.ray(middle).normalize().dot(disc.direction) < quantities::sin_cos(reach.min(3.0)).1 {
            return Ok(());
        }
        for (pixel, at) in pixels(area) {
            let (mut mask, mut sum) = (0, [0.0; 3]);
            for (i, place) in self.sampling.places(at).enumerate() {
                if let Some(light) = disc.light(camera.ray(place).normalize()) {
                    mask |= 1 << i;
                    sum = std::array::from_fn(|channel| sum[channel] + light[channel]);
                }
            }
            if mask != 0 {
                let colour = sum.map(|channel| channel / f64::from(u32::count_ones(mask)));
                let feature = Feature::surface(id, priority, colour, 0.0)?;
                let infinitely_far = DistancePlane { slope: [0.0; 2], origin: 0.0 };
                self.stack.add(feature, &infinitely_far, [(pixel, mask)]);
            }
        }
        Ok(())
    }

    /// Reads out the calligraphic points of a sub-area near to far, after all other features (claims 7, 13).
    fn read_out(&mut self, scene: &Scene, area: &SubArea, number: usize, shares: &mut Vec<(u32, Share)>) {
        self.veil.lift();
        shares.clear();
        for &at in scene.lights.of(number) {
            let point = &scene.lights.points[at as usize];
            if !point.is_calligraphic {
                continue;
            }
            let samples = self.sampling.count();
            let covered = under(point, area, &self.sampling).flat_map(|(pixel, mask)| {
                (0..samples).filter(move |i| mask >> i & 1 == 1).map(move |i| pixel * samples + i)
            });
            let stack = &self.stack;
            let through = |sample: usize| stack.through(sample, point.q, &point.feature);
            let share = self.veil.read_out(covered, through, point.feature.translucency());
            shares.push((at, share));
        }
    }

    /// Colours of a sub-area's pixels and of those that the filter reaches.
    fn colours(&self, area: &SubArea, colours: &mut Vec<([f64; 3], f64)>) {
        let reach = self.reach as i32;
        let [width, height] = [area.columns(), area.rows()].map(|range| range.len() + 2 * self.reach);
        colours.clear();
        colours.resize(width * height, ([0.0; 3], 0.0));
        for (pixel, _) in pixels(area) {
            let [x, y] = [pixel % SIDE, pixel / SIDE];
            for row in -reach..=reach {
                for column in -reach..=reach {
                    // The pixel lies as far from the one that it reaches as that lies from it, on the other side.
                    let weights = self.weights.of([-column, -row]);
                    let reached = [x as i32 + column + reach, y as i32 + row + reach];
                    let (colour, weight) = &mut colours[reached[1] as usize * width + reached[0] as usize];
                    let [red, green, blue] = self.stack.colour(pixel, weights);
                    *colour = [colour[0] + red, colour[1] + green, colour[2] + blue];
                    *weight += weights.iter().sum::<f64>();
                }
            }
        }
    }

    /// What is seen in each pixel of a sub-area: its nearest opaque surface, or what weighs more before it.
    fn surfaces(&self, scene: &Scene, area: &SubArea, surfaces: &mut Vec<(f64, Label)>) {
        let label = |feature: &Feature| scene.faces.labels[feature.id() as usize];
        let of_pixel = |pixel: usize| {
            let first = self.stack.is_layered(pixel).then(|| pixel * self.stack.samples());
            let heavy = first.and_then(|sample| {
                let mut layers = self.stack.layers(sample);
                layers.find(|layer| layer.weight() > 0.5 && !layer.feature.is_opaque())
            });
            match (self.stack.surface(pixel), heavy) {
                (surface, Some(layer)) => (surface.map_or(0.0, |(_, q)| q), label(layer.feature)),
                (Some((feature, q)), None) => (q, label(feature)),
                (None, None) => (0.0, Label::Sky),
            }
        };
        surfaces.clear();
        surfaces.extend(pixels(area).map(|(pixel, _)| of_pixel(pixel)));
    }
}

/// Dust over covered pixels: each pixel has the translucency of the path through its middle.
fn dust(
    stack: &mut Stack,
    coverage: &Coverage,
    plane: &DistancePlane,
    sheet: &Sheet,
    id: u32,
    area: &SubArea,
    camera: &Camera,
) -> Result<(), FeatureError> {
    let normal = sheet.normal();
    for (pixel, mask) in coverage.pixels() {
        let ahead = camera.ray(middle(area, pixel)).normalize();
        let share = sheet.translucency(ahead.dot(normal));
        let feature = Feature::surface(id, i32::from(sheet.priority), sheet.colour, share)?;
        stack.add(feature, plane, [(pixel, mask)]);
    }
    Ok(())
}

/// The look of ground with a map at a place on the screen (pixels).
///
/// # Errors If the map's colour is none.
pub fn mapped(
    ground: Mapped,
    map: &GroundMap,
    plane: &DistancePlane,
    camera: &Camera,
    place: [f64; 2],
) -> Result<Feature, FeatureError> {
    // A pixel's middle may lie beside the triangle: no farther away than its corners.
    let q = plane.at(place).clamp(ground.between[0], ground.between[1]);
    let seen = camera.eye + camera.ray(place) / q;
    // For light the map is flat.
    let at = seen + DVec3::Z * camera.drop_at(seen);
    Feature::surface(ground.id, ground.priority, map.at(at, camera.eye), 0.0)
}

/// Middle (pixels on the screen) of a pixel of a sub-area.
fn middle(area: &SubArea, pixel: usize) -> [f64; 2] {
    let (column, row) = (f64::from(area.columns().start), f64::from(area.rows().start));
    [column + (pixel % SIDE) as f64 + 0.5, row + (pixel / SIDE) as f64 + 0.5]
}

/// Numbers of the pixels of a sub-area, and their places on the screen.
pub fn pixels(area: &SubArea) -> impl Iterator<Item = (usize, [i32; 2])> + use<> {
    let (columns, rows) = (area.columns(), area.rows());
    rows.enumerate().flat_map(move |(row, y)| {
        columns.clone().enumerate().map(move |(column, x)| (SIDE * row + column, [x as i32, y as i32]))
    })
}

/// Pixels of a sub-area under a point's disc, with the bits of the covered sampling points.
fn under<'a>(
    point: &'a Point,
    area: &SubArea,
    sampling: &'a Sampling,
) -> impl Iterator<Item = (usize, u32)> + use<'a> {
    pixels(area)
        .map(|(pixel, at)| (pixel, mask_under(point.middle, point.disc.diameter, at, sampling)))
        .filter(|(_, mask)| *mask != 0)
}

/// Largest angle (rad) between the ray of a sub-area's middle and those of its corners, or a little more.
fn farthest_angle(area: &SubArea, middle: [f64; 2], camera: &Camera) -> f64 {
    let ahead = camera.ray(middle).normalize();
    let [columns, rows] = [area.columns(), area.rows()];
    let corners = [columns.start, columns.end].map(|x| [rows.start, rows.end].map(|y| [x, y].map(f64::from)));
    let chord = |at: &[f64; 2]| (camera.ray(*at).normalize() - ahead).length();
    // An angle below a right one is less than 1.2 chords.
    1.2 * corners.as_flattened().iter().map(chord).fold(0.0, f64::max)
}
