//! `exact` as a generator: checks the pose, draws the columns.

use std::ops::Range;
use std::sync::Arc;

use generator::{
    Counter, Fact, FrameCounts, FrameError, Generator, Joined, Omission, PlaneKind, Planes, PrepareError,
    Role, Row, Session as GeneratorSession, Stage, Weight, photographs_beside,
};
use quantities::intensity;
use rayon::prelude::*;
use scenario::{FaceKind, Pose};
use signal::Probe;

use crate::column::{Column, Fineness, Frame, Pixel};
use crate::effects::{Layer, Screen};
use crate::light::Light;
use crate::lists::FaceLayer;
use crate::scene::Scene;
use crate::{Ceilings, Outlook, stance, water_area};

/// Rays of a frame, and bodies in it.
const COUNTERS: [Counter; 2] =
    [Counter { name: "samples", joined: Joined::Sum }, Counter { name: "bodies", joined: Joined::Sum }];

/// The row of the registry.
pub static ROW: Row = Row {
    name: "exact",
    about: "the same picture by closed form and root finding",
    role: Role::Judge,
    signals: &[],
    timed: false,
    parameters: None,
    gear: None,
    ladders: &[],
    details: &[],
    lamps: &[],
    configure: |_| Some(Arc::new(Exact)),
};

/// The generator that error is measured against; see the crate's data sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Exact;

/// What it fills: all.
const PLANES: &[PlaneKind] = &PlaneKind::ALL;

impl Generator for Exact {
    fn name(&self) -> &'static str {
        ROW.name
    }

    fn counters(&self) -> &'static [Counter] {
        &COUNTERS
    }

    fn planes(&self) -> &'static [PlaneKind] {
        PLANES
    }

    fn draws_colour(&self, stage: &Stage) -> bool {
        stage.is_colourful() || !stage.scenery.face_lists().is_empty()
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn GeneratorSession>, PrepareError> {
        Ok(Box::new(Session::new(stage, Fineness::USUAL)))
    }
}

/// The same with another quadrature of the lines: what `exact` itself is held to account by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExactWithin(pub Fineness);

impl Generator for ExactWithin {
    fn name(&self) -> &'static str {
        Exact.name()
    }

    fn counters(&self) -> &'static [Counter] {
        Exact.counters()
    }

    fn planes(&self) -> &'static [PlaneKind] {
        PLANES
    }

    fn draws_colour(&self, stage: &Stage) -> bool {
        Exact.draws_colour(stage)
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn GeneratorSession>, PrepareError> {
        Ok(Box::new(Session::new(stage, self.0)))
    }
}

struct Session {
    stage: Stage,
    ceilings: Ceilings,
    fineness: Fineness,
}

impl GeneratorSession for Session {
    /// The raster is that of `planes`; nothing can be probed.
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        _probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        self.check(frame, pose)?;
        let size = [planes.columns(), planes.lines()];
        let scene = self.scene((frame, pose), size);
        let (columns, samples) = self.columns(&scene, pose, 0..planes.columns(), size);
        for &kind in PLANES {
            fill(planes, kind, &columns, &scene);
        }
        let bodies = scene.standing().len() as u64;
        Ok(FrameCounts::of([("samples", samples), ("bodies", bodies)]))
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        stance::check(&self.stage, frame, pose)
    }

    fn omissions(&self) -> Vec<Omission> {
        let photographs = photographs_beside(&self.stage.landscape, ROW.name);
        let lists = self.stage.scenery.face_lists();
        let has_levels =
            lists.open_sea.is_some() && lists.lists.iter().any(|list| list.kind == FaceKind::Level);
        let levels = has_levels.then(|| Omission {
            block: ROW.name,
            what: "stern wakes (`stern_wake`)".into(),
            why: "a level of detail lies upon a flat sea, and this one has true waves (`sea.waves`)".into(),
            weight: Weight::NotModelled,
        });
        photographs.into_iter().chain(levels).collect()
    }

    /// All planes of the pixel: of its column alone, so that nobody waits for the picture. Then the faces at its middle, near to far.
    fn explain(&self, frame: u64, pose: &Pose, [column, line]: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        self.check(frame, pose)?;
        let scene = self.scene((frame, pose), self.size());
        let mut facts = self.planes_of(&scene, pose, column, PLANES).facts([0, line]);
        facts.extend(scene.faces().into_iter().flat_map(|faces| faces.facts([column, line])));
        Ok(facts)
    }
}

