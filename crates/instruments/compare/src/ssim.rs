//! Structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004).

use picture::GreyPicture;

const RADIUS: usize = 5;
const WINDOW: usize = 2 * RADIUS + 1;
const SIGMA: f64 = 1.5;
/// `(K L)^2` with L = 1.
const C1: f64 = 0.01 * 0.01;
const C2: f64 = 0.03 * 0.03;

/// Mean structural similarity on grey 0 to 1: Gaussian window of 11 x 11, sigma 1.5, K 0.01 and 0.03, over
/// the places where the whole window lies in the picture. 1 for equal pictures. Nothing when the sizes differ
/// or the window does not fit.
///
/// For reports, not for gates: where mean and variance are small, as in sky and shadow, the constants decide.
pub fn ssim(test: &GreyPicture, reference: &GreyPicture) -> Option<f64> {
    let size = (test.columns(), test.lines());
    if size != (reference.columns(), reference.lines()) || size.0 < WINDOW || size.1 < WINDOW {
        return None;
    }
    let (x, y): (Vec<f64>, Vec<f64>) = (test.levels().collect(), reference.levels().collect());
    let mean = |product: fn(f64, f64) -> f64| {
        let plane: Vec<f64> = x.iter().zip(&y).map(|(x, y)| product(*x, *y)).collect();
        blurred(&plane, size.0)
    };
    let (mean_x, mean_y) = (mean(|x, _| x), mean(|_, y| y));
    let (mean_xx, mean_yy, mean_xy) = (mean(|x, _| x * x), mean(|_, y| y * y), mean(|x, y| x * y));
    let similarity = |at: usize| {
        let (x, y) = (mean_x[at], mean_y[at]);
        let (xx, yy, xy) = (mean_xx[at] - x * x, mean_yy[at] - y * y, mean_xy[at] - x * y);
        (2.0 * x * y + C1) * (2.0 * xy + C2) / ((x * x + y * y + C1) * (xx + yy + C2))
    };
    Some((0..mean_x.len()).map(similarity).sum::<f64>() / mean_x.len() as f64)
}

/// The weights of the window along one axis; their sum is 1.
fn weights() -> [f64; WINDOW] {
    let bell = |at: usize| {
        let offset = at as f64 - RADIUS as f64;
        libm::exp(-offset * offset / (2.0 * SIGMA * SIGMA))
    };
    let bells: [f64; WINDOW] = std::array::from_fn(bell);
    let sum: f64 = bells.iter().sum();
    bells.map(|bell| bell / sum)
}

/// Weighted means along both axes; smaller than the plane by the radius on every side.
fn blurred(plane: &[f64], columns: usize) -> Vec<f64> {
    let weights = weights();
    let across = columns - 2 * RADIUS;
    // In a line the window's terms lie one pixel apart, in a column one line.
    let lines = plane.chunks_exact(columns);
    let rows: Vec<f64> = lines.flat_map(|line| weighted_sums(line, 1, across, &weights)).collect();
    let windows = 0..plane.len() / columns - 2 * RADIUS;
    windows.flat_map(|line| weighted_sums(&rows[line * across..], across, across, &weights)).collect()
}

/// `count` sums of [`WINDOW`] values that lie `stride` apart, the first at the first value, then at the next.
fn weighted_sums(values: &[f64], stride: usize, count: usize, weights: &[f64; WINDOW]) -> Vec<f64> {
    let mut sums = vec![0.0; count];
    for (term, weight) in weights.iter().enumerate() {
        for (sum, value) in sums.iter_mut().zip(&values[term * stride..]) {
            *sum += value * weight;
        }
    }
    sums
}
