//! A drive that grows: one pose a frame, as a closed loop tells them.
//!
//! **Law.** Frame n is at n over the update rate. The yoke starts settled at the roll of frame 0 and follows from frame to frame.
//! The poses are those of a [`Path`] with these waypoints, to the bit: what was driven, saved as a path file, is driven again.

use landscape::{Attitude, Landscape};
use quantities::Rate;

use crate::pose_table::{Driver, Follower, time_of};
use crate::yoke::Swing;
use crate::{Channel, Path, PathError, PathProblems, Pose, Scenario, Vehicle, Waypoint, Yoke};

/// Name of the drive where a problem of its path is told.
const NAME: &str = "the drive";

/// What has been driven so far, without its pictures.
#[derive(Debug, Clone)]
pub struct Driven {
    vehicle: Vehicle,
    channel: Option<Channel>,
    update: Rate,
    yoke: Option<Yoke>,
    frames: u64,
    swing: Swing,
    /// The last waypoint, its angles with the whole turns that they have made.
    last: Option<Waypoint>,
}

/// Why a pose cannot be driven.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DrivenError {
    /// The numbers are no waypoint.
    #[error("{0}")]
    Waypoint(#[from] PathError),
    /// The vehicle cannot be there.
    #[error("{0}")]
    Problems(#[from] PathProblems),
}

impl Driven {
    /// Nothing driven yet by the vehicle of `scenario`, at `update` frames a second, with the deflection yoke of the view.
    pub fn new(scenario: &Scenario, update: Rate, yoke: Option<Yoke>) -> Self {
        let Scenario { vehicle, channel, .. } = scenario;
        let (vehicle, channel) = (*vehicle, channel.clone());
        Self { vehicle, channel, update, yoke, frames: 0, swing: Swing::default(), last: None }
    }

    /// Number of frames that have been driven.
    pub fn frames(&self) -> u64 {
        self.frames
    }

    /// Time of the next frame since the start of the mission (s).
    pub fn time(&self) -> f64 {
        time_of(self.frames, self.update)
    }

    /// Drives the next frame: the eye stands at `eye` (north, east, height above the tangent plane; m) with the attitude of the
    /// vehicle's camera. Returns the pose of the picture: through the channel, and with the angle of the yoke.
    ///
    /// # Errors
    /// If a number is not finite, the eye is under the ground, or a pitch or roll is beyond what a path may state. Nothing is driven then.
    pub fn push(
        &mut self,
        landscape: &Landscape,
        eye: [f64; 3],
        attitude: Attitude,
    ) -> Result<Pose, DrivenError> {
        let frame = self.frames;
        let [time, after] = [frame, frame + 1].map(|frame| time_of(frame, self.update));
        let Attitude { heading, pitch, roll } = attitude;
        let [x, y, z] = eye;
        let told = Waypoint { pitch: Some(pitch), roll: Some(roll), ..stood(time, [x, y], heading, Some(z)) };
        // A curve has its waypoints to the bit but for the last one.
        let waypoints = self.last.into_iter().chain([told, Waypoint { time: after, ..told }]);
        let path = Path::new(waypoints.collect())?.named(NAME);
        let Self { vehicle, channel, update, yoke, swing, .. } = &*self;
        let driver = Driver { path: &path, vehicle, channel: channel.as_ref(), landscape, update: *update };
        let mut picture = Follower { yoke: *yoke, driver: &driver, swing: *swing };
        let row = picture.turn(frame, driver.row(frame));
        let swing = picture.swing;
        let row = row.map_err(|problem| PathProblems::one(&path, problem))?;
        let [heading, pitch, roll] = path.turned(time);
        self.last = Some(Waypoint { heading: Some(heading), pitch: Some(pitch), roll: Some(roll), ..told });
        (self.swing, self.frames) = (swing, frame + 1);
        Ok(row.pose)
    }

    /// Pose of the vehicle's own camera where the vehicle stands on the ground at `at` (north, east; m) and looks along `heading` (rad), at
    /// the time of the next frame. With `eye_height`, height of the eye above the tangent plane (m), it flies there level.
    ///
    /// # Errors
    /// If it cannot stand there.
    pub fn stand(
        &self,
        landscape: &Landscape,
        at: [f64; 2],
        heading: f64,
        eye_height: Option<f64>,
    ) -> Result<Pose, DrivenError> {
        let level = eye_height.map(|_| 0.0);
        let there = stood(self.time(), at, heading, eye_height);
        let path = Path::new(vec![Waypoint { pitch: level, roll: level, ..there }])?.named(NAME);
        let driver =
            Driver { path: &path, vehicle: &self.vehicle, channel: None, landscape, update: self.update };
        let row = driver.row(self.frames).map_err(|problem| PathProblems::one(&path, problem))?;
        Ok(row.pose)
    }
}

/// A waypoint whose pitch and roll are open.
fn stood(time: f64, at: [f64; 2], heading: f64, eye_height: Option<f64>) -> Waypoint {
    Waypoint { time, at, heading: Some(heading), eye_height, pitch: None, roll: None }
}
