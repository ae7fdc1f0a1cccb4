//! The deflection yoke: how the picture follows the vehicle's roll (section 18).

/// The deflection yoke and its stepping motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Yoke {
    /// Angle of a step (rad); 0 is a servo without steps.
    pub step: f64,
    /// Fastest turn (rad/s).
    pub rate: f64,
    /// Whole travel, from stop to stop (rad): half of it either way.
    pub travel: f64,
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
        Yoke { step: radians(step_deg), rate: radians(10.0), travel: radians(40.0) }
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
