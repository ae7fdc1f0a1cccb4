//! One column of the picture: a ray or an adaptive mean for every line, from the bottom upwards.

use std::array;

use generator::Label;
use scenario::PixelRule;

use crate::ground::Scratch;
use crate::scene::Scene;
use crate::seen::Seen;
use crate::standing::Stand;

/// Step of reflectivity at which the quadrature of a line stops: the last difference between Simpson's rule and
/// the trapezoid in a part of the line, times the part's share of it. An edge inside a line is followed until the
/// part around it is too small to matter, so it shifts the mean by at most twice this figure.
pub const LINE_MEAN_TOLERANCE: f64 = 1e-4;

/// A part of a line whose ranges do not lie evenly may hide a ridge between equal shades; it is looked into down
/// to this share of a line.
pub const RIDGE_SHARE: f64 = 1.0 / 32.0;

/// The smallest part that is looked into, as a share of a line.
const FINEST_SHARE: f64 = 1.0 / 8192.0;

/// Share of a line on either side of an edge of a body that is left to the other side.
const EDGE: f64 = 1e-7;

/// How far the quadrature of a line goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fineness {
    /// Step of reflectivity at which it stops.
    pub tolerance: f64,
    /// Share of a line down to which a part that may hide a ridge is looked into.
    pub ridge_share: f64,
    /// Share of a line below which no part is divided further.
    finest_share: f64,
}

impl Fineness {
    /// That of every picture but those that hold it to account.
    pub const USUAL: Self =
        Self { tolerance: LINE_MEAN_TOLERANCE, ridge_share: RIDGE_SHARE, finest_share: FINEST_SHARE };

    /// Every limit halved so many times.
    pub fn halved(self, times: u32) -> Self {
        let share = libm::ldexp(1.0, -(times as i32));
        Self {
            tolerance: self.tolerance * share,
            ridge_share: self.ridge_share * share,
            finest_share: self.finest_share * share,
        }
    }
}

/// What one pixel holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pixel {
    /// Red, green and blue under the pixel rule, 0 in the sky; equal where there is no colour.
    pub light: [f64; 3],
    /// What is seen at its centre.
    pub seen: Seen,
}

/// What all columns of a frame share.
#[derive(Debug, Clone, Copy)]
pub struct Frame<'a> {
    /// What there is to see.
    pub scene: &'a Scene<'a>,
    /// Half the height of the view-plane.
    pub half_height: f64,
    /// Lines of the picture.
    pub lines: usize,
    /// How far the quadrature of a line goes.
    pub fineness: Fineness,
}

/// A column to be drawn.
#[derive(Debug, Clone)]
pub struct Column<'a> {
    frame: Frame<'a>,
    x: f64,
    bodies: Vec<&'a Stand<'a>>,
    /// Edges of bodies (y), the lowest on the screen first.
    cuts: Vec<f64>,
    scratch: Scratch,
    rays: u64,
}

/// What is seen at one height of the column.
#[derive(Debug, Clone, Copy)]
struct Sample {
    y: f64,
    seen: Seen,
    /// Up to here every higher ray of the column is above the ground (m).
    clear: f64,
}

impl<'a> Column<'a> {
    /// The column at `x` on the screen, positive right.
    pub fn new(frame: Frame<'a>, x: f64) -> Self {
        let bodies = frame.scene.standing().column(x);
        let mut cuts = Vec::new();
        bodies.iter().for_each(|body| body.edges(x, &mut cuts));
        cuts.sort_unstable_by(|a, b| b.total_cmp(a));
        cuts.dedup_by(|a, b| (*a - *b).abs() < 4.0 * EDGE * line_height(&frame));
        Self { frame, x, bodies, cuts, scratch: Scratch::default(), rays: 0 }
    }

    /// All pixels, top line first, and the rays that they took.
    pub fn draw(mut self, rule: PixelRule) -> (Vec<Pixel>, u64) {
        let mut pixels = match rule {
            PixelRule::LineMean => self.means(),
            PixelRule::Centre => self.centres(),
        };
        pixels.reverse();
        (pixels, self.rays)
    }

