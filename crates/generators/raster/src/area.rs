//! Exact areas of polygons within a rectangle: what sampling is measured against.

use smallvec::SmallVec;

use crate::keep;

/// Corners (x, y; pixels) of a convex polygon, around it in either direction.
type Polygon = SmallVec<[[f64; 2]; 12]>;

/// Area (pixels squared) of the convex `polygon` within the rectangle from `low` to `high` (pixels), by clipping in f64.
pub fn area_within(polygon: &[[f64; 2]], low: [f64; 2], high: [f64; 2]) -> f64 {
    area(&rectangle(low, high, polygon))
}

/// Areas (pixels squared) that each of the convex `polygons`, near to far, shows within a rectangle, and what is left over.
///
/// What is not yet covered is a set of convex pieces; each polygon takes its part out of every piece.
pub fn visible_areas(polygons: &[&[[f64; 2]]], low: [f64; 2], high: [f64; 2]) -> (Vec<f64>, f64) {
    let mut free = vec![box_corners(low, high)];
    let shown = polygons.iter().map(|polygon| {
        let mut left = Vec::new();
        let seen = free.iter().map(|piece| take_out(piece, polygon, &mut left)).sum();
        free = left;
        seen
    });
    let shown = shown.collect();
    (shown, free.iter().map(|piece| area(piece)).sum())
}

/// Area of `piece` within `polygon`; what lies outside goes to `left`.
fn take_out(piece: &Polygon, polygon: &[[f64; 2]], left: &mut Vec<Polygon>) -> f64 {
    let mut inside = piece.clone();
    for line in lines(polygon) {
        let outside = keep(&inside, |point| -line(point));
        if area(&outside) > 0.0 {
            left.push(outside);
        }
        inside = keep(&inside, line);
    }
    area(&inside)
}

/// The part of a convex polygon that lies in the rectangle.
fn rectangle([left, top]: [f64; 2], [right, bottom]: [f64; 2], polygon: &[[f64; 2]]) -> Polygon {
    let polygon = keep(polygon, |[x, _]| x - left);
    let polygon = keep(&polygon, |[x, _]| right - x);
    let polygon = keep(&polygon, |[_, y]| y - top);
    keep(&polygon, |[_, y]| bottom - y)
}

fn box_corners([left, top]: [f64; 2], [right, bottom]: [f64; 2]) -> Polygon {
    Polygon::from_slice(&[[left, top], [right, top], [right, bottom], [left, bottom]])
}

/// Functions that are at least 0 on the inner side of each edge, whichever way round the polygon is given.
fn lines(polygon: &[[f64; 2]]) -> impl Iterator<Item = impl Fn([f64; 2]) -> f64> {
    let turn = doubled_area(polygon).signum();
    (0..polygon.len()).map(move |i| {
        let ([x, y], [to_x, to_y]) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        let along = [turn * (to_x - x), turn * (to_y - y)];
        move |[u, v]: [f64; 2]| along[0] * (v - y) - along[1] * (u - x)
    })
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

    #[test]
    fn nearer_polygons_hide_farther_ones() {
        let left: &[_] = &[[-1.0, -1.0], [0.5, -1.0], [0.5, 2.0], [-1.0, 2.0]];
        let upper: &[_] = &[[-1.0, 0.25], [2.0, 0.25], [2.0, -1.0], [-1.0, -1.0]];
        let whole: &[_] = &[[-1.0, -1.0], [2.0, -1.0], [2.0, 2.0], [-1.0, 2.0]];
        let (shown, rest) = visible_areas(&[left, upper], [0.0, 0.0], [1.0, 1.0]);
        assert_eq!((shown, rest), (vec![0.5, 0.125], 0.375));
        let (shown, rest) = visible_areas(&[upper, left, whole, left], [0.0, 0.0], [1.0, 1.0]);
        assert_eq!((shown, rest), (vec![0.25, 0.375, 0.375, 0.0], 0.0));
    }

    #[test]
    fn a_flat_polygon_hides_nothing() {
        let flat: &[_] = &[[0.0, 0.0], [1.0, 1.0], [0.5, 0.5]];
        let (shown, rest) = visible_areas(&[flat], [0.0, 0.0], [1.0, 1.0]);
        assert_eq!((shown, rest), (vec![0.0], 1.0));
    }
}
