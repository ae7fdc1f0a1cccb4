//! What a terrain can be: every value against its range.

use rayon::prelude::*;

use crate::contents::{Boulder, Contents, Frame, Map, Range, Shape};
use crate::error::{Unfit, expect};
use crate::heights::MOST_STEPS;
use crate::tiling::{MOST_ORDER, Tiling};

/// Largest height that is allowed (m).
const MOST_HEIGHT: f64 = 1e9;

/// The tiles of so many posts along x and along y.
pub(crate) fn tiling(order: u32, posts: [usize; 2]) -> Result<Tiling, Unfit> {
    expect((1..=MOST_ORDER).contains(&order), "order", order, "a whole number from 1 to 12")?;
    let side = 1 << order;
    for (key, posts) in [("posts along x", posts[0]), ("posts along y", posts[1])] {
        let is_whole = posts > side && (posts - 1) % side == 0;
        expect(
            is_whole,
            key,
            posts,
            format_args!("a multiple of {side} and one more, for tiles of {side} cells"),
        )?;
    }
    Ok(Tiling { order, counts: posts.map(|posts| (posts - 1) >> order) })
}

/// Whether contents make a terrain.
pub(crate) fn check(contents: &Contents, tiling: Tiling) -> Result<(), Unfit> {
    check_frame(&contents.frame)?;
    check_ranges(&contents.ranges, tiling.order)?;
    check_places(&contents.places)?;
    let posts: usize = tiling.posts().iter().product();
    expect(contents.heights.len() == posts, "number of heights", contents.heights.len(), posts)?;
    check_heights(&contents.heights, contents.step)?;
    for (key, map) in [("light", &contents.light), ("albedo", &contents.albedo)] {
        let found = map.as_ref().map_or(posts, Map::len);
        expect(
            found == posts,
            key,
            format_args!("{found} numbers"),
            format_args!("{posts} numbers, one a post"),
        )?;
    }
    contents.boulders.iter().try_for_each(check_boulder)
}

/// Whether axes stand on a body.
pub(crate) fn check_frame(frame: &Frame) -> Result<(), Unfit> {
    let Frame { radius, latitude, longitude, origin } = *frame;
    expect((1.0..=1e9).contains(&radius), "radius", radius, "a length from 1 m to 1e9 m")?;
    let turn = std::f64::consts::TAU;
    expect(latitude.abs() <= 0.25 * turn, "latitude", latitude, "an angle from -pi/2 to pi/2 rad")?;
    expect(longitude.abs() <= 2.0 * turn, "longitude", longitude, "an angle from -4 pi to 4 pi rad")?;
    let is_near = origin.iter().all(|at| at.abs() <= 1e9);
    expect(is_near, "origin", format_args!("{origin:?}"), "lengths within 1e9 m")
}

/// Whether the ranges of levels rise.
pub(crate) fn check_ranges(ranges: &[Range], order: u32) -> Result<(), Unfit> {
    let most = order as usize + 1;
    expect(
        ranges.len() <= most,
        "number of ranges",
        ranges.len(),
        format_args!("at most {most}, one a level"),
    )?;
    let mut begin = 0.0;
    for &Range { end, share } in ranges {
        expect(
            end > begin && end.is_finite(),
            "end of a range",
            end,
            format_args!("a length above {begin} m"),
        )?;
        expect((0.0..=1.0).contains(&share), "share of a range", share, "a share from 0 to 1")?;
        begin = end;
    }
    Ok(())
}

fn check_places(places: &[Vec<f64>; 2]) -> Result<(), Unfit> {
    for (key, places) in [("place along x", &places[0]), ("place along y", &places[1])] {
        let wrong = places.iter().find(|place| !(-1e9..=1e9).contains(*place));
        expect(wrong.is_none(), key, wrong.unwrap_or(&0.0), "a length within 1e9 m")?;
        let wrong = places.windows(2).find(|pair| pair[1] <= pair[0]);
        let [before, found] = wrong.map_or([0.0; 2], |pair| [pair[0], pair[1]]);
        expect(
            wrong.is_none(),
            key,
            found,
            format_args!("a length above {before} m, that of the post before it"),
        )?;
    }
    Ok(())
}

fn check_heights(heights: &[f64], step: Option<f64>) -> Result<(), Unfit> {
    check_step(step)?;
    let most = step.map_or(MOST_HEIGHT, |step| (step * MOST_STEPS).min(MOST_HEIGHT));
    let wrong = heights.par_iter().find_first(|height| !(-most..=most).contains(*height));
    expect(wrong.is_none(), "height", wrong.unwrap_or(&0.0), format_args!("a length within {most} m"))
}

/// Whether a step is one.
pub(crate) fn check_step(step: Option<f64>) -> Result<(), Unfit> {
    let is_sound = step.is_none_or(|step| (1e-9..=1e6).contains(&step));
    expect(is_sound, "step", step.unwrap_or_default(), "a length from 1e-9 m to 1e6 m")
}

fn check_boulder(boulder: &Boulder) -> Result<(), Unfit> {
    let Boulder { centre, radius, shape, yaw, burial, .. } = *boulder;
    let is_near = centre.iter().all(|at| at.abs() <= 1e9);
    expect(is_near, "centre of a boulder", format_args!("{centre:?}"), "lengths within 1e9 m")?;
    expect(radius > 0.0 && radius <= 1e5, "radius of a boulder", radius, "a length up to 1e5 m, above 0")?;
    expect(yaw.is_finite(), "yaw of a boulder", yaw, "an angle")?;
    expect((0.0..=0.9).contains(&burial), "burial of a boulder", burial, "a share from 0 to 0.9")?;
    let faces = if let Shape::Rock(faces) = shape { faces } else { 4 };
    expect((4..=64).contains(&faces), "faces of a boulder", faces, "a whole number from 4 to 64")
}
