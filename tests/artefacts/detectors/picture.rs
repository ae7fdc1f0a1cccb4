//! What is seen in pictures alone (A20, A21, A23, A24).

use crate::artefacts::look::{Look, Run, largest, mean, median};

/// A picture by line and column.
struct Picture<'a> {
    values: &'a [f32],
    columns: usize,
}

impl<'a> Picture<'a> {
    fn of(run: &'a Run, frame: usize) -> Self {
        Self { values: &run.frames[frame].picture, columns: run.settings.raster.columns as usize }
    }

    fn lines(&self) -> usize {
        self.values.len() / self.columns
    }

    fn at(&self, line: usize, column: usize) -> f64 {
        f64::from(self.values[line * self.columns + column])
    }

    /// Whether nothing is seen around a place.
    fn is_dark(&self, line: usize, column: usize) -> bool {
        let near = |at: usize, count: usize| at.saturating_sub(MARGIN)..(at + MARGIN + 1).min(count);
        near(line, self.lines())
            .all(|line| near(column, self.columns).all(|column| self.at(line, column) == 0.0))
    }

    /// Line from the top at which a column becomes bright, to a share of a line: what is bright of the lines about it counts.
    fn horizon(&self, column: usize) -> Option<f64> {
        let level = |lines: std::ops::Range<usize>| {
            mean(&lines.map(|line| self.at(line, column)).collect::<Vec<_>>())
        };
        let below = |line: usize| level(line + 4..line + 8);
        let first = (0..self.lines() - 8).find(|&line| {
            let ground = below(line);
            ground > 0.02 && self.at(line, column) > 0.02 * ground
        })?;
        Some(first as f64 + 4.0 * (1.0 - level(first..first + 4) / below(first)))
    }
}

/// Cells that a displaced picture may be off by.
const MARGIN: usize = 6;

/// A20: light where there is sky now and was ground in the frame before, against that ground.
pub fn residue(look: &Look<'_>) -> f64 {
    residue_after(look, 1)
}

/// The same in the frame `age` frames after the ground was there.
pub fn residue_after(look: &Look<'_>, age: usize) -> f64 {
    let [before, now] = [0, age].map(|frame| Picture::of(look.clean, frame));
    let found = Picture::of(look.run, age);
    let (mut left, mut was) = (0.0, 0.0);
    for line in 0..now.lines() {
        for column in 0..now.columns {
            if now.is_dark(line, column) && before.at(line, column) > 0.0 {
                left += found.at(line, column);
                was += before.at(line, column);
            }
        }
    }
    left / was
}

/// Where a picture is off (lines down, columns to the right), by the horizon and by the edges of the bodies.
pub fn displacement(look: &Look<'_>, frame: usize) -> [f64; 2] {
    let [found, right] = [look.run, look.clean].map(|run| Picture::of(run, frame));
    let columns = 2 * MARGIN..right.columns - 2 * MARGIN;
    let down = columns.filter_map(|column| {
        let way = found.horizon(column)? - right.horizon(column)?;
        (way.abs() < 3.0).then_some(way)
    });
    let [moved, place] = [&found, &right].map(body_edges);
    let aside: Vec<f64> = moved.iter().zip(&place).map(|(moved, place)| moved - place).collect();
    [median(&down.collect::<Vec<_>>()), median(&aside)]
}

/// Line of the horizon, between the bodies.
pub fn horizon_line(run: &Run, frame: usize) -> f64 {
    let picture = Picture::of(run, frame);
    median(&(0..picture.columns).filter_map(|column| picture.horizon(column)).collect::<Vec<_>>())
}

/// Columns at which bodies begin and end, in the lines in which they stand before the sky.
fn body_edges(picture: &Picture<'_>) -> Vec<f64> {
    let tops: Vec<f64> = (0..picture.columns).filter_map(|column| picture.horizon(column)).collect();
    let ground = median(&tops);
    let line = (ground - 3.0).max(0.0) as usize;
    let row: Vec<f64> = (0..picture.columns).map(|column| picture.at(line, column)).collect();
    let bright = largest(row.iter().copied());
    // Rising and falling through half of the brightness.
    let passes = |pair: (usize, &[f64])| {
        let (column, [a, b]) = (pair.0, [pair.1[0] / bright - 0.5, pair.1[1] / bright - 0.5]);
        (a * b < 0.0).then(|| column as f64 + a / (a - b))
    };
    row.windows(2).enumerate().filter_map(passes).collect()
}

/// A21: length of the displacement of the picture (% of its height).
pub fn registration(look: &Look<'_>) -> f64 {
    let [down, aside] = displacement(look, 0);
    let raster = look.run.settings.raster;
    let field = raster.field;
    let lines = f64::from(raster.lines);
    // A column in heights of the picture.
    let column = field.tan_half_width / field.tan_half_height / f64::from(raster.columns);
    100.0 * libm::hypot(down / lines, aside * column)
}

/// Tilt of the horizon in a picture (degrees, starboard down).
pub fn tilt(run: &Run, frame: usize) -> f64 {
    let (picture, raster) = (Picture::of(run, frame), run.settings.raster);
    let columns = picture.columns / 4..picture.columns - picture.columns / 4;
    let points = columns.filter_map(|column| {
        let x = (column as f64 + 0.5) / picture.columns as f64 * 2.0 * raster.field.tan_half_width;
        let y = picture.horizon(column)? / picture.lines() as f64 * 2.0 * raster.field.tan_half_height;
        Some([x, y])
    });
    let slope = super::beam::slope(&points.collect::<Vec<_>>());
    quantities::degrees(libm::atan(slope))
}

/// A23: by how much the horizon swings beyond the lean of one degree.
pub fn roll_steps(look: &Look<'_>) -> f64 {
    let tilts = (0..look.run.frames.len()).map(|frame| tilt(look.run, frame).abs());
    largest(tilts) - 1.0
}

/// A24: how often a picture is shown before the next one.
pub fn lag_of_update(look: &Look<'_>) -> f64 {
    let [first, next] = [0, 1].map(|frame| &look.run.frames[frame].picture);
    let showings = look.run.showings() as f64;
    if first == next { 2.0 * showings } else { showings }
}
