//! A photograph in smaller and smaller pictures.

use photograph::Photograph;
use rayon::prelude::*;

/// Light of a photograph, and of pictures of half its size and so on down to one pixel.
#[derive(Debug, Clone)]
pub(crate) struct Pyramid {
    /// The half, the quarter and so on; the whole one is the photograph's own.
    levels: Vec<Level>,
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

    /// Light at a pixel I, J of the photograph, in pictures whose pixels are 2^`level` as wide; beside the photograph that of its edge.
    pub fn light(&self, photograph: &Photograph, pixel: [f64; 2], level: f64) -> f64 {
        let level = level.clamp(0.0, self.levels.len() as f64);
        let (fine, share) = (level as usize, level.fract());
        let of = |level: usize| match level.checked_sub(1) {
            None => whole(photograph, pixel),
            Some(at) => {
                let scale = (1_u64 << level) as f64;
                self.levels[at].light([pixel[0] / scale, pixel[1] / scale])
            }
        };
        let first = of(fine);
        if share == 0.0 { first } else { first + share * (of(fine + 1) - first) }
    }
}

/// Light at a pixel I, J of a photograph, linear between centres; beside it that of its edge.
fn whole(photograph: &Photograph, pixel: [f64; 2]) -> f64 {
    let picture = photograph.picture();
    between([picture.columns(), picture.lines()], pixel, |column, line| photograph.light_of(column, line))
}

// Of these and what they ask, no array goes through `map`: its closures stay calls, one for each of many looks at a pixel.
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
