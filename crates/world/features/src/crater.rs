//! The three crater types in closed form (section 9).

use std::fmt;

/// Radii of a crater, from the centre outwards (m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// Type 1: a paraboloid that meets the ground at `r1`.
    Bowl {
        /// Radius at which the bowl meets the ground (m).
        r1: f64,
    },
    /// Type 2: a paraboloid with a rim between `r1` and `r2`.
    RimmedBowl {
        /// End of the bowl.
        r1: f64,
        /// End of the rim.
        r2: f64,
    },
    /// Type 3: flat floor to `r1`, wall to `r2`, rim to `r3`.
    FlatFloor {
        /// End of the floor.
        r1: f64,
        /// End of the wall.
        r2: f64,
        /// End of the rim.
        r3: f64,
    },
}

/// Why a crater cannot be.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum CraterError {
    /// Radii that are not positive and strictly ascending.
    #[error("radii {0} m, {1} m, {2} m: expected radii above 0 in ascending order")]
    Radii(f64, f64, f64),
    /// Depth or rim height out of range.
    #[error("{what} {found} m: expected 0 m to 1e5 m")]
    Height {
        /// Name of the height at fault: `depth` or `rim`.
        what: &'static str,
        /// Depth or rim height that was given (m).
        found: f64,
    },
    /// Centre that is no place.
    #[error("centre ({0}, {1}) m: expected two lengths of at most 1e9 m either way")]
    Centre(f64, f64),
}

/// A crater that is in order: radii ascending, depth and rim at least 0, all finite.
#[derive(Clone, Copy, PartialEq)]
pub struct Crater {
    centre: [f64; 2],
    /// Radii of its shape, ascending; 0 for those that it does not have.
    radii: [f64; 3],
    depth: f64,
    rim: f64,
}

impl fmt::Debug for Crater {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { centre, depth, rim, .. } = self;
        let mut told = f.debug_struct("Crater");
        told.field("centre", centre)
            .field("shape", &self.shape())
            .field("depth", depth)
            .field("rim", rim)
            .finish()
    }
}

impl Crater {
    /// A crater at `centre` (north, east; m), `depth` (m) below the ground around, its rim `rim` (m) above it. A
    /// type 1 crater has no rim: `rim` must be 0.
    ///
    /// # Errors
    /// If radii do not ascend, or a height or the centre is out of range.
    pub fn new(centre: [f64; 2], shape: Shape, depth: f64, rim: f64) -> Result<Self, CraterError> {
        let (radii, reach) = match shape {
            Shape::Bowl { r1 } => ([r1, 0.0, 0.0], [r1, 2.0 * r1, 3.0 * r1]),
            Shape::RimmedBowl { r1, r2 } => ([r1, r2, 0.0], [r1, r2, 2.0 * r2]),
            Shape::FlatFloor { r1, r2, r3 } => ([r1, r2, r3], [r1, r2, r3]),
        };
        let [r1, r2, r3] = reach;
        let ascend = r1 > 0.0 && r2 > r1 && r3 > r2 && r3 < 1e9;
        if !ascend {
            return Err(CraterError::Radii(r1, r2, r3));
        }
        for (what, found) in [("depth", depth), ("rim", rim)] {
            if !(0.0..=1e5).contains(&found)
                || (what == "rim" && found > 0.0 && matches!(shape, Shape::Bowl { .. }))
            {
                return Err(CraterError::Height { what, found });
            }
        }
        if !centre.iter().all(|place| place.abs() <= 1e9) {
            return Err(CraterError::Centre(centre[0], centre[1]));
        }
        Ok(Self { centre, radii, depth, rim })
    }

    /// One that was in order once; radii that its shape does not have are 0.
    #[inline]
    pub(crate) fn of_radii(centre: [f64; 2], radii: [f64; 3], depth: f64, rim: f64) -> Self {
        Self { centre, radii, depth, rim }
    }

    /// Centre: north, east (m).
    pub fn centre(&self) -> [f64; 2] {
        self.centre
    }

    /// Returns the type of the crater with its radii (m).
    pub fn shape(&self) -> Shape {
        let [r1, r2, r3] = self.radii;
        if r3 > 0.0 {
            Shape::FlatFloor { r1, r2, r3 }
        } else if r2 > 0.0 {
            Shape::RimmedBowl { r1, r2 }
        } else {
            Shape::Bowl { r1 }
        }
    }

