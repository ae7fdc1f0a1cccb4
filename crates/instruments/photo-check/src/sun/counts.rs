//! How many posts are dark in the photograph, in the ground, in both and in none, tile by tile.

/// Tiles along each side of the ground (chosen).
pub(super) const ACROSS: usize = 4;
/// Number of tiles of the ground.
pub(super) const TILES: usize = ACROSS * ACROSS;

/// Numbers of posts: dark in none, in the ground alone, in the photograph alone, in both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Counts(pub [u64; 4]);

/// The counts of every tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Tiles(pub [Counts; TILES]);

impl Tiles {
    /// Counts of all tiles together.
    pub fn total(&self) -> Counts {
        self.without(None)
    }

    /// Counts of all tiles but one.
    pub fn without(&self, left_out: Option<usize>) -> Counts {
        let kept = self.0.iter().enumerate().filter(|(tile, _)| Some(*tile) != left_out);
        Counts(kept.fold([0; 4], |sum, (_, counts)| [0, 1, 2, 3].map(|kind| sum[kind] + counts.0[kind])))
    }
}

impl Counts {
    fn numbers(&self) -> [f64; 4] {
        self.0.map(|count| count as f64)
    }

    /// Correlation of dark posts (phi), -1 to 1; none where one of the two is all dark or all lit.
    pub fn overlap(&self) -> Option<f64> {
        let [none, ground, photo, both] = self.numbers();
        let sides = [both + photo, none + ground, both + ground, none + photo];
        let scale = (sides[0] * sides[1]).sqrt() * (sides[2] * sides[3]).sqrt();
        (scale > 0.0).then(|| (both * none - photo * ground) / scale)
    }

    /// Posts that are dark in both, as a share of those that are dark in either; 0 where none is.
    pub fn common(&self) -> f64 {
        let [_, ground, photo, both] = self.numbers();
        both / (ground + photo + both).max(1.0)
    }

    /// Shares of dark posts in the photograph and in the ground.
    pub fn dark(&self) -> [f64; 2] {
        let [none, ground, photo, both] = self.numbers();
        let all = (none + ground + photo + both).max(1.0);
        [(photo + both) / all, (ground + both) / all]
    }
}

#[cfg(test)]
mod tests {
    use super::{Counts, TILES, Tiles};

    /// Dark in none 4, in the ground alone 1, in the photograph alone 2, in both 3.
    const SOME: Counts = Counts([4, 1, 2, 3]);

    #[test]
    fn overlap_is_the_correlation_of_two_maps() {
        // (3 x 4 - 2 x 1) / sqrt((3 + 2) (4 + 1) (3 + 1) (4 + 2))
        assert!((SOME.overlap().unwrap() - 10.0 / 600.0_f64.sqrt()).abs() < 1e-15);
        assert_eq!((SOME.common(), SOME.dark()), (0.5, [0.5, 0.4]));
        assert_eq!(Counts([5, 0, 0, 5]).overlap(), Some(1.0));
        assert_eq!(Counts([0, 5, 5, 0]).overlap(), Some(-1.0));
        assert_eq!(Counts([4, 6, 0, 0]).overlap(), None);
    }

    #[test]
    fn a_tile_that_is_left_out_is_in_no_sum() {
        let mut tiles = Tiles([SOME; TILES]);
        tiles.0[3] = Counts([0, 0, 0, 100]);
        assert_eq!(tiles.total().0, [60, 15, 30, 145]);
        assert_eq!(tiles.without(Some(3)).0, [60, 15, 30, 45]);
    }
}
