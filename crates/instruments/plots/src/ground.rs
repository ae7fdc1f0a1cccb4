//! Shaded ground with contours.

use crate::axis::{Ruler, extremes, round_up};
use crate::canvas::{Area, Canvas};
use crate::colour::{Colour, lit, mix, of_height};
use landscape::{Level, Sun};
use rayon::prelude::{IntoParallelIterator, ParallelIterator};

/// Contours between the lowest and the highest ground, about.
const CONTOURS: f64 = 32.0;
/// Every fifth contour is heavier.
const HEAVY: f64 = 5.0;

/// Heights and slopes at the middle of every pixel of a map.
pub(crate) struct GroundMap {
    columns: u32,
    /// Height (m), slopes north and east (m/m).
    points: Vec<[f64; 3]>,
    /// Metres a pixel, the larger of both axes.
    pixel: f64,
    heights: [f64; 2],
    sun: Sun,
}

impl GroundMap {
    /// The ground of `level` over the pixels of `area`.
    pub fn sample(level: &Level, area: Area, sun: Sun) -> Self {
        let [south, west, north, east] = level.extent();
        let (columns, lines) = (area.width as u32, area.height as u32);
        let steps = [(north - south) / f64::from(lines), (east - west) / f64::from(columns)];
        let at = |line: u32, column: u32| {
            let x = north - (f64::from(line) + 0.5) * steps[0];
            let y = west + (f64::from(column) + 0.5) * steps[1];
            point(level, x, y)
        };
        let points: Vec<[f64; 3]> = (0..lines)
            .into_par_iter()
            .flat_map_iter(|line| (0..columns).map(move |column| at(line, column)))
            .collect();
        let heights = extremes(points.iter().map(|p| p[0])).unwrap_or([0.0, 0.0]);
        Self { columns, points, pixel: steps[0].max(steps[1]), heights, sun }
    }

    /// The range of heights, for a colour bar.
    pub fn ruler(&self) -> Ruler {
        Ruler::linear(self.heights)
    }

    /// Returns the height from one contour to the next (m).
    pub fn contour_interval(&self) -> f64 {
        round_up((self.heights[1] - self.heights[0]) / CONTOURS)
    }

    /// Draws the map into `area` of `canvas`, with contour lines if `contours`.
    pub fn draw(&self, canvas: &mut Canvas, area: Area, contours: bool) {
        let ruler = self.ruler();
        let interval = contours.then(|| self.contour_interval());
        canvas.image(area, |column, line| {
            let point = &self.points[(line * self.columns + column) as usize];
            let ground = lit(of_height(ruler.share(point[0])), self.light([point[1], point[2]]));
            interval.map_or(ground, |interval| self.contoured(ground, point, interval))
        });
    }

    /// Level ground keeps nine tenths of its colour; local shadow a third, so that heights stay legible in it.
    fn light(&self, slopes: [f64; 2]) -> f64 {
        let level_ground = self.sun.reflectivity([0.0, 0.0]).max(0.02);
        0.32 + 0.58 * (self.sun.reflectivity(slopes) / level_ground).min(1.7)
    }

    /// Ink over the ground by the distance to the nearest contour, known in pixels from height and slope.
    fn contoured(&self, ground: Colour, [height, hx, hy]: &[f64; 3], interval: f64) -> Colour {
        let index = (height / interval).round();
        let fall = (hx * hx + hy * hy).sqrt() * self.pixel;
        // A plain that happens to lie at the height of a contour has none.
        if fall < 1e-6 * interval {
            return ground;
        }
        let pixels = (height - index * interval).abs() / fall;
        let heavy = (index / HEAVY).fract() == 0.0;
        let (half_width, strength) = if heavy { (0.75, 0.6) } else { (0.5, 0.35) };
        // Where contours crowd below four pixels they would be a wash of ink: let them fade.
        let room = (interval / fall / 4.0).min(1.0);
        mix(ground, [30, 26, 22], strength * room * (half_width + 0.5 - pixels).clamp(0.0, 1.0))
    }
}

fn point(level: &Level, x: f64, y: f64) -> [f64; 3] {
    // The middle of a pixel lies inside, but for rounding at the very edge.
    let Some((region, local)) = level.locate(x, y) else { return [level.words()[0][0], 0.0, 0.0] };
    let [height, hu, hv] = level.height_and_slopes(region, local);
    let d = level.region_size();
    [height, hu / d, hv / d]
}
