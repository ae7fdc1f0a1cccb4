//! What a terrain can be: every value against its range.

use std::fmt;

use rayon::prelude::*;

use crate::blocks::Block;
use crate::contents::{Boulder, Contents, Frame, Map, Range, Shape};
use crate::error::{Unfit, UnfitBlock, expect};
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
pub(crate) fn check(contents: &Contents, tiling: Tiling) -> Result<(), UnfitBlock> {
    let of = |block: Block| move |unfit: Unfit| UnfitBlock { block, unfit };
    check_frame(&contents.frame).map_err(of(Block::Header))?;
    check_ranges(&contents.ranges, tiling.order).map_err(of(Block::Header))?;
    check_places(&contents.places).map_err(of(Block::Places))?;
    check_heights(contents, tiling)?;
    let posts: usize = tiling.posts().iter().product();
    for (key, map) in [("light", &contents.light), ("albedo", &contents.albedo)] {
        let found = map.as_ref().map_or(posts, Map::len);
        expect(
            found == posts,
            key,
            format_args!("{found} numbers"),
            format_args!("{posts} numbers, one a post"),
        )
        .map_err(of(Block::Header))?;
    }
    contents.boulders.iter().enumerate().try_for_each(check_boulder).map_err(of(Block::Boulders))
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
    for (axis, places) in ["x", "y"].into_iter().zip(places) {
        let is_far = |place: &f64| !(-1e9..=1e9).contains(place);
        if let Some(post) = places.iter().position(is_far) {
            let key = format_args!("place along {axis} of post {post}");
            expect(false, key, places[post], "a length within 1e9 m")?;
        }
        let is_before = |pair: &[f64]| pair[1] <= pair[0];
        if let Some(post) = places.windows(2).position(is_before) {
            let [before, found] = [places[post], places[post + 1]];
            let key = format_args!("place along {axis} of post {}", post + 1);
            let expected = format_args!("a length above {before} m, that of the post before it");
            expect(false, key, found, expected)?;
        }
    }
    Ok(())
}

fn check_heights(contents: &Contents, tiling: Tiling) -> Result<(), UnfitBlock> {
    let Contents { heights, step, .. } = contents;
    let [columns, rows] = tiling.posts();
    let of_header = |unfit: Unfit| UnfitBlock { block: Block::Header, unfit };
    expect(heights.len() == columns * rows, "number of heights", heights.len(), columns * rows)
        .and_then(|()| check_step(*step))
        .map_err(of_header)?;
    let most = step.map_or(MOST_HEIGHT, |step| (step * MOST_STEPS).min(MOST_HEIGHT));
    let is_beyond = |height: &f64| !(-most..=most).contains(height);
    let Some(post) = heights.par_iter().position_first(is_beyond) else { return Ok(()) };
    let place = [post % columns, post / columns];
    let key = format_args!("height of post (column {}, row {})", place[0], place[1]);
    expect(false, key, heights[post], format_args!("a length within {most} m"))
        .map_err(|unfit| UnfitBlock { block: Block::Heights(tiling.owner(place)), unfit })
}

/// Whether a step is one.
pub(crate) fn check_step(step: Option<f64>) -> Result<(), Unfit> {
    let is_sound = step.is_none_or(|step| (1e-9..=1e6).contains(&step));
    expect(is_sound, "step", step.unwrap_or_default(), "a length from 1e-9 m to 1e6 m")
}

fn check_boulder((number, boulder): (usize, &Boulder)) -> Result<(), Unfit> {
    let Boulder { centre, radius, shape, yaw, burial, .. } = *boulder;
    let named = |key: &'static str| fmt::from_fn(move |f| write!(f, "{key} of boulder {number}"));
    let is_near = centre.iter().all(|at| at.abs() <= 1e9);
    expect(is_near, named("centre"), format_args!("{centre:?}"), "lengths within 1e9 m")?;
    expect(radius > 0.0 && radius <= 1e5, named("radius"), radius, "a length up to 1e5 m, above 0")?;
    expect(yaw.is_finite(), named("yaw"), yaw, "an angle")?;
    expect((0.0..=0.9).contains(&burial), named("burial"), burial, "a share from 0 to 0.9")?;
    let faces = if let Shape::Rock(faces) = shape { faces } else { 4 };
    expect((4..=64).contains(&faces), named("faces"), faces, "a whole number from 4 to 64")
}
