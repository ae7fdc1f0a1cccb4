//! The generator made ready for a stage.

use generator::{
    Detailed, FaceScene, Fact, FrameCounts, FrameError, Label, Omission, Planes, PrepareError,
    Session as GeneratorSession, Stage, Weight, check_free_eye, face_lists_beside, photographs_beside,
};
use glam::DVec3;
use lod_tiles::{State, Tile};
use raster::Screen;
use scenario::Pose;
use scene_sampler::{
    Camera, Field, Fields, Filled, Scene, Shown, expect_course, judged_faces, record_pixel_rows,
    small_craters,
};
use serde_json::Value;
use signal::{Probe, Wire};

use crate::ground::{self, Mesh};
use crate::name::NAME;
use crate::parameters::{Clock, GroundLight, Parameters, Show};
use crate::place::{Seen, distance};
use crate::prepared::Prepared;
use crate::signals::{COLUMN, SIGNALS, Samples};
use crate::sounding::sounding;
use crate::time::{Hardware, SECOND, Work, frame_time};
use crate::{signals, slots, wires};

/// The generator made ready for one stage.
pub(crate) struct Session {
    pub(crate) prepared: Prepared,
    hardware: Hardware,
    screen: Screen,
    /// What the viewer does in each field, under a clock of real time.
    fields: Fields,
}

/// Levels of a frame, beside those of the frame that was begun before it.
pub(crate) struct Looked {
    camera: Camera,
    /// Eye of the frame: north, east, up (m).
    pub eye: DVec3,
    /// Levels and fractions of its tiles.
    pub state: State,
    /// Those of the frame before; none where there is none.
    before: Option<State>,
}

impl Looked {
    /// Tiles that take another level: number, level before, level now.
    pub fn changes(&self) -> impl Iterator<Item = (usize, usize, usize)> {
        self.before.iter().flat_map(|before| self.state.changes(before))
    }
}

/// A frame ready to be drawn.
pub(crate) struct Gathered {
    scene: Scene,
    state: State,
    mesh: Mesh,
}

impl Session {
    /// Makes ready for `stage`: posts, levels, slopes.
    ///
    /// # Errors
    /// If its raster or its ground is too large, ranges do not rise, tiles have no slots, or a clock of real time lacks the course of the mission.
    pub fn new(stage: Stage, run: Parameters, hardware: Hardware) -> Result<Self, PrepareError> {
        let screen = scene_sampler::screen(&stage, NAME)?;
        if run.clock == Clock::RealTime {
            expect_course(&stage, NAME, "a clock of real time")?;
        }
        let prepared = Prepared::new(stage, run, &hardware)?;
        Ok(Self { prepared, hardware, screen, fields: Fields::default() })
    }

    /// Posts, levels and slopes, which all frames share.
    pub fn prepared(&self) -> &Prepared {
        &self.prepared
    }

    /// What the viewer runs on.
    pub fn hardware(&self) -> &Hardware {
        &self.hardware
    }

    /// Name of a tile in records, as `explain` tells its column and row.
    pub fn tile_name(&self, number: usize) -> String {
        let Tile { column, row } = self.tile(number);
        format!("tile.{column}.{row}")
    }

    /// Distance (m) of a tile's middle from an eye.
    pub fn tile_distance(&self, number: usize, eye: DVec3) -> f64 {
        distance(&self.prepared.posts.terrain, self.tile(number), eye)
    }

    /// South, west, north and east border (m) of a tile on the map.
    pub fn tile_borders(&self, number: usize) -> [f64; 4] {
        let terrain = &self.prepared.posts.terrain;
        let cells = terrain.cells(0);
        let [[west, south], [east, north]] =
            [[0, 0], [cells, cells]].map(|at| terrain.place(self.tile(number), 0, at));
        [south, west, north, east]
    }

    fn tile(&self, number: usize) -> Tile {
        let columns = self.prepared.posts.terrain.counts()[0];
        Tile { column: number % columns, row: number / columns }
    }

