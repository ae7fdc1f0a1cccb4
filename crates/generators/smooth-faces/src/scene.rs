//! Everything of a frame on the screen: lists with their pieces, in the order of their priorities.

use faces::{Cut, Detail, Mesh};
use generator::{FrameError, Label, Stage};
use scenario::Pose;
use scene_sampler::Camera;
use smallvec::SmallVec;

use crate::hardware::Hardware;
use crate::parameters::Parameters;
use crate::piece::{Corner, Piece};
use crate::schedule::Schedule;
use crate::session::Session;
use crate::{bodies, frame_lists, ground, slots};

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
    /// Whether it has a sun of its own.
    pub has_own_sun: bool,
    /// Frames whose sequence, sun vector, body and normals it shows.
    pub shown: [u64; 4],
    /// Whether it is a level of detail that fell for want of edge slots.
    pub has_fallen: bool,
}

/// What geometry has to do for a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Geometry {
    /// Vertices that are transformed.
    pub vertices: u64,
    /// Faces that are tested.
    pub faces: u64,
    /// Triangles that faces are cut into.
    pub triangles: u64,
}

impl Geometry {
    /// Adds the vertices and faces of a list.
    pub fn add_mesh(&mut self, mesh: &Mesh) {
        self.vertices += mesh.vertices().len() as u64;
        self.faces += mesh.faces().len() as u64;
    }
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
    /// What geometry has to do.
    pub work: Geometry,
    /// Columns and lines of the screen.
    size: [usize; 2],
    lists: Vec<List>,
    pieces: Vec<Piece>,
    faces: u64,
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

    /// Adds a face, cut in pieces, with the numbers of its list and of itself in it.
    pub fn add(&mut self, corners: &[Corner], colour: [f64; 3], numbers: [u32; 2]) {
        self.faces += 1;
        if corners.len() == 3 {
            self.pieces.extend(Piece::new(corners, (self.camera, self.size), colour, numbers));
            return;
        }
        let pieces = self.run.cut.pieces(corners.len());
        self.work.triangles += if self.run.cut == Cut::Fan { pieces.len() as u64 } else { 0 };
        for piece in pieces {
            let corners: SmallVec<[Corner; 8]> = piece.into_iter().map(|corner| corners[corner]).collect();
            self.pieces.extend(Piece::new(&corners, (self.camera, self.size), colour, numbers));
        }
    }
}

impl Scene {
    /// Gathers frame `frame` of a session from a pose.
    ///
    /// # Errors
    /// If the ground has no mesh there, or a body is no shape.
    pub fn new(session: &Session, frame: u64, pose: &Pose) -> Result<Self, FrameError> {
        let Session { stage, run, hardware, schedule } = session;
        let refused = |reason: String| FrameError::Refused { frame, reason };
        let camera = Camera::new(pose, &stage.view);
        let mut scene = SceneBuilder {
            camera: &camera,
            run: *run,
            hardware: *hardware,
            schedule,
            frame,
            work: Geometry::default(),
            size: session.size(),
            lists: Vec::new(),
            pieces: Vec::new(),
            faces: 0,
        };
        frame_lists::add(&mut scene, stage, pose);
        bodies::add(&mut scene, stage, pose).map_err(|error| refused(error.to_string()))?;
        if let Some(rings) = run.ground {
            ground::add(&mut scene, stage, rings, pose.time).map_err(|error| refused(error.to_string()))?;
        }
        let SceneBuilder { lists, pieces, faces, work, .. } = scene;
        let mut scene = Self {
            lists,
            pieces,
            faces,
            camera,
            slots: hardware.edges_line,
            lost: Vec::new(),
            lost_faces: 0,
            work,
            words: schedule.words(),
            late: schedule.late(frame),
        };
        if let Some(slots) = hardware.edges_frame {
            slots::limit(&mut scene, u64::from(slots));
        }
        Ok(scene)
    }
}
