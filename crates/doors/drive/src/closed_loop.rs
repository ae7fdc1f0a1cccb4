//! A closed loop: a pose in, a picture out, one frame a step.

use std::path::Path;
use std::sync::Arc;

use diagnostics::Problem;
use limits::Limit;
use quantities::{radians, sin_cos};
use scenario::{Course, Driven, DrivenError, Pose};

use crate::bench::Bench;
use crate::saved::{self, SavedFile};
use crate::{Drive, DriveError, EyePose, Seen, Viewpoint};

/// A drive that grows with each pose.
pub struct Loop {
    drive: Arc<Drive>,
    driven: Driven,
    /// The stage on the course, and the generator on it; made when it is needed, and kept while the loop goes on.
    bench: Option<Bench>,
    /// Poses of the pictures of the first and of the last frame.
    ends: Option<[Pose; 2]>,
    /// Poses of the pictures so far, for generators with memory. The generator of `bench` holds the same course.
    course: Course,
    /// Poses of the vehicle so far, as they were told.
    told: Vec<EyePose>,
}

impl Loop {
    /// A loop that has not driven yet.
    pub fn new(drive: Arc<Drive>) -> Self {
        let view = &drive.bench.stage.view;
        let driven = Driven::new(&drive.opened.scenario, view.update, view.yoke);
        let (course, told) = Default::default();
        Self { drive, driven, bench: None, ends: None, course, told }
    }

    /// A loop that has driven `poses`, one a frame, without drawing them.
    ///
    /// # Errors
    /// If a pose cannot be driven, or the sun is known for fewer frames.
    pub fn after(drive: Arc<Drive>, poses: &[EyePose]) -> Result<Self, DriveError> {
        let mut driven = Self::new(drive);
        for pose in poses {
            let next = driven.next(pose)?;
            driven.remember(next.picture);
            driven.go(next);
        }
        Ok(driven)
    }

    /// Number of frames that have been driven.
    pub fn frames(&self) -> u64 {
        self.driven.frames()
    }

    /// Poses of the vehicle so far, one a frame, as they were told.
    pub fn poses(&self) -> &[EyePose] {
        &self.told
    }

    /// Drives the next frame to `pose` and draws it. Time and yoke of the pose are the loop's own: the time is that of the frame, and the yoke follows
    /// the roll from frame to frame.
    ///
    /// # Errors
    /// If a number of the pose is none, the pose cannot be driven or drawn, or the sun is known for fewer frames. Nothing is driven then.
    pub fn look(&mut self, pose: &EyePose) -> Result<Seen, DriveError> {
        let next = self.next(pose)?;
        let seen = self.draw(next.picture)?;
        self.go(next);
        Ok(seen)
    }