    fn centres(&mut self) -> Vec<Pixel> {
        let lines = self.frame.lines;
        let mut clear = self.frame.scene.near();
        let pixel = |line: usize| {
            let sample = self.sample(self.y(line as f64 + 0.5), clear);
            clear = sample.clear;
            Pixel { light: sample.seen.light, seen: sample.seen }
        };
        (0..lines).rev().map(pixel).collect()
    }

    fn means(&mut self) -> Vec<Pixel> {
        let lines = self.frame.lines;
        let mut bottom = self.sample(self.y(lines as f64), self.frame.scene.near());
        let pixel = |line: usize| {
            let centre = self.sample(self.y(line as f64 + 0.5), bottom.clear);
            let top = self.sample(self.y(line as f64), centre.clear);
            let light = sum(self.half(&bottom, &centre), self.half(&centre, &top));
            bottom = top;
            Pixel { light, seen: centre.seen }
        };
        (0..lines).rev().map(pixel).collect()
    }

    /// Place on the screen, positive down, of a place counted in lines from the top.
    fn y(&self, lines: f64) -> f64 {
        self.frame.half_height * (2.0 * lines / self.frame.lines as f64 - 1.0)
    }

    /// Integral over half a line, part by part between edges of bodies.
    fn half(&mut self, low: &Sample, high: &Sample) -> [f64; 3] {
        let first = self.cuts.partition_point(|&cut| cut >= low.y);
        let count = self.cuts[first..].partition_point(|&cut| cut > high.y);
        if count == 0 {
            return self.integral(low, high, 0.5);
        }
        let line = line_height(&self.frame);
        let (mut from, mut light) = (*low, [0.0; 3]);
        for index in first..first + count {
            let cut = self.cuts[index];
            let before = self.sample((cut + EDGE * line).min(low.y), from.clear);
            light = sum(light, self.integral(&from, &before, (from.y - before.y) / line));
            from = self.sample((cut - EDGE * line).max(high.y), before.clear);
        }
        sum(light, self.integral(&from, high, (from.y - high.y) / line))
    }

    /// Adaptive Simpson's rule over a part of a line that covers `share` of it.
    fn integral(&mut self, low: &Sample, high: &Sample, share: f64) -> [f64; 3] {
        let middle = self.sample(0.5 * (low.y + high.y), low.clear);
        let fineness = self.frame.fineness;
        if share <= fineness.finest_share || settled([low, &middle, high], share, &fineness) {
            let [low, middle, high] = [low, &middle, high].map(|sample| sample.seen.light);
            return array::from_fn(|channel| {
                share * (low[channel] + 4.0 * middle[channel] + high[channel]) / 6.0
            });
        }
        let half = 0.5 * share;
        sum(self.integral(low, &middle, half), self.integral(&middle, high, half))
    }

    fn sample(&mut self, y: f64, clear: f64) -> Sample {
        self.rays += 1;
        let (seen, clear) = self.frame.scene.look([self.x, y], &self.bodies, clear, &mut self.scratch);
        Sample { y, seen, clear }
    }
}

fn line_height(frame: &Frame) -> f64 {
    2.0 * frame.half_height / frame.lines as f64
}

fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    array::from_fn(|channel| a[channel] + b[channel])
}

/// Whether shade, in every colour, is as good as known between three samples, and ranges do not betray a ridge.
fn settled([low, middle, high]: [&Sample; 3], share: f64, fineness: &Fineness) -> bool {
    let bend = |value: &dyn Fn(&Sample) -> f64| (value(low) - 2.0 * value(middle) + value(high)).abs();
    // Over level ground the inverse range is linear in y.
    let nearness = |sample: &Sample| 1.0 / sample.seen.range;
    let ridge = bend(&nearness) > 0.5 * (nearness(low) - nearness(high)).abs();
    // Water is drawn again by its area.
    if [low, middle, high].iter().all(|sample| sample.seen.label == Label::Sea) {
        return true;
    }
    let is_known =
        |channel: usize| bend(&|sample| sample.seen.light[channel]) * share / 6.0 <= fineness.tolerance;
    (0..3).all(is_known) && !(ridge && share > fineness.ridge_share)
}
