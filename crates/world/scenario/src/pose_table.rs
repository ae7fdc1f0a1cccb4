//! The vehicle on the ground, for every frame.

use std::fmt::Write as _;
use std::ops::Range;

use landscape::{Attitude, Landscape};
use quantities::{Rate, degrees, radians};

use crate::limits::{LimitReport, limit_reports};
use crate::path::{Station, shortest_turn};
use crate::pose_problem::{PathProblem, PathProblems, PoseFault};
use crate::vehicle::{Stand, Vehicle};
use crate::yoke::Swing;
use crate::{Channel, HeightOver, Path, Pose, Scenario, Yoke};

/// Pitch or roll beyond which a pose is taken for a mistake (our choice): the sweeps need ground ahead.
const MAX_TILT_DEG: f64 = 60.0;

/// The same for a pitch that the path states: a lander looks straight down (section 20), and the curve through the rows
/// rounds. What a generator cannot draw it refuses itself.
const MAX_STATED_PITCH_DEG: f64 = 90.000_001;

/// The same for the roll of a path that flies.
const MAX_FLOWN_ROLL_DEG: f64 = 180.000_001;

/// Pose of one frame and how the vehicle moves in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoseRow {
    /// Frame, counted at the update rate.
    pub frame: u64,
    /// Time, eye and attitude in that frame.
    pub pose: Pose,
    /// Speed along the ground (m/s).
    pub speed: f64,
    /// Turn to starboard since the frame before; in frame 0, to the frame after (rad/s).
    pub turn_rate: f64,
    /// Steepness of the ground under the wheels (rad); 0 where the path says height, pitch and roll.
    pub slope: f64,
}

/// Poses of a range of frames; any part of a table is the same as in the whole.
#[derive(Debug, Clone, PartialEq)]
pub struct PoseTable {
    rows: Vec<PoseRow>,
    limits: Vec<LimitReport>,
}

impl PoseTable {
    /// Puts the vehicle of `scenario` on the ground for each frame of `frames`, at `update` frames a second. A
    /// `yoke` starts settled at the roll of frame 0 and follows from frame to frame, so the rolls of all frames
    /// before `frames` are worked out too; one that cannot be driven leaves it where it is.
    ///
    /// # Errors
    /// Every stretch of frames in which the path leaves the problem area, the eye is under the ground, or the
    /// attitude is beyond 60 degrees. A path that states height, pitch and roll flies: it may leave the area, look straight
    /// down or up, and roll to any side.
    pub fn resolve(
        scenario: &Scenario,
        landscape: &Landscape,
        update: Rate,
        yoke: Option<Yoke>,
        frames: Range<u64>,
    ) -> Result<Self, PathProblems> {
        let (path, vehicle, channel) = (scenario.way(), &scenario.vehicle, scenario.channel.as_ref());
        let driver = Driver { path, vehicle, channel, landscape, update };
        let mut picture = Follower { yoke, driver: &driver, swing: Swing::default() };
        (0..frames.start).for_each(|frame| picture.pass(frame));
        let row = |frame| {
            let time = driver.time(frame);
            match &scenario.driven {
                Some(driven) if !driven.has_waypoint_at(time) => {
                    let at = driven.at(time).at;
                    Err(PathProblem { fault: PoseFault::NotDriven, frames: frame..frame + 1, time, at })
                }
                _ => driver.row(frame),
            }
        };
        let found: Vec<_> = frames.map(|frame| (frame, picture.turn(frame, row(frame)))).collect();
        let faults = found.iter().filter_map(|(frame, row)| Some((*frame, row.as_ref().err()?.clone())));
        PathProblems::of(path, faults)?;
        let rows: Vec<PoseRow> = found.into_iter().filter_map(|(_, row)| row.ok()).collect();
        let limits = limit_reports(&rows, &scenario.vehicle);
        Ok(Self { rows, limits })
    }

    /// One row a frame, ascending.
    pub fn rows(&self) -> &[PoseRow] {
        &self.rows
    }

    /// Every stretch of frames in which the vehicle does more than it can.
    pub fn limits(&self) -> &[LimitReport] {
        &self.limits
    }
}

/// Time of a frame (s).
pub(crate) fn time_of(frame: u64, update: Rate) -> f64 {
    frame as f64 / update.hertz()
}

/// The yoke, driven from frame to frame.
pub(crate) struct Follower<'a> {
    pub yoke: Option<Yoke>,
    pub driver: &'a Driver<'a>,
    pub swing: Swing,
}

impl Follower<'_> {
    /// Follows the roll of a frame of which nothing else is wanted.
    fn pass(&mut self, frame: u64) {
        if self.yoke.is_some()
            && let Ok((_, attitude, _)) = self.driver.place(&self.driver.path.at(self.driver.time(frame)))
        {
            self.follow(frame, attitude.roll);
        }
    }

    /// The row with the angle of the yoke.
    pub fn turn(&mut self, frame: u64, row: Result<PoseRow, PathProblem>) -> Result<PoseRow, PathProblem> {
        let mut row = row?;
        self.follow(frame, row.pose.attitude.roll);
        row.pose.yoke = self.swing.angle();
        Ok(row)
    }

    fn follow(&mut self, frame: u64, roll: f64) {
        let Some(yoke) = self.yoke else { return };
        self.swing = match frame {
            0 => yoke.at_rest(roll),
            _ => yoke.swing(self.swing, roll, [frame - 1, frame].map(|frame| self.driver.time(frame))),
        };
    }
}

