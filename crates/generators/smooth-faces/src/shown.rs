//! Faces that are shown, cut in pieces on the screen.

use faces::{Cut, Mesh};
use rayon::prelude::*;
use scene_sampler::Camera;
use smallvec::SmallVec;

use crate::piece::{Corner, Piece};

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
    /// Vertices and faces of a list.
    pub fn of_mesh(mesh: &Mesh) -> Self {
        Self { vertices: mesh.vertices().len() as u64, faces: mesh.faces().len() as u64, triangles: 0 }
    }

    /// Adds the work of other faces.
    pub fn add(&mut self, other: Self) {
        self.vertices += other.vertices;
        self.faces += other.faces;
        self.triangles += other.triangles;
    }
}

/// A screen, and how faces are cut for it.
#[derive(Debug, Clone, Copy)]
pub struct Screen<'a> {
    /// Camera of the pose.
    pub camera: &'a Camera,
    /// Columns and lines of the picture.
    pub size: [usize; 2],
    /// How faces of more than three corners are cut.
    pub cut: Cut,
}

/// Some faces of a list on a screen.
#[derive(Debug, Default)]
pub struct Shown {
    /// Faces that are seen, within the picture or beside it.
    pub faces: u64,
    /// What geometry has to do for them.
    pub work: Geometry,
    /// Pieces in which a sample can be, in stored order.
    pub pieces: Vec<Piece>,
}

impl Shown {
    /// Adds a face, cut in pieces, with the numbers of its list and of itself in it.
    pub fn add(&mut self, screen: Screen<'_>, corners: &[Corner], colour: [f64; 3], numbers: [u32; 2]) {
        let Screen { camera, size, cut } = screen;
        self.faces += 1;
        if corners.len() == 3 {
            self.pieces.extend(Piece::new(corners, (camera, size), colour, numbers));
            return;
        }
        let pieces = cut.pieces(corners.len());
        self.work.triangles += if cut == Cut::Fan { pieces.len() as u64 } else { 0 };
        for piece in pieces {
            let corners: SmallVec<[Corner; 8]> = piece.into_iter().map(|corner| corners[corner]).collect();
            self.pieces.extend(Piece::new(&corners, (camera, size), colour, numbers));
        }
    }

    /// Adds runs of faces behind these.
    pub fn append(&mut self, runs: Vec<Self>) {
        self.pieces.reserve(runs.iter().map(|run| run.pieces.len()).sum());
        for mut run in runs {
            self.faces += run.faces;
            self.work.add(run.work);
            self.pieces.append(&mut run.pieces);
        }
    }
}

/// Faces that a thread takes at a time. Chosen: some hundred faces are worth a task.
const RUN: usize = 256;

/// What `show` makes of the numbers below `count`, which threads share out in runs; the runs stand in their order.
pub fn in_runs(count: usize, show: impl Fn(&mut Shown, usize) + Sync) -> Vec<Shown> {
    let run = |run: usize| {
        let mut shown = Shown::default();
        (run * RUN..count.min((run + 1) * RUN)).for_each(|number| show(&mut shown, number));
        shown
    };
    (0..count.div_ceil(RUN)).into_par_iter().map(run).collect()
}