/// Single columns of pictures, for whoever does not need the rest.
pub struct Columns(Session);

impl Columns {
    /// Columns of the pictures of `stage`.
    pub fn new(stage: Stage) -> Self {
        Self(Session::new(stage, Fineness::USUAL))
    }

    /// Column `column` of frame `frame` as the raster of the stage has it: planes `kinds`, one pixel wide.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn column(
        &self,
        frame: u64,
        pose: &Pose,
        column: usize,
        kinds: &[PlaneKind],
    ) -> Result<Planes, FrameError> {
        self.0.planes_of_column(frame, pose, column, kinds)
    }
}

/// The ground below a sweep, whether or not it is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// Height of terrain and craters (m above the tangent plane).
    pub height: f64,
    /// Slopes of the terrain alone to the north and to the east.
    pub slopes: [f64; 2],
    /// Reflectivity of the terrain alone, 0..=1.
    pub reflectivity: f64,
    /// Tangent of the elevation under which the eye would see it, curvature included.
    pub elevation: f64,
}

impl Columns {
    /// The ground at each of `ranges` (m, above 0) from the eye of `pose` in `direction` (unit vector: north, east);
    /// `None` outside the problem area. What the signals of a sweep stand for.
    pub fn profile(&self, pose: &Pose, direction: [f64; 2], ranges: &[f64]) -> Vec<Option<ProfilePoint>> {
        let Stage { landscape, scenery, view } = &self.0.stage;
        let outlook = self.0.outlook(pose);
        let light = Light::new(landscape, &scenery.sun(pose.time), view.laws, pose.eye[2]);
        let point = |range: &f64| {
            let spot = outlook.spot_at(direction, *range)?;
            let height = outlook.height(&spot);
            let sight = |height: f64| (height - pose.eye[2]) / spot.range;
            let shaded = light.shaded(spot.slopes, direction, sight(spot.height));
            let albedo = intensity(light.albedo(spot.place));
            Some(ProfilePoint {
                height,
                slopes: spot.slopes,
                reflectivity: (albedo * shaded).clamp(0.0, 1.0),
                elevation: sight(height - outlook.drop(spot.range)),
            })
        };
        ranges.iter().map(point).collect()
    }
}

impl Session {
    fn new(stage: Stage, fineness: Fineness) -> Self {
        let ceilings = Ceilings::new(&stage.landscape);
        Self { stage, ceilings, fineness }
    }

