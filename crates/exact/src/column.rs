//! One column of the picture: a ray or an adaptive mean for every line, from the bottom upwards.

use landscape::{Landscape, Sun};
use scenario::PixelRule;

use crate::{Outlook, Sight, Spot, View};

/// Step of reflectivity at which the quadrature of a line stops: the last difference between Simpson's rule and
/// the trapezoid in a part of the line, times the part's share of it. An edge inside a line is followed until the
/// part around it is too small to matter, so it shifts the mean by at most twice this figure.
pub const LINE_MEAN_TOLERANCE: f64 = 1e-4;

/// A part of a line whose ranges do not lie evenly may hide a ridge between equal shades; it is looked into down
/// to this share of a line.
pub const RIDGE_SHARE: f64 = 1.0 / 32.0;

/// The smallest part that is looked into, as a share of a line.
const FINEST_SHARE: f64 = 1.0 / 8192.0;

/// What one pixel holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pixel {
    /// Reflectivity under the pixel rule, 0 in the sky.
    pub intensity: f64,
    /// Ground range at the centre (m), infinite in the sky.
    pub range: f64,
}

/// What all columns of a frame share.
#[derive(Debug, Clone, Copy)]
pub struct Frame<'a> {
    /// The ground around the eye.
    pub outlook: &'a Outlook<'a>,
    /// From view-plane to rays.
    pub view: &'a View,
    /// Slopes and albedo.
    pub landscape: &'a Landscape,
    /// The light.
    pub sun: &'a Sun,
    /// Half the height of the view-plane.
    pub half_height: f64,
    /// Lines of the picture.
    pub lines: usize,
}

/// A column to be drawn.
#[derive(Debug, Clone)]
pub struct Column<'a> {
    frame: Frame<'a>,
    x: f64,
    rays: u64,
}

/// What is seen at one height of the column.
#[derive(Debug, Clone, Copy)]
struct Sample {
    y: f64,
    intensity: f64,
    range: f64,
    /// Up to here every higher ray of the column is above the ground (m).
    clear: f64,
}

impl<'a> Column<'a> {
    /// The column at `x` on the view-plane, positive right.
    pub fn new(frame: Frame<'a>, x: f64) -> Self {
        Self { frame, x, rays: 0 }
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
        let mut clear = self.frame.outlook.near();
        let pixel = |line: usize| {
            let sample = self.sample(self.y(line as f64 + 0.5), clear);
            clear = sample.clear;
            Pixel { intensity: sample.intensity, range: sample.range }
        };
        (0..lines).rev().map(pixel).collect()
    }

    fn means(&mut self) -> Vec<Pixel> {
        let lines = self.frame.lines;
        let mut bottom = self.sample(self.y(lines as f64), self.frame.outlook.near());
        let pixel = |line: usize| {
            let centre = self.sample(self.y(line as f64 + 0.5), bottom.clear);
            let top = self.sample(self.y(line as f64), centre.clear);
            let intensity = self.integral(&bottom, &centre, 0.5) + self.integral(&centre, &top, 0.5);
            bottom = top;
            Pixel { intensity, range: centre.range }
        };
        (0..lines).rev().map(pixel).collect()
    }

    /// Place on the view-plane, positive down, of a place counted in lines from the top.
    fn y(&self, lines: f64) -> f64 {
        self.frame.half_height * (2.0 * lines / self.frame.lines as f64 - 1.0)
    }

    /// Adaptive Simpson's rule over a part of a line that covers `share` of it.
    fn integral(&mut self, low: &Sample, high: &Sample, share: f64) -> f64 {
        let middle = self.sample(0.5 * (low.y + high.y), low.clear);
        if share <= FINEST_SHARE || settled(low, &middle, high, share) {
            return share * (low.intensity + 4.0 * middle.intensity + high.intensity) / 6.0;
        }
        let half = 0.5 * share;
        self.integral(low, &middle, half) + self.integral(&middle, high, half)
    }

    fn sample(&mut self, y: f64, clear: f64) -> Sample {
        let Frame { outlook, view, .. } = self.frame;
        self.rays += 1;
        let sight = outlook.look_from(&view.ray(self.x, y), clear);
        let (intensity, range, met) = match sight {
            Sight::Ground(spot) => (self.shade(&spot), spot.range, spot.range),
            Sight::Sky => (0.0, f64::INFINITY, f64::INFINITY),
            Sight::TooNear => (0.0, f64::INFINITY, outlook.near()),
        };
        // Under pitch a column's rays have different azimuths: one says nothing about the next.
        let clear = if view.columns_are_vertical() { met } else { outlook.near() };
        Sample { y, intensity, range, clear }
    }

    fn shade(&self, spot: &Spot) -> f64 {
        let Frame { landscape, sun, .. } = self.frame;
        let level = landscape.level();
        let [_, hu, hv] = level.height_and_slopes(spot.region, spot.local);
        let slopes = [hu / level.region_size(), hv / level.region_size()];
        landscape.albedo() * sun.reflectivity(slopes)
    }
}

/// Whether shade is as good as known between three samples, and ranges do not betray a ridge.
fn settled(low: &Sample, middle: &Sample, high: &Sample, share: f64) -> bool {
    let bend = |value: fn(&Sample) -> f64| (value(low) - 2.0 * value(middle) + value(high)).abs();
    // Over level ground the inverse range is linear in y.
    let nearness = |sample: &Sample| 1.0 / sample.range;
    let ridge = bend(nearness) > 0.5 * (nearness(low) - nearness(high)).abs();
    bend(|sample| sample.intensity) * share / 6.0 <= LINE_MEAN_TOLERANCE && !(ridge && share > RIDGE_SHARE)
}
