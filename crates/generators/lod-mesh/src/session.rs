//! The generator made ready for a stage.

use generator::{
    Detailed, FaceScene, Fact, FrameCounts, FrameError, Omission, Planes, PrepareError,
    Session as GeneratorSession, Stage, Weight, check_free_eye, face_lists_beside, photographs_beside,
};
use glam::DVec3;
use lod_tiles::State;
use raster::Screen;
use scenario::Pose;
use scene_sampler::{Camera, Filled, Scene, judged_faces};
use serde_json::Value;
use signal::Probe;

use crate::ground::{self, Mesh};
use crate::name::NAME;
use crate::parameters::Parameters;
use crate::place::Seen;
use crate::prepared::Prepared;
use crate::sounding::sounding;

/// The generator made ready for one stage.
pub(crate) struct Session {
    pub(crate) prepared: Prepared,
    screen: Screen,
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
    /// If its raster or its ground is too large, or ranges do not rise.
    pub fn new(stage: Stage, run: Parameters) -> Result<Self, PrepareError> {
        let screen = scene_sampler::screen(&stage, NAME)?;
        Ok(Self { prepared: Prepared::new(stage, run)?, screen })
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
        let mesh = ground::mesh(&self.prepared, &surface, &camera);
        let faces = ground::faces(&self.prepared, &surface, &mesh, &camera, pose.time);
        let run = &self.prepared.run.sampling;
        let scene = Scene::new(&self.prepared.stage, run, &self.screen, camera, faces, (frame, pose.time))?;
        Ok(Gathered { scene, state, mesh })
    }

    /// Draws a frame that is ready.
    pub(crate) fn draw(
        &self,
        frame: u64,
        gathered: &Gathered,
        planes: &mut Planes,
    ) -> Result<FrameCounts, FrameError> {
        let (scene, run) = (&gathered.scene, &self.prepared.run.sampling);
        let view = &self.prepared.stage.view;
        let picture = scene_sampler::draw_untimed(scene, &self.screen, run, (view, frame), planes)?;
        Ok(FrameCounts::of([
            ("tiles", gathered.mesh.tile_count()),
            ("visits", gathered.state.visits()),
            ("vertices", gathered.mesh.vertices.len() as u64),
            ("morphing", gathered.mesh.morphing),
            ("ground_triangles", gathered.mesh.triangles.len() as u64),
            ("faces", scene.faces.work.faces),
            ("triangles", scene.faces.work.triangles),
            ("entries", picture.entries),
            ("lights", scene.lights.points.len() as u64),
            ("lost_surfaces", picture.losses.translucent),
            ("lost_lights", picture.losses.lights),
        ]))
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
        _: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        self.draw(frame, &self.gather(frame, pose)?, planes)
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

    fn omissions(&self) -> Vec<Omission> {
        let mut omissions = scene_sampler::omissions(&self.prepared.stage, NAME);
        omissions.extend(photographs_beside(&self.prepared.stage.landscape, NAME));
        omissions.extend(face_lists_beside(&self.prepared.stage.scenery, NAME));
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
        let gathered = self.gather(frame, pose)?;
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
        let gathered = self.gather(frame, pose)?;
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
        Ok(Some(judged_faces(self.gather(frame, pose)?.scene, &self.prepared.run.sampling)))
    }
}