    fn outlook(&self, pose: &Pose) -> Outlook<'_> {
        let Stage { landscape, view, .. } = &self.stage;
        // Where no sweep can be drawn none has a first sample: ground is seen from under the eye on.
        let [first, end] = view.ranges;
        let ranges = [if stance::is_swept(landscape, view.field, pose) { first } else { 0.0 }, end];
        Outlook::new(landscape, &self.ceilings, pose.eye, view.laws.curvature, ranges, view.levels)
    }

    /// The scene of a frame for a picture of `size` (columns, lines).
    fn scene(&self, (frame, pose): (u64, &Pose), size: [usize; 2]) -> Scene<'_> {
        let Stage { landscape, scenery, view } = &self.stage;
        let reach = view.shadows.map(|fineness| fineness.reach.unwrap_or(f64::INFINITY));
        let scene = Scene::new(landscape, scenery, self.outlook(pose), view.laws, reach, pose);
        let faces = FaceLayer::new(&self.stage, &scene, (frame, pose), Screen::new(size, view.field));
        scene.with_faces(faces)
    }

    /// Columns and lines of the raster of the stage.
    fn size(&self) -> [usize; 2] {
        [self.stage.view.columns as usize, self.stage.view.lines as usize]
    }

    /// Planes of one column of the raster of the stage.
    fn planes_of_column(
        &self,
        frame: u64,
        pose: &Pose,
        column: usize,
        kinds: &[PlaneKind],
    ) -> Result<Planes, FrameError> {
        self.check(frame, pose)?;
        let scene = self.scene((frame, pose), self.size());
        Ok(self.planes_of(&scene, pose, column, kinds))
    }

    /// The same of a scene.
    fn planes_of(&self, scene: &Scene, pose: &Pose, column: usize, kinds: &[PlaneKind]) -> Planes {
        let size = self.size();
        let (pixels, _) = self.columns(scene, pose, column..column + 1, size);
        let mut planes = Planes::new(1, size[1], kinds);
        kinds.iter().for_each(|&kind| fill(&mut planes, kind, &pixels, scene));
        planes
    }

    /// Some columns of a picture of `size` (columns, lines) with faces and all effects, and the rays that they took.
    fn columns(
        &self,
        scene: &Scene,
        pose: &Pose,
        columns: Range<usize>,
        size: [usize; 2],
    ) -> (Vec<Vec<Pixel>>, u64) {
        let effects = self.stage.scenery.effects(pose.time);
        let layer = Layer::new(scene, &effects, size, self.stage.view.field);
        let screen = Screen::new(size, self.stage.view.field);
        let draw = |column| {
            let (mut pixels, mut rays) = self.column(scene, column, size);
            if scene.has_open_sea() {
                rays += water_area::area_means(scene, &screen, column, &mut pixels);
            }
            let faces = scene.faces().map_or(0, |faces| faces.over(scene, column, &mut pixels));
            let over = layer.as_ref().map_or(0, |layer| layer.over(column, &mut pixels));
            (pixels, rays + faces + over)
        };
        let first = columns.start;
        let drawn: Vec<_> = columns.into_par_iter().map(draw).collect();
        let (mut columns, rays): (Vec<_>, Vec<u64>) = drawn.into_iter().unzip();
        let beam = layer.as_ref().map_or(0, |layer| layer.beam(first, &mut columns));
        (columns, rays.into_iter().sum::<u64>() + beam)
    }

    /// Pixels of a column of a picture of `columns` x `lines`, top line first, and the rays that they took.
    fn column(&self, scene: &Scene, column: usize, [columns, lines]: [usize; 2]) -> (Vec<Pixel>, u64) {
        let (field, rule) = (self.stage.view.field, self.stage.view.laws.pixel_rule);
        let frame = Frame { scene, half_height: field.tan_half_height, lines, fineness: self.fineness };
        let x = field.tan_half_width * (2.0 * column as f64 + 1.0 - columns as f64) / columns as f64;
        Column::new(frame, x).draw(rule)
    }
}

fn fill(planes: &mut Planes, kind: PlaneKind, columns: &[Vec<Pixel>], scene: &Scene) {
    let Some(values) = planes.get_mut(kind) else { return };
    let value = |pixel: &Pixel| match kind {
        PlaneKind::Intensity => intensity(pixel.light),
        PlaneKind::Red => pixel.light[0],
        PlaneKind::Green => pixel.light[1],
        PlaneKind::Blue => pixel.light[2],
        PlaneKind::Distance => scene.distance(pixel.seen.range, pixel.seen.height),
        _ => pixel.seen.value(kind),
    };
    for (line, row) in values.chunks_mut(columns.len().max(1)).enumerate() {
        for (target, column) in row.iter_mut().zip(columns) {
            *target = value(&column[line]) as f32;
        }
    }
}
