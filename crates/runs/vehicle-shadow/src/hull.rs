//! Convex hull of points in a plane: the outline of one convex figure.

use glam::DVec2;

/// Corners of the convex hull of `points`, x turning towards y; nothing if they lie in a line.
pub fn hull(mut points: Vec<DVec2>) -> Option<Vec<DVec2>> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let mut corners: Vec<DVec2> = Vec::with_capacity(points.len() + 1);
    let back = points.iter().rev().skip(1);
    let mut fixed = 1;
    for (index, &point) in points.iter().chain(back).enumerate() {
        if index == points.len() {
            fixed = corners.len();
        }
        while corners.len() > fixed {
            let [before, last] = [corners[corners.len() - 2], corners[corners.len() - 1]];
            if (last - before).perp_dot(point - last) > 0.0 {
                break;
            }
            corners.pop();
        }
        corners.push(point);
    }
    // The first point stands at the end again.
    corners.pop();
    (corners.len() >= 3).then_some(corners)
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::hull;

    fn points(list: &[[f64; 2]]) -> Vec<DVec2> {
        list.iter().map(|&point| DVec2::from_array(point)).collect()
    }

    #[test]
    fn corners_run_around_what_is_inside() {
        let cloud =
            [[2.0, 2.0], [0.0, 0.0], [1.0, 1.0], [4.0, 0.0], [2.0, 0.0], [0.0, 4.0], [4.0, 4.0], [0.0, 0.0]];
        let found = hull(points(&cloud)).unwrap();
        assert_eq!(found, points(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]));
    }

    #[test]
    fn a_line_has_none() {
        assert_eq!(hull(points(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]])), None);
        assert_eq!(hull(points(&[[1.0, 1.0], [1.0, 1.0]])), None);
        assert_eq!(hull(Vec::new()), None);
    }
}