    /// The frame that was driven last, with what the generator remembers of the frames before.
    ///
    /// # Errors
    /// If nothing was driven, or the generator cannot be made ready.
    pub fn viewpoint(&mut self) -> Result<Viewpoint<'_>, DriveError> {
        let Some([first, pose]) = self.ends else { return Err(self.nothing_driven()) };
        let bench = match self.bench.take() {
            Some(bench) => bench,
            None => self.ready(first)?,
        };
        let bench = self.bench.insert(bench);
        Ok(Viewpoint { drive: &self.drive, bench, frame: self.driven.frames() - 1, pose })
    }

    /// The vehicle `metres` further along the heading of `pose`, at the time of the next frame: on the ground, or level at the height of the eye where
    /// the path of the scenario states heights.
    ///
    /// # Errors
    /// If the vehicle cannot stand there.
    pub fn ahead(&self, pose: &EyePose, metres: f64) -> Result<EyePose, DriveError> {
        self.turned(pose, 0.0, metres)
    }

    /// The same after a turn by `turn_deg` degrees, clockwise.
    ///
    /// # Errors
    /// If the vehicle cannot stand there, or a number is not finite.
    pub fn turned(&self, pose: &EyePose, turn_deg: f64, metres: f64) -> Result<EyePose, DriveError> {
        let drive = &self.drive;
        let pose = pose.checked(drive.file())?;
        if !(metres.is_finite() && turn_deg.is_finite()) {
            let found = format!("{metres} metres ahead after a turn of {turn_deg} degrees");
            return Err(DriveError::asked(drive.file(), found, "finite numbers"));
        }
        let heading = pose.attitude().heading + radians(turn_deg);
        let (sin, cos) = sin_cos(heading);
        let [x, y, z] = pose.eye_m;
        let flies = drive.opened.scenario.way().waypoints().iter().any(|point| point.eye_height.is_some());
        let at = [x + metres * cos, y + metres * sin];
        let there = self.driven.stand(&drive.bench.stage.landscape, at, heading, flies.then_some(z));
        Ok(EyePose::of(&there.map_err(|error| self.undriven(&error))?, None))
    }

    /// Writes what was driven into `folder`, which it makes: `scenario.toml`, `driven.csv` and the files that the scenario names. `lunoid replay` of the
    /// scenario, with the wishes of the drive, draws the same pixels.
    ///
    /// # Errors
    /// If nothing was driven, the folder is there already, or a file cannot be read or written.
    pub fn save(&self, folder: &Path) -> Result<(), DriveError> {
        self.save_with(folder, &[])
    }

    /// The same with `more` files beside the scenario.
    ///
    /// # Errors
    /// As [`save`](Self::save).
    pub fn save_with(&self, folder: &Path, more: &[SavedFile]) -> Result<(), DriveError> {
        saved::save(&self.drive.opened, &self.own_files()?, more, folder)
    }

    /// The files that [`save`](Self::save) would write.
    ///
    /// # Errors
    /// If nothing was driven, or a file cannot be read.
    pub fn saved(&self) -> Result<Vec<SavedFile>, DriveError> {
        saved::files(&self.drive.opened, &self.own_files()?)
    }

    fn own_files(&self) -> Result<[SavedFile; 2], DriveError> {
        if self.told.is_empty() {
            return Err(self.nothing_driven());
        }
        saved::own(&self.drive.opened, self.drive.bench.stage.view.update, &self.told)
    }

    fn nothing_driven(&self) -> DriveError {
        DriveError::asked(self.drive.file(), "a loop that has driven nothing", "at least one look")
    }

    fn undriven(&self, error: &DrivenError) -> DriveError {
        DriveError::of(self.drive.file(), error)
    }

    /// The next frame at `pose`, not yet driven.
    fn next(&self, pose: &EyePose) -> Result<Next, DriveError> {
        self.expect_room(self.frames())?;
        let told = pose.checked(self.drive.file())?;
        let mut driven = self.driven.clone();
        let landscape = &self.drive.bench.stage.landscape;
        let picture = driven.push(landscape, told.eye_m, told.attitude());
        let picture = picture.map_err(|error| self.undriven(&error))?;
        Ok(Next { driven, told, picture })
    }

    fn go(&mut self, Next { driven, told, picture }: Next) {
        let first = self.ends.map_or(picture, |[first, _]| first);
        (self.ends, self.driven) = (Some([first, picture]), driven);
        self.told.push(told);
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

    /// The picture of the next frame from `pose`, which the generator remembers from then on if it can be drawn.
    fn draw(&mut self, pose: Pose) -> Result<Seen, DriveError> {
        if let Some(bench) = &self.bench {
            let can = bench.session.check(self.frames(), &pose);
            can.map_err(|error| DriveError::of(self.drive.file(), &error))?;
        }
        self.remember(pose);
        self.draw_remembered(pose).inspect_err(|_| self.forget())
    }

    fn draw_remembered(&mut self, pose: Pose) -> Result<Seen, DriveError> {
        let (frame, first) = (self.frames(), self.ends.map_or(pose, |[first, _]| first));
        let bench = match self.bench.take() {
            Some(bench) => bench,
            None => self.ready(first)?,
        };
        let bench = self.bench.insert(bench);
        Viewpoint { drive: &self.drive, bench, frame, pose }.draw()
    }

    /// Forgets a pose that was remembered and not driven. What was chosen by a first pose, or worked out from this one, goes with it.
    fn forget(&mut self) {
        let driven = self.told.len();
        if driven == 0 || self.course.len() > driven {
            self.bench = None;
            self.course = self.course.iter().take(driven).copied().collect();
        }
    }

    /// Adds the pose of the next picture to the course, where the generator has memory.
    fn remember(&self, pose: Pose) {
        if self.drive.remembers_frames() {
            self.course.push(pose);
        }
    }

    /// The generator on the stage of the drive with the course behind it, from `first` on.
    fn ready(&self, first: Pose) -> Result<Bench, DriveError> {
        let Drive { opened, pool, bench, .. } = &*self.drive;
        Bench::new(opened, pool, bench.machine_on(first, self.course.clone()))
    }
}

/// A frame that may be driven.
struct Next {
    driven: Driven,
    told: EyePose,
    picture: Pose,
}
