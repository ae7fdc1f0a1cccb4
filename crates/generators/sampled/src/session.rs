//! The generator made ready for a stage.

use generator::{
    BeamEntry, FaceScene, Fact, FrameCounts, FrameError, Omission, PlaneKind, Planes, PrepareError,
    Session as GeneratorSession, Stage, Weight, check_eye,
};
use ground_mesh::Rings;
use raster::{Lists, Screen};
use scenario::Pose;
use serde_json::Value;
use signal::{Probe, Wire};
use translucency::{FeatureError, Losses};

use crate::fields::Fields;
use crate::hardware::Hardware;
use crate::overload::LostEntry;
use crate::parameters::Parameters;
use crate::picture::{self, Picture};
use crate::point::SamplingPoint;
use crate::row::NAME;
use crate::rows::{self, Rows};
use crate::scene::Scene;
use crate::store::Gathered;
use crate::tile::{SIDE, Sampler};
use crate::{ground, judged, map, overload, store};

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
}

impl Session {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// If its raster is too large.
    pub fn new(stage: Stage, parameters: Parameters, hardware: Hardware) -> Result<Self, PrepareError> {
        let size = [stage.view.columns, stage.view.lines];
        let screen = Screen::new(size, SIDE as u32).map_err(|error| PrepareError::Unsupported {
            generator: NAME,
            what: error.to_string(),
            remedy: "ask for a smaller raster".into(),
        })?;
        let frames = stage.scenery.course().len();
        if parameters.overload.shows_earlier_frames() && frames == 0 {
            return Err(PrepareError::Unsupported {
                generator: NAME,
                what: format!("overload `{}` without the frames before", parameters.overload.word()),
                remedy: "give the stage the course of its mission".into(),
            });
        }
        let rings = ground::rings(&stage, &parameters);
        Ok(Self { stage, screen, parameters, hardware, fields: Fields::of(frames), rings })
    }

    /// Gathers frame `frame` from `pose`.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn gather(&self, frame: u64, pose: &Pose) -> Result<Gathered, FrameError> {
        self.check(frame, pose)?;
        let mut scene = Scene::new(&self.stage, &self.parameters, self.rings, &self.screen, frame, pose)?;
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
    pub fn picture(&self, scene: &Scene, frame: u64, is_read: bool) -> Result<Picture, FrameError> {
        let Self { stage, screen, parameters, hardware, .. } = self;
        picture::draw(scene, screen, parameters, hardware, &stage.view, frame, is_read)
    }
}

