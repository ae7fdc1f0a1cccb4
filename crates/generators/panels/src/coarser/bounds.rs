//! How far panels lie beside the triangles that a post halves, and in what sphere.

use glam::DVec3;
use rayon::prelude::*;
use scenario::Curvature;

use super::half::{Half, Post, parts_from_south_west};
use crate::mesh::Mesh;

/// What a bound grows by for the rounding of its own figures, as a share.
const ROUNDING: f32 = 1e-6;

/// The bound of one post.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// How far (m) panels lie above or below the triangles that the post halves, at most; infinite where the ground's border cuts them.
    pub error: f32,
    /// Distance (m) from the post up to which those panels and the bounds of all posts below reach.
    pub radius: f32,
}

impl Bound {
    /// Bound of what the ground's border cuts: such a triangle is halved whatever the eye sees.
    pub const BORDER: Self = Self { error: f32::INFINITY, radius: f32::INFINITY };
}

/// The bounds of all posts that halve triangles.
#[derive(Debug)]
pub struct Bounds {
    /// Row by row from the south.
    bounds: Vec<Bound>,
    size: [usize; 2],
    /// Cells along a side of the square, a power of two.
    side: u32,
    curvature: Curvature,
}

impl Bounds {
    /// The bounds of the posts of `mesh` on a Moon with `curvature`.
    pub fn new(mesh: &Mesh, curvature: Curvature) -> Self {
        let size = mesh.ground().size();
        let side = (size[0].max(size[1]) - 1).next_power_of_two() as u32;
        let bounds = vec![Bound { error: 0.0, radius: 0.0 }; size[0] * size[1]];
        let mut all = Self { bounds, size, side, curvature };
        let mut step = 1;
        while step < side {
            // Posts in the middle of a side of a square of two steps, then those in the middle of the square.
            all.fill(mesh, step, |post| (post[0] + post[1]) % 2 == 1);
            all.fill(mesh, step, |post| post[0] % 2 == 1 && post[1] % 2 == 1);
            step *= 2;
        }
        all
    }

    /// Cells along a side of the square.
    pub fn side(&self) -> u32 {
        self.side
    }

    /// The last post of the ground.
    pub fn last(&self) -> Post {
        self.size.map(|posts| posts as u32 - 1)
    }

    /// Curvature of the Moon that they hold for.
    pub fn curvature(&self) -> Curvature {
        self.curvature
    }

    /// The bound of a post. It is infinite where the post lies beyond the ground.
    pub fn of(&self, post: Post) -> Bound {
        self.number(post).map_or(Bound::BORDER, |number| self.bounds[number])
    }

    fn number(&self, post: Post) -> Option<usize> {
        let last = self.last();
        (post[0] <= last[0] && post[1] <= last[1]).then(|| post[0] as usize * self.size[1] + post[1] as usize)
    }

    /// Fills the bounds of those posts, `step` apart, that `is_meant` takes by their numbers of steps.
    fn fill(&mut self, mesh: &Mesh, step: u32, is_meant: impl Fn(Post) -> bool + Sync) {
        let [rows, columns] = self.last().map(|last| last / step);
        let in_row = |row: u32| -> Vec<(u32, Bound)> {
            let meant = (0..=columns).filter(|column| is_meant([row, *column]));
            meant.map(|column| (column, self.found(mesh, [row, column], step))).collect()
        };
        let found: Vec<_> = (0..=rows).into_par_iter().map(in_row).collect();
        for (row, found) in (0..).zip(found) {
            for (column, bound) in found {
                self.bounds[(row * step) as usize * self.size[1] + (column * step) as usize] = bound;
            }
        }
    }

