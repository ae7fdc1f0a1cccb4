//! A closed loop: a pose in, a picture out, one frame a step.

use std::path::Path;
use std::sync::Arc;

use diagnostics::Problem;
use generator::{Session, Stage};
use limits::Limit;
use quantities::sin_cos;
use scenario::{Driven, DrivenError, Pose};

use crate::saved;
use crate::{Drive, DriveError, EyePose, Seen};

/// A drive that grows with each pose.
pub struct Loop {
    drive: Arc<Drive>,
    driven: Driven,
    /// The stage with what was driven, and the generator on it; made at the first pose.
    session: Option<Box<dyn Session>>,
    /// Poses of the pictures so far, for generators with memory.
    course: Vec<Pose>,
    /// Poses of the vehicle so far, as they were told.
    told: Vec<EyePose>,
}

impl Loop {
    /// A loop that has not driven yet.
    pub fn new(drive: Arc<Drive>) -> Self {
        let view = &drive.stage.view;
        let driven = Driven::new(&drive.opened.scenario, view.update, view.yoke);
        Self { drive, driven, session: None, course: Vec::new(), told: Vec::new() }
    }

    /// Number of frames that have been driven.
    pub fn frames(&self) -> u64 {
        self.driven.frames()
    }

    /// Drives the next frame to `pose` and draws it. Time and yoke of the pose are the loop's own: the time is that of the frame, and the yoke follows
    /// the roll from frame to frame.
    ///
    /// # Errors
    /// If a number of the pose is none, the pose cannot be driven or drawn, or the sun is known for fewer frames. Nothing is driven then.
    pub fn look(&mut self, pose: &EyePose) -> Result<Seen, DriveError> {
        let frame = self.frames();
        self.expect_room(frame)?;
        let drive = Arc::clone(&self.drive);
        let told = pose.checked(drive.file())?;
        let mut driven = self.driven.clone();
        let seen = driven.push(&drive.stage.landscape, told.eye_m, told.attitude());
        let seen = seen.map_err(|error| self.undriven(&error))?;
        let seen = self.draw(frame, seen)?;
        self.driven = driven;
        self.told.push(told);
        Ok(seen)
    }

    /// The vehicle `metres` further along the heading of `pose`, at the time of the next frame: on the ground, or level at the height of the eye where
    /// the path of the scenario states heights.
    ///
    /// # Errors
    /// If the vehicle cannot stand there.
    pub fn ahead(&self, pose: &EyePose, metres: f64) -> Result<EyePose, DriveError> {
        let drive = &self.drive;
        let pose = pose.checked(drive.file())?;
        if !metres.is_finite() {
            return Err(DriveError::asked(
                drive.file(),
                format!("{metres} metres ahead"),
                "a finite number of metres",
            ));
        }
        let heading = pose.attitude().heading;
        let (sin, cos) = sin_cos(heading);
        let [x, y, z] = pose.eye_m;
        let flies = drive.opened.scenario.way().waypoints().iter().any(|point| point.eye_height.is_some());
        let at = [x + metres * cos, y + metres * sin];
        let there = self.driven.stand(&drive.stage.landscape, at, heading, flies.then_some(z));
        Ok(EyePose::of(&there.map_err(|error| self.undriven(&error))?, None))
    }

    /// Writes what was driven into `folder`, which it makes: `scenario.toml`, `driven.csv` and the files that the scenario names. `lunoid replay` of the
    /// scenario, with the wishes of the drive, draws the same pixels.
    ///
    /// # Errors
    /// If nothing was driven, the folder is there already, or a file cannot be read or written.
    pub fn save(&self, folder: &Path) -> Result<(), DriveError> {
        if self.told.is_empty() {
            return Err(DriveError::asked(
                self.drive.file(),
                "a loop that has driven nothing",
                "at least one look",
            ));
        }
        saved::save(&self.drive.opened, self.drive.stage.view.update, &self.told, folder)
    }

    fn undriven(&self, error: &DrivenError) -> DriveError {
        DriveError::of(self.drive.file(), error)
    }

    /// Sees that the sun of frame `frame` is known, and that a scenario may be so long.
    fn expect_room(&self, frame: u64) -> Result<(), DriveError> {
        let (scenario, frames) = (&self.drive.opened.scenario, self.drive.frames());
        let room = if scenario.sun.moves() { frames } else { Limit::Frames.value() };
        if frame < room {
            return Ok(());
        }
        let title = format!("frame {frame} of a loop: the sun is worked out for {room} frames");
        let problem = Problem::of_file(self.drive.file(), title).found(frame.to_string());
        let problem = problem.expected(format!("a frame from 0 to {}", room - 1));
        Err(problem.help("open the scenario with a larger `scenario.frames`").into())
    }

    /// The picture from `pose`, after the poses before it. Where the generator has memory it is made ready anew with what was driven.
    fn draw(&mut self, frame: u64, pose: Pose) -> Result<Seen, DriveError> {
        let drive = Arc::clone(&self.drive);
        let mut course = std::mem::take(&mut self.course);
        course.extend(drive.remembers_frames().then_some(pose));
        let session = match self.session.take().filter(|_| !drive.remembers_frames()) {
            Some(session) => Ok(session),
            None => ready(&drive, &course, pose),
        };
        let drawn = session.and_then(|session| {
            let drawn = drive.drawn(&*session, frame, &pose);
            // The first pose decides what is chosen once for a mission.
            self.session = Some(session).filter(|_| drawn.is_ok() || frame > 0);
            drawn
        });
        // What could not be drawn was not driven.
        course.truncate(course.len() - usize::from(drawn.is_err() && drive.remembers_frames()));
        self.course = course;
        drawn
    }
}

/// The generator on the stage of `drive` with `course` behind it, up to `pose`.
fn ready(drive: &Drive, course: &[Pose], pose: Pose) -> Result<Box<dyn Session>, DriveError> {
    let first = course.first().copied().unwrap_or(pose);
    let scenery = (*drive.stage.scenery).clone().with_course(course.to_vec());
    let scenery = scenery.with_start(Some(Pose { yoke: 0.0, ..first }));
    let stage = Stage { scenery: Arc::new(scenery), ..drive.stage.clone() };
    let session = drive.pool.install(|| drive.opened.generator.prepare(stage));
    session.map_err(|error| DriveError::of(drive.file(), &error))
}
