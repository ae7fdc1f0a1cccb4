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
    /// Fastest turn of the motor (rad/s).
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
    use std::f64::consts::PI;

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

    /// A yoke of 0.05 degrees a step, 300 steps a second, swinging.
    fn swinging(hertz: f64, damping: f64) -> Yoke {
        Yoke {
            step: radians(0.05),
            rate: radians(15.0),
            travel: radians(40.0),
            natural: Some(hertz),
            damping,
        }
    }

    /// Angles (deg) every `h` seconds of a yoke at rest that is told one step just before 0.
    fn ring(yoke: &Yoke, h: f64, count: usize) -> Vec<f64> {
        let roll = radians(0.05);
        let mut swing = yoke.swing(yoke.at_rest(0.0), roll, [0.5 / 300.0, 1.0 / 300.0]);
        let angle = |k: usize| {
            let times = [k, k + 1].map(|k| 1.0 / 300.0 + h * k as f64);
            swing = yoke.swing(swing, roll, times);
            degrees(swing.angle())
        };
        (0..count).map(angle).collect()
    }

    #[test]
    fn a_step_rings_at_its_frequency_with_its_damping_and_settles() {
        for (hertz, damping) in [(90.0, 0.25), (60.0, 0.15), (20.0, 0.05)] {
            let beat = (1.0f64 - damping * damping).sqrt();
            // Half a period of the swing: it is furthest out at every one.
            let half = 0.5 / (hertz * beat);
            let decay = libm::exp(-PI * damping / beat);
            let extremes = ring(&swinging(hertz, damping), half, 40);
            let mut beyond = 0.05 * decay;
            for (k, angle) in extremes.iter().enumerate() {
                let side = if k % 2 == 0 { 1.0 } else { -1.0 };
                assert!((angle - 0.05 - side * beyond).abs() < 1e-9, "{hertz} Hz, {k}: {angle}");
                beyond *= decay;
            }
            let settled = ring(&swinging(hertz, damping), 10.0, 3)[2];
            assert!((settled - 0.05).abs() < 1e-9, "{settled}");
        }
    }

    #[test]
    fn pulses_swing_it_at_their_own_times_whatever_the_frames_are() {
        let angle = |yoke: &Yoke, frames: u32| {
            let time = |frame: u32| f64::from(frame) / f64::from(frames);
            let start = yoke.at_rest(0.0);
            let turn = |swing, frame| yoke.swing(swing, radians(20.0), [time(frame), time(frame + 1)]);
            degrees((0..frames).fold(start, turn).angle())
        };
        for yoke in [swinging(90.0, 0.25), Yoke { step: 0.0, ..swinging(90.0, 0.25) }] {
            let whole = angle(&yoke, 1);
            for frames in [2, 7, 30, 1000] {
                assert!((angle(&yoke, frames) - whole).abs() < 1e-9, "{frames}");
            }
        }
        // A servo at 15 deg/s drags its yoke behind by 2 z / w.
        let late = 2.0 * 0.25 / (2.0 * PI * 90.0);
        let servo = angle(&Yoke { step: 0.0, ..swinging(90.0, 0.25) }, 30);
        assert!((servo - 15.0 * (1.0 - late)).abs() < 1e-9, "{servo}");
    }

    #[test]
    fn a_stiff_yoke_stands_where_its_motor_does() {
        let loose = Yoke { natural: None, ..swinging(90.0, 0.25) };
        let stiff = swinging(f64::INFINITY, 0.25);
        let (mut a, mut b) = (loose.at_rest(0.0), stiff.at_rest(0.0));
        for frame in 1..200 {
            // Frames that begin with a pulse would find the yoke still before it.
            let times = [frame - 1, frame].map(|frame| f64::from(frame) / 29.73);
            let roll = radians(20.0) * libm::sin(f64::from(frame) * 0.1);
            (a, b) = (loose.swing(a, roll, times), stiff.swing(b, roll, times));
            assert!((a.angle() - b.angle()).abs() < 1e-12);
            assert_eq!(a.angle(), a.told);
        }
    }

    #[test]
    fn no_yoke_is_nowhere() {
        for step in [0.0, 1e-12, 0.05, 10.0] {
            for (hertz, damping) in [(1e-9, 0.0), (90.0, 0.0), (1e12, 50.0), (0.0, 1.0)] {
                let yoke = Yoke { step: radians(step), ..swinging(hertz, damping) };
                let mut swing = yoke.at_rest(0.0);
                for frame in 1..50 {
                    let times = [frame - 1, frame].map(|frame| f64::from(frame) / 30.0);
                    swing = yoke.swing(swing, if frame % 20 < 10 { 0.5 } else { -0.5 }, times);
                    assert!(swing.angle().abs() < 40.0, "{yoke:?}: {swing:?}");
                }
            }
        }
    }
}
