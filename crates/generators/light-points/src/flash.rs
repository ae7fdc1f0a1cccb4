//! Flashing lamps, as a function of time.

use crate::error::{LightError, checked};

/// A lamp that is lit for a share of every period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flash {
    period: f64,
    duty: f64,
    phase: f64,
}

impl Flash {
    /// A programme with its period (s, above 0), the share of it that is lit (0 to 1), and where in it time 0 lies (0 to below 1,
    /// a share of the period).
    ///
    /// # Errors If one of them is out of range or not finite.
    pub fn new(period: f64, duty: f64, phase: f64) -> Result<Self, LightError> {
        Ok(Self {
            period: checked("period of a flash (s)", period, "a number above 0", |period| period > 0.0)?,
            duty: checked("duty of a flash", duty, "0 to 1", |duty| (0.0..=1.0).contains(&duty))?,
            phase: checked("phase of a flash", phase, "0 to below 1", |phase| (0.0..1.0).contains(&phase))?,
        })
    }

    /// Whether the lamp is lit at a time (s), before 0 too. The lit part is the first of each period.
    pub fn is_lit(&self, time: f64) -> bool {
        let periods = time / self.period + self.phase;
        periods - periods.floor() < self.duty
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_part_of_each_period_is_lit() {
        let flash = Flash::new(2.0, 0.25, 0.0).unwrap();
        let lit = |flash: &Flash, times: [f64; 5]| times.map(|time| flash.is_lit(time));
        assert_eq!(lit(&flash, [0.0, 0.4, 0.5, 1.9, 2.1]), [true, true, false, false, true]);
        assert_eq!(lit(&flash, [-0.1, -1.4, -1.6, -2.0, -2.1]), [false, false, true, true, false]);
        let late = Flash::new(2.0, 0.25, 0.5).unwrap();
        assert_eq!(lit(&late, [0.0, 0.9, 1.0, 1.4, 1.5]), [false, false, true, true, false]);
        assert!(
            Flash::new(1.0, 1.0, 0.0).unwrap().is_lit(0.99)
                && !Flash::new(1.0, 0.0, 0.0).unwrap().is_lit(0.0)
        );
    }

    #[test]
    fn figures_out_of_range_are_refused() {
        for [period, duty, phase] in
            [[0.0, 0.5, 0.0], [1.0, 1.1, 0.0], [1.0, -0.1, 0.0], [1.0, 0.5, 1.0], [f64::INFINITY, 0.5, 0.0]]
        {
            assert!(Flash::new(period, duty, phase).is_err(), "{period} {duty} {phase}");
        }
    }
}