    /// Its type in the report: 1, 2 or 3.
    pub fn type_number(&self) -> u32 {
        match self.shape() {
            Shape::Bowl { .. } => 1,
            Shape::RimmedBowl { .. } => 2,
            Shape::FlatFloor { .. } => 3,
        }
    }

    /// Depth of the bowl or floor below the ground around, a (m).
    pub fn depth(&self) -> f64 {
        self.depth
    }

    /// Height of the rim crest above the ground around, delta (m).
    pub fn rim(&self) -> f64 {
        self.rim
    }

    /// Radius outside which there is nothing of it (m).
    pub fn outer(&self) -> f64 {
        let [r1, r2, r3] = self.radii;
        r1.max(r2).max(r3)
    }

    /// Radius of the flat floor (m): 0 for types 1 and 2.
    pub fn floor(&self) -> f64 {
        match self.shape() {
            Shape::FlatFloor { r1, .. } => r1,
            Shape::Bowl { .. } | Shape::RimmedBowl { .. } => 0.0,
        }
    }

    /// Radius at which bowl or wall comes up to the ground around, the inner foot of the rim (m): r1 of types 1 and
    /// 2, r2 of type 3.
    pub fn foot(&self) -> f64 {
        match self.shape() {
            Shape::Bowl { r1 } | Shape::RimmedBowl { r1, .. } => r1,
            Shape::FlatFloor { r2, .. } => r2,
        }
    }

    /// Radii (m), ascending, at which the slope jumps (table of section 9): r1 of type 1; r1, r2 of type 2; r2, r3 of
    /// type 3. The last is [`outer`](Self::outer).
    pub fn kinks(&self) -> impl Iterator<Item = f64> {
        let inner = Some(self.foot()).filter(|foot| *foot < self.outer());
        inner.into_iter().chain([self.outer()])
    }

    /// Height (m) that nothing of it exceeds.
    pub fn highest(&self) -> f64 {
        self.rim
    }

    /// Height (m) that nothing of it is below.
    pub fn lowest(&self) -> f64 {
        -self.depth
    }

    /// Way from its floor to the crest of its rim (m).
    pub fn relief(&self) -> f64 {
        self.depth + self.rim
    }

    /// Slope that nothing of it exceeds either way: bowl and rim are steepest where they meet the ground around.
    pub fn steepest(&self) -> f64 {
        let (floor, foot, outer) = (self.floor(), self.foot(), self.outer());
        let wall = 2.0 * self.depth / (foot - floor);
        if outer > foot { wall.max(4.0 * self.rim / (outer - foot)) } else { wall }
    }

    /// Height (m) and its derivative outwards at a distance `rho` (m) from the centre. The lower bound of each
    /// interval belongs to it.
    pub fn profile(&self, rho: f64) -> [f64; 2] {
        match self.shape() {
            Shape::Bowl { r1 } => self.bowl(rho, r1),
            Shape::RimmedBowl { r1, r2 } if rho >= r1 => self.ring(rho, r1, r2),
            Shape::RimmedBowl { r1, .. } => self.bowl(rho, r1),
            Shape::FlatFloor { r1, .. } if rho < r1 => [-self.depth, 0.0],
            Shape::FlatFloor { r1, r2, .. } if rho < r2 => self.bowl(rho - r1, r2 - r1),
            Shape::FlatFloor { r2, r3, .. } => self.ring(rho, r2, r3),
        }
    }

    fn bowl(&self, rho: f64, radius: f64) -> [f64; 2] {
        let share = rho / radius;
        if share < 1.0 {
            [self.depth * (share * share - 1.0), 2.0 * self.depth * share / radius]
        } else {
            [0.0; 2]
        }
    }

