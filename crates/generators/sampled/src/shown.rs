//! What a picture shows when the sampler runs out of time: sub-areas, or whole pictures, of frames before.

use generator::FrameError;
use scenario::Pose;
use scene_sampler::{Field, Picture, Reading, Scene, Shown};

use crate::overload;
use crate::policy::Overload;
use crate::session::Session;
use crate::work::{self, Course};

impl Session {
    /// What the picture of field `frame` shows: its own frame from `pose`, or an earlier one where frames take several fields.
    ///
    /// # Errors
    /// If a frame before cannot be drawn.
    pub fn shown(&self, frame: u64, pose: &Pose) -> Result<Shown, FrameError> {
        if self.parameters.overload != Overload::Extend {
            return Ok(Shown::own(frame, pose));
        }
        Shown::of(self.field(frame)?, self.stage.scenery.course())
    }

    /// What the machine does in field `number` where frames may take several.
    ///
    /// # Errors
    /// If a frame before cannot be drawn.
    pub fn field(&self, number: u64) -> Result<Field, FrameError> {
        self.fields.field(number, |frame, _| {
            let scene = self.gather(frame, &self.pose(frame)?)?.scene;
            Ok(work::fields(self.course(&scene, frame)?.end(), self.field_ticks()))
        })
    }

    /// Ticks of a field.
    pub fn field_ticks(&self) -> u64 {
        work::frame_ticks(&self.hardware, self.stage.view.update)
    }

    /// The course of a scene through the sampler. Sampling points are looked at only where the depth of their stacks takes time.
    fn course(&self, scene: &Scene, frame: u64) -> Result<Course, FrameError> {
        let readings = match self.hardware.insert_ticks {
            1 => self.counts(scene),
            _ => self.drawn(scene, frame, true)?.picture.readings,
        };
        Ok(Course::of(&readings, &self.hardware))
    }

    fn counts(&self, scene: &Scene) -> Vec<Reading> {
        let Self { screen, parameters, hardware, .. } = self;
        let (lists, _) = overload::lists(scene, screen, parameters.overload, &hardware.memory);
        let areas = 0..screen.sub_areas();
        areas.map(|number| Reading::counted(scene, &lists, &screen.sub_area(number), number)).collect()
    }

    /// Pose of a frame of the mission.
    fn pose(&self, frame: u64) -> Result<Pose, FrameError> {
        scene_sampler::pose(self.stage.scenery.course(), frame)
    }

    /// Puts the frame before into each sub-area of `picture`, drawn from `scene`, that is not read out in time; black, where `frame`
    /// is the first. The frame before is taken as if it were in time. Returns how many sub-areas are late.
    ///
    /// # Errors
    /// If the frame before cannot be drawn.
    pub fn show_late(&self, picture: &mut Picture, scene: &Scene, frame: u64) -> Result<u64, FrameError> {
        if self.parameters.overload != Overload::Late {
            return Ok(0);
        }
        let late = self.late(&picture.readings);
        let count = late.iter().filter(|is_late| **is_late).count() as u64;
        if count == 0 {
            return Ok(0);
        }
        let Some(before) = frame.checked_sub(1) else {
            picture.show_earlier(None, scene.camera, late, &self.screen);
            return Ok(count);
        };
        let earlier = self.gather(before, &self.pose(before)?)?.scene;
        let shown = self.drawn(&earlier, before, false)?.picture;
        picture.show_earlier(Some(&shown), earlier.camera, late, &self.screen);
        Ok(count)
    }

    /// Whether each sub-area is read out after its line was due.
    pub fn late(&self, readings: &[Reading]) -> Vec<bool> {
        let course = Course::of(readings, &self.hardware);
        let dues = work::dues(&self.screen, self.field_ticks());
        course.read_out.iter().zip(dues).map(|(came, (_, due))| *came > due).collect()
    }
}

#[cfg(test)]
mod tests {
    use generator::{Generator, PlaneKind, Planes};
    use scenario::Effects;
    use signal::Probe;

    use super::*;
    use crate::{BeamLayer, Hardware, Parameters, Sampled, scenes};

    const KINDS: [PlaneKind; 4] =
        [PlaneKind::Red, PlaneKind::Label, PlaneKind::Distance, PlaneKind::Overload];

    /// The pane and two stars of the raster, seen from poses that nod: each frame shows the stars elsewhere.
    fn effects() -> Effects {
        let lights = vec![scenes::star(0, [0.5, -0.5], 0.0, false), scenes::star(1, [0.5, 0.5], 0.0, false)];
        Effects { lights, overlays: vec![scenes::pane()], ..Effects::default() }
    }

