//! The overlap of many suns, closer and closer around the best.

use std::f64::consts::PI;

use landscape::Sun;
use quantities::radians;
use rayon::prelude::{IntoParallelIterator, ParallelIterator};

use super::counts::Tiles;
use super::dark::Dark;
use super::error::SunError;
use crate::Ground;

/// Azimuths of the first search.
const AZIMUTHS: usize = 36;
/// Elevations of the first search: their number, the lowest and the highest (deg).
const ELEVATIONS: (usize, [f64; 2]) = (12, [1.0, 80.0]);
/// Posts of the first search and of a closer one, at most (chosen).
const POSTS: [usize; 2] = [4000, 40_000];
/// Suns on each side of the best in a closer search.
const BESIDE: i32 = 3;
/// Times that the step is halved.
const CLOSER: u32 = 5;
/// Least correlation of dark posts that tells a sun (chosen).
const LEAST_OVERLAP: f64 = 0.1;

/// The suns of one search, around the best of the one before, with their counts.
#[derive(Debug, Clone)]
pub(super) struct Found {
    /// The sun in the middle.
    pub middle: Sun,
    /// Step of azimuth (rad), and ratio of one elevation to the one below.
    pub step: [f64; 2],
    /// Steps from the middle, with the counts of that sun.
    pub tried: Vec<([f64; 2], Tiles)>,
}

impl Found {
    /// Half of the window (rad): how far it reaches in azimuth, and upwards in elevation.
    pub fn reach(&self) -> [f64; 2] {
        let steps = f64::from(BESIDE);
        [steps * self.step[0], self.sun([0.0, steps]).elevation - self.middle.elevation]
    }

    /// The sun so many steps of azimuth and elevation from the middle.
    pub fn sun(&self, steps: [f64; 2]) -> Sun {
        moved(self.middle, self.step, steps)
    }
}

/// Searches for the sun whose shadows overlap best with the dark posts: windows, each closer than the one before.
///
/// # Errors
/// If shadows of no sun overlap.
pub(super) fn search(ground: &Ground, dark: &Dark) -> Result<Vec<Found>, SunError> {
    let (count, [low, high]) = ELEVATIONS;
    let ratio = libm::pow(high / low, 1.0 / (count - 1) as f64);
    let step = [2.0 * PI / AZIMUTHS as f64, ratio];
    let lowest = Sun { azimuth: 0.0, elevation: radians(low) };
    let whole: Vec<[i32; 2]> =
        (0..AZIMUTHS as i32).flat_map(|azimuth| (0..count as i32).map(move |up| [azimuth, up])).collect();
    let [first, closer] = POSTS.map(|most| stride(dark, most));
    let around: Vec<[i32; 2]> =
        (-BESIDE..=BESIDE).flat_map(|azimuth| (-BESIDE..=BESIDE).map(move |up| [azimuth, up])).collect();
    let mut found = try_all(ground, dark, Found { middle: lowest, step, tried: Vec::new() }, &whole, first);
    let mut windows = Vec::new();
    for _ in 0..CLOSER {
        let [azimuth, ratio] = found.step;
        let next = Found { middle: best(&found)?, step: [0.5 * azimuth, ratio.sqrt()], tried: Vec::new() };
        found = try_all(ground, dark, next, &around, closer);
        windows.push(found.clone());
    }
    Ok(windows)
}

/// Every how many posts a search of at most so many looks at.
fn stride(dark: &Dark, most: usize) -> usize {
    ((dark.count() as f64 / most as f64).sqrt().ceil() as usize).max(1)
}

/// Adds the counts of the suns that lie so many steps from the middle, those above the zenith left out.
fn try_all(ground: &Ground, dark: &Dark, around: Found, steps: &[[i32; 2]], stride: usize) -> Found {
    let suns = steps.iter().map(|steps| steps.map(f64::from));
    let suns: Vec<([f64; 2], Sun)> = suns.map(|steps| (steps, around.sun(steps))).collect();
    let suns = suns.into_par_iter().filter(|(_, sun)| sun.elevation < 0.5 * PI);
    let tried = suns.map(|(steps, sun)| (steps, dark.counts(ground, &sun, stride))).collect();
    Found { tried, ..around }
}

/// The best sun of those that were tried; the first of equals.
fn best(found: &Found) -> Result<Sun, SunError> {
    let overlaps = found.tried.iter().map(|(steps, tiles)| (*steps, tiles.total().overlap().unwrap_or(-1.0)));
    let best = overlaps.reduce(|best, next| if next.1 > best.1 { next } else { best });
    match best {
        Some((steps, overlap)) if overlap >= LEAST_OVERLAP => Ok(found.sun(steps)),
        other => {
            Err(SunError::NoOverlap { best: other.map_or(-1.0, |(_, best)| best), least: LEAST_OVERLAP })
        }
    }
}

fn moved(from: Sun, [azimuth, ratio]: [f64; 2], [turn, up]: [f64; 2]) -> Sun {
    Sun { azimuth: from.azimuth + turn * azimuth, elevation: from.elevation * libm::pow(ratio, up) }
}
