//! The rover: its size, its limits, and how it stands on the ground.

use landscape::{Attitude, Landscape};
use quantities::{radians, sin_cos};

/// Size and limits of the vehicle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vehicle {
    /// Eye above the ground under the vehicle's centre (m).
    pub eye_height: f64,
    /// Between front and rear contacts (m).
    pub wheelbase: f64,
    /// Between port and starboard contacts (m).
    pub track: f64,
    /// Fastest that it drives (m/s).
    pub max_speed: f64,
    /// Fastest that it turns (rad/s).
    pub max_turn: f64,
    /// Steepest ground that it climbs (rad).
    pub max_slope: f64,
}

impl Default for Vehicle {
    /// Eye height, speed and turn rate of section 3; wheelbase and track of the Lunar Roving Vehicle; the slope
    /// it was rated for.
    fn default() -> Self {
        Self {
            eye_height: 1.6334,
            wheelbase: 2.3,
            track: 1.83,
            max_speed: 4.877,
            max_turn: radians(10.0),
            max_slope: radians(25.0),
        }
    }
}

/// The ground as the vehicle feels it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stand {
    /// Height of the ground under the centre (m).
    pub ground: f64,
    /// Rise to the north and to the east of the plane through the wheel contacts (m/m).
    pub slopes: [f64; 2],
}

impl Vehicle {
    /// Wheel contacts (north, east; m): front port, front starboard, rear port, rear starboard.
    pub fn wheels(&self, at: [f64; 2], heading: f64) -> [[f64; 2]; 4] {
        let (sin, cos) = sin_cos(heading);
        let [ahead, aside] = [0.5 * self.wheelbase, 0.5 * self.track];
        let contact = |[forward, starboard]: [f64; 2]| {
            [at[0] + forward * cos - starboard * sin, at[1] + forward * sin + starboard * cos]
        };
        [[ahead, -aside], [ahead, aside], [-ahead, -aside], [-ahead, aside]].map(contact)
    }

    /// How it stands at a place (north, east; m) with a heading (rad); nothing where the centre or a wheel is
    /// outside the problem area.
    ///
    /// The wheels touch at half the wheelbase and half the track from the centre, measured level. Four points are
    /// not in one plane: the mean slope of the two sides and the mean slope of the two axles are taken, which is
    /// the plane of least squares.
    pub fn stand(&self, landscape: &Landscape, at: [f64; 2], heading: f64) -> Option<Stand> {
        let height = |wheel: [f64; 2]| landscape.height(wheel[0], wheel[1]);
        let [port_front, starboard_front, port_rear, starboard_rear] = self.wheels(at, heading);
        let front = [height(port_front)?, height(starboard_front)?];
        let rear = [height(port_rear)?, height(starboard_rear)?];
        let (sin, cos) = sin_cos(heading);
        let forward = (front[0] - rear[0] + (front[1] - rear[1])) / (2.0 * self.wheelbase);
        let starboard = (front[1] - front[0] + (rear[1] - rear[0])) / (2.0 * self.track);
        let slopes = [forward * cos - starboard * sin, forward * sin + starboard * cos];
        Some(Stand { ground: landscape.height(at[0], at[1])?, slopes })
    }
}

impl Stand {
    /// Attitude with a heading (rad), by section 4.
    pub fn attitude(&self, heading: f64) -> Attitude {
        Attitude::on_slope(self.slopes, heading)
    }

    /// Steepest slope of the ground (rad), 0 or more.
    pub fn steepness(&self) -> f64 {
        let [north, east] = self.slopes;
        libm::atan((north * north + east * east).sqrt())
    }
}
