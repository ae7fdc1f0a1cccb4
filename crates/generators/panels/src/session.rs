//! The generator made ready for a stage.

use generator::{
    FaceScene, Fact, FrameCounts, FrameError, Label, Omission, PlaneKind, Planes, PrepareError,
    Session as GeneratorSession, Stage, Weight, check_free_eye, face_lists_beside,
};
use glam::DVec3;
use quantities::degrees;
use raster::Screen;
use scenario::{Pose, View};
use scene_sampler::{Camera, Filled, Scene, judged_faces};
use serde_json::Value;
use signal::{Probe, Wire};

use crate::coarser::Choice;
use crate::frame_ground::{Own, ground};
use crate::name::NAME;
use crate::parameters::Parameters;
use crate::place::Seen;
use crate::prepared::Prepared;
use crate::signals::{self, Sample};

/// Angle (degrees) between two suns from which a drape is said to be lit by the wrong one. Chosen by the specification.
const SUNS_APART_DEG: f64 = 5.0;

/// The generator made ready for one stage.
pub(crate) struct Session {
    prepared: Prepared,
    own: Own,
    screen: Screen,
}

impl Session {
    /// Makes ready for `stage`: posts, panels, photographs.
    ///
    /// # Errors
    /// If its raster or its ground is too large, or its photographs cannot be laid over it.
    pub fn new(stage: Stage, run: Parameters) -> Result<Self, PrepareError> {
        let screen = scene_sampler::screen(&stage, NAME)?;
        let prepared = Prepared::new(stage, run)?;
        Ok(Self { own: Own::new(&prepared), prepared, screen })
    }

    /// The scene of a frame, and how many panels its ground has.
    fn scene(&self, frame: u64, pose: &Pose) -> Result<(Scene, usize), FrameError> {
        self.check(frame, pose)?;
        let Prepared { stage, run, mesh, coarser, .. } = &self.prepared;
        let camera = Camera::new(pose, &stage.view);
        let choice = coarser.as_ref().map(|bounds| Choice::new(mesh, bounds, &camera, run.coarser_px));
        self.scene_of((frame, pose), camera, choice.as_ref())
    }

    /// The same with the panels of `choice`, or all of them.
    fn scene_of(
        &self,
        (frame, pose): (u64, &Pose),
        camera: Camera,
        choice: Option<&Choice>,
    ) -> Result<(Scene, usize), FrameError> {
        let ground = ground(&self.prepared, &self.own, choice, &camera, pose.time);
        let panels = ground.triangles.len();
        let run = &self.prepared.run.sampling;
        let scene = Scene::new(&self.prepared.stage, run, &self.screen, camera, ground, (frame, pose.time))?;
        Ok((scene, panels))
    }

    /// The pixel of a frame with what it shows of the ground.
    fn filled<T>(
        &self,
        frame: u64,
        scene: &Scene,
        pixel: [usize; 2],
        use_it: impl FnOnce(&Filled<'_>) -> T,
    ) -> Result<T, FrameError> {
        let run = &self.prepared.run.sampling;
        scene_sampler::with_pixel(scene, &self.screen, run, (frame, pixel), use_it)
    }

    /// The largest angle (degrees) between the scenario's sun as the mission begins and that of a photograph.
    fn suns_apart(&self) -> f64 {
        let sun = DVec3::from_array(self.prepared.stage.scenery.sun(0.0).direction());
        let drape = &self.prepared.drape;
        let apart = |number: usize| {
            let other = drape.sun_of(number).ok()?;
            Some(degrees(libm::acos(sun.dot(other).clamp(-1.0, 1.0))))
        };
        (0..drape.photographs().len()).filter_map(apart).fold(0.0, f64::max)
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
        let (scene, panels) = self.scene(frame, pose)?;
        let run = &self.prepared.run.sampling;
        let view = &self.prepared.stage.view;
        let picture = scene_sampler::draw_untimed(&scene, &self.screen, run, (view, frame), planes)?;
        // What a pixel shows of the ground.
        let ground = |pixel: [usize; 2]| {
            let (q, label) = picture.surfaces[pixel[1] * view.columns as usize + pixel[0]];
            let is_ground = q > 0.0 && label == Label::Terrain;
            is_ground.then(|| Seen::new(&scene.camera, pixel, f64::from(q)))
        };
        signals::record((frame, view), false, probe, |pixel| {
            ground(pixel).map_or(Sample::NONE, |seen| seen.sample(&self.prepared, &scene.camera))
        });
        if let Some(labels) = planes.get_mut(PlaneKind::Label) {
            let columns = view.columns as usize;
            for (at, label) in labels.iter_mut().enumerate() {
                if let Some(seen) = ground([at % columns, at / columns]) {
                    *label = f32::from(seen.label(&self.prepared).code());
                }
            }
        }
        Ok(FrameCounts::of([
            ("panels", panels as u64),
            ("faces", scene.faces.work.faces),
            ("triangles", scene.faces.work.triangles),
            ("entries", picture.entries),
            ("lights", scene.lights.points.len() as u64),
            ("lost_surfaces", picture.losses.translucent),
            ("lost_lights", picture.losses.lights),
            ("unseen_panels", self.prepared.unseen_panels()),
        ]))
    }

    fn wires(&self) -> Vec<Wire> {
        signals::wires(&self.prepared.stage.view, false)
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        check_free_eye(&self.prepared.stage.landscape, frame, pose)
    }

    fn omissions(&self) -> Vec<Omission> {
        let stage = &self.prepared.stage;
        let omission =
            |what: String, why: String| Omission { block: NAME, what, why, weight: Weight::NotModelled };
        // Ground that is lit anew has the scenario's cast shadow.
        let shadows = stage.view.shadows.filter(|_| self.prepared.relit.is_none());
        let unlit = Stage { view: View { shadows, ..stage.view.clone() }, ..stage.clone() };
        let mut omissions = scene_sampler::omissions(&unlit, NAME);
        omissions.extend(face_lists_beside(&stage.scenery, NAME));
        if stage.landscape.bank().levels().len() > 1 {
            let why = "its posts are those of the finest level".to_owned();
            omissions.push(omission("a second level of ground".to_owned(), why));
        }
        let apart = self.suns_apart();
        if apart > SUNS_APART_DEG && self.prepared.relit.is_none() {
            let why = format!(
                "the photographs have their own, {apart:.1} degrees from it; panels.relight = true lays the scenario's on"
            );
            omissions.push(omission("the scenario's sun on the ground".to_owned(), why));
        }
        omissions
    }

    /// Panel, posts, photograph, pixels and light of the ground in a pixel; then the stack of every sampling point.
    fn explain(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        let (scene, _) = self.scene(frame, pose)?;
        self.filled(frame, &scene, pixel, |filled| {
            let ground = filled.nearness().map(|q| Seen::new(&scene.camera, pixel, q));
            let mut facts = ground.map_or(Vec::new(), |seen| seen.facts(&self.prepared, &scene.camera));
            facts.push(Fact::new("sub-area", format!("{}: {} entries", filled.number(), filled.entries())));
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
        let (scene, _) = self.scene(frame, pose)?;
        self.filled(frame, &scene, pixel, |filled| filled.document(number, &[]))
    }

    /// All panels: coarser ones are held to them.
    fn faces(&self, frame: u64, pose: &Pose) -> Result<Option<FaceScene>, FrameError> {
        self.check(frame, pose)?;
        let camera = Camera::new(pose, &self.prepared.stage.view);
        let (scene, _) = self.scene_of((frame, pose), camera, None)?;
        Ok(Some(judged_faces(scene, &self.prepared.run.sampling)))
    }
}