    /// Levels of frame `frame` from `pose`, and those of the frame that the viewer has begun before it, as far as the stage knows its pose.
    ///
    /// # Errors
    /// If a pose cannot be drawn.
    pub fn look(&self, frame: u64, pose: &Pose) -> Result<Looked, FrameError> {
        let before = match self.prepared.run.clock {
            Clock::Stepped => frame.checked_sub(1),
            Clock::RealTime => self.field(frame)?.before,
        };
        self.look_after(frame, pose, before)
    }

    fn look_after(&self, frame: u64, pose: &Pose, before: Option<u64>) -> Result<Looked, FrameError> {
        self.check(frame, pose)?;
        let camera = Camera::new(pose, &self.prepared.stage.view);
        let eye = camera.eye;
        let course = self.prepared.stage.scenery.course();
        let earlier = before.and_then(|frame| course.get(frame as usize));
        let before = earlier.map(|pose| ground::state(&self.prepared, DVec3::from_array(pose.eye)));
        Ok(Looked { camera, eye, state: ground::state(&self.prepared, eye), before })
    }

    /// The work of a frame.
    pub fn work(&self, looked: &Looked) -> Work {
        let Prepared { posts, run, slots, stage, .. } = &self.prepared;
        let words = slots::words(&posts.terrain, run, *slots);
        let tiles = ground::in_view(&self.prepared, &looked.camera);
        let surface = ground::surface(&self.prepared, &looked.state);
        Work::of(&surface, looked.before.as_ref(), &tiles, words).captured(&stage.view, &self.hardware)
    }

    /// What the viewer does in field `number` of a mission under a clock of real time: a frame takes as many fields as it needs, and the next one
    /// begins with the pose of the time that was reached.
    ///
    /// # Errors
    /// If a frame before cannot be drawn.
    pub fn field(&self, number: u64) -> Result<Field, FrameError> {
        let Stage { view, scenery, .. } = &self.prepared.stage;
        let ticks = view.update.period_ticks(SECOND);
        self.fields.field(number, |frame, before| {
            let looked = self.look_after(frame, &scene_sampler::pose(scenery.course(), frame)?, before)?;
            Ok(frame_time(&self.work(&looked).tasks(&self.hardware)).div_ceil(ticks))
        })
    }

    /// What the picture of frame `frame` shows: itself from `pose`, or under a clock of real time the last picture that was complete.
    fn shown(&self, frame: u64, pose: &Pose) -> Result<Shown, FrameError> {
        match self.prepared.run.clock {
            Clock::Stepped => Ok(Shown::own(frame, pose)),
            Clock::RealTime => Shown::of(self.field(frame)?, self.prepared.stage.scenery.course()),
        }
    }

    /// Records the rows that `probe` wants of a picture with these surfaces.
    fn record(&self, frame: u64, gathered: &Gathered, surfaces: &[(f32, Label)], probe: &mut Probe) {
        let view = &self.prepared.stage.view;
        let (camera, terrain) = (&gathered.scene.camera, &self.prepared.posts.terrain);
        let samples = Samples::of(ground::surface(&self.prepared, &gathered.state));
        let sample = |pixel: [usize; 2]| {
            let (q, label) = surfaces[pixel[1] * view.columns as usize + pixel[0]];
            let is_ground = q > 0.0 && label == Label::Terrain;
            is_ground.then(|| {
                let tile = Seen::new(camera, pixel, f64::from(q)).tile(terrain);
                samples.tile(tile, distance(terrain, tile, camera.eye))
            })
        };
        record_pixel_rows((frame, view), SIGNALS.iter(), COLUMN, probe, sample, signals::value);
    }

    fn gather(&self, frame: u64, pose: &Pose) -> Result<Gathered, FrameError> {
        self.gather_held(frame, pose, pose)
    }

