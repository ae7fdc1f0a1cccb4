//! Where the sampling points of a sub-area lie.

use raster::{DistancePlane, Sampling, SubArea};

use crate::stack::SIDE;

/// Places of the sampling points of each pixel of a sub-area.
#[derive(Debug, Clone)]
pub(crate) struct Places {
    sampling: Sampling,
    /// Sampling points of a pixel, 1 to 32.
    pub samples: usize,
    /// Column and row on the screen of the first pixel.
    origin: [u32; 2],
    /// Offsets from a pixel's corner (pixels), by axis: of one pixel for all, or of every pixel where the pattern is turned.
    offsets: [Vec<f64>; 2],
}

impl Places {
    /// Those of a sampling, for no sub-area yet.
    pub fn new(sampling: Sampling) -> Self {
        let pixels = if sampling.is_turned() { SIDE * SIDE } else { 1 };
        let samples = sampling.count();
        let empty = vec![0.0; pixels * samples];
        let mut places = Self { sampling, samples, origin: [0; 2], offsets: [empty.clone(), empty] };
        places.fill(0, [0; 2]);
        places
    }

    /// Moves to a sub-area.
    pub fn start(&mut self, area: &SubArea) {
        self.origin = [area.columns().start, area.rows().start];
        if self.sampling.is_turned() {
            for pixel in 0..SIDE * SIDE {
                self.fill(pixel, self.pixel(pixel).map(|at| at as i32));
            }
        }
    }

    /// Distances (q, 1/m) of a plane at the sampling points of a pixel, bit for bit as [`DistancePlane::at`] has them there.
    pub fn distances<const N: usize>(&self, pixel: usize, plane: &DistancePlane) -> [f64; N] {
        let [column, row] = self.pixel(pixel);
        let (column, row) = (f64::from(column), f64::from(row));
        let first = if self.sampling.is_turned() { pixel * N } else { 0 };
        let [x, y] = &self.offsets;
        let (x, y) = (&x[first..first + N], &y[first..first + N]);
        let mut distances = [0.0; N];
        for i in 0..N {
            distances[i] = plane.at([column + x[i], row + y[i]]);
        }
        distances
    }

    /// Column and row on the screen of a pixel of the sub-area.
    fn pixel(&self, pixel: usize) -> [u32; 2] {
        [self.origin[0] + (pixel % SIDE) as u32, self.origin[1] + (pixel / SIDE) as u32]
    }

    /// Middle of a pixel of the sub-area (pixels on the screen).
    pub fn middle(&self, pixel: usize) -> [f64; 2] {
        let [column, row] = self.pixel(pixel);
        [f64::from(column) + 0.5, f64::from(row) + 0.5]
    }

    fn fill(&mut self, pixel: usize, on_screen: [i32; 2]) {
        let first = pixel * self.samples;
        for (i, place) in self.sampling.places(on_screen).enumerate() {
            for axis in 0..2 {
                self.offsets[axis][first + i] = place[axis] - f64::from(on_screen[axis]);
            }
        }
    }
}
