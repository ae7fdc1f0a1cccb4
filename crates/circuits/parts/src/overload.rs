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

/// The clip at an amplifier's output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Overload {
    /// Largest output, either sign.
    pub saturation: f64,
    /// Time constant of the recovery (s).
    pub recovery: f64,
}

/// At most this many cuts in a piece: one turn, and both clips on either side of it.
const CUTS: usize = 7;

/// An instant of a piece and the output there.
type Point = (f64, f64);

impl Overload {
    /// The store after `piece`, from `x`.
    pub fn advance(&self, mut x: f64, piece: &Piece) -> f64 {
        let (cuts, count) = self.cuts(piece);
        for pair in cuts[..count].windows(2) {
            x = self.stretch(x, piece, pair[0], pair[1]);
        }
        x
    }

    /// Points between which the output lies on one side of each clip, ends of the piece included.
    fn cuts(&self, piece: &Piece) -> ([Point; CUTS], usize) {
        let mut cuts = [(0.0, piece.y(0.0)); CUTS];
        let mut count = 1;
        for end in piece.turn().into_iter().chain([piece.length]) {
            let (start, end) = (cuts[count - 1], (end, piece.y(end)));
            let upwards = if end.1 > start.1 { self.saturation } else { -self.saturation };
            for level in [-upwards, upwards] {
                if let Some(t) = crossing(|t| piece.y(t), level, start, end) {
                    cuts[count] = (t, level);
                    count += 1;
                }
            }
            cuts[count] = end;
            count += 1;
        }
        (cuts, count)
    }

    fn stretch(&self, x: f64, piece: &Piece, (a, from): Point, (b, to): Point) -> f64 {
        let mean = (from + to) / 2.0;
        let level = mean.clamp(-self.saturation, self.saturation);
        if mean == level {
            // Nearly always there is nothing to decay.
            return if x == 0.0 { x } else { LagStep::<f64>::new(b - a, self.recovery).step(x, 0.0, 0.0) };
        }
        match piece.free_lag() {
            Some(tau) if is_time(tau) && is_time(self.recovery) => {
                self.behind_lag(tau, b - a, x, from - level, [piece.u(a) - level, piece.u(b) - level])
            }
            _ => LagStep::<f64>::new(b - a, self.recovery).step(x, from - level, to - level),
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

/// Neither none nor for ever.
fn is_time(time: f64) -> bool {
    time > 0.0 && time < f64::INFINITY
}

/// Where between two points the monotonic `f` is at `level`, if anywhere: a secant step, and a halving where that has
/// not halved the bracket, until the bracket is at rounding.
fn crossing(f: impl Fn(f64) -> f64, level: f64, start: Point, end: Point) -> Option<f64> {
    let mut ends = [(start.0, start.1 - level), (end.0, end.1 - level)];
    if (ends[0].1 > 0.0) == (ends[1].1 > 0.0) || ends[0].1 == 0.0 || ends[1].1 == 0.0 {
        return None;
    }
    let off = |t: f64| f(t) - level;
    loop {
        let [(a, fa), (b, fb)] = ends;
        narrow(&mut ends, (a * fb - b * fa) / (fb - fa), &off);
        if ends[1].0 - ends[0].0 > (b - a) / 2.0 {
            let middle = (ends[0].0 + ends[1].0) / 2.0;
            narrow(&mut ends, middle, &off);
        }
        // Nothing lies between, or nothing that a secant step could find.
        if ends[1].0 - ends[0].0 >= b - a || ends[0].1 == 0.0 {
            return Some(ends[0].0);
        }
    }
}

/// Moves the end of the bracket that has the sign of `f` at `c`; both on a root.
fn narrow(ends: &mut [Point; 2], c: f64, f: &impl Fn(f64) -> f64) {
    if c <= ends[0].0 || c >= ends[1].0 {
        return;
    }
    let value = f(c);
    if value == 0.0 {
        *ends = [(c, 0.0); 2];
    } else {
        ends[usize::from((value > 0.0) == (ends[1].1 > 0.0))] = (c, value);
    }
}
