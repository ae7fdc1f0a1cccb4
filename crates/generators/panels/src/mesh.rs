//! Panels: the cells of the posts, each cut in two.

use std::sync::{Arc, OnceLock};

use glam::DVec3;
use photo_drape::Ground;
use rayon::prelude::*;

use crate::parameters::Diagonal;

/// Vertices and panels of the ground, for all frames. Two panels a cell, cells in the order of their south-western posts.
#[derive(Debug)]
pub struct Mesh {
    ground: Arc<Ground>,
    diagonal: Diagonal,
    /// Corners of all panels, once they are asked for.
    panels: OnceLock<Vec<[u32; 3]>>,
}

impl Mesh {
    /// The panels of posts.
    pub fn new(ground: Arc<Ground>, diagonal: Diagonal) -> Self {
        Self { ground, diagonal, panels: OnceLock::new() }
    }

    /// Posts under the panels.
    pub fn ground(&self) -> &Ground {
        &self.ground
    }

    /// How many panels there are.
    pub fn count(&self) -> usize {
        let [rows, columns] = self.ground().size();
        2 * (rows - 1) * (columns - 1)
    }

    /// A post (north, east, up; m) by its number, row by row from the south.
    pub fn vertex(&self, post: u32) -> DVec3 {
        let columns = self.ground().size()[1];
        self.ground().post([post as usize / columns, post as usize % columns])
    }

    /// Something of each post, row by row from the south.
    pub fn of_vertices<T: Send>(&self, of: impl Fn(usize, DVec3) -> T + Sync) -> Vec<T> {
        let [rows, columns] = self.ground().size();
        let post = |post: usize| of(post, self.ground().post([post / columns, post % columns]));
        (0..rows * columns).into_par_iter().map(post).collect()
    }

    /// Numbers of the corners of each panel, counter-clockwise seen from above.
    pub fn panels(&self) -> &[[u32; 3]] {
        self.panels.get_or_init(|| {
            let [rows, columns] = self.ground().size();
            let cells = (0..rows - 1).flat_map(|row| (0..columns - 1).map(move |column| [row, column]));
            cells.flat_map(|cell| self.cut(cell)).collect()
        })
    }

    /// Places of the corners of a panel.
    pub fn corners(&self, panel: usize) -> [DVec3; 3] {
        let cells = self.ground().size()[1] - 1;
        let cell = [panel / 2 / cells, panel / 2 % cells];
        self.cut(cell)[panel % 2].map(|corner| self.vertex(corner))
    }

    /// Number of the panel over a place (north, east; m) of the cell with a south-western post.
    pub fn panel_at(&self, cell: [usize; 2], [up, right]: [f64; 2]) -> usize {
        let [row, column] = cell;
        let first = 2 * (row * (self.ground().size()[1] - 1) + column);
        let is_first = if self.is_cut_from_south_west(cell) { right >= up } else { up + right <= 1.0 };
        first + usize::from(!is_first)
    }

    /// Whether a cell, by its south-western post, is cut from there to its north-eastern post; otherwise between the others.
    pub fn is_cut_from_south_west(&self, [row, column]: [usize; 2]) -> bool {
        let post = |up: usize, right: usize| self.ground().post([row + up, column + right]);
        self.diagonal == Diagonal::Shorter
            && post(0, 0).distance_squared(post(1, 1)) < post(0, 1).distance_squared(post(1, 0))
    }

    /// Both panels of a cell: the first has its south-western and its south-eastern post.
    pub fn cut(&self, cell: [usize; 2]) -> [[u32; 3]; 2] {
        let columns = self.ground().size()[1];
        let south_west = cell[0] * columns + cell[1];
        let [sw, se, nw, ne] = [south_west, south_west + 1, south_west + columns, south_west + columns + 1]
            .map(|post| post as u32);
        match self.is_cut_from_south_west(cell) {
            true => [[sw, se, ne], [sw, ne, nw]],
            false => [[sw, se, nw], [se, ne, nw]],
        }
    }
}
