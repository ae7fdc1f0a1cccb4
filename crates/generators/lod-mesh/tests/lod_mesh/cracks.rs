//! Ground that fills a picture hides all of the sky: what shines through is a crack.

use lod_mesh::Parameters;
use lod_tiles::{Edges, Stitch};
use quantities::unit_interval;
use raster::Pattern;

use crate::shots::{SIDE, draw, pose, run, session, sky, stage};

const PIXELS: usize = 128;

/// Tiles of 4 cells of 10 m with three levels.
fn near() -> Parameters {
    let mut run = Parameters { order: 2, levels: Some(3), ranges: vec![110.0, 220.0, 330.0], ..run() };
    run.sampling.pattern = Pattern::One;
    run
}

/// Pixels of sky in `views` random views that look down so far that all of them ends on the ground.
fn holes(run: Parameters, views: u64) -> usize {
    let stage = stage(PIXELS as u32);
    let landscape = stage.landscape.clone();
    let session = session(stage, run);
    let one = |view: u64| {
        let random = |word: u64| unit_interval(view, &[word]);
        let above = 30.0 + 90.0 * random(0);
        // The uppermost ray sinks by 0.3 m a metre, and relief is within 60 m.
        let reach = (above + 60.0) / 0.3;
        let [x, y] = [1, 2].map(|word| reach + (SIDE - 2.0 * reach) * random(word));
        let eye = [x, y, landscape.height(x, y).unwrap() + above];
        sky(&draw(&*session, PIXELS, &pose(eye, 360.0 * random(3), -45.0)))
    };
    (0..views).map(one).sum()
}

#[test]
fn nothing_shines_through_in_1000_views() {
    assert_eq!(holes(near(), 1000), 0);
}

#[test]
fn the_finer_tile_may_adapt_as_well() {
    assert_eq!(holes(Parameters { stitch: Stitch::FineSide, ..near() }, 100), 0);
}

#[test]
fn tiles_that_decide_for_themselves_crack() {
    assert!(holes(Parameters { edges: Edges::PerTile, ..near() }, 100) > 0);
}

#[test]
fn tiles_that_are_not_stitched_leave_holes() {
    assert!(holes(Parameters { stitch: Stitch::None, ..near() }, 100) > 0);
}
