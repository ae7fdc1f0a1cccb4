//! The generator made ready for a stage.

use std::sync::{Mutex, PoisonError};

use generator::{
    BeamEntry, FaceScene, Fact, FrameCounts, FrameError, Omission, PlaneKind, Planes, PrepareError,
    Session as GeneratorSession, Stage, check_eye, face_lists_beside, photographs_beside,
};
use ground_mesh::{GroundMesh, Rings};
use raster::{Lists, Screen};
use scenario::Pose;
use scene_sampler::{Camera, Fields, Filled, Scene, expect_course, judged_faces};
use serde_json::Value;
use signal::{Probe, Wire};
use translucency::Losses;

use crate::drawn::Drawn;
use crate::hardware::Hardware;
use crate::overload::LostEntry;
use crate::parameters::Parameters;
use crate::row::NAME;
use crate::rows::{self, Rows};
use crate::store::Gathered;
use crate::{ground, map, overload, store};

/// How much the limits of the stacks can change a colour of a sampling point, in millionths of white, rounded up.
fn largest_loss_ppm(losses: &Losses) -> u64 {
    (1e6 * losses.bound.into_iter().fold(0.0, f64::max)).ceil() as u64
}

/// The generator made ready for one stage.
pub(crate) struct Session {
    pub stage: Stage,
    pub screen: Screen,
    pub parameters: Parameters,
    pub hardware: Hardware,
    pub fields: Fields,
    /// Rings of the ground in all frames.
    rings: Rings,
    /// Buffers of meshes that no frame uses at the moment.
    meshes: Mutex<Vec<GroundMesh>>,
}

impl Session {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// If its raster is too large.
    pub fn new(stage: Stage, parameters: Parameters, hardware: Hardware) -> Result<Self, PrepareError> {
        let screen = scene_sampler::screen(&stage, NAME)?;
        if parameters.overload.shows_earlier_frames() {
            expect_course(&stage, NAME, &format!("overload `{}`", parameters.overload.word()))?;
        }
        let rings = ground::rings(&stage, &parameters);
        let (fields, meshes) = (Fields::default(), Mutex::default());
        Ok(Self { stage, screen, parameters, hardware, fields, rings, meshes })
    }

    /// Gathers frame `frame` from `pose`.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn gather(&self, frame: u64, pose: &Pose) -> Result<Gathered, FrameError> {
        let mut scene = self.scene(frame, pose)?;
        let lost_points = store::limit(&mut scene.lights, self.hardware.memory.points, &self.screen);
        Ok(Gathered { scene, lost_points })
    }

    fn remembers_frames(&self) -> bool {
        self.parameters.overload.shows_earlier_frames()
    }

    /// Draws a scene as if everything were in time, and reads its sub-areas off if `is_read`. The beam's spots are not yet in it.
    ///
    /// # Errors
    /// If a light is no number.
    pub fn drawn(&self, scene: &Scene, frame: u64, is_read: bool) -> Result<Drawn, FrameError> {
        let (lists, lost) = self.lists(scene);
        let Self { stage, screen, parameters, hardware, .. } = self;
        let (run, view) = (&parameters.sampling, &stage.view);
        let picture = scene_sampler::draw(scene, &lists, screen, run, hardware.beam, view, frame, is_read)?;
        Ok(Drawn { picture, lost })
    }
}

impl Session {
    /// A scene's lists within the limits of the list memory, and what found no place in them.
    fn lists(&self, scene: &Scene) -> (Lists, Vec<LostEntry>) {
        overload::lists(scene, &self.screen, self.parameters.overload, &self.hardware.memory)
    }

    /// Gathers frame `frame` from `pose` without the limits of the light point store.
    fn scene(&self, frame: u64, pose: &Pose) -> Result<Scene, FrameError> {
        self.check(frame, pose)?;
        let camera = Camera::new(pose, &self.stage.view);
        let mut meshes = self.meshes.lock().unwrap_or_else(PoisonError::into_inner);
        let mut mesh = meshes.pop().unwrap_or_default();
        drop(meshes);
        ground::fill(&mut mesh, &self.stage, self.rings, &camera)
            .map_err(|error| FrameError::Refused { frame, reason: error.to_string() })?;
        let sun = self.stage.scenery.sun(pose.time);
        let ground = ground::faces(&self.stage, &mesh, &camera, &sun);
        let run = &self.parameters.sampling;
        let scene = Scene::new(&self.stage, run, &self.screen, camera, ground, (frame, pose.time));
        self.meshes.lock().unwrap_or_else(PoisonError::into_inner).push(mesh);
        scene
    }

