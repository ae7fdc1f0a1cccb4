//! Where the eye is and how the vehicle's camera looks, in the units of path files.

use diagnostics::Problem;
use landscape::Attitude;
use quantities::{degrees, radians};
use scenario::{Channel, Pose};

use crate::DriveError;

/// Largest heading that a path file may have (degrees).
const MOST_HEADING: f64 = 36_000.0;

/// One instant of the vehicle. Through a channel the picture is turned against it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EyePose {
    /// Seconds since the start of the mission.
    pub time_s: f64,
    /// Eye: north, east, height above the lunoid's tangent plane (m).
    pub eye_m: [f64; 3],
    /// Clockwise from north (degrees).
    pub heading_deg: f64,
    /// Pitch, nose up (degrees).
    pub pitch_deg: f64,
    /// Roll, starboard down (degrees).
    pub roll_deg: f64,
    /// Angle by which the deflection yoke turns the picture (degrees), starboard down; 0 without a yoke. A loop works it out itself.
    pub yoke_deg: f64,
}

impl EyePose {
    /// The vehicle whose picture, through `channel`, has the pose `seen`.
    pub(crate) fn of(seen: &Pose, channel: Option<&Channel>) -> Self {
        let Pose { time, eye, attitude, yoke } = *seen;
        let Attitude { heading, pitch, roll } = channel.map_or(attitude, |channel| channel.off(attitude));
        Self {
            time_s: time,
            eye_m: eye,
            heading_deg: degrees(heading),
            pitch_deg: degrees(pitch),
            roll_deg: degrees(roll),
            yoke_deg: degrees(yoke),
        }
    }

    /// Pose of the picture through `channel`.
    pub(crate) fn seen(&self, channel: Option<&Channel>) -> Pose {
        let attitude = self.attitude();
        let attitude = channel.map_or(attitude, |channel| channel.on(attitude));
        Pose { time: self.time_s, eye: self.eye_m, attitude, yoke: radians(self.yoke_deg) }
    }

    /// Attitude of the vehicle's own camera.
    pub(crate) fn attitude(&self) -> Attitude {
        let [heading, pitch, roll] = [self.heading_deg, self.pitch_deg, self.roll_deg].map(radians);
        Attitude { heading, pitch, roll }
    }

    /// Refuses numbers that no path file could have; minus zero becomes zero, as a path has it.
    pub(crate) fn checked(self, file: &str) -> Result<Self, DriveError> {
        let Self { time_s, eye_m: [x, y, z], heading_deg, pitch_deg, roll_deg, yoke_deg } = self;
        let limits = [
            ("time_s", time_s, 1e12),
            ("x_m", x, 1e7),
            ("y_m", y, 1e7),
            ("z_m", z, 1e7),
            ("heading_deg", heading_deg, MOST_HEADING),
            ("pitch_deg", pitch_deg, 360.0),
            ("roll_deg", roll_deg, 360.0),
            ("yoke_deg", yoke_deg, 360.0),
        ];
        match limits.into_iter().find(|(_, value, most)| !(-*most..=*most).contains(value)) {
            None => Ok(Self {
                time_s: time_s + 0.0,
                eye_m: [x + 0.0, y + 0.0, z + 0.0],
                heading_deg: heading_deg + 0.0,
                pitch_deg: pitch_deg + 0.0,
                roll_deg: roll_deg + 0.0,
                yoke_deg: yoke_deg + 0.0,
            }),
            Some((name, found, most)) => {
                let title = format!("a pose whose `{name}` is {found:?}");
                let problem = Problem::of_file(file, title).key(name).found(format!("{found:?}"));
                Err(problem.expected(format!("a number from -{most} to {most}")).into())
            }
        }
    }
}
