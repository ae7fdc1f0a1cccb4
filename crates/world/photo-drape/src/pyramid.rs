//! A photograph in smaller and smaller pictures.

use photograph::Photograph;
use rayon::prelude::*;

/// Light of a photograph, and of pictures of half its size and so on down to one pixel.
#[derive(Debug, Clone)]
pub(crate) struct Pyramid {
    /// The half, the quarter and so on; the whole one is the photograph's own.
    levels: Vec<Level>,
}

/// A place between two pictures of a pyramid.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fineness {
    /// The finer picture, from 0 for the whole one.
    fine: usize,
    /// Share of the coarser one, 0 to 1.
    share: f64,
}

#[derive(Debug, Clone)]
struct Level {
    /// Number of columns and of lines.
    size: [usize; 2],
    lights: Vec<f32>,
}

impl Pyramid {
    pub fn new(photograph: &Photograph) -> Self {
        let picture = photograph.picture();
        let (mut levels, mut size) = (Vec::<Level>::new(), [picture.columns(), picture.lines()]);
        while size != [1, 1] {
            let next = match levels.last() {
                None => Level::half(size, |column, line| photograph.light_of(column, line)),
                Some(last) => {
                    Level::half(size, |column, line| f64::from(last.lights[line * size[0] + column]))
                }
            };
            size = next.size;
            levels.push(next);
        }
        Self { levels }
    }

    /// The pictures between which pixels are 2^`level` as wide as those of the photograph; the first or the last beyond them.
    pub fn fineness(&self, level: f64) -> Fineness {
        let level = level.clamp(0.0, self.levels.len() as f64);
        Fineness { fine: level as usize, share: level.fract() }
    }

    /// Light at a pixel I, J of the photograph; beside it that of its edge.
    #[inline]
    pub fn light(&self, photograph: &Photograph, pixel: [f64; 2], Fineness { fine, share }: Fineness) -> f64 {
        let first = self.light_in(photograph, pixel, fine);
        match share == 0.0 {
            true => first,
            false => first + share * (self.light_in(photograph, pixel, fine + 1) - first),
        }
    }

    /// Light in one of the pictures, from 0 for the whole one.
    #[inline]
    fn light_in(&self, photograph: &Photograph, pixel: [f64; 2], picture: usize) -> f64 {
        match picture.checked_sub(1) {
            None => whole(photograph, pixel),
            Some(at) => {
                // A power of two: its inverse is as exact.
                let scale = 1.0 / (1_u64 << picture) as f64;
                self.levels[at].light([pixel[0] * scale, pixel[1] * scale])
            }
        }
    }
}

/// Light at a pixel I, J of a photograph, linear between centres; beside it that of its edge.
fn whole(photograph: &Photograph, pixel: [f64; 2]) -> f64 {
    let picture = photograph.picture();
    between([picture.columns(), picture.lines()], pixel, |column, line| photograph.light_of(column, line))
}

/// A value at a pixel I, J of a picture of `size` (columns, lines), linear between the centres; beyond the outermost centres theirs.
#[inline]
fn between(size: [usize; 2], pixel: [f64; 2], value: impl Fn(usize, usize) -> f64) -> f64 {
    let (left, right, across) = beside(size[0], pixel[0]);
    let (above, below, down) = beside(size[1], pixel[1]);
    let row = |line: usize| {
        let from = value(left, line);
        from + across * (value(right, line) - from)
    };
    let (from, to) = (row(above), row(below));
    from + down * (to - from)
}

/// Pixels before and behind a place along an axis of `count` pixels, and the share of the second; beyond the outermost centres theirs.
#[inline]
fn beside(count: usize, at: f64) -> (usize, usize, f64) {
    let at = (at - 0.5).clamp(0.0, (count - 1) as f64);
    let first = at as usize;
    (first, (first + 1).min(count - 1), at - first as f64)
}

impl Level {
    /// The picture of half a size: each pixel the mean of those that it covers.
    fn half(size: [usize; 2], light: impl Fn(usize, usize) -> f64 + Sync) -> Self {
        let half = size.map(|count| count.div_ceil(2));
        let mean = |pixel: usize| {
            let (column, line) = (2 * (pixel % half[0]), 2 * (pixel / half[0]));
            let (columns, lines) = (column..(column + 2).min(size[0]), line..(line + 2).min(size[1]));
            let count = (columns.len() * lines.len()) as f64;
            let sum: f64 = lines
                .flat_map(|line| columns.clone().map(move |column| (column, line)))
                .map(|(column, line)| light(column, line))
                .sum();
            (sum / count) as f32
        };
        Self { size: half, lights: (0..half[0] * half[1]).into_par_iter().map(mean).collect() }
    }

    /// Light at a pixel of this picture.
    #[inline]
    fn light(&self, pixel: [f64; 2]) -> f64 {
        between(self.size, pixel, |column, line| f64::from(self.lights[line * self.size[0] + column]))
    }
}
