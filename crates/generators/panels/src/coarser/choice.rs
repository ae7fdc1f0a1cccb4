//! The triangles that a frame shows.

use glam::DVec3;
use rayon::prelude::*;
use scene_sampler::Camera;

use super::bounds::{Bound, Bounds};
use super::half::{Half, Post, parts_from_south_west};
use crate::mesh::Mesh;

/// Triangles that are halved on one thread before the others begin. Chosen: enough work for each of them.
const FIRST: usize = 256;

/// What a frame needs of the ground.
#[derive(Debug)]
pub struct Choice {
    /// Posts that are corners, by their numbers in the mesh.
    pub posts: Vec<u32>,
    /// Corners of each triangle, by their places in `posts`; counter-clockwise seen from above.
    pub triangles: Vec<[u32; 3]>,
}

impl Choice {
    /// Panels that lie at most `pixels` beside those of `mesh` on the screen of `camera`, as far as they may be seen.
    pub fn new(mesh: &Mesh, bounds: &Bounds, camera: &Camera, pixels: f64) -> Self {
        let eye = Eye { mesh, bounds, camera, metres_of_one: pixels / camera.most_pixels() };
        let triangles: Vec<Vec<[u32; 3]>> =
            eye.begun().into_par_iter().map(|begun| eye.below(begun)).collect();
        Self::of_posts(&triangles, mesh)
    }

    /// Numbers the corners of triangles in the order in which they come.
    fn of_posts(parts: &[Vec<[u32; 3]>], mesh: &Mesh) -> Self {
        let [rows, columns] = mesh.ground().size();
        let mut numbers = vec![u32::MAX; rows * columns];
        let mut posts = Vec::new();
        let mut number = |post: u32| {
            let number = &mut numbers[post as usize];
            if *number == u32::MAX {
                *number = posts.len() as u32;
                posts.push(post);
            }
            *number
        };
        let triangles = parts.iter().flatten().map(|corners| corners.map(&mut number)).collect();
        Self { posts, triangles }
    }
}

/// A triangle to be halved, or one that stays.
enum Begun {
    Open(Half),
    Whole(Half),
}

/// Who looks at the ground.
struct Eye<'a> {
    mesh: &'a Mesh,
    bounds: &'a Bounds,
    camera: &'a Camera,
    /// Error (m) that may be seen a metre away.
    metres_of_one: f64,
}

/// What becomes of a triangle.
enum Fate {
    Unseen,
    Whole,
    Halved(Post),
}

impl Eye<'_> {
    /// The first triangles, in their order: as many as threads share.
    fn begun(&self) -> Vec<Begun> {
        let mut all: Vec<Begun> = Half::of_square(self.bounds.side()).map(Begun::Open).into();
        loop {
            let open = all.iter().filter(|begun| matches!(begun, Begun::Open(_))).count();
            if open == 0 || all.len() >= FIRST {
                return all;
            }
            let next = all.into_iter().flat_map(|begun| match begun {
                Begun::Whole(_) => vec![begun],
                Begun::Open(half) => match self.fate(half) {
                    Fate::Unseen => Vec::new(),
                    Fate::Whole => vec![Begun::Whole(half)],
                    Fate::Halved(middle) => half.halves(middle).map(Begun::Open).into(),
                },
            });
            all = next.collect();
        }
    }

    /// The triangles of the mesh's posts that are left of one.
    fn below(&self, begun: Begun) -> Vec<[u32; 3]> {
        let mut found = Vec::new();
        let mut open = match begun {
            Begun::Open(half) => vec![half],
            Begun::Whole(half) => {
                found.push(self.shown(half));
                Vec::new()
            }
        };
        while let Some(half) = open.pop() {
            match self.fate(half) {
                Fate::Unseen => (),
                Fate::Whole => found.push(self.shown(half)),
                Fate::Halved(middle) => open.extend(half.halves(middle)),
            }
        }
        found
    }

    fn fate(&self, half: Half) -> Fate {
        if half.is_beside(self.bounds.last()) {
            return Fate::Unseen;
        }
        let Some(middle) = half.middle() else { return Fate::Whole };
        let bound = self.bounds.of(middle);
        if bound == Bound::BORDER {
            return Fate::Halved(middle);
        }
        let from_eye = self.place(middle) - self.camera.eye;
        let distance = from_eye.length();
        let radius = f64::from(bound.radius);
        // What lies farther away drops more.
        let curvature = self.bounds.curvature();
        let reach = radius + curvature.drop(distance + radius) - curvature.drop(distance);
        let dropped = from_eye - DVec3::Z * curvature.drop(from_eye.truncate().length());
        match () {
            () if self.camera.misses(dropped, reach) => Fate::Unseen,
            () if self.differs(bound, distance) => Fate::Halved(middle),
            () => Fate::Whole,
        }
    }

    /// Whether what a bound tells may be seen from a distance (m).
    fn differs(&self, bound: Bound, distance: f64) -> bool {
        f64::from(bound.error) > self.metres_of_one * (distance - f64::from(bound.radius))
    }

    /// Corners of a triangle. Half a cell is the mesh's own panel where the cell's other half is shown as well.
    fn shown(&self, half: Half) -> [u32; 3] {
        let columns = self.mesh.ground().size()[1] as u32;
        let number = |post: Post| post[0] * columns + post[1];
        let plain = half.corners().map(number);
        if half.middle().is_some() {
            return plain;
        }
        let [a, b] = half.ends;
        let cell = [a[0].min(b[0]), a[1].min(b[1])];
        let own = cell.map(|at| at as usize);
        if self.mesh.is_cut_from_south_west(own) == parts_from_south_west(cell) {
            return plain;
        }
        let across = [a[0] + b[0] - half.corner[0], a[1] + b[1] - half.corner[1]];
        let is_halved =
            |post: Post| self.differs(self.bounds.of(post), self.place(post).distance(self.camera.eye));
        // A square of one cell is never halved.
        match self.bounds.side() == 1 || is_halved(across) && is_halved(half.corner) {
            true => self.mesh.cut(own)[usize::from(half.corner[0] > across[0])],
            false => plain,
        }
    }

    fn place(&self, post: Post) -> DVec3 {
        self.mesh.ground().post(post.map(|at| at as usize))
    }
}
