//! Intensity codes of the recorder, and the film read into the planes of a frame.

use generator::{Label, PlaneKind, Planes};
use scenario::PixelRule;

use crate::grid::{Cover, Grid};
use crate::light::Lit;
use crate::observer::Observer;
use crate::projection::{Plot, SKY};

/// Codes of the SC 4020: equal steps from 0, black, to the exposure that the display shows white (our choice).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct IntensityCodes {
    /// How many there are, at least 2.
    pub count: u32,
    /// Reflectivity of the highest.
    pub white: f64,
}

impl IntensityCodes {
    /// The code of an intensity, 0 or more: the nearest, from 0 to `count - 1`.
    pub fn code(&self, intensity: f64) -> u32 {
        let highest = f64::from(self.count - 1);
        (intensity / self.white * highest).round().clamp(0.0, highest) as u32
    }

    /// The intensity that a code stands for on the film.
    pub fn grey(&self, code: u32) -> f64 {
        f64::from(code) / f64::from(self.count - 1) * self.white
    }
}

/// What LUNSIM fills: all but colour.
pub(crate) const PLANES: &[PlaneKind] = &[
    PlaneKind::Intensity,
    PlaneKind::Range,
    PlaneKind::Height,
    PlaneKind::NormalNorth,
    PlaneKind::NormalEast,
    PlaneKind::NormalUp,
    PlaneKind::Reflectivity,
    PlaneKind::Shadow,
    PlaneKind::Label,
    PlaneKind::Distance,
];

/// A picture as it was sent to the recorder, and what it was made from.
pub(crate) struct Film<'a> {
    /// What is seen where; no point is seen without a grid.
    pub plot: &'a Plot,
    /// Ground grid that the picture shows.
    pub grid: &'a Grid,
    /// Light at each point of the grid.
    pub light: &'a [Lit],
    /// Whose picture it is.
    pub observer: &'a Observer,
    /// Codes of the recorder.
    pub codes: IntensityCodes,
}

impl Film<'_> {
    /// Fills the planes that are asked for.
    pub fn develop(&self, rule: PixelRule, planes: &mut Planes) {
        let [columns, lines] = [planes.columns(), planes.lines()];
        for &kind in PLANES {
            let Some(values) = planes.get_mut(kind) else { continue };
            for (pixel, value) in values.iter_mut().enumerate() {
                let at = [[pixel % columns, columns], [pixel / columns, lines]];
                *value = match (kind, rule) {
                    (PlaneKind::Intensity, PixelRule::LineMean) => self.mean(at) as f32,
                    _ => self.point_at(at).map_or(kind.sky(), |point| self.value(kind, point) as f32),
                };
            }
        }
    }

    /// Points of each column of positions that is not dark, from the top: line and code of each. What is black is not plotted.
    pub fn columns(&self) -> impl Iterator<Item = (usize, Vec<(usize, u32)>)> {
        let code = |point: u32| (point != SKY).then(|| self.code(point as usize)).filter(|code| *code > 0);
        let points = move |seen: &[u32]| -> Vec<(usize, u32)> {
            seen.iter().enumerate().filter_map(|(line, point)| Some((line, code(*point)?))).collect()
        };
        let columns = self.plot.seen.chunks(self.plot.size[1]).map(points).enumerate();
        columns.filter(|(_, points)| !points.is_empty())
    }

    /// The code of a point of the grid.
    pub fn code(&self, point: usize) -> u32 {
        self.codes.code(self.light[point].intensity())
    }

    /// What a position of the film shows.
    fn grey(&self, point: Option<usize>) -> f64 {
        point.map_or(0.0, |point| self.codes.grey(self.code(point)))
    }

    /// Mean over the positions whose middles lie in a pixel; of the one under its middle if there is none.
    fn mean(&self, at: [[usize; 2]; 2]) -> f64 {
        let inside = |axis: usize| {
            let ([pixel, count], positions) = (at[axis], self.plot.size[axis]);
            let first = |pixel: usize| (2 * pixel * positions + count).div_ceil(2 * count) - 1;
            // Middles at (2 k + 1) / 2 positions, from the pixel's begin up to its end.
            let [from, to] = [pixel, pixel + 1].map(first);
            from..to
        };
        let (columns, lines) = (inside(0), inside(1));
        if columns.is_empty() || lines.is_empty() {
            return self.grey(self.point_at(at));
        }
        let count = (columns.len() * lines.len()) as f64;
        let sum: f64 = columns
            .flat_map(|column| lines.clone().map(move |line| [column, line]))
            .map(|position| self.grey(self.point(position)))
            .sum();
        sum / count
    }

    /// The point under the middle of a pixel.
    pub fn point_at(&self, at: [[usize; 2]; 2]) -> Option<usize> {
        self.point([0, 1].map(|axis| {
            let [pixel, count] = at[axis];
            (2 * pixel + 1) * self.plot.size[axis] / (2 * count)
        }))
    }

    /// The point at a position, column and line.
    fn point(&self, [column, line]: [usize; 2]) -> Option<usize> {
        let point = self.plot.seen[column * self.plot.size[1] + line];
        (point != SKY).then_some(point as usize)
    }

    /// What a plane has of a point of the grid.
    pub fn value(&self, kind: PlaneKind, point: usize) -> f64 {
        let (row, column) = (point / self.grid.size, point % self.grid.size);
        let place = self.grid.place(row, column);
        let normal = |axis: usize| {
            let slopes = self.observer.turned(self.grid.slopes(row, column));
            let up = 1.0 / (1.0 + slopes[0] * slopes[0] + slopes[1] * slopes[1]).sqrt();
            slopes.get(axis).map_or(up, |slope| -slope * up)
        };
        let lit = self.light[point];
        match kind {
            // It draws no colour: all three would be alike, and their luminance the intensity.
            PlaneKind::Intensity | PlaneKind::Red | PlaneKind::Green | PlaneKind::Blue => {
                self.grey(Some(point))
            }
            PlaneKind::Distance => {
                // Heights of the grid have the drop of the lunoid in them.
                let rise = self.grid.heights[point] - self.observer.eye[2];
                (place[0] * place[0] + place[1] * place[1] + rise * rise).sqrt()
            }
            PlaneKind::Range => (place[0] * place[0] + place[1] * place[1]).sqrt(),
            PlaneKind::Height => self.grid.heights[point] + self.grid.drop(place),
            PlaneKind::NormalNorth => normal(0),
            PlaneKind::NormalEast => normal(1),
            PlaneKind::NormalUp => normal(2),
            PlaneKind::Reflectivity => lit.reflectivity,
            PlaneKind::Shadow => f64::from(lit.shade.code()),
            PlaneKind::Label => f64::from(label(self.grid.covers[point]).code()),
            // A program takes the time and the memory that it takes.
            PlaneKind::Overload => 0.0,
        }
    }
}

fn label(cover: Cover) -> Label {
    match cover {
        Cover::Nothing => Label::Sky,
        Cover::Terrain => Label::Terrain,
        Cover::Crater => Label::Feature,
    }
}

#[cfg(test)]
mod tests {
    use super::IntensityCodes;

    #[test]
    fn codes_are_the_nearest_of_equal_steps() {
        let codes = IntensityCodes { count: 16, white: 0.5 };
        let found = [0.0, 0.01, 0.02, 0.25, 0.49, 0.5, 2.0].map(|intensity| codes.code(intensity));
        assert_eq!(found, [0, 0, 1, 8, 15, 15, 15]);
        assert!((0..16).all(|code| codes.code(codes.grey(code)) == code));
        assert_eq!((codes.grey(0), codes.grey(15)), (0.0, 0.5));
    }
}
