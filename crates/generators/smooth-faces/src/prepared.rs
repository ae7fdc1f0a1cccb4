//! A stage made ready: run parameters, gear, and the schedule of the real-time computer.

use faces::Order;
use generator::{FrameError, PrepareError, Stage};
use scenario::{FaceList, Pose};

use crate::drawn_lists;
use crate::hardware::Hardware;
use crate::name::NAME;
use crate::parameters::Parameters;
use crate::schedule::Schedule;

/// A stage with what the generator works out of it once.
pub struct Prepared {
    /// World and view of the pictures.
    pub stage: Stage,
    /// Run parameters of the pictures.
    pub run: Parameters,
    /// What the generator runs on.
    pub hardware: Hardware,
    /// When sequences, suns, bodies and normals are new.
    pub schedule: Schedule,
}

impl Prepared {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// If a list has too many faces, or pictures are late and the stage does not have the course of the mission.
    pub fn new(stage: Stage, run: Parameters, hardware: Hardware) -> Result<Self, PrepareError> {
        let lists = drawn_lists::drawn(&stage, &run);
        for FaceList { group, .. } in &lists {
            let faces = group.mesh.faces().len();
            if faces > run.limit as usize {
                return Err(PrepareError::Unsupported {
                    generator: NAME,
                    what: format!("{faces} faces of list {} (at most {})", group.name, run.limit),
                    remedy: "raise faces.limit, or give the list fewer faces".into(),
                });
            }
        }
        if run.delayed && hardware.delay_frames > 0 && stage.scenery.course().is_empty() {
            return Err(PrepareError::Unsupported {
                generator: NAME,
                what: "delayed pictures without the frames before".into(),
                remedy: "give the stage the course of its mission".into(),
            });
        }
        let schedule = Schedule::new(&stage, &lists, &run, &hardware);
        // A hull that is whole below the water needs depth, whatever the run asks for.
        let order = if stage.scenery.face_lists().by_depth { Order::Depth } else { run.order };
        Ok(Self { run: Parameters { order, ..run }, stage, hardware, schedule })
    }

    /// Columns and lines of the screen.
    pub fn size(&self) -> [usize; 2] {
        [self.stage.view.columns as usize, self.stage.view.lines as usize]
    }

    /// Samples of a scan line.
    pub fn samples(&self) -> usize {
        self.size()[1 - self.run.across()]
    }

    /// The frame whose state the picture of `frame` shows, with its pose: its own from `pose`, or an earlier one where pictures are late.
    ///
    /// # Errors
    /// If that is not a frame of the mission.
    pub fn seen(&self, frame: u64, pose: &Pose) -> Result<(u64, Pose), FrameError> {
        if !self.run.delayed || self.hardware.delay_frames == 0 {
            return Ok((frame, *pose));
        }
        let earlier = frame.saturating_sub(u64::from(self.hardware.delay_frames));
        let pose = self.stage.scenery.course().get(earlier as usize).copied();
        let reason = || {
            format!("frame {earlier}, which it shows, is not among those of the mission; choose one of those")
        };
        Ok((earlier, pose.ok_or_else(|| FrameError::Refused { frame, reason: reason() })?))
    }
}