    /// Frames of a policy at 166 frames a second: six ticks, of which rows are due at 3 and 6. Read out is at 3, 4, 6 and 7.
    fn drawn(overload: Overload, frames: &[u64]) -> Vec<(Planes, u64, u64)> {
        let (generator, update) = scenes::slow(166);
        let sampling =
            scene_sampler::Parameters { beam_layer: BeamLayer::Raster, ..generator.parameters.sampling };
        let parameters = Parameters { overload, sampling, ..generator.parameters };
        let stage = scenes::moving(effects(), update, 6);
        let course = stage.scenery.course().to_vec();
        let session = Sampled { parameters, ..generator }.prepare(stage).unwrap();
        let draw = |frame: &u64| {
            let mut planes = Planes::new(16, 16, &KINDS);
            let pose = &course[*frame as usize];
            let counts = session.frame(*frame, pose, &mut planes, &mut Probe::off()).unwrap();
            (planes, counts["late_sub_areas"], counts["repeated"])
        };
        frames.iter().map(draw).collect()
    }

    /// Values of a plane in a sub-area of the 2 x 2.
    fn tile(planes: &Planes, kind: PlaneKind, number: usize) -> Vec<f32> {
        let values = planes.get(kind).unwrap();
        (0..256).filter(|at| scene_sampler::area_of(*at, 16) == number).map(|at| values[at]).collect()
    }

    #[test]
    fn a_late_sub_area_shows_the_frame_before_and_black_in_the_first() {
        let [before, now] = &drawn(Overload::DropSmallest, &[2, 3])[..] else { unreachable!() };
        let [first, late] = &drawn(Overload::Late, &[0, 3])[..] else { unreachable!() };
        assert_eq!(((now.1, late.1, first.1), late.2), ((0, 2, 2), 0));
        for (number, shown) in [(0, now), (1, before), (2, now), (3, before)] {
            for kind in &KINDS[..3] {
                assert_eq!(tile(&late.0, *kind, number), tile(&shown.0, *kind, number), "{number}");
            }
        }
        assert_ne!(tile(&before.0, PlaneKind::Red, 1), tile(&now.0, PlaneKind::Red, 1));
        assert!(tile(&first.0, PlaneKind::Red, 1).iter().all(|red| *red == 0.0));
        let marked = |number| tile(&late.0, PlaneKind::Overload, number);
        assert_eq!([0, 1, 2, 3].map(|number| marked(number)[0]), [0.0, 4.0, 0.0, 4.0]);
        assert_eq!(now.0.get(PlaneKind::Overload), late.0.get(PlaneKind::Overload));
    }

    /// Each frame takes two fields: the odd ones are never begun.
    #[test]
    fn a_frame_that_takes_another_field_is_shown_when_it_is_complete() {
        let own = drawn(Overload::DropSmallest, &[0, 1, 2, 3, 4]);
        let long = drawn(Overload::Extend, &[0, 1, 2, 3, 4]);
        let red = |(planes, ..): &(Planes, u64, u64)| planes.get(PlaneKind::Red).unwrap().to_vec();
        assert!(red(&long[0]).iter().all(|red| *red == 0.0));
        assert_ne!(red(&own[0]), red(&own[2]));
        for (field, frame) in [(1, 0), (2, 0), (3, 2), (4, 2)] {
            assert_eq!(red(&long[field]), red(&own[frame]), "field {field}");
        }
        assert_eq!(long.iter().map(|(.., repeated)| *repeated).collect::<Vec<_>>(), [1, 0, 1, 0, 1]);
    }

    #[test]
    fn a_frame_alone_is_as_in_sequence() {
        for overload in [Overload::Late, Overload::Extend] {
            let sequence = drawn(overload, &[0, 1, 2, 3, 4, 5]);
            for (frame, shown) in (0..).zip(&sequence) {
                assert_eq!(&drawn(overload, &[frame])[0], shown, "{overload:?}, frame {frame}");
            }
        }
    }

    /// Where insertions take time, fields are counted with the depth of stacks: the pane takes two ticks more, twice.
    #[test]
    fn insertions_count_for_the_fields_of_a_frame() {
        let (generator, update) = scenes::slow(100);
        let fields = |insert_ticks: u64| {
            let parameters = Parameters { overload: Overload::Extend, ..generator.parameters };
            let hardware = Hardware { insert_ticks, ..generator.hardware };
            let stage = scenes::moving(effects(), update, 2);
            let session = Session::new(stage, parameters, hardware).unwrap();
            session.field(0).unwrap().is_complete
        };
        assert!(fields(1) && !fields(3));
    }

    #[test]
    fn a_stage_without_the_frames_before_is_refused() {
        for overload in [Overload::Late, Overload::Extend] {
            let (generator, update) = scenes::slow(10);
            let parameters = Parameters { overload, ..generator.parameters };
            let stage = scenes::stage(effects(), update);
            let error = Sampled { parameters, ..generator }.prepare(stage).err().unwrap().to_string();
            assert!(error.contains(overload.word()) && error.contains("course"), "{error}");
        }
    }
}