    /// What a frame took and lost, with its late sub-areas, and whether its picture shows a new frame.
    fn counted(&self, gathered: &Gathered, drawn: &Drawn, late: u64, is_new: bool) -> FrameCounts {
        let Drawn { picture, lost } = drawn;
        let scene = &gathered.scene;
        let calligraphic = scene.lights.points.iter().filter(|point| point.is_calligraphic).count() as u64;
        FrameCounts::of([
            ("ground_cells", u64::from(self.rings.cells)),
            ("faces", scene.faces.work.faces),
            ("triangles", scene.faces.work.triangles),
            ("entries", picture.entries),
            ("lights", scene.lights.points.len() as u64),
            ("calligraphic", calligraphic),
            ("lost_surfaces", picture.losses.translucent),
            ("lost_lights", picture.losses.lights),
            ("lost_entries", lost.len() as u64),
            ("lost_points", gathered.lost_points.len() as u64),
            ("beam_dropped", picture.beam.dropped.len() as u64),
            ("late_sub_areas", late),
            ("repeated", u64::from(!is_new)),
            ("loss_bound_ppm", largest_loss_ppm(&picture.losses)),
        ])
    }
}

impl GeneratorSession for Session {
    /// The raster is that of `planes`; a sweep of `probe` is a row of sub-areas.
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        let shown = self.shown(frame, pose)?;
        let gathered = self.gather(shown.frame, &shown.pose)?;
        let scene = &gathered.scene;
        let wants_map = planes.get(PlaneKind::Overload).is_some();
        let is_read = probe.is_on() || wants_map || self.remembers_frames();
        let mut drawn = self.drawn(scene, shown.frame, is_read)?;
        let picture = &mut drawn.picture;
        let late = self.show_late(picture, scene, shown.frame)?;
        let Self { screen, hardware, parameters, .. } = self;
        picture.beam.draw(&scene.lights.points, &parameters.sampling, screen, &mut picture.colours);
        scene_sampler::fill(picture, scene, planes);
        if shown.is_dark {
            planes.fill_sky();
        }
        if let Some(plane) = planes.get_mut(PlaneKind::Overload) {
            map::fill(plane, &drawn, &gathered, screen, &self.late(&drawn.picture.readings));
        }
        Rows { screen, camera: &scene.camera, hardware, readings: &drawn.picture.readings }
            .record(frame, probe);
        Ok(self.counted(&gathered, &drawn, late, shown.is_new))
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        check_eye(&self.stage.landscape, frame, pose)
    }

    fn omissions(&self) -> Vec<Omission> {
        let mut omissions = scene_sampler::omissions(&self.stage, NAME);
        omissions.extend(photographs_beside(&self.stage.landscape, NAME));
        omissions.extend(face_lists_beside(&self.stage.scenery, NAME));
        let finest = self.rings.finest_step();
        let remedy = "ask for more sampled.ground_cells";
        omissions.extend(scene_sampler::small_craters(&self.stage.landscape, finest, NAME, remedy));
        omissions
    }

    fn wires(&self) -> Vec<Wire> {
        rows::wires(&self.stage, &self.screen, &self.parameters, &self.hardware)
    }

    /// The ground mesh of the frame with its error; lists and stacks of every sampling point of the pixel.
    fn explain(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        let scene = self.gather(frame, pose)?.scene;
        let refused = |reason: String| FrameError::Refused { frame, reason };
        let (lists, lost) = self.lists(&scene);
        let filled = Filled::new(&scene, &lists, &self.screen, &self.parameters.sampling, pixel)
            .map_err(|error| refused(error.to_string()))?;
        let lost = lost.iter().filter(|lost| lost.sub_area as usize == filled.number()).count();
        let without = if lost > 0 { format!(", {lost} without a place") } else { String::new() };
        let ground = ground::told(&self.stage, self.rings, &scene.camera);
        let sub_area = format!("{}: {} entries{without}", filled.number(), filled.entries());
        let mut facts = vec![
            Fact::new("ground mesh", ground.map_err(|error| refused(error.to_string()))?),
            Fact::new("sub-area", sub_area),
        ];
        facts.extend(filled.facts());
        Ok(facts)
    }

    fn sampling_point(
        &self,
        frame: u64,
        pose: &Pose,
        pixel: [usize; 2],
        number: usize,
    ) -> Result<Option<Value>, FrameError> {
        let scene = self.gather(frame, pose)?.scene;
        let (lists, lost) = self.lists(&scene);
        let filled = Filled::new(&scene, &lists, &self.screen, &self.parameters.sampling, pixel)
            .map_err(|error| FrameError::Refused { frame, reason: error.to_string() })?;
        let of_area = lost.iter().filter(|lost| lost.sub_area as usize == filled.number());
        let lost: Vec<u32> = of_area.map(|lost| lost.triangle).collect();
        Ok(filled.document(number, &lost))
    }

    fn faces(&self, frame: u64, pose: &Pose) -> Result<Option<FaceScene>, FrameError> {
        Ok(Some(judged_faces(self.scene(frame, pose)?, &self.parameters.sampling)))
    }

    fn beam_list(&self, frame: u64, pose: &Pose) -> Result<Option<Vec<BeamEntry>>, FrameError> {
        let Gathered { scene, .. } = self.gather(frame, pose)?;
        let drawn = self.drawn(&scene, frame, false)?;
        Ok(Some(drawn.picture.beam.entries(&scene.lights.points)))
    }
}
