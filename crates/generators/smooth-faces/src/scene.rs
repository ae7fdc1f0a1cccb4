//! Everything of a frame on the screen: lists with their pieces, in the order of their priorities.

use generator::{FrameError, Stage, check_free_eye};
use scenario::Pose;
use scene_sampler::Camera;

use crate::hardware::Hardware;
use crate::list::List;
use crate::parameters::Parameters;
use crate::piece::Piece;
use crate::prepared::Prepared;
use crate::schedule::Schedule;
use crate::shown::{Geometry, Screen, Shown};
use crate::slots::{self, Slotted};
use crate::{bodies, frame_lists, ground};

/// A frame on the screen.
#[derive(Debug)]
pub struct Scene {
    /// Camera of the pose.
    pub camera: Camera,
    /// Lists, the lowest priority first.
    pub lists: Vec<List>,
    /// Pieces of their faces, list by list, in stored order.
    pub pieces: Vec<Piece>,
    /// Faces that were shown.
    pub faces: u64,
    /// Pieces that a scan line holds; `None` is without limit.
    pub slots: Option<u32>,
    /// Pieces that were taken out for want of edge slots in the frame.
    pub lost: Vec<Piece>,
    /// Faces of those, but for the levels of detail that fell.
    pub lost_faces: u64,
    /// What geometry has to do.
    pub work: Geometry,
    /// Memory words that the real-time computer writes.
    pub words: u64,
    /// Sequences, sun vectors, bodies and normals that are those of an earlier frame.
    pub late: u64,
}

/// A scene that is being gathered.
pub struct SceneBuilder<'a> {
    /// Camera of the pose.
    pub camera: &'a Camera,
    /// Run parameters of the generator.
    pub run: Parameters,
    /// What it runs on.
    pub hardware: Hardware,
    /// When sequences, suns, bodies and normals are new.
    pub schedule: &'a Schedule,
    /// Number of the frame.
    pub frame: u64,
    /// Faces of the lists so far.
    pub shown: Shown,
    /// Columns and lines of the screen.
    size: [usize; 2],
    lists: Vec<List>,
}

impl SceneBuilder<'_> {
    /// Time of the frame `shown` (s), of which a list or a body shows the state; `pose` is that of the frame that is drawn.
    pub fn time(&self, shown: u64, stage: &Stage, pose: &Pose) -> f64 {
        if shown == self.frame { pose.time } else { shown as f64 / stage.view.update.hertz() }
    }

    /// Begins a list; the number of it.
    pub fn start(&mut self, list: List) -> u32 {
        self.lists.push(list);
        self.lists.len() as u32 - 1
    }

    /// What cuts faces in pieces.
    pub fn screen(&self) -> Screen<'_> {
        Screen { camera: self.camera, size: self.size, cut: self.run.cut }
    }
}

impl Scene {
    /// The frame that shows in the picture of `frame`: its own from `pose`, or an earlier one where pictures are late.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn new(prepared: &Prepared, frame: u64, pose: &Pose) -> Result<Self, FrameError> {
        let (seen, pose) = prepared.seen(frame, pose)?;
        check_free_eye(&prepared.stage.landscape, frame, &pose)?;
        Self::gathered(prepared, seen, &pose)
    }

    /// Gathers frame `frame` from a pose.
    fn gathered(prepared: &Prepared, frame: u64, pose: &Pose) -> Result<Self, FrameError> {
        let Prepared { stage, run, hardware, schedule } = prepared;
        let refused = |reason: String| FrameError::Refused { frame, reason };
        let camera = Camera::new(pose, &stage.view);
        let mut scene = SceneBuilder {
            camera: &camera,
            run: *run,
            hardware: *hardware,
            schedule,
            frame,
            shown: Shown::default(),
            size: prepared.size(),
            lists: Vec::new(),
        };
        frame_lists::add(&mut scene, stage, pose);
        bodies::add(&mut scene, stage, pose).map_err(|error| refused(error.to_string()))?;
        if let Some(rings) = run.ground {
            ground::add(&mut scene, stage, rings, pose.time).map_err(|error| refused(error.to_string()))?;
        }
        let SceneBuilder { mut lists, shown: Shown { faces, work, pieces }, .. } = scene;
        let limit = hardware.edges_frame.map_or(u64::MAX, u64::from);
        let Slotted { kept, lost, lost_faces } = slots::limited(&mut lists, pieces, limit);
        Ok(Self {
            lists,
            pieces: kept,
            faces,
            camera,
            slots: hardware.edges_line,
            lost,
            lost_faces,
            work,
            words: schedule.words(),
            late: schedule.late(frame),
        })
    }
}