    fn ring(&self, rho: f64, inner: f64, outer: f64) -> [f64; 2] {
        let width = outer - inner;
        let place = (2.0 * rho - inner - outer) / width;
        if rho < outer {
            [self.rim * (1.0 - place * place), -4.0 * self.rim * place / width]
        } else {
            [0.0; 2]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Crater, CraterError, Shape};

    #[test]
    fn check_table_23_4() {
        let t1 = Crater::new([0.0; 2], Shape::Bowl { r1: 100.0 }, 20.0, 0.0).unwrap();
        let t2 = Crater::new([0.0; 2], Shape::RimmedBowl { r1: 100.0, r2: 140.0 }, 20.0, 6.0).unwrap();
        let t3 =
            Crater::new([0.0; 2], Shape::FlatFloor { r1: 40.0, r2: 100.0, r3: 140.0 }, 20.0, 6.0).unwrap();
        let rows = [
            (50.0, t1, [-15.0, 0.2]),
            (50.0, t2, [-15.0, 0.2]),
            (50.0, t3, [-19.44444444444444, 0.1111111111111111]),
            (5.0, t1, [-19.95, 0.02]),
            (5.0, t3, [-20.0, 0.0]),
            (110.0, t1, [0.0, 0.0]),
            (110.0, t2, [4.5, 0.3]),
            (110.0, t3, [4.5, 0.3]),
            (125.0, t2, [5.625, -0.15]),
            (119.0, t3, [5.985, 0.03]),
            (100.0, t2, [0.0, 0.6]),
            (100.0, t3, [0.0, 0.6]),
            // The ground around begins where the crater ends.
            (100.0, t1, [0.0, 0.0]),
            (140.0, t2, [0.0, 0.0]),
            (140.0, t3, [0.0, 0.0]),
        ];
        for (rho, crater, expected) in rows {
            for (found, expected) in crater.profile(rho).into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-13, "{crater:?} at {rho}: {found}");
            }
        }
    }

    #[test]
    fn slopes_jump_at_the_kinks_and_nowhere_else() {
        let shapes = [
            (Shape::Bowl { r1: 100.0 }, 0.0, vec![100.0]),
            (Shape::RimmedBowl { r1: 100.0, r2: 140.0 }, 6.0, vec![100.0, 140.0]),
            (Shape::FlatFloor { r1: 40.0, r2: 100.0, r3: 140.0 }, 6.0, vec![100.0, 140.0]),
        ];
        for (shape, rim, kinks) in shapes {
            let crater = Crater::new([3.0, 4.0], shape, 20.0, rim).unwrap();
            assert_eq!(crater.kinks().collect::<Vec<_>>(), kinks);
            let slope = |rho: f64| crater.profile(rho)[1];
            for rho in (1..1500).map(|k| 0.1 * f64::from(k)) {
                let jumps = (slope(rho + 1e-9) - slope(rho - 1e-9)).abs() > 1e-6;
                assert_eq!(jumps, kinks.iter().any(|kink| (kink - rho).abs() < 1e-6), "{shape:?} at {rho}");
            }
        }
    }

    #[test]
    fn bounds_hold_and_are_met() {
        let shapes = [
            (Shape::Bowl { r1: 100.0 }, 0.0),
            (Shape::RimmedBowl { r1: 100.0, r2: 140.0 }, 6.0),
            (Shape::FlatFloor { r1: 90.0, r2: 100.0, r3: 140.0 }, 6.0),
        ];
        for (shape, rim) in shapes {
            let crater = Crater::new([0.0; 2], shape, 20.0, rim).unwrap();
            let profile: Vec<_> = (0..150_000).map(|k| crater.profile(1e-3 * f64::from(k))).collect();
            let largest = |f: fn(&[f64; 2]) -> f64| profile.iter().map(f).fold(f64::NEG_INFINITY, f64::max);
            let met = [
                (largest(|p| p[0]), crater.highest()),
                (largest(|p| -p[0]), -crater.lowest()),
                (largest(|p| p[1].abs()), crater.steepest()),
            ];
            for (found, bound) in met {
                assert!(found <= bound && found > bound - 1e-3, "{shape:?}: {found} against {bound}");
            }
        }
    }

    #[test]
    fn impossible_craters_are_refused() {
        let refused = Crater::new([0.0; 2], Shape::RimmedBowl { r1: 4.0, r2: 3.0 }, 1.0, 0.0);
        assert_eq!(refused, Err(CraterError::Radii(4.0, 3.0, 6.0)));
        assert!(Crater::new([0.0; 2], Shape::Bowl { r1: f64::NAN }, 1.0, 0.0).is_err());
        assert!(Crater::new([0.0; 2], Shape::Bowl { r1: 1.0 }, -1.0, 0.0).is_err());
        assert!(Crater::new([0.0; 2], Shape::Bowl { r1: 1.0 }, 1.0, 0.5).is_err());
    }
}
