//! What the vehicle is asked to do beyond its limits: reported, not refused.

use std::fmt;
use std::ops::Range;

use quantities::degrees;

use crate::Vehicle;
use crate::pose_table::PoseRow;

/// A limit of the vehicle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit {
    /// Speed along the ground (m/s).
    Speed,
    /// Rate of turn, either way (rad/s).
    Turn,
    /// Steepness of the ground (rad).
    Slope,
}

/// One stretch of frames beyond a limit.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitReport {
    /// Limit that the vehicle exceeds.
    pub what: Limit,
    /// Frames of the whole stretch.
    pub frames: Range<u64>,
    /// The worst frame of the stretch.
    pub frame: u64,
    /// Time of the worst frame (s).
    pub time: f64,
    /// What was found there, in the unit of `what`.
    pub found: f64,
    /// What is allowed, in the unit of `what`.
    pub allowed: f64,
}

impl fmt::Display for LimitReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (what, unit, scale): (_, _, fn(f64) -> f64) = match self.what {
            Limit::Speed => ("speed", "m/s", |speed| speed),
            Limit::Turn => ("turn rate", "deg/s", degrees),
            Limit::Slope => ("slope", "deg", degrees),
        };
        let (found, allowed) = (scale(self.found), scale(self.allowed));
        let Range { start, end } = self.frames;
        write!(f, "{what} {found:.2} {unit} in frame {} (t = {:.3} s), ", self.frame, self.time)?;
        write!(f, "the vehicle's limit is {allowed:.2} {unit}; beyond it in frames {start}..{end}")
    }
}

/// Every stretch of `rows` beyond a limit of `vehicle`, limit by limit.
pub(crate) fn limit_reports(rows: &[PoseRow], vehicle: &Vehicle) -> Vec<LimitReport> {
    let speed = stretches(rows, Limit::Speed, vehicle.max_speed, |row| row.speed);
    let turn = stretches(rows, Limit::Turn, vehicle.max_turn, |row| row.turn_rate.abs());
    let slope = stretches(rows, Limit::Slope, vehicle.max_slope, |row| row.slope);
    [speed, turn, slope].concat()
}

fn stretches(rows: &[PoseRow], what: Limit, allowed: f64, of: impl Fn(&PoseRow) -> f64) -> Vec<LimitReport> {
    // A limit that is driven at exactly is not exceeded by the last bits of a division.
    let exceeds = |row: &PoseRow| of(row) > allowed * (1.0 + 1e-9);
    let over = rows.chunk_by(|a, b| exceeds(a) == exceeds(b)).filter(|stretch| exceeds(&stretch[0]));
    over.map(|stretch| {
        let worst = stretch.iter().reduce(|a, b| if of(b) > of(a) { b } else { a }).unwrap_or(&stretch[0]);
        LimitReport {
            what,
            frames: stretch[0].frame..stretch[stretch.len() - 1].frame + 1,
            frame: worst.frame,
            time: worst.pose.time,
            found: of(worst),
            allowed,
        }
    })
    .collect()
}
