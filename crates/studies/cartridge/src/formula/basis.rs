//! The basis functions by their definition, for the direct sum over the corners of a region (5.1).

use landscape::CornerWords;

/// The quintic that has derivative 1 of one order at 0 and none else at 0, 1 and -1, and its slope: `g_0p` on the far
/// side of the corner, `g_1p` on the near side, `(-1)^p g_0p(-t)`.
pub fn hermite(order: usize, t: f64) -> [f64; 2] {
    let z = t.abs();
    if z >= 1.0 {
        return [0.0; 2];
    }
    let w = 1.0 - z;
    let [value, slope] = match order {
        0 => [w * w * w * (1.0 + 3.0 * z + 6.0 * z * z), -30.0 * z * z * w * w],
        1 => [z * w * w * w * (1.0 + 3.0 * z), w * w * (1.0 + 2.0 * z - 15.0 * z * z)],
        _ => [0.5 * z * z * w * w * w, 0.5 * z * w * w * (2.0 - 5.0 * z)],
    };
    match (t < 0.0, order == 1) {
        (false, _) => [value, slope],
        (true, true) => [-value, slope],
        (true, false) => [value, -slope],
    }
}

/// Height (m) and slopes at a place (regions) from the words of the four corners around it.
pub fn direct_sum(words: impl Fn([i64; 2]) -> CornerWords, place: [f64; 2], region_size: f64) -> [f64; 3] {
    let south_west = place.map(|along| along.floor() as i64);
    let mut sum = [0.0; 3];
    for step in [[0, 0], [0, 1], [1, 0], [1, 1]] {
        let corner = [south_west[0] + step[0], south_west[1] + step[1]];
        let [u, v] = [0, 1].map(|axis| place[axis] - corner[axis] as f64);
        for (word, value) in words(corner).into_iter().enumerate() {
            let ([g, g_u], [h, h_v]) = (hermite(word / 3, u), hermite(word % 3, v));
            sum[0] += value * g * h;
            sum[1] += value * g_u * h / region_size;
            sum[2] += value * g * h_v / region_size;
        }
    }
    sum
}
