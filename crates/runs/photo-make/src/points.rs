//! Control points of a photograph: ground points of a lattice of pixels.

use std::fmt::Write;

use crate::Made;

/// Control points along each side of the picture.
const ALONG: usize = 5;

/// Name, ground point and pixel of each control point, as a table that `lunoid photo check` reads. Numbers read back as the same
/// ones.
pub fn points(made: &Made) -> String {
    let [columns, lines] = [made.picture.columns(), made.picture.lines()];
    let middle = |part: usize, count: usize| (2 * part + 1) * count / (2 * ALONG);
    let lattice = (0..ALONG).flat_map(|down| (0..ALONG).map(move |across| [across, down]));
    let mut text = String::from("name,east_m,north_m,height_m,i_px,j_px\n");
    for [across, down] in lattice {
        let (column, line) = (middle(across, columns), middle(down, lines));
        if let Some(point) = made.ground[line * columns + column] {
            let [i, j] = [column, line].map(|at| at as f64 + 0.5);
            writeln!(text, "p{down}{across},{},{},{},{i},{j}", point.x, point.y, point.z)
                .expect("a String takes everything");
        }
    }
    text
}
