//! Clip of an amplifier's output, with the time it needs to recover (section 6; artefact A25).
//!
//! **Law** (our choice: section 6 names the recovery lag and no law). What is beyond the clip, `e = y - clip(y)`, fills a
//! store, `T x' = e - x`, and the output is `clip(y + x)`. So an overload ends late, by a tail with time constant T
//! that grows with how far and how long it went; `T = 0` is a plain clip.
//! Over a piece of the slew-bounded lag: e is cut where y passes the clip, a bracketed root between the turns of y.
//! Between the cuts the store is a lag behind a straight line, or behind a lag: a second order with two real modes.

use crate::lag::LagStep;
use crate::second_order::{SecondOrder, SecondOrderState};
use crate::slew::Piece;

/// The clip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Overload {
    /// Largest output, either sign.
    pub saturation: f64,
    /// Recovery lag (s).
    pub recovery: f64,
}

/// At most this many cuts in a piece: one turn, and both clips on either side of it.
const CUTS: usize = 7;

impl Overload {
    /// The store after `piece`, from `x`.
    pub fn advance(&self, mut x: f64, piece: &Piece) -> f64 {
        let (cuts, count) = self.cuts(piece);
        for pair in cuts[..count].windows(2) {
            x = self.stretch(x, piece, pair[0], pair[1]);
        }
        x
    }

    /// Instants between which the output lies on one side of each clip, ends of the piece included.
    fn cuts(&self, piece: &Piece) -> ([f64; CUTS], usize) {
        let (mut cuts, mut count) = ([0.0; CUTS], 1);
        let turn = piece.turn();
        let mut start = 0.0;
        for end in turn.into_iter().chain([piece.length]) {
            let rising = piece.y(end) > piece.y(start);
            let levels = if rising { [-self.saturation, self.saturation] } else { [self.saturation, -self.saturation] };
            for level in levels {
                if let Some(t) = crossing(|t| piece.y(t) - level, start, end) {
                    cuts[count] = t;
                    count += 1;
                }
            }
            cuts[count] = end;
            count += 1;
            start = end;
        }
        (cuts, count)
    }

    fn stretch(&self, x: f64, piece: &Piece, a: f64, b: f64) -> f64 {
        let middle = piece.y((a + b) / 2.0);
        let level = if middle > self.saturation {
            self.saturation
        } else if middle < -self.saturation {
            -self.saturation
        } else {
            return LagStep::<f64>::new(b - a, self.recovery).step(x, 0.0, 0.0);
        };
        let excess = [piece.y(a) - level, piece.y(b) - level];
        match piece.free_lag() {
            Some(tau) if tau > 0.0 && tau * self.recovery > 0.0 && (tau * self.recovery).is_finite() => {
                self.behind_lag(tau, b - a, x, excess[0], [piece.u(a) - level, piece.u(b) - level])
            }
            _ => LagStep::<f64>::new(b - a, self.recovery).step(x, excess[0], excess[1]),
        }
    }

    /// The store behind the lag `tau`: `tau T x'' + (tau + T) x' + x = u`.
    fn behind_lag(&self, tau: f64, h: f64, x: f64, excess: f64, [u0, u1]: [f64; 2]) -> f64 {
        let mean = tau.sqrt() * self.recovery.sqrt();
        let modes = SecondOrder { natural: 1.0 / mean, damping: (tau + self.recovery) / (2.0 * mean) };
        let start = SecondOrderState { y: x, rate: (excess - x) / self.recovery };
        modes.step::<f64>(h).step(start, u0, u1).y
    }
}

/// The root of the monotonic `f` in `a..b`, if its sign changes: secant steps with the weight of an end that stays
/// halved each time (Illinois), until the bracket or the value is at rounding.
fn crossing(f: impl Fn(f64) -> f64, mut a: f64, mut b: f64) -> Option<f64> {
    let (mut fa, mut fb) = (f(a), f(b));
    if fa * fb >= 0.0 {
        return None;
    }
    for _ in 0..100 {
        let c = (a * fb - b * fa) / (fb - fa);
        let fc = f(c);
        if fc == 0.0 || !(a < c && c < b) {
            return Some(c.clamp(a, b));
        }
        if (fc > 0.0) == (fb > 0.0) {
            (b, fb, fa) = (c, fc, fa / 2.0);
        } else {
            (a, fa, fb) = (c, fc, fb / 2.0);
        }
    }
    Some((a + b) / 2.0)
}
