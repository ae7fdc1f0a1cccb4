//! The deflection yoke: how the picture follows the vehicle's roll (section 18).
//!
//! ```text
//! roll ─▶ pulses, or a servo ─▶ where the motor is told to stand ─▶ second order ─▶ angle of the picture
//! ```
//!
//! **Law.** The motor is told to go to the nearest angle at which it can stand, by a step a pulse. A yoke of real
//! mechanics is a mass on that motor (hardware-1969, section 6: second order, driven by steps): each step swings it,
//! exactly between the pulses, whatever the frames are.

use parts::{SecondOrder, SecondOrderState};

/// The deflection yoke and its stepping motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Yoke {
    /// Angle of a step (rad); 0 is a servo without steps.
    pub step: f64,
    /// Fastest turn (rad/s).
    pub rate: f64,
    /// Whole travel, from stop to stop (rad): half of it either way.
    pub travel: f64,
    /// Natural frequency of motor and yoke (Hz); the yoke stands where its motor is told to if `None`.
    pub natural: Option<f64>,
    /// Damping, of critical; read with a natural frequency alone.
    pub damping: f64,
}

/// Where a yoke is on its way.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Swing {
    /// Where the motor was told to stand (rad).
    told: f64,
    /// Angle of the picture (rad), and its rate.
    yoke: SecondOrderState<f64>,
}

impl Swing {
    /// Angle of the picture (rad).
    pub fn angle(&self) -> f64 {
        self.yoke.y
    }
}

impl Yoke {
    /// Angle nearest to `roll` (rad) at which it can stand.
    pub fn settled(&self, roll: f64) -> f64 {
        let stop = 0.5 * self.travel;
        let wanted = roll.clamp(-stop, stop);
        if self.step == 0.0 {
            return wanted;
        }
        let last = whole_steps(stop / self.step);
        (wanted / self.step).round().clamp(-last, last) * self.step
    }

    /// Angle (rad) at `times[1]` (s) if it stood at `angle` at `times[0]` and was told to go to `roll`. Pulses come
    /// at whole multiples of their period since the start of the mission, so no part of a step is lost at a frame.
    pub fn follow(&self, angle: f64, roll: f64, times: [f64; 2]) -> f64 {
        let wanted = self.settled(roll) - angle;
        let reach = if self.step == 0.0 {
            self.rate * (times[1] - times[0])
        } else {
            let pulses = times.map(|time| whole_steps(time * self.rate / self.step));
            (pulses[1] - pulses[0]) * self.step
        };
        if wanted.abs() <= reach {
            return self.settled(roll);
        }
        let moved = angle + reach * wanted.signum();
        // Sums of steps keep to the multiples at which the motor stands.
        if self.step == 0.0 { moved } else { (moved / self.step).round() * self.step }
    }

    /// At rest, settled at `roll` (rad).
    pub(crate) fn at_rest(&self, roll: f64) -> Swing {
        let told = self.settled(roll);
        Swing { told, yoke: SecondOrderState { y: told, rate: 0.0 } }
    }

    /// [`Yoke::follow`] with the mass of the yoke.
    pub(crate) fn swing(&self, from: Swing, roll: f64, times: [f64; 2]) -> Swing {
        let told = self.follow(from.told, roll, times);
        let yoke = match self.natural {
            None => SecondOrderState { y: told, rate: 0.0 },
            Some(hertz) => {
                let natural = 2.0 * std::f64::consts::PI * hertz;
                let mass = SecondOrder { natural, damping: self.damping };
                Drive { yoke: self, mass, told: [from.told, told], times }.run(from.yoke)
            }
        };
        Swing { told, yoke }
    }
}

/// Pulses between two frames beyond which the motor runs rather than steps: no yoke tells them apart.
const MOST_PULSES: f64 = 1000.0;

/// What the motor does between two frames.
struct Drive<'a> {
    yoke: &'a Yoke,
    mass: SecondOrder,
    /// Where it is told to stand at the begin and at the end.
    told: [f64; 2],
    /// Begin and end (s).
    times: [f64; 2],
}

