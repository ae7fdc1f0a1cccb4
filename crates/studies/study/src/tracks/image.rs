//! Pictures in grey, and the same at half, a quarter and an eighth of their size.

/// A picture of f32 grey values. Places are in pixels: 0, 0 is the middle of the top left pixel, x runs to the right, y down.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    columns: usize,
    lines: usize,
    values: Vec<f32>,
}

/// Weights of the binomial filter along a line or a column.
const BINOMIAL: [f32; 5] = [1.0 / 16.0, 4.0 / 16.0, 6.0 / 16.0, 4.0 / 16.0, 1.0 / 16.0];

impl Image {
    /// A picture of `values`, line by line from the top. There is at least one line and one column.
    pub fn new(columns: usize, values: Vec<f32>) -> Self {
        Self { columns, lines: values.len() / columns, values }
    }

    /// Columns and lines of the picture.
    pub fn size(&self) -> [usize; 2] {
        [self.columns, self.lines]
    }

    /// Value of a pixel; that of the nearest one beyond the borders.
    pub fn pixel(&self, [x, y]: [isize; 2]) -> f32 {
        let within = |at: isize, count: usize| at.clamp(0, count as isize - 1) as usize;
        self.values[within(y, self.lines) * self.columns + within(x, self.columns)]
    }

    /// Value at a place, bilinear between the pixels around it.
    pub fn at(&self, place: [f64; 2]) -> f64 {
        let [x, y] = place.map(f64::floor);
        let [right, down] = [place[0] - x, place[1] - y];
        let pixel = |i: isize, j: isize| f64::from(self.pixel([x as isize + i, y as isize + j]));
        let line = |j: isize| (1.0 - right) * pixel(0, j) + right * pixel(1, j);
        (1.0 - down) * line(0) + down * line(1)
    }

    /// The picture after the binomial filter.
    pub fn smoothed(&self) -> Self {
        self.filtered(1)
    }

    /// The picture after the binomial filter, every `step`-th pixel of it: pixel i, j lies at `step` i, `step` j of this one.
    fn filtered(&self, step: usize) -> Self {
        let [columns, lines] = self.size().map(|count| count.div_ceil(step));
        let weighted = |at: &dyn Fn(isize) -> f32| {
            BINOMIAL.into_iter().zip(-2..).map(|(weight, off)| weight * at(off)).sum::<f32>()
        };
        let along: Vec<f32> = (0..self.lines * columns)
            .map(|index| {
                let (x, y) = ((step * (index % columns)) as isize, (index / columns) as isize);
                weighted(&|off| self.pixel([x + off, y]))
            })
            .collect();
        let narrow = Self { columns, lines: self.lines, values: along };
        let down = |index: usize| {
            let (x, y) = ((index % columns) as isize, (step * (index / columns)) as isize);
            weighted(&|off| narrow.pixel([x, y + off]))
        };
        Self { columns, lines, values: (0..lines * columns).map(down).collect() }
    }
}

/// A picture and its halves.
#[derive(Debug, Clone)]
pub struct Pyramid {
    /// The whole picture first.
    pub levels: Vec<Image>,
}

impl Pyramid {
    /// A pyramid of `count` levels, at least one.
    pub fn new(whole: Image, count: usize) -> Self {
        let mut levels = vec![whole];
        while levels.len() < count {
            levels.extend(levels.last().map(|last| last.filtered(2)));
        }
        Self { levels }
    }

    /// The picture at its full size.
    pub fn whole(&self) -> &Image {
        &self.levels[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_is_a_ramp_at_every_size() {
        let values = (0..40 * 30).map(|index| (index % 40) as f32 + 3.0 * (index / 40) as f32);
        let pyramid = Pyramid::new(Image::new(40, values.collect()), 3);
        assert_eq!(pyramid.levels.iter().map(Image::size).collect::<Vec<_>>(), [[40, 30], [20, 15], [10, 8]]);
        assert!((pyramid.whole().at([7.25, 4.5]) - 20.75).abs() < 1e-9);
        assert!((pyramid.whole().smoothed().at([7.25, 4.5]) - 20.75).abs() < 1e-4);
        // Away from the borders; pixel 5, 4 of a quarter lies at 20, 16.
        assert!((pyramid.levels[2].at([5.0, 4.0]) - 68.0).abs() < 1e-4);
    }
}