    /// The bound of the post that is so many steps from the first, by the bounds below it.
    fn found(&self, mesh: &Mesh, steps: Post, step: u32) -> Bound {
        let halved = halved(steps, step, self.side);
        if halved.iter().flatten().any(|half| half.is_over_border(self.last())) {
            return Bound::BORDER;
        }
        let post = steps.map(|at| at * step);
        let place = |post: Post| mesh.ground().post(post.map(|at| at as usize));
        let here = place(post);
        // Both triangles have the same longest side.
        let ends = halved.iter().flatten().find(|half| !half.is_beside(self.last()));
        let Some([a, b]) = ends.map(|half| half.ends.map(place)) else { return Bound::BORDER };
        let sag = 2.0 * self.curvature.drop(a.truncate().distance(b.truncate()) / 2.0);
        let own = (here.z - (a.z + b.z) / 2.0).abs() + sag;
        let below = match step == 1 && steps[0] % 2 != steps[1] % 2 {
            true => self.of_cells(mesh, post, here),
            false => self.of_halves(mesh, halved, here),
        };
        Bound {
            error: (own as f32 + below.error) * (1.0 + ROUNDING),
            radius: below.radius * (1.0 + ROUNDING),
        }
    }

    /// What halves of triangles are bound by.
    fn of_halves(&self, mesh: &Mesh, halved: [Option<Half>; 2], here: DVec3) -> Bound {
        let mut all = Bound { error: 0.0, radius: 0.0 };
        for half in halved.into_iter().flatten().filter(|half| !half.is_beside(self.last())) {
            let Some(middle) = half.middle() else { continue };
            for post in half.halves(middle).into_iter().filter_map(|half| half.middle()) {
                let (bound, place) = (self.of(post), mesh.ground().post(post.map(|at| at as usize)));
                all.error = all.error.max(bound.error);
                all.radius = all.radius.max(here.distance(place) as f32 * (1.0 + ROUNDING) + bound.radius);
            }
        }
        all
    }

    /// What the cells around a post are bound by: half a cell is no panel where the mesh cuts that cell the other way.
    fn of_cells(&self, mesh: &Mesh, post: Post, here: DVec3) -> Bound {
        let mut all = Bound { error: 0.0, radius: 0.0 };
        let last = self.last();
        for [south, west] in [[1, 1], [1, 0], [0, 1], [0, 0]] {
            if post[0] < south || post[1] < west {
                continue;
            }
            let cell = [post[0] - south, post[1] - west];
            if cell[0] >= last[0] || cell[1] >= last[1] {
                continue;
            }
            let corner = |up: u32, right: u32| {
                mesh.ground().post([cell[0] + up, cell[1] + right].map(|at| at as usize))
            };
            let corners = [corner(0, 0), corner(0, 1), corner(1, 0), corner(1, 1)];
            let reach = corners.iter().map(|corner| here.distance(*corner) as f32);
            all.radius = reach.fold(all.radius, f32::max);
            if mesh.is_cut_from_south_west(cell.map(|at| at as usize)) != parts_from_south_west(cell) {
                let [sw, se, nw, ne] = corners.map(|corner| corner.z);
                all.error = all.error.max(((sw + ne - se - nw) / 2.0).abs() as f32);
            }
        }
        all
    }
}

/// The triangles of a square of `side` cells that the post in the middle of their longest side halves; the post by its number of steps.
fn halved(steps: Post, step: u32, side: u32) -> [Option<Half>; 2] {
    let at = |north: i64, east: i64| {
        let place = [i64::from(steps[0]) + north, i64::from(steps[1]) + east].map(|at| at * i64::from(step));
        let inside = place.iter().all(|at| (0..=i64::from(side)).contains(at));
        inside.then(|| place.map(|at| at as u32))
    };
    let half = |a: [i64; 2], b: [i64; 2], corner: [i64; 2]| {
        let [a, b, corner] = [a, b, corner].map(|[north, east]| at(north, east));
        Some(Half { ends: [a?, b?], corner: corner? })
    };
    match (steps[0] % 2 == 1, steps[1] % 2 == 1) {
        // In the middle of a square of two steps.
        (true, true) => match parts_from_south_west(steps.map(|at| at / 2)) {
            true => [half([1, 1], [-1, -1], [-1, 1]), half([-1, -1], [1, 1], [1, -1])],
            false => [half([1, -1], [-1, 1], [1, 1]), half([-1, 1], [1, -1], [-1, -1])],
        },
        // In the middle of a side from the south to the north.
        (true, false) => [half([1, 0], [-1, 0], [0, 1]), half([-1, 0], [1, 0], [0, -1])],
        // In the middle of a side from the west to the east.
        _ => [half([0, -1], [0, 1], [1, 0]), half([0, 1], [0, -1], [-1, 0])],
    }
}
