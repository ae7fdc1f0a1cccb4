//! What a picture shows when the sampler runs out of time: sub-areas, or whole pictures, of frames before.

use generator::FrameError;
use scenario::Pose;

use crate::fields::Field;
use crate::overload::{self, Overload};
use crate::picture::Picture;
use crate::reading::Reading;
use crate::scene::Scene;
use crate::session::Session;
use crate::work::{self, Course};

/// The frame that a picture shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown {
    /// Number of the frame.
    pub frame: u64,
    /// Its pose.
    pub pose: Pose,
    /// Whether nothing is complete yet: the picture is dark.
    pub is_dark: bool,
}

impl Session {
    /// What the picture of field `frame` shows: its own frame from `pose`, or an earlier one where frames take several fields.
    ///
    /// # Errors
    /// If a frame before cannot be drawn.
    pub fn shown(&self, frame: u64, pose: &Pose) -> Result<Shown, FrameError> {
        if self.parameters.overload != Overload::Extend {
            return Ok(Shown { frame, pose: *pose, is_dark: false });
        }
        let field = self.field(frame)?;
        let shown = field.shown();
        let frame = shown.unwrap_or(field.frame);
        Ok(Shown { frame, pose: self.pose(frame)?, is_dark: shown.is_none() })
    }

    /// What the machine does in field `number` where frames may take several.
    ///
    /// # Errors
    /// If a frame before cannot be drawn.
    pub fn field(&self, number: u64) -> Result<Field, FrameError> {
        self.fields.field(number, |frame| {
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
            _ => self.picture(scene, frame, true)?.readings,
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
        let pose = self.stage.scenery.course().get(frame as usize).copied();
        let reason = || "it is not among the frames of the mission; choose one of those".to_owned();
        pose.ok_or_else(|| FrameError::Refused { frame, reason: reason() })
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
        let shown = self.picture(&earlier, before, false)?;
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
