//! How far the ground of a frame is off the finest mesh, post by post.
//!
//! **Law.** At each post of the finest mesh that lies inside the picture, the height of the drawn surface is held against that of the post.
//! Hidden posts count too. Heights are those on the map: the drop of the lunoid, which a coarse cell follows by a chord, is left out. It
//! is at most `cell^2 / 8 R`.

use generator::GroundLoss;
use glam::{DVec2, DVec3};
use lod_tiles::{Surface, Tile};
use rayon::prelude::*;
use scene_sampler::{Camera, NEAR};

use crate::prepared::{Prepared, focal};

/// How far `tiles` of `surface` are off the finest mesh, as `camera` sees them.
pub fn loss(prepared: &Prepared, surface: &Surface<'_>, camera: &Camera, tiles: Vec<Tile>) -> GroundLoss {
    let focal = focal(&prepared.stage);
    let view = &prepared.stage.view;
    let size = [view.columns, view.lines].map(f64::from);
    let parts: Vec<GroundLoss> =
        tiles.into_par_iter().map(|tile| of_tile(surface, tile, camera, (size, focal))).collect();
    // In the order of the tiles, whichever thread was first.
    let mut whole = GroundLoss::default();
    parts.iter().for_each(|part| whole.join(part));
    whole
}

/// The same of the posts of a tile. Those on its northern and eastern edge are its neighbours'.
fn of_tile(surface: &Surface<'_>, tile: Tile, camera: &Camera, (size, focal): ([f64; 2], f64)) -> GroundLoss {
    let cells = surface.terrain.cells(0);
    let mut loss = GroundLoss::default();
    for at in (0..cells).flat_map(|j| (0..cells).map(move |i| [i, j])) {
        let place = surface.terrain.place(tile, 0, at);
        let seen = |up: f64| {
            let camera_axes = camera.place(DVec3::new(place[1], place[0], up));
            (camera_axes.z > NEAR).then(|| (camera_axes, camera.projection.project(camera_axes)))
        };
        let finest = surface.terrain.height(tile, 0, at);
        let is_inside = |at: &[f64; 2]| (0..2).all(|axis| (0.0..size[axis]).contains(&at[axis]));
        let Some((from_eye, true_place)) = seen(finest).filter(|(_, at)| is_inside(at)) else { continue };
        let drawn = surface.under(place);
        let distance = (from_eye / DVec3::new(1.0, camera.squeeze(), 1.0)).length();
        loss.posts += 1;
        loss.metres.add(drawn - finest);
        loss.pixels.add((drawn - finest) * focal / distance);
        // Drawn ground behind the eye is in no picture.
        if let Some((_, drawn_place)) = seen(drawn) {
            let moved = DVec2::from_array(drawn_place) - DVec2::from_array(true_place);
            loss.moved.add(moved.length());
        }
    }
    loss
}
