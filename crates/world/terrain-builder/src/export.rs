//! What a landscape becomes for other generators: heights for a coefficient bank, craters for the feature generator.

use std::collections::BTreeSet;
use std::fmt::Write;

use features::Shape;
use rayon::prelude::*;
use survey::{Affine, Elevation, Frame as FileFrame, Method, Projection};

use crate::crater::{Crater, Nearest, NoNearest};
use crate::ground::Ground;
use crate::height_grid::Area;

/// A landscape in the axes of a bank: x north, y east, origin at the south-west corner of its posts.
#[derive(Debug, Clone)]
pub struct Export {
    /// Heights without the craters of the list, on even posts; the survey fits a bank to them.
    pub elevation: Elevation,
    /// Craters of type 2, one for each crater that has a nearest one. Centres are in the axes of the bank.
    pub craters: Vec<Nearest>,
    /// Number of the feature of each of these craters.
    pub features: Vec<u32>,
    /// Names of features whose craters stay in the heights, with the reason.
    pub kept: BTreeSet<(String, NoNearest)>,
}

impl Export {
    /// Largest difference of height between a crater and its nearest one of type 2 (m).
    pub fn largest_difference(&self) -> f64 {
        self.craters.iter().map(|nearest| nearest.largest_difference).fold(0.0, f64::max)
    }

    /// The craters as a list that the feature generator reads: CSV with a header.
    pub fn crater_list(&self) -> String {
        let mut list = "x_m,y_m,radius_m,depth_m,rim_m,type,outer_m\n".to_owned();
        for Nearest { crater, .. } in &self.craters {
            let ([north, east], foot, outer) = (crater.centre(), crater.foot(), crater.outer());
            // Writing to a text does not fail.
            let _ = writeln!(list, "{north},{east},{foot},{},{},2,{outer}", crater.depth(), crater.rim());
        }
        list
    }
}

impl Ground {
    /// The landscape for other generators. Craters that the feature generator cannot draw (oblique, without
    /// depth, over the border) stay in the heights.
    pub fn exported(&self) -> Export {
        let [corner, far] = self.description().grid.extent();
        let nearest = |crater: &Crater| crater.nearest().and_then(|nearest| inside(nearest, [corner, far]));
        let nearest = self.reliefs().par_iter().map(|relief| relief.crater().map(nearest));
        let nearest: Vec<_> = nearest.collect();
        let (mut craters, mut features, mut kept) = (Vec::new(), Vec::new(), BTreeSet::new());
        for (relief, nearest) in self.reliefs().iter().zip(&nearest) {
            match nearest {
                Some(Ok(nearest)) => {
                    craters.push(moved(nearest, corner));
                    features.push(relief.feature);
                }
                Some(Err(reason)) => {
                    let id = &self.description().features[relief.feature as usize].id;
                    kept.insert((id.clone(), *reason));
                }
                None => {}
            }
        }
        let is_in_heights: Vec<bool> =
            nearest.iter().map(|nearest| !matches!(nearest, Some(Ok(_)))).collect();
        Export { elevation: self.elevation(&is_in_heights), craters, features, kept }
    }

    /// Heights of some reliefs over the base, on even posts.
    fn elevation(&self, is_in_heights: &[bool]) -> Elevation {
        let description = self.description();
        let (grid, frame) = (description.grid, description.frame);
        let [north, east] = [grid.north, grid.east];
        let step = [north.resolution, east.resolution];
        let (lines, columns) = (north.cells + 1, east.cells + 1);
        let height = |index: usize| {
            let post = [index / columns, index % columns];
            let first = [north.first, east.first];
            let place = [0, 1].map(|axis| first[axis] + post[axis] as f64 * step[axis]);
            self.height_of(place, |relief| is_in_heights[relief as usize])
        };
        let heights = (0..lines * columns).into_par_iter().map(height).collect();
        let [latitude, longitude] = frame.centre();
        let method = Method::Equirectangular { parallel: latitude };
        let projection = Projection { method, latitude, longitude, radius: frame.radius(), offset: [0.0; 2] };
        let affine = Affine { first: [north.first, east.first], step };
        let mut elevation =
            Elevation::new(lines, columns, heights, affine, FileFrame::Plane(Some(projection)));
        elevation.title.clone_from(&description.title);
        elevation
    }
}

/// The crater, if it lies wholly inside an area.
fn inside(nearest: Nearest, [low, high]: Area) -> Result<Nearest, NoNearest> {
    let (centre, outer) = (nearest.crater.centre(), nearest.crater.outer());
    let is_inside =
        (0..2).all(|axis| centre[axis] - outer >= low[axis] && centre[axis] + outer <= high[axis]);
    if is_inside { Ok(nearest) } else { Err(NoNearest::Border) }
}

/// The same crater with its centre in the axes of a bank whose origin is `corner`.
fn moved(nearest: &Nearest, corner: [f64; 2]) -> Nearest {
    let crater = &nearest.crater;
    let shape = Shape::RimmedBowl { r1: crater.foot(), r2: crater.outer() };
    let centre = [0, 1].map(|axis| crater.centre()[axis] - corner[axis]);
    match features::Crater::new(centre, shape, crater.depth(), crater.rim()) {
        Ok(crater) => Nearest { crater, ..*nearest },
        // Only a centre 1e9 m away is refused; such a crater was refused before.
        Err(_) => *nearest,
    }
}