/// What a pose is made of.
pub(crate) struct Driver<'a> {
    pub path: &'a Path,
    pub vehicle: &'a Vehicle,
    pub channel: Option<&'a Channel>,
    pub landscape: &'a Landscape,
    pub update: Rate,
}

impl Driver<'_> {
    fn time(&self, frame: u64) -> f64 {
        time_of(frame, self.update)
    }

    pub fn row(&self, frame: u64) -> Result<PoseRow, PathProblem> {
        let time = self.time(frame);
        let station = self.path.at(time);
        let problem = |fault| PathProblem { fault, frames: frame..frame + 1, time, at: station.at };
        let (eye, attitude, stand) = self.place(&station).map_err(problem)?;
        let [north, east] = station.velocity;
        let along = stand.slopes[0] * north + stand.slopes[1] * east;
        let climb = match (station.climb, station.height_over) {
            (Some(climb), HeightOver::Datum) => climb,
            (Some(climb), HeightOver::Ground) => climb + along,
            (None, _) => along,
        };
        Ok(PoseRow {
            frame,
            pose: Pose { time, eye: [station.at[0], station.at[1], eye], attitude, yoke: 0.0 },
            speed: (north * north + east * east + climb * climb).sqrt(),
            turn_rate: self.turn_rate(frame),
            slope: stand.steepness(),
        })
    }

    /// Height of the eye, attitude of the picture, and the ground under the vehicle. Limits are those of the vehicle.
    fn place(&self, station: &Station) -> Result<(f64, Attitude, Stand), PoseFault> {
        let stand = self.stand(station)?;
        let standing = stand.attitude(station.heading);
        let attitude = Attitude {
            roll: station.roll.unwrap_or(standing.roll),
            pitch: station.pitch.unwrap_or(standing.pitch),
            heading: station.heading,
        };
        let ground = stand.ground;
        let eye = match station.eye_height {
            Some(height) => station.height_over.above(height, ground),
            None => ground + self.vehicle.eye_height,
        };
        if eye <= ground {
            return Err(PoseFault::EyeUnderGround { eye, ground });
        }
        let steepest = if station.pitch.is_some() { MAX_STATED_PITCH_DEG } else { MAX_TILT_DEG };
        check_tilt("pitch", attitude.pitch, steepest)?;
        let most = if flies(station) { MAX_FLOWN_ROLL_DEG } else { MAX_TILT_DEG };
        check_tilt("roll", attitude.roll, most)?;
        let attitude = self.channel.map_or(attitude, |channel| channel.on(attitude));
        Ok((eye, attitude, stand))
    }

    /// The ground under the wheels. A path that flies needs none, and outside the area none is under the eye.
    fn stand(&self, station: &Station) -> Result<Stand, PoseFault> {
        let outside = |wheels| PoseFault::Outside { wheels, extent: self.landscape.level().extent() };
        let [x, y] = station.at;
        let ground = self.landscape.height(x, y);
        if flies(station) {
            let ground = match station.height_over {
                HeightOver::Datum => ground.unwrap_or(f64::NEG_INFINITY),
                HeightOver::Ground => ground.ok_or_else(|| outside(false))?,
            };
            return Ok(Stand { ground, slopes: [0.0; 2] });
        }
        ground.ok_or_else(|| outside(false))?;
        let stand = self.vehicle.stand(self.landscape, station.at, station.heading);
        let stand = stand.ok_or_else(|| outside(true))?;
        let wheels = self.vehicle.wheels(station.at, station.heading);
        match wheels.into_iter().find(|&[x, y]| !self.landscape.has_data(x, y)) {
            Some(wheel) => Err(PoseFault::NoData { wheel }),
            None => Ok(stand),
        }
    }

    fn turn_rate(&self, frame: u64) -> f64 {
        let from = frame.saturating_sub(1);
        let [before, after] = [from, from + 1].map(|frame| self.path.at(self.time(frame)).heading);
        shortest_turn(before, after) * self.update.hertz()
    }
}

/// Whether the path states height, pitch and roll, so that no wheel has to stand.
fn flies(station: &Station) -> bool {
    station.eye_height.is_some() && station.pitch.is_some() && station.roll.is_some()
}

fn check_tilt(what: &'static str, found: f64, allowed_deg: f64) -> Result<(), PoseFault> {
    let allowed = radians(allowed_deg);
    if found.abs() <= allowed { Ok(()) } else { Err(PoseFault::Tilt { what, found, allowed }) }
}

/// The poses as CSV, in the columns that a path file has, so that a run's poses can be driven again.
pub fn poses_csv(table: &PoseTable) -> String {
    let mut text =
        String::from("frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg,speed_m_s,turn_deg_s,slope_deg\n");
    for row in &table.rows {
        let Pose { time, eye: [x, y, z], attitude, .. } = row.pose;
        let [heading, pitch, roll] = [attitude.heading, attitude.pitch, attitude.roll].map(degrees);
        let [turn, slope] = [row.turn_rate, row.slope].map(degrees);
        let (frame, speed) = (row.frame, row.speed);
        let written =
            writeln!(text, "{frame},{time},{x},{y},{z},{heading},{pitch},{roll},{speed},{turn},{slope}");
        written.expect("a String takes everything");
    }
    text
}
