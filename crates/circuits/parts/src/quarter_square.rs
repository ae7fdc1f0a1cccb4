//! Ripple of a quarter-square multiplier: `a b = ((a + b) / 2)^2 - ((a - b) / 2)^2` with each parabola a broken line.
//!
//! **Law** (sections 3.4 and 6). A parabola of N equal segments on either side of 0, equal ripple, is off by
//! `(s (1 - s) - 1/8) / N^2`, s the place in the segment 0..1: at most `1 / (8 N^2)`. The ripple of the product is that
//! at `(a + b) / 2` less that at `(a - b) / 2`, so the 1/8 drops out.
//! **Parameters.** N.
//! **State and timing.** None.

use signal::Real;

/// The ripple, to be added to a product.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuarterSquare {
    segments: f64,
}

impl QuarterSquare {
    /// Parabolas of `segments` (at least 1) to a side.
    pub fn new(segments: u32) -> Self {
        Self { segments: f64::from(segments.max(1)) }
    }

    /// What is added to the product of `a` and `b` (shares of full scale).
    #[inline]
    pub fn ripple<S: Real>(&self, a: S, b: S) -> S {
        self.parabola(a + b) - self.parabola(a - b)
    }

    /// Chord less parabola at `twice / 2`.
    #[inline(always)]
    fn parabola<S: Real>(&self, twice: S) -> S {
        let place = (twice.to_f64() / 2.0).abs() * self.segments;
        let s = place - place.floor();
        S::from_f64(s * (1.0 - s) / (self.segments * self.segments))
    }
}

#[cfg(test)]
mod tests {
    use super::QuarterSquare;

    #[test]
    fn a_broken_parabola_is_the_parabola_and_its_ripple() {
        let n = 10.0;
        let ripple = QuarterSquare::new(10);
        // Chords of x^2, lowered by half their sagitta.
        let broken = |x: f64| {
            let k = (x.abs() * n).floor();
            let (start, end) = (k / n, (k + 1.0) / n);
            start * start + (x.abs() - start) * (start + end) - 1.0 / (8.0 * n * n)
        };
        for i in -50..=50 {
            for j in -50..=50 {
                let (a, b) = (f64::from(i) / 50.3, f64::from(j) / 50.3);
                let product = broken((a + b) / 2.0) - broken((a - b) / 2.0);
                let with_ripple = a * b + ripple.ripple(a, b);
                assert!((product - with_ripple).abs() < 1e-13, "{a}, {b}");
            }
        }
    }

    #[test]
    fn no_more_than_twice_one_parabola() {
        let ripple = QuarterSquare::new(10);
        let at = |i: i32| ripple.ripple(f64::from(i) / 1000.0, 0.37).abs();
        let most = (-1000..=1000).map(at).fold(0.0, f64::max);
        assert!(most > 0.00125 && most <= 0.0025, "{most}");
    }
}
