//! Lines of sight and viewsheds against closed forms and against an evaluator that shares no code with them.

mod closed_forms;
mod landscapes;
mod random_landscapes;
mod real_ground;
mod refused;
mod second_evaluator;
mod spheres;
mod voids;

use sight::Posts;

/// Random numbers that are the same in every run.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        let unit = quantities::unit_interval(self.0, &[]);
        self.0 = quantities::hash_words(self.0, &[]);
        unit
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Heights with detail at every scale: random numbers on ever finer grids, each half as high, joined by bilinear patches.
    fn rough(&mut self, [rows, columns]: [usize; 2], height: f64) -> Vec<f64> {
        let mut heights = vec![0.0; rows * columns];
        for octave in 0..5 {
            let cell = 16 >> octave;
            let lattice: Vec<f64> = (0..40 * 40 * 9).map(|_| self.between(-1.0, 1.0)).collect();
            let at = |i: usize, j: usize| lattice[i * 120 + j];
            for (post, sum) in heights.iter_mut().enumerate() {
                let [i, j] = [post / columns, post % columns];
                let [u, v] = [i, j].map(|k| (k % cell) as f64 / cell as f64);
                let [i, j] = [i / cell, j / cell];
                let north = (1.0 - v) * at(i, j) + v * at(i, j + 1);
                let south = (1.0 - v) * at(i + 1, j) + v * at(i + 1, j + 1);
                *sum += height / f64::from(1 << octave) * ((1.0 - u) * north + u * south);
            }
        }
        heights
    }
}

/// A mesh with heights by row and column, north-western post at (0, 0), posts every `spacing` metres.
fn posts(size: [usize; 2], spacing: f64, height: impl Fn(usize, usize) -> f64) -> Posts {
    let heights = (0..size[0] * size[1]).map(|at| height(at / size[1], at % size[1])).collect();
    Posts::new(size, [0.0, 0.0], spacing, heights).unwrap()
}
