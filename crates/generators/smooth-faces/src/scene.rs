//! Everything of a frame on the screen: lists with their pieces, in the order of their priorities.

use faces::Detail;
use generator::{FrameError, Label, Stage};
use scenario::Pose;
use scene_sampler::Camera;
use smallvec::SmallVec;

use crate::parameters::Parameters;
use crate::piece::{Corner, Piece};
use crate::{bodies, frame_lists, ground};

/// A list of faces in a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct List {
    /// What it is called.
    pub name: String,
    /// What its faces are in the plane of labels.
    pub label: Label,
    /// Its priority: the lower number wins.
    pub priority: i64,
    /// How it is laid upon what is behind it; `None` where it stands for itself.
    pub level: Option<Detail>,
    /// Unit vector to its sun: north, east, up.
    pub sun: [f64; 3],
    /// Memory words that the real-time computer writes for it.
    pub words: u64,
    /// Whether it has a sun of its own.
    pub has_own_sun: bool,
}

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
}

/// A scene that is being gathered.
pub struct SceneBuilder<'a> {
    /// Camera of the pose.
    pub camera: &'a Camera,
    /// Run parameters of the generator.
    pub run: Parameters,
    /// Columns and lines of the screen.
    size: [usize; 2],
    lists: Vec<List>,
    pieces: Vec<Piece>,
    faces: u64,
}

impl SceneBuilder<'_> {
    /// Begins a list; the number of it.
    pub fn start(&mut self, list: List) -> u32 {
        self.lists.push(list);
        self.lists.len() as u32 - 1
    }

    /// Adds a face, cut in pieces, with the numbers of its list and of itself in it.
    pub fn add(&mut self, corners: &[Corner], colour: [f64; 3], numbers: [u32; 2]) {
        self.faces += 1;
        if corners.len() == 3 {
            self.pieces.extend(Piece::new(corners, (self.camera, self.size), colour, numbers));
            return;
        }
        for piece in self.run.cut.pieces(corners.len()) {
            let corners: SmallVec<[Corner; 8]> = piece.into_iter().map(|corner| corners[corner]).collect();
            self.pieces.extend(Piece::new(&corners, (self.camera, self.size), colour, numbers));
        }
    }
}

impl Scene {
    /// Gathers frame `frame` from a pose.
    ///
    /// # Errors
    /// If the ground has no mesh there, or a body is no shape.
    pub fn new(stage: &Stage, run: Parameters, frame: u64, pose: &Pose) -> Result<Self, FrameError> {
        let refused = |reason: String| FrameError::Refused { frame, reason };
        let camera = Camera::new(pose, &stage.view);
        let size = [stage.view.columns as usize, stage.view.lines as usize];
        let (lists, pieces) = (Vec::new(), Vec::new());
        let mut scene = SceneBuilder { camera: &camera, run, size, lists, pieces, faces: 0 };
        frame_lists::add(&mut scene, stage, frame, pose);
        bodies::add(&mut scene, stage, pose).map_err(|error| refused(error.to_string()))?;
        if let Some(rings) = run.ground {
            ground::add(&mut scene, stage, rings, pose.time).map_err(|error| refused(error.to_string()))?;
        }
        let SceneBuilder { lists, pieces, faces, .. } = scene;
        Ok(Self { lists, pieces, faces, camera })
    }
}
