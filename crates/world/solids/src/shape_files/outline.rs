//! Outlines of faces that turn back on themselves, as triangles.

use glam::DVec3;

use crate::Solid;

/// Most corners of an outline that is cut into triangles: the work grows with their third power.
const MOST_CORNERS: usize = 256;

/// Triangles, by numbers of corners, of a plane outline that is not convex; `None` if it is convex already, or cannot be cut.
///
/// Ears are cut one by one: a corner that turns outwards and whose triangle holds no other corner.
pub(super) fn ears(corners: &[DVec3]) -> Option<Vec<[usize; 3]>> {
    let normal = normal_of(corners)?;
    let turn = |a: DVec3, b: DVec3, c: DVec3| normal.dot((b - a).cross(c - b));
    let extent = corners.iter().map(|corner| corner.distance(corners[0])).fold(0.0, f64::max);
    let around = |left: &[usize], at: usize| {
        let count = left.len();
        [left[(at + count - 1) % count], left[at], left[(at + 1) % count]]
    };
    let mut left: Vec<usize> = (0..corners.len()).collect();
    let is_dent = |at: usize| {
        let [a, b, c] = around(&left, at).map(|corner| corners[corner]);
        turn(a, b, c) < -Solid::TOLERANCE * extent * extent
    };
    let is_plane = corners.iter().all(|at| normal.dot(*at - corners[0]).abs() <= Solid::TOLERANCE * extent);
    if corners.len() > MOST_CORNERS || !is_plane || !(0..corners.len()).any(is_dent) || crosses(corners, turn)
    {
        return None;
    }
    let mut triangles = Vec::with_capacity(corners.len() - 2);
    while left.len() > 3 {
        let is_ear = |&at: &usize| {
            let own = around(&left, at);
            let [a, b, c] = own.map(|corner| corners[corner]);
            let within = |place: DVec3| {
                [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| turn(from, to, place) >= 0.0)
            };
            let others = left.iter().filter(|corner| !own.contains(corner));
            turn(a, b, c) > 0.0 && !others.map(|&corner| corners[corner]).any(within)
        };
        let ear = (0..left.len()).find(is_ear)?;
        triangles.push(around(&left, ear));
        left.remove(ear);
    }
    triangles.push([left[0], left[1], left[2]]);
    Some(triangles)
}

/// Whether two edges of an outline cross.
fn crosses(corners: &[DVec3], turn: impl Fn(DVec3, DVec3, DVec3) -> f64) -> bool {
    let edges = || corners.iter().zip(corners.iter().cycle().skip(1));
    let parts = |(a, b): (&DVec3, &DVec3), c: &DVec3, d: &DVec3| turn(*a, *b, *c) * turn(*a, *b, *d) < 0.0;
    edges().enumerate().any(|(number, (a, b))| {
        edges().skip(number + 1).any(|(c, d)| parts((a, b), c, d) && parts((c, d), a, b))
    })
}

/// The unit normal of an outline, by right-handed axes.
fn normal_of(corners: &[DVec3]) -> Option<DVec3> {
    let [first, ..] = corners else { return None };
    let next = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(next)
        .map(|(from, to)| (*from - *first).cross(*to - *first))
        .sum::<DVec3>()
        .try_normalize()
}

#[cfg(test)]
mod tests {
    use super::ears;
    use glam::DVec3;

    fn places(corners: &[[f64; 2]]) -> Vec<DVec3> {
        corners.iter().map(|&[x, y]| DVec3::new(x, y, 2.0)).collect()
    }

    #[test]
    fn ears_fill_an_outline_with_dents() {
        let star = places(&[
            [0.0, 0.0],
            [4.0, 1.0],
            [8.0, 0.0],
            [5.0, 3.0],
            [8.0, 8.0],
            [4.0, 5.0],
            [0.0, 8.0],
            [2.0, 4.0],
        ]);
        let area = |triangle: &[usize; 3]| {
            let [a, b, c] = triangle.map(|corner| star[corner]);
            0.5 * (b - a).cross(c - a).z
        };
        let triangles = ears(&star).unwrap();
        assert_eq!(triangles.len(), 6);
        assert!(triangles.iter().all(|triangle| area(triangle) > 0.0));
        // The shoelace sum of the outline.
        assert!((triangles.iter().map(area).sum::<f64>() - 28.0).abs() < 1e-12);
    }

    #[test]
    fn what_is_convex_or_crosses_itself_is_left() {
        assert_eq!(ears(&places(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])), None);
        let crossed = [[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0], [1.0, 2.0]];
        assert_eq!(ears(&places(&crossed)), None);
    }
}
