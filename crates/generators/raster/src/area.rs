//! Exact areas of polygons within a rectangle: what sampling is measured against.

use smallvec::SmallVec;

use crate::keep;

/// Corners (x, y; pixels) of a convex polygon, around it in either direction.
type Polygon = SmallVec<[[f64; 2]; 12]>;

/// Area (pixels squared) of the convex `polygon` within the rectangle from `low` to `high` (pixels), by clipping in f64.
pub fn area_within(polygon: &[[f64; 2]], low: [f64; 2], high: [f64; 2]) -> f64 {
    area(&rectangle(low, high, polygon))
}

/// The part of a convex polygon that lies in the rectangle.
fn rectangle([left, top]: [f64; 2], [right, bottom]: [f64; 2], polygon: &[[f64; 2]]) -> Polygon {
    let polygon = keep(polygon, |[x, _]| x - left);
    let polygon = keep(&polygon, |[x, _]| right - x);
    let polygon = keep(&polygon, |[_, y]| y - top);
    keep(&polygon, |[_, y]| bottom - y)
}

/// The part of a convex polygon where a linear function is at least 0.
fn keep(polygon: &[[f64; 2]], height: impl Fn([f64; 2]) -> f64) -> Polygon {
    keep::keep(polygon, height, |from: [f64; 2], to: [f64; 2], share| {
        [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * share)
    })
}

fn area(polygon: &[[f64; 2]]) -> f64 {
    doubled_area(polygon).abs() / 2.0
}

/// Twice the signed area. Corners are taken from the first one, so that far polygons lose no digits.
fn doubled_area(polygon: &[[f64; 2]]) -> f64 {
    let Some((&[x, y], others)) = polygon.split_first() else { return 0.0 };
    others
        .windows(2)
        .map(|pair| (pair[0][0] - x) * (pair[1][1] - y) - (pair[1][0] - x) * (pair[0][1] - y))
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn areas_of_simple_shapes() {
        let half = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
        assert_eq!(area_within(&half, [0.0, 0.0], [1.0, 1.0]), 1.0);
        assert_eq!(area_within(&half, [1.0, 0.0], [2.0, 1.0]), 0.5);
        assert_eq!(area_within(&half, [1.0, 1.0], [2.0, 2.0]), 0.0);
        assert_eq!(area_within(&[], [0.0, 0.0], [1.0, 1.0]), 0.0);
        let backwards = [[0.0, 2.0], [2.0, 0.0], [0.0, 0.0]];
        assert_eq!(area_within(&backwards, [0.0, 0.0], [1.5, 1.5]), 1.5 * 1.5 - 0.5);
    }

    #[test]
    fn the_area_of_a_triangle_is_the_sum_over_all_pixels() {
        let triangle = [[10.0, 10.0], [50.0, 20.0], [20.0, 60.0]];
        let pixels = (0..64 * 64).map(|i| [f64::from(i % 64), f64::from(i / 64)]);
        let sum: f64 = pixels.map(|[x, y]| area_within(&triangle, [x, y], [x + 1.0, y + 1.0])).sum();
        assert!((sum - 950.0).abs() < 1e-9, "{sum}");
    }
}