impl Session {
    /// The sub-area that holds a pixel of frame `frame` from `pose`.
    fn filled(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Filled, FrameError> {
        let Gathered { scene, .. } = self.gather(frame, pose)?;
        let refused = |error: FeatureError| FrameError::Refused { frame, reason: error.to_string() };
        let (lists, lost) =
            overload::lists(&scene, &self.screen, self.parameters.overload, &self.hardware.memory);
        let number = (pixel[1] / SIDE) * self.screen.counts()[0] as usize + pixel[0] / SIDE;
        let mut sampler = Sampler::new(&self.parameters).map_err(refused)?;
        sampler.fill(&scene, &lists, &self.screen.sub_area(number), number).map_err(refused)?;
        Ok(Filled { scene, lists, lost, sampler, number })
    }

    /// What a frame took and lost, with its late sub-areas, and whether its picture shows a new frame.
    fn counted(&self, gathered: &Gathered, picture: &Picture, late: u64, is_new: bool) -> FrameCounts {
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
            ("lost_entries", picture.lost.len() as u64),
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
        let mut picture = self.picture(scene, shown.frame, is_read)?;
        let late = self.show_late(&mut picture, scene, shown.frame)?;
        let Self { screen, hardware, parameters, .. } = self;
        picture.beam.draw(&scene.lights.points, parameters, screen, &mut picture.colours);
        picture::fill(&picture, scene, planes);
        if shown.is_dark {
            planes.fill_sky();
        }
        if let Some(plane) = planes.get_mut(PlaneKind::Overload) {
            map::fill(plane, &picture, &gathered, screen, &self.late(&picture.readings));
        }
        Rows { screen, camera: &scene.camera, hardware, readings: &picture.readings }.record(frame, probe);
        Ok(self.counted(&gathered, &picture, late, shown.is_new))
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        check_eye(&self.stage.landscape, frame, pose)
    }

    fn omissions(&self) -> Vec<Omission> {
        let Stage { landscape, scenery, view } = &self.stage;
        let lacks = [
            (!scenery.patches(f64::INFINITY).is_empty(), "vehicle tracks"),
            (landscape.texture().is_some(), "texture"),
            (!landscape.silhouettes().is_empty(), "far silhouettes"),
            (view.shadows.is_some(), "remote shadow"),
        ];
        let omission = |what: &str| Omission {
            block: NAME,
            what: what.into(),
            why: "it draws faces, sheets and lights".into(),
            weight: Weight::NotModelled,
        };
        lacks.into_iter().filter(|(is_there, _)| *is_there).map(|(_, what)| omission(what)).collect()
    }

    fn wires(&self) -> Vec<Wire> {
        rows::wires(&self.stage, &self.screen, &self.parameters, &self.hardware)
    }

    /// The ground mesh of the frame with its error; lists and stacks of every sampling point of the pixel.
    fn explain(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        let filled = self.filled(frame, pose, pixel)?;
        let Filled { scene, lists, lost, number, .. } = &filled;
        let entries = lists.of(*number).len() + scene.lights.of(*number).len();
        let lost = lost.iter().filter(|lost| lost.sub_area as usize == *number).count();
        let without = if lost > 0 { format!(", {lost} without a place") } else { String::new() };
        let ground = ground::told(&self.stage, self.rings, &scene.camera);
        let ground = ground.map_err(|error| FrameError::Refused { frame, reason: error.to_string() })?;
        let mut facts = vec![
            Fact::new("ground mesh", ground),
            Fact::new("sub-area", format!("{number}: {entries} entries{without}")),
        ];
        let stack = filled.sampler.stack();
        let first = (pixel[1] % SIDE * SIDE + pixel[0] % SIDE) * stack.samples();
        for point in 0..stack.samples() {
            let words = format!("{point}: {}", told(scene, stack, first + point));
            facts.push(Fact::new("sampling point", words));
        }
        Ok(facts)
    }

    fn sampling_point(
        &self,
        frame: u64,
        pose: &Pose,
        pixel: [usize; 2],
        number: usize,
    ) -> Result<Option<Value>, FrameError> {
        let filled = self.filled(frame, pose, pixel)?;
        let stack = filled.sampler.stack();
        let point = SamplingPoint {
            scene: &filled.scene,
            run: &self.parameters,
            lists: &filled.lists,
            lost: &filled.lost,
            stack,
            sub_area: filled.number,
            area: self.screen.sub_area(filled.number),
            pixel,
            number,
        };
        Ok((number < stack.samples()).then(|| point.document()))
    }

    fn faces(&self, frame: u64, pose: &Pose) -> Result<Option<FaceScene>, FrameError> {
        self.check(frame, pose)?;
        let scene = Scene::new(&self.stage, &self.parameters, self.rings, &self.screen, frame, pose)?;
        Ok(Some(judged::faces(scene, &self.parameters)))
    }

    fn beam_list(&self, frame: u64, pose: &Pose) -> Result<Option<Vec<BeamEntry>>, FrameError> {
        let Gathered { scene, .. } = self.gather(frame, pose)?;
        let picture = self.picture(&scene, frame, false)?;
        Ok(Some(picture.beam.entries(&scene.lights.points)))
    }
}

/// The sub-area of a pixel with its stacks filled.
struct Filled {
    scene: Scene,
    lists: Lists,
    lost: Vec<LostEntry>,
    sampler: Sampler,
    /// Number of the sub-area.
    number: usize,
}

/// The stack of a sampling point in words, near to far.
fn told(scene: &Scene, stack: &translucency::Stack, sample: usize) -> String {
    let layer = |layer: translucency::Layer<'_>| {
        let label = scene.faces.labels[layer.feature.id() as usize].name();
        let at = if layer.q > 0.0 && layer.q.is_finite() {
            format!(" at {:.3} m", 1.0 / layer.q)
        } else {
            String::new()
        };
        format!("{label}{at}, weight {:.4}", layer.weight())
    };
    let mut words: Vec<String> = stack.layers(sample).map(layer).collect();
    if let Some(loss) = stack.loss_at(sample) {
        words.push(format!("lost to the limits: at most {:.4} of light", loss.bound[1]));
    }
    let [red, green, blue] = stack.colour_at(sample);
    words.push(format!("red {red:.4}, green {green:.4}, blue {blue:.4}"));
    words.join("; ")
}