    /// A frame from `pose` with the levels that the ground has for an eye at `levels`.
    pub(crate) fn gather_held(&self, frame: u64, pose: &Pose, levels: &Pose) -> Result<Gathered, FrameError> {
        self.check(frame, pose)?;
        self.check(frame, levels)?;
        let camera = Camera::new(pose, &self.prepared.stage.view);
        let state = ground::state(&self.prepared, DVec3::from_array(levels.eye));
        let surface = ground::surface(&self.prepared, &state);
        let mesh = ground::mesh(&surface, &ground::in_view(&self.prepared, &camera), &camera);
        let faces = ground::faces(&self.prepared, &surface, &mesh, &camera, pose.time);
        let run = &self.prepared.run.sampling;
        let stage = self.prepared.seen(&camera);
        let scene = Scene::new(&stage, run, &self.screen, camera, faces, (frame, pose.time))?;
        Ok(Gathered { scene, state, mesh })
    }

    /// Draws a frame that is ready, as the picture of `shown`; what it took, and the nearest surface of each pixel.
    pub(crate) fn draw(
        &self,
        shown: &Shown,
        gathered: &Gathered,
        planes: &mut Planes,
    ) -> Result<(FrameCounts, Vec<(f32, Label)>), FrameError> {
        let (scene, run) = (&gathered.scene, &self.prepared.run.sampling);
        let view = &self.prepared.stage.view;
        let picture = scene_sampler::draw_untimed(scene, &self.screen, run, (view, shown.frame), planes)?;
        if shown.is_dark {
            planes.fill_sky();
        }
        let surface = ground::surface(&self.prepared, &gathered.state);
        if self.prepared.run.show == Show::Wires && !shown.is_dark {
            wires::draw(&gathered.mesh, &surface, &scene.camera, &picture.surfaces, planes);
        }
        let counts = FrameCounts::of([
            ("tiles", gathered.mesh.tile_count()),
            ("visits", gathered.state.visits()),
            ("vertices", gathered.mesh.vertices.len() as u64),
            ("morphing", gathered.mesh.morphing),
            ("ground_triangles", gathered.mesh.triangles.len() as u64),
            ("cracked_edges", surface.cracked_edges()),
            ("repeated", u64::from(!shown.is_new)),
            ("faces", scene.faces.work.faces),
            ("triangles", scene.faces.work.triangles),
            ("entries", picture.entries),
            ("lights", scene.lights.points.len() as u64),
            ("lost_surfaces", picture.losses.translucent),
            ("lost_lights", picture.losses.lights),
        ]);
        Ok((counts, picture.surfaces))
    }

    /// The pixel of a frame with what it shows of the ground.
    fn filled<T>(
        &self,
        frame: u64,
        gathered: &Gathered,
        pixel: [usize; 2],
        use_it: impl FnOnce(&Filled<'_>) -> T,
    ) -> Result<T, FrameError> {
        let run = &self.prepared.run.sampling;
        scene_sampler::with_pixel(&gathered.scene, &self.screen, run, (frame, pixel), use_it)
    }
}

impl GeneratorSession for Session {
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        let shown = self.shown(frame, pose)?;
        let gathered = self.gather(shown.frame, &shown.pose)?;
        let (counts, surfaces) = self.draw(&shown, &gathered, planes)?;
        self.record(frame, &gathered, &surfaces, probe);
        Ok(counts)
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        check_free_eye(&self.prepared.stage.landscape, frame, pose)?;
        let [north, east, up] = pose.eye;
        let spacing = self.prepared.posts.axes[0].step;
        match ground::finest_at(&self.prepared, [east, north]).filter(|height| *height >= up) {
            Some(height) => Err(FrameError::Refused {
                frame,
                reason: format!(
                    "the eye is {:.3} m under the ground between posts {spacing:.1} m apart; {}",
                    height - up,
                    match self.prepared.stage.landscape.posts() {
                        // A database has its own posts, and vehicles stand on the bank.
                        Some(_) =>
                            "begin elsewhere, or raise vehicle.eye_height_m: these are the posts of landscape.database",
                        None => "ask for a smaller lod.spacing_m, or lift the eye",
                    }
                ),
            }),
            None => Ok(()),
        }
    }

