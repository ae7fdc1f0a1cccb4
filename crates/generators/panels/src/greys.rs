//! One light a panel, and that of the vertices.

use glam::DVec3;
use photo_drape::{Choice, Drape, Footprint};
use rayon::prelude::*;

use crate::mesh::Mesh;

/// What photographs show of a panel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grey {
    /// Light of the panel, 0 or more.
    pub light: f64,
    /// Where the light comes from.
    pub source: Source,
}

/// Where the light of a panel comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// The mean of so many pixels of a photograph.
    Mean {
        /// Number of the photograph, from 0.
        photograph: usize,
        /// Number of pixels in the mean.
        pixels: u32,
    },
    /// A look at its middle: it is smaller than a pixel, or several photographs are blended.
    Look {
        /// Number of the photograph that weighs most, from 0.
        photograph: usize,
    },
    /// No photograph sees it.
    Unseen,
}

/// What photographs show of a panel; `unseen` is the light of each post where none shows it.
pub fn grey(drape: &Drape, choice: Choice, corners: [DVec3; 3], unseen: &[f32]) -> Grey {
    let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    let normal = drape.ground().normal([middle.x, middle.y]);
    let shown = drape.at(middle, &Footprint::square(normal, area(corners).sqrt()));
    let Some(shown) = shown else {
        let light = drape.ground().between([middle.x, middle.y], |post| [f64::from(unseen[post])]);
        return Grey { light: light[0], source: Source::Unseen };
    };
    let photograph = shown.photograph;
    match drape.mean_in(photograph, corners) {
        Some((light, pixels)) if choice == Choice::Best => {
            Grey { light, source: Source::Mean { photograph, pixels } }
        }
        _ => Grey { light: shown.light, source: Source::Look { photograph } },
    }
}

/// Light of all panels.
pub fn of_panels(drape: &Drape, choice: Choice, mesh: &Mesh, unseen: &[f32]) -> Vec<Grey> {
    (0..mesh.count()).into_par_iter().map(|panel| grey(drape, choice, mesh.corners(panel), unseen)).collect()
}

/// Light of all vertices: the mean of their panels, by area.
pub fn of_vertices(mesh: &Mesh, greys: &[Grey]) -> Vec<f32> {
    let mut sums = vec![[0.0; 2]; mesh.ground().heights().len()];
    for (panel, grey) in greys.iter().enumerate() {
        let area = area(mesh.corners(panel));
        for corner in mesh.panels()[panel] {
            let [sum, areas] = &mut sums[corner as usize];
            (*sum, *areas) = (*sum + area * grey.light, *areas + area);
        }
    }
    sums.into_iter().map(|[sum, areas]| (sum / areas) as f32).collect()
}

/// Area of a panel (m^2).
fn area([a, b, c]: [DVec3; 3]) -> f64 {
    (b - a).cross(c - a).length() / 2.0
}
