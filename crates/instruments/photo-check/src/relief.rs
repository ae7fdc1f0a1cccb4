//! An elevation grid as a picture: its light under a sun.

use landscape::Sun;
use quantities::sin_cos;
use rayon::prelude::{IntoParallelIterator, ParallelIterator};

use crate::Ground;

/// The light of every post.
#[derive(Debug, Clone, PartialEq)]
pub struct Relief {
    lights: Vec<f64>,
    columns: usize,
}

/// How a sun lights the posts of a ground.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lighting<'a> {
    ground: &'a Ground,
    sun: Sun,
    /// Highest post (m): above it nothing stands before the sun.
    highest: f64,
}

/// The way to the sun over the grid.
struct Way {
    /// Lines and columns of one step.
    step: [f64; 2],
    /// Rise of one step (m).
    rise: f64,
    /// Height of the highest post (m).
    highest: f64,
}

impl Relief {
    /// The light of `ground` under `sun`, whose azimuth counts from the grid's north.
    pub fn new(ground: &Ground, sun: &Sun) -> Self {
        let [lines, columns] = ground.size();
        let lighting = Lighting::new(ground, sun);
        let line = |line: usize| lighting.line(line, 0..columns).map(|light| light.unwrap_or(f64::NAN));
        let lines = (0..lines).into_par_iter().map(|at| line(at).collect::<Vec<_>>());
        Self { lights: lines.flatten_iter().collect(), columns }
    }

    /// Light of a post, 0 to 1; none where a void stays.
    pub fn light(&self, [line, column]: [usize; 2]) -> Option<f64> {
        let light = self.lights[line * self.columns + column];
        (!light.is_nan()).then_some(light)
    }
}

impl<'a> Lighting<'a> {
    /// The lighting of `ground` by `sun`, whose azimuth counts from the grid's north.
    pub fn new(ground: &'a Ground, sun: &Sun) -> Self {
        let known = ground.filling.heights.iter().copied().filter(|height| !height.is_nan());
        Self { ground, sun: *sun, highest: known.fold(f64::NEG_INFINITY, f64::max) }
    }

    /// Light of some posts of a line, 0 to 1; none where a void stays.
    pub fn line<'b, I>(
        &'b self,
        line: usize,
        columns: I,
    ) -> impl Iterator<Item = Option<f64>> + use<'a, 'b, I>
    where
        I: IntoIterator<Item = usize> + 'b,
    {
        let way = Way::new(self.ground.steps(line as f64), &self.sun, self.highest);
        columns.into_iter().map(move |column| self.light([line, column], &way))
    }

    fn light(&self, post: [usize; 2], way: &Way) -> Option<f64> {
        let height = self.ground.height(post)?;
        let lit = self.sun.reflectivity(slopes(self.ground, post));
        Some(if lit > 0.0 && way.is_dark(self.ground, post, height) { 0.0 } else { lit })
    }
}

/// Slopes to the north and to the east (m/m): central where both neighbours are known, else from one side, else 0.
fn slopes(ground: &Ground, [line, column]: [usize; 2]) -> [f64; 2] {
    let [north, east] = ground.steps(line as f64);
    let size = ground.size();
    let along = |axis: usize, metres: f64| {
        let at = [line, column][axis];
        let beside = |at: usize| {
            let mut post = [line, column];
            post[axis] = at;
            Some((at as f64, ground.height(post)?))
        };
        let here = beside(at);
        let before = at.checked_sub(1).and_then(beside).or(here);
        let after = if at + 1 < size[axis] { beside(at + 1).or(here) } else { here };
        match (before, after) {
            (Some((from, low)), Some((to, high))) if to > from => (high - low) / ((to - from) * metres),
            _ => 0.0,
        }
    };
    [along(0, north), along(1, east)]
}

impl Way {
    /// Steps of one post along the axis that the sun's azimuth follows more.
    fn new([north, east]: [f64; 2], sun: &Sun, highest: f64) -> Self {
        let (sin_a, cos_a) = sin_cos(sun.azimuth);
        let (sin_e, cos_e) = sin_cos(sun.elevation);
        let per_metre = [cos_a / north, sin_a / east];
        let metres = 1.0 / per_metre[0].abs().max(per_metre[1].abs());
        Self { step: per_metre.map(|posts| posts * metres), rise: metres * sin_e / cos_e.max(1e-12), highest }
    }

    /// Whether ground of the grid stands between a post and the sun.
    fn is_dark(&self, ground: &Ground, [line, column]: [usize; 2], height: f64) -> bool {
        let (mut at, mut ray) = ([line as f64, column as f64], height);
        let end = ground.size().map(|count| (count - 1) as f64);
        loop {
            ray += self.rise;
            at = [at[0] + self.step[0], at[1] + self.step[1]];
            let inside = (0.0..=end[0]).contains(&at[0]) && (0.0..=end[1]).contains(&at[1]);
            if !inside || ray >= self.highest {
                return false;
            }
            if ground.height_between(at).is_some_and(|ground| ground > ray) {
                return true;
            }
        }
    }
}