impl Drive<'_> {
    fn run(&self, state: SecondOrderState<f64>) -> SecondOrderState<f64> {
        let (Yoke { step, .. }, [from, to]) = (self.yoke, self.told);
        let pulses = if *step == 0.0 { 0.0 } else { ((to - from).abs() / step).round() };
        if *step > 0.0 && pulses <= MOST_PULSES {
            self.steps(state, pulses as u32)
        } else {
            self.run_on(state)
        }
    }

    /// Pulse by pulse from the first one after the begin.
    fn steps(&self, mut state: SecondOrderState<f64>, pulses: u32) -> SecondOrderState<f64> {
        let ([from, to], [begin, end]) = (self.told, self.times);
        let period = self.yoke.step / self.yoke.rate;
        let passed = whole_steps(begin / period);
        let (mut now, mut told) = (begin, from);
        for pulse in 1..=pulses {
            let instant = ((passed + f64::from(pulse)) * period).clamp(now, end);
            state = self.mass.step::<f64>(instant - now).step(state, told, told);
            (now, told) = (instant, from + (to - from) * f64::from(pulse) / f64::from(pulses));
        }
        self.mass.step::<f64>(end - now).step(state, to, to)
    }

    /// At its rate until it is there.
    fn run_on(&self, state: SecondOrderState<f64>) -> SecondOrderState<f64> {
        let ([from, to], [begin, end]) = (self.told, self.times);
        let running = ((to - from).abs() / self.yoke.rate).min(end - begin);
        let there = self.mass.step::<f64>(running).step(state, from, to);
        self.mass.step::<f64>(end - begin - running).step(there, to, to)
    }
}

/// Whole steps in `steps`, which may be short of a whole number by the last bits of a division.
fn whole_steps(steps: f64) -> f64 {
    (steps + 1e-9 * steps.max(1.0)).floor()
}

#[cfg(test)]
mod tests {
    use super::Yoke;
    use quantities::{degrees, radians};

    fn yoke(step_deg: f64) -> Yoke {
        let (rate, travel) = (radians(10.0), radians(40.0));
        Yoke { step: radians(step_deg), rate, travel, natural: None, damping: 1.0 }
    }

    #[test]
    fn it_stands_at_whole_steps_between_its_stops() {
        for (roll, expected) in [(3.13, 3.1), (-3.16, -3.2), (19.97, 20.0), (33.0, 20.0), (-90.0, -20.0)] {
            let found = degrees(yoke(0.1).settled(radians(roll)));
            assert!((found - expected).abs() < 1e-12, "{roll}: {found}");
        }
        assert_eq!(yoke(0.0).settled(0.123), 0.123);
        // Three steps of 7 degrees go into 20 degrees twice.
        assert!((degrees(yoke(7.0).settled(radians(33.0))) - 14.0).abs() < 1e-12);
    }

    #[test]
    fn it_keeps_its_rate_to_the_pulse() {
        // 10 deg/s in steps of 0.1 deg at 30 Hz: 100 pulses in 30 frames, 3 or 4 in each.
        let (motor, mut angle) = (yoke(0.1), 0.0);
        for frame in 1..=30 {
            let times = [frame - 1, frame].map(|frame| f64::from(frame) / 30.0);
            let next = motor.follow(angle, radians(20.0), times);
            let pulses = degrees(next - angle) / 0.1;
            assert!((2.999..4.001).contains(&pulses), "frame {frame}: {pulses}");
            angle = next;
        }
        assert!((degrees(angle) - 10.0).abs() < 1e-9, "{}", degrees(angle));
        assert_eq!(motor.follow(angle, angle, [1.0, 1.1]), motor.settled(angle));
        let servo = yoke(0.0).follow(0.0, -1.0, [0.0, 0.5]);
        assert!((degrees(servo) + 5.0).abs() < 1e-12);
    }
}
