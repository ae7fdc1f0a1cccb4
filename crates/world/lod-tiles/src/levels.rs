//! At which distance a tile has which level, and how far it has morphed.

use crate::TileError;

/// A level's range of distances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Level {
    /// Where its range ends (m); that of the coarsest level has no end, whatever stands here.
    pub end: f64,
    /// Share of the range, at its far end, over which it morphs into the next level, 0 to 1; 0 switches at the end.
    pub share: f64,
}

/// Levels with ranges that join, the finest first.
#[derive(Debug, Clone, PartialEq)]
pub struct Levels {
    levels: Vec<Level>,
}

impl Levels {
    /// The levels of tiles of order `order`.
    ///
    /// # Errors
    /// If there are none or too many, ranges do not rise, or a share is none.
    pub fn new(order: u32, levels: Vec<Level>) -> Result<Self, TileError> {
        let most = order as usize + 1;
        if !(1..=most).contains(&levels.len()) {
            return Err(TileError::Count { found: levels.len(), most });
        }
        let mut begin = 0.0;
        for (level, &Level { end, share }) in levels.iter().enumerate() {
            if !(end > begin && end.is_finite()) {
                return Err(TileError::Range { level, begin, end });
            }
            if !(0.0..=1.0).contains(&share) {
                return Err(TileError::Share { level, share });
            }
            begin = end;
        }
        Ok(Self { levels })
    }

    /// How many levels there are.
    pub fn count(&self) -> usize {
        self.levels.len()
    }

    /// The level whose range holds a distance (m).
    pub fn at(&self, distance: f64) -> usize {
        let inside = self.levels.iter().position(|level| distance < level.end);
        inside.unwrap_or(self.levels.len() - 1)
    }

    /// How far a level has become the next one at a distance (m): 0 to 1, and 0 for the coarsest.
    pub fn fraction(&self, level: usize, distance: f64) -> f64 {
        if level + 1 == self.levels.len() {
            return 0.0;
        }
        let Level { end, share } = self.levels[level];
        let zone = self.zone(level);
        if share == 0.0 {
            f64::from(u8::from(distance >= end))
        } else {
            ((distance - (end - zone)) / zone).clamp(0.0, 1.0)
        }
    }

    /// Length (m) of the zone in which a level morphs.
    pub fn zone(&self, level: usize) -> f64 {
        let begin = if level == 0 { 0.0 } else { self.levels[level - 1].end };
        self.levels[level].share * (self.levels[level].end - begin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of the document.
    #[test]
    fn morphing_begins_at_5_17_and_28_metres() {
        let levels = [(10.0, 0.5), (20.0, 0.3), (30.0, 0.2), (40.0, 0.9)];
        let levels = Levels::new(5, levels.map(|(end, share)| Level { end, share }).into()).unwrap();
        let found = [(0, 5.0), (0, 7.5), (0, 9.0), (0, 10.0)].map(|(level, at)| levels.fraction(level, at));
        assert_eq!(found, [0.0, 0.5, 0.8, 1.0]);
        assert!((levels.fraction(1, 18.0) - 1.0 / 3.0).abs() < 1e-15);
        assert!((levels.fraction(1, 19.5) - 5.0 / 6.0).abs() < 1e-15);
        assert!(levels.fraction(1, 17.0) == 0.0 && levels.fraction(2, 28.0).abs() < 1e-15);
        assert_eq!((levels.at(9.99), levels.at(10.0), levels.at(99.0)), (0, 1, 3));
        assert_eq!(levels.fraction(3, 39.0), 0.0, "the coarsest has nothing to become");
    }

    #[test]
    fn without_a_zone_a_level_switches_at_its_end() {
        let levels = [(10.0, 0.0), (20.0, 0.0)];
        let levels = Levels::new(1, levels.map(|(end, share)| Level { end, share }).into()).unwrap();
        assert_eq!((levels.fraction(0, 9.999), levels.fraction(0, 10.0)), (0.0, 1.0));
    }

    #[test]
    fn ranges_that_do_not_join_are_refused() {
        let of =
            |ends: &[f64], share: f64| Levels::new(2, ends.iter().map(|&end| Level { end, share }).collect());
        assert!(matches!(of(&[10.0, 10.0], 0.1), Err(TileError::Range { level: 1, .. })));
        assert!(matches!(of(&[f64::NAN], 0.1), Err(TileError::Range { level: 0, .. })));
        assert!(matches!(of(&[10.0], 1.1), Err(TileError::Share { .. })));
        assert!(matches!(of(&[], 0.1), Err(TileError::Count { found: 0, most: 3 })));
        assert!(matches!(of(&[1.0, 2.0, 3.0, 4.0], 0.1), Err(TileError::Count { found: 4, most: 3 })));
    }
}
