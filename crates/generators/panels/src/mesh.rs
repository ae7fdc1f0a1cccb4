//! Panels: the cells of the posts, each cut in two.

use glam::DVec3;
use photo_drape::Ground;

use crate::parameters::Diagonal;

/// Vertices and panels of the ground, for all frames.
#[derive(Debug)]
pub struct Mesh {
    /// Posts (north, east, up; m), row by row from the south.
    pub vertices: Vec<DVec3>,
    /// Numbers of the corners of each panel, counter-clockwise seen from above; two a cell, cells in the order of their south-western posts.
    pub panels: Vec<[u32; 3]>,
    /// Number of columns of posts.
    columns: usize,
}

impl Mesh {
    /// The panels of posts.
    pub fn new(ground: &Ground, diagonal: Diagonal) -> Self {
        let [rows, columns] = ground.size();
        let posts = (0..rows).flat_map(|row| (0..columns).map(move |column| [row, column]));
        let vertices: Vec<DVec3> = posts.map(|post| ground.post(post)).collect();
        let cells = (0..rows - 1).flat_map(|row| (0..columns - 1).map(move |column| row * columns + column));
        let panels = cells.flat_map(|south_west| cut(&vertices, south_west, columns, diagonal)).collect();
        Self { vertices, panels, columns }
    }

    /// Places of the corners of a panel.
    pub fn corners(&self, panel: usize) -> [DVec3; 3] {
        self.panels[panel].map(|corner| self.vertices[corner as usize])
    }

    /// Number of the panel over a place (north, east; m) of the cell with a south-western post.
    pub fn panel_at(&self, [row, column]: [usize; 2], [up, right]: [f64; 2]) -> usize {
        let first = 2 * (row * (self.columns - 1) + column);
        let south_west = (row * self.columns + column) as u32;
        // A cell that is cut from south-east to north-west has its south-western post in the first panel alone.
        let is_first = match self.panels[first + 1].contains(&south_west) {
            false => up + right <= 1.0,
            true => right >= up,
        };
        first + usize::from(!is_first)
    }
}

/// Both panels of a cell: the first has its south-western and its south-eastern post.
fn cut(vertices: &[DVec3], south_west: usize, columns: usize, diagonal: Diagonal) -> [[u32; 3]; 2] {
    let [sw, se, nw, ne] =
        [south_west, south_west + 1, south_west + columns, south_west + columns + 1].map(|post| post as u32);
    let length = |a: u32, b: u32| vertices[a as usize].distance_squared(vertices[b as usize]);
    match diagonal == Diagonal::Shorter && length(sw, ne) < length(se, nw) {
        true => [[sw, se, ne], [sw, ne, nw]],
        false => [[sw, se, nw], [se, ne, nw]],
    }
}
