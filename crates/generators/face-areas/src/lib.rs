//! Faces drawn by area and depth, without sampling points: what generators of triangles are judged by.
//!
//! ```text
//!  faces of a frame (FaceScene) --> those of each pixel --> pieces that all their faces cover --> split where planes cross
//!                                                                                                        \--> light by area
//! ```
//!
//! # Law
//!
//! - **Areas.** A pixel is cut by the edges of its faces into convex pieces, in f64. A piece lies wholly under each of its faces, or
//!   wholly beside it.
//! - **Depth.** `q = 1/w` is linear on the screen, so two planes cross along a straight line there: pieces are cut along it. In what is
//!   left each face is nearer or farther all over. Of faces equally near, within the scene's `coincidence`, the higher priority is seen, then
//!   the lower id.
//! - **Light** (EP-0611021, claim 4): the sum of each face's own light times the product of all nearer translucencies, without limit. It is
//!   integrated over each triangle of a piece by the middles of its sides, which is exact for light that is quadratic there.
//! - Behind everything is black ([`draw`]), or what [`Mean::through`] lets through ([`mean()`]).
//!
//! **Error.** Of areas and crossings: rounding of f64. Of light that is no polynomial over a pixel, as colours in perspective: third order
//! in the size of the piece.
//!
//! # Threads
//!
//! Rows of pixels are independent; the bits do not depend on the number of threads.

mod grid;
mod mean;
mod piece;
mod pixel;

use generator::FaceScene;
use rayon::prelude::*;

use crate::grid::Rows;
use crate::pixel::Pixel;

pub use crate::mean::Mean;

/// Mean light (linear red, green, blue) of each pixel of a screen of `columns` x `lines`, row by row, by the threads of the current pool.
pub fn draw(scene: &FaceScene, [columns, lines]: [usize; 2]) -> Vec<[f64; 3]> {
    let rows = Rows::of(&scene.faces, lines);
    let row = |line: usize| {
        let faces = rows.of_line(line);
        let pixel = |column: usize| Pixel::new(scene, faces, [column, line]).mean().light;
        (0..columns).map(pixel).collect::<Vec<_>>()
    };
    (0..lines).into_par_iter().flat_map_iter(row).collect()
}

/// What the faces of some numbers make of the pixel in a column and a line.
pub fn mean(scene: &FaceScene, faces: &[u32], at: [usize; 2]) -> Mean {
    Pixel::new(scene, faces, at).mean()
}

/// Orders the faces of some numbers near to far at a place (pixels) that they cover.
pub fn near_to_far(scene: &FaceScene, faces: &mut [u32], place: [f64; 2]) {
    let face = |number: u32| &scene.faces[number as usize];
    let order = |number: u32| (-face(number).priority, face(number).id);
    pixel::near_to_far(faces, |number| face(number).nearness(place), order, scene.coincidence);
}

/// What faces in their order, near to far, make of a place (pixels) that they cover.
pub fn seen(scene: &FaceScene, faces: &[u32], place: [f64; 2]) -> Mean {
    pixel::seen(scene, faces.iter().copied(), place)
}
