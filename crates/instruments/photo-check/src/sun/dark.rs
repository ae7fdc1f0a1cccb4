//! Which posts are dark in the photograph, and which under a sun.

use landscape::Sun;
use photograph::Photograph;
use rayon::prelude::{IntoParallelIterator, ParallelIterator};

use super::counts::{ACROSS, Counts, TILES, Tiles};
use super::error::SunError;
use crate::Ground;
use crate::relief::Lighting;
use crate::visible::Sight;

/// Light below which a post is dark, as a share of the usual light (chosen).
const SHARE: f64 = 0.1;
/// Fewest posts of a search (chosen).
const FEWEST: usize = 1000;
/// Part of the posts whose light is that of shadow (chosen).
const DARKEST: f64 = 0.001;
/// Part of the posts below the usual light.
const USUAL: f64 = 0.75;
/// Largest light of shadow, as a share of the usual light (chosen).
const MOST_SHADOW: f64 = 0.3;
/// Least and largest share of dark posts (chosen).
const DARK_SHARES: [f64; 2] = [0.002, 0.75];

/// The posts that a photograph shows, and whether each is dark in it.
#[derive(Debug, Clone)]
pub(super) struct Dark {
    /// Column and darkness of the posts of each line.
    lines: Vec<Vec<(usize, bool)>>,
    /// Number of posts that are shown.
    count: usize,
    size: [usize; 2],
}

impl Dark {
    /// The posts of `ground` that `photo` shows.
    ///
    /// # Errors
    /// If the photograph shows too few posts, no shadow, or nothing but shadow.
    pub fn new(ground: &Ground, photo: &Photograph) -> Result<Self, SunError> {
        let size = ground.size();
        let sight = Sight::new(ground, photo);
        let light = |post: [usize; 2]| {
            let point = ground.point(post.map(|at| at as f64), ground.height(post)?)?;
            let light = photo.light_at(point)?;
            (!ground.was_void(post) && !sight.is_hidden(point)).then_some(light)
        };
        let line = |line: usize| {
            let seen = |column| Some((column, light([line, column])?));
            (0..size[1]).filter_map(seen).collect::<Vec<(usize, f64)>>()
        };
        let lights: Vec<Vec<(usize, f64)>> = (0..size[0]).into_par_iter().map(line).collect();
        let dark = Self::below(&lights, edge(&lights)?, size);
        let all = dark.lines.iter().flatten();
        let share = all.filter(|(_, is_dark)| *is_dark).count() as f64 / dark.count as f64;
        let [least, most] = DARK_SHARES;
        match (least..=most).contains(&share) {
            true => Ok(dark),
            false => {
                let [percent, least, most] = [share, least, most].map(|share| 100.0 * share);
                Err(SunError::DarkShare { percent, least, most })
            }
        }
    }

    fn below(lights: &[Vec<(usize, f64)>], edge: f64, size: [usize; 2]) -> Self {
        let line =
            |line: &Vec<(usize, f64)>| line.iter().map(|(column, light)| (*column, *light < edge)).collect();
        Self { lines: lights.iter().map(line).collect(), count: lights.iter().map(Vec::len).sum(), size }
    }

    /// Number of posts that are shown.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Counts of every `stride`-th post each way under `sun`.
    pub fn counts(&self, ground: &Ground, sun: &Sun, stride: usize) -> Tiles {
        let lighting = Lighting::new(ground, sun);
        let lit = |line: usize| {
            let posts = || self.lines[line].iter().filter(|(column, _)| column % stride == 0);
            let lights = lighting.line(line, posts().map(|(column, _)| *column));
            let kept =
                posts().zip(lights).map(|((column, dark), light)| (*column, *dark, light.unwrap_or(0.0)));
            kept.collect::<Vec<_>>()
        };
        let lines: Vec<usize> = (0..self.lines.len()).step_by(stride).collect();
        let lines: Vec<_> = lines.into_par_iter().map(|line| (line, lit(line))).collect();
        let mut all: Vec<f64> = lines.iter().flat_map(|(_, posts)| posts.iter().map(|post| post.2)).collect();
        let edge = SHARE * part(&mut all, USUAL);
        let mut tiles = [Counts::default(); TILES];
        for (line, posts) in &lines {
            for (column, dark, light) in posts {
                let kind = 2 * usize::from(*dark) + usize::from(*light <= edge);
                tiles[self.tile([*line, *column])].0[kind] += 1;
            }
        }
        Tiles(tiles)
    }

    fn tile(&self, post: [usize; 2]) -> usize {
        let [down, across] = [0, 1].map(|axis| post[axis] * ACROSS / self.size[axis]);
        down * ACROSS + across
    }
}

/// Light below which a post of the photograph is dark.
fn edge(lights: &[Vec<(usize, f64)>]) -> Result<f64, SunError> {
    let mut all: Vec<f64> = lights.iter().flatten().map(|(_, light)| *light).collect();
    if all.len() < FEWEST {
        return Err(SunError::Few { found: all.len(), expected: FEWEST });
    }
    let [darkest, usual] = [DARKEST, USUAL].map(|share| part(&mut all, share));
    // A black photograph is as dark as its usual light.
    let share = if usual > 0.0 { darkest / usual } else { 1.0 };
    if share > MOST_SHADOW {
        return Err(SunError::NoShadow { share, most: MOST_SHADOW });
    }
    Ok(darkest + SHARE * (usual - darkest))
}

/// The value below which a part of the values lies; 0 of none.
fn part(values: &mut [f64], share: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let at = ((share * values.len() as f64) as usize).min(values.len() - 1);
    *values.select_nth_unstable_by(at, f64::total_cmp).1
}
