//! Channels: several views from one vehicle, each drawn by a machine of its own (`docs/scenario-format.md`).

use landscape::Attitude;

use crate::FieldWish;

/// One of several views from the vehicle: a camera that is turned against the vehicle's own and fixed to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// Its name: letters, digits, dashes and underscores. Names of a scenario differ, capitals or not.
    pub name: String,
    /// How it is turned against the vehicle's camera: first by the heading, then by pitch and roll (rad).
    pub mount: Attitude,
    /// What it shows; the scenario's own field where there is none.
    pub field: Option<FieldWish>,
}

impl Channel {
    /// Attitude of the channel on a vehicle whose camera has the attitude `vehicle`.
    pub fn on(&self, vehicle: Attitude) -> Attitude {
        Attitude::of_terrain(&(vehicle.to_terrain() * self.mount.to_terrain()))
    }

    /// Attitude of the vehicle's camera where the channel has the attitude `channel`.
    pub fn off(&self, channel: Attitude) -> Attitude {
        Attitude::of_terrain(&(channel.to_terrain() * self.mount.to_terrain().transpose()))
    }
}

#[cfg(test)]
mod tests {
    use landscape::Attitude;
    use quantities::radians;

    use super::Channel;

    fn turned(heading: f64, pitch: f64, roll: f64) -> Attitude {
        Attitude { heading: radians(heading), pitch: radians(pitch), roll: radians(roll) }
    }

    fn channel(mount: Attitude) -> Channel {
        Channel { name: "left".into(), mount, field: None }
    }

    fn expect_near(found: Attitude, expected: Attitude) {
        for (found, expected) in
            [(found.heading, expected.heading), (found.pitch, expected.pitch), (found.roll, expected.roll)]
        {
            assert!((found - expected).abs() < 1e-14, "{found} {expected}");
        }
    }

    #[test]
    fn on_a_level_vehicle_angles_add_up() {
        let left = channel(turned(-50.0, 4.0, 0.0));
        expect_near(left.on(turned(20.0, 0.0, 0.0)), turned(-30.0, 4.0, 0.0));
    }

    /// To the right of who looks to starboard is the stern, which is low where the nose is up.
    #[test]
    fn a_window_to_starboard_makes_roll_of_pitch() {
        let starboard = channel(turned(90.0, 0.0, 0.0));
        expect_near(starboard.on(turned(0.0, 10.0, 0.0)), turned(90.0, 0.0, 10.0));
        expect_near(starboard.on(turned(0.0, 0.0, 10.0)), turned(90.0, -10.0, 0.0));
    }

    #[test]
    fn off_takes_back_what_on_did() {
        let skew = channel(turned(-120.0, 12.0, 7.0));
        let vehicle = turned(33.0, -8.0, 5.0);
        expect_near(skew.off(skew.on(vehicle)), vehicle);
    }
}
