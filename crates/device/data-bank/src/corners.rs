//! From regions to the corners that draw them.

use std::collections::BTreeSet;

/// The corners of `regions` (north, east), each once, in order of first use, as indices into a level of
/// `corners` (north, east) corners. Regions that the level does not store are left out.
pub fn corners_of(regions: impl Iterator<Item = [usize; 2]>, corners: [usize; 2]) -> Vec<u32> {
    let mut seen = BTreeSet::new();
    let mut listed = Vec::new();
    for [m, n] in regions.filter(|&[m, n]| m + 1 < corners[0] && n + 1 < corners[1]) {
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let corner = ((m + i) * corners[1] + n + j) as u32;
            if seen.insert(corner) {
                listed.push(corner);
            }
        }
    }
    listed
}

/// Orders corners of a level with `columns` corners to the east by their distance from `foot` (north, east, in
/// regions from the level's origin): sweeps meet the nearest first. Equal distances keep ascending indices.
pub fn nearest_first(corners: &mut [u32], columns: usize, foot: [f64; 2]) {
    let columns = columns.max(1) as u32;
    let distance = |corner: u32| {
        let [north, east] = [f64::from(corner / columns) - foot[0], f64::from(corner % columns) - foot[1]];
        north * north + east * east
    };
    corners.sort_unstable_by(|&a, &b| distance(a).total_cmp(&distance(b)).then(a.cmp(&b)));
}

#[cfg(test)]
mod tests {
    use super::{corners_of, nearest_first};

    #[test]
    fn a_corner_that_four_regions_share_is_named_once() {
        let regions = [[0, 0], [0, 1], [1, 0], [1, 1]];
        assert_eq!(corners_of(regions.into_iter(), [3, 4]), [0, 1, 4, 5, 2, 6, 8, 9, 10]);
    }

    #[test]
    fn regions_beyond_the_level_have_no_corners() {
        assert_eq!(corners_of([[2, 0], [0, 3], [1, 2]].into_iter(), [3, 4]), [6, 7, 10, 11]);
        assert!(corners_of([[0, 0]].into_iter(), [0, 0]).is_empty());
    }

    #[test]
    fn the_corner_under_the_foot_comes_first() {
        let mut corners: Vec<u32> = (0..12).collect();
        nearest_first(&mut corners, 4, [1.1, 1.8]);
        assert_eq!(corners[..4], [6, 5, 10, 2]);
        assert_eq!(corners[11], 0);
    }

    #[test]
    fn equal_distances_keep_ascending_indices() {
        let mut corners = [9, 6, 4, 1, 5];
        nearest_first(&mut corners, 4, [1.0, 1.0]);
        assert_eq!(corners, [5, 1, 4, 6, 9]);
    }
}
