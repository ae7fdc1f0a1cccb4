//! A lag whose rate is bounded, piece by piece over one step: `y' = clip((u - y) / tau, -SR..SR)` (section 6).
//!
//! With the input a straight line of slope s, the difference `d = u - y` decides: the lag is free while
//! `|d| <= SR tau`. Free, d moves monotonically towards `s tau`; bounded, it is a straight line. So both kinds of piece
//! end at an instant in closed form, and a step has at most three pieces.

use crate::lag::LagStep;

/// How the output moves.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Motion {
    /// The output moves as the lag alone would.
    Free,
    /// Up at the slew rate.
    Up,
    /// Down at the slew rate.
    Down,
}

/// The lag with a bounded rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Slew {
    /// Time constant of the lag (s).
    pub tau: f64,
    /// Slew rate (full scales a second).
    pub rate: f64,
}

/// A stretch of a step without a change of law; t runs from 0 to its length.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece {
    motion: Motion,
    slew: Slew,
    y: f64,
    u: f64,
    /// Slope of the input (1/s).
    s: f64,
    /// Length of the piece (s).
    pub length: f64,
}

impl Slew {
    /// The difference of input and output up to which the lag is free.
    pub fn reach(&self) -> f64 {
        match (self.rate, self.tau) {
            (0.0, _) => 0.0,
            (f64::INFINITY, _) => f64::INFINITY,
            (rate, tau) => rate * tau,
        }
    }

    /// Follows the input from `u0` to `u1` over `h` seconds from `y`; shows each piece to `visit`, returns the output.
    pub fn advance(&self, h: f64, mut y: f64, [u0, u1]: [f64; 2], mut visit: impl FnMut(&Piece)) -> f64 {
        let s = if h == 0.0 { 0.0 } else { (u1 - u0) / h };
        let mut motion = self.motion(u0 - y);
        let mut t = 0.0;
        while t < h {
            let u = u0 + s * t;
            let lasts = self.lasts(motion, u - y, s);
            let piece = Piece { motion, slew: *self, y, u, s, length: lasts.min(h - t) };
            if piece.length > 0.0 {
                visit(&piece);
                y = piece.y(piece.length);
            }
            t = if lasts < h - t { t + lasts } else { h };
            motion = next(motion, s);
        }
        y
    }

    fn motion(&self, d: f64) -> Motion {
        let reach = self.reach();
        if d > reach {
            Motion::Up
        } else if d < -reach {
            Motion::Down
        } else {
            Motion::Free
        }
    }

    /// How long the motion lasts from difference `d` on, under input slope `s`.
    fn lasts(&self, motion: Motion, d: f64, s: f64) -> f64 {
        match motion {
            Motion::Up => self.catches_up(d, s),
            Motion::Down => self.catches_up(-d, -s),
            Motion::Free if s > self.rate => self.escapes(d, s),
            Motion::Free if s < -self.rate => self.escapes(-d, -s),
            Motion::Free => f64::INFINITY,
        }
    }

    fn catches_up(&self, d: f64, s: f64) -> f64 {
        if s < self.rate { ((d - self.reach()) / (self.rate - s)).max(0.0) } else { f64::INFINITY }
    }

    fn escapes(&self, d: f64, s: f64) -> f64 {
        let reach = self.reach();
        if reach == 0.0 || reach == f64::INFINITY {
            return reach;
        }
        self.tau * libm::log1p((reach - d).max(0.0) / (self.tau * (s - self.rate)))
    }
}

/// What follows when a motion ends under input slope `s`.
fn next(motion: Motion, s: f64) -> Motion {
    match motion {
        Motion::Up | Motion::Down => Motion::Free,
        Motion::Free if s > 0.0 => Motion::Up,
        Motion::Free => Motion::Down,
    }
}

impl Piece {
    /// Returns the output at time `t` (s).
    pub fn y(&self, t: f64) -> f64 {
        match self.motion {
            Motion::Free if self.slew.tau == 0.0 => self.u(t),
            Motion::Free => LagStep::<f64>::new(t, self.slew.tau).step(self.y, self.u, self.u(t)),
            Motion::Up => self.y + self.slew.rate * t,
            Motion::Down => self.y - self.slew.rate * t,
        }
    }

    /// Returns the input at time `t` (s).
    pub fn u(&self, t: f64) -> f64 {
        self.u + self.s * t
    }

    /// Integral of the output over the piece. Of `tau y' = u - y` it is that of the input, less what the output has risen.
    pub fn area(&self) -> f64 {
        let ends = |value: fn(&Self, f64) -> f64| [value(self, 0.0), value(self, self.length)];
        let [[y0, y1], [u0, u1]] = [ends(Self::y), ends(Self::u)];
        match self.free_lag() {
            Some(tau) => 0.5 * (u0 + u1) * self.length - tau * (y1 - y0),
            None => 0.5 * (y0 + y1) * self.length,
        }
    }

    /// The time constant, where the output is that of the lag.
    pub fn free_lag(&self) -> Option<f64> {
        (self.motion == Motion::Free).then_some(self.slew.tau)
    }

    /// Where inside the piece the output turns round: the input meets it there.
    pub fn turn(&self) -> Option<f64> {
        let tau = self.free_lag()?;
        let towards = (self.u - self.y) / (self.s * tau);
        let t = tau * libm::log1p(-towards);
        (towards < 0.0 && t > 0.0 && t < self.length).then_some(t)
    }
}