    fn wires(&self) -> Vec<Wire> {
        let Prepared { stage, table, posts, .. } = &self.prepared;
        let cells = posts.terrain.cells(0);
        signals::wires(&stage.view, table.levels.count(), 2 * cells * cells)
    }

    fn omissions(&self) -> Vec<Omission> {
        let mut omissions = scene_sampler::omissions(&self.prepared.stage, NAME);
        omissions.extend(photographs_beside(&self.prepared.stage.landscape, NAME));
        omissions.extend(face_lists_beside(&self.prepared.stage.scenery, NAME));
        let landscape = &self.prepared.stage.landscape;
        // Posts of a terrain database have what its export made of them.
        if landscape.posts().is_none() {
            let spacing = self.prepared.posts.spacing();
            omissions.extend(small_craters(landscape, spacing, NAME, "ask for a smaller lod.spacing_m"));
        }
        let has_albedo = landscape.posts().is_some_and(|posts| posts.albedo.is_some());
        // A scenario that has a map of albedo over the database says what is drawn.
        if has_albedo && landscape.albedo_map().is_none() && self.prepared.run.light != GroundLight::Stored {
            omissions.push(Omission {
                block: NAME,
                what: "the albedo of the terrain database".into(),
                why: "the ground has that of the landscape; lod.light = \"stored\" draws it".into(),
                weight: Weight::NotModelled,
            });
        }
        omissions.extend(self.prepared.table.short_zone.map(|(level, zone, tile)| Omission {
            block: NAME,
            what: format!("continuity of edges in time at level {level}"),
            why: format!("its morph zone of {zone:.0} m is shorter than a tile of {tile:.0} m; widen lod.ranges_m or raise lod.morph_percent"),
            weight: Weight::NotModelled,
        }));
        omissions
    }

    /// Tile, level, fraction, heights before and after morphing of the ground in a pixel; then the stack of every sampling point.
    fn explain(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        let Shown { frame, pose, .. } = self.shown(frame, pose)?;
        let gathered = self.gather(frame, &pose)?;
        let surface = ground::surface(&self.prepared, &gathered.state);
        let camera = &gathered.scene.camera;
        self.filled(frame, &gathered, pixel, |filled| {
            let entries = format!("{}: {} entries", filled.number(), filled.entries());
            let ground = filled.nearness().map(|q| Seen::new(camera, pixel, q));
            let mut facts =
                ground.map_or(Vec::new(), |seen| seen.facts(&self.prepared, &surface, camera.eye));
            facts.push(Fact::new("levels", self.prepared.table.told()));
            facts.push(Fact::new("sub-area", entries));
            facts.extend(filled.facts());
            facts
        })
    }

    fn sampling_point(
        &self,
        frame: u64,
        pose: &Pose,
        pixel: [usize; 2],
        number: usize,
    ) -> Result<Option<Value>, FrameError> {
        let Shown { frame, pose, .. } = self.shown(frame, pose)?;
        let gathered = self.gather(frame, &pose)?;
        self.filled(frame, &gathered, pixel, |filled| filled.document(number, &[]))
    }

    fn sounding(&self, frame: u64, pose: &Pose, levels: [&Pose; 2]) -> Result<Option<f64>, FrameError> {
        self.check(frame, pose)?;
        levels.into_iter().try_for_each(|pose| self.check(frame, pose))?;
        let camera = Camera::new(pose, &self.prepared.stage.view);
        let state =
            ground::at_change(&self.prepared, camera.eye, levels.map(|pose| DVec3::from_array(pose.eye)));
        Ok(Some(sounding(&self.prepared, &ground::surface(&self.prepared, &state), &camera)))
    }

    fn detailed(&self) -> Option<&dyn Detailed> {
        Some(self)
    }

    fn faces(&self, frame: u64, pose: &Pose) -> Result<Option<FaceScene>, FrameError> {
        let Shown { frame, pose, .. } = self.shown(frame, pose)?;
        Ok(Some(judged_faces(self.gather(frame, &pose)?.scene, &self.prepared.run.sampling)))
    }
}
