//! An opened scenario, and what is asked of its frames.

use std::path::Path;
use std::sync::Arc;

use diagnostics::{Problem, asked};
use front_door::{Opened, Wishes, open};
use generator::Omission;
use rayon::ThreadPool;
use scenario::Pose;

use crate::bench::Bench;
use crate::parameters::{Parameter, parameters};
use crate::seen::Drawing;
use crate::threads;
use crate::{DriveError, EyePose, Seen, Viewpoint};

/// Size of a picture and its clock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Raster {
    /// Columns of the picture.
    pub columns: u32,
    /// Lines of the picture.
    pub lines: u32,
    /// Sweeps of a frame, or rows of the generator's own lines; 0 if it has no signals.
    pub sweeps: u32,
    /// Samples of a sweep; 0 if it has no signals.
    pub samples: u32,
    /// From one sample of a sweep to the next (µs), the first of which is the start of the sweep; 0 if it has no signals.
    pub sample_us: f64,
    /// Pictures computed a second.
    pub update_hz: f64,
    /// Tangents of half the field of view, across and down.
    pub tan_half_field: [f64; 2],
}

/// A scenario on its ground, with the generator that draws it.
pub struct Drive {
    pub(crate) opened: Opened,
    pub(crate) bench: Bench,
    pub(crate) drawing: Drawing,
    pub(crate) pool: Arc<ThreadPool>,
    parameters: Vec<Parameter>,
}

impl Drive {
    /// Opens the scenario in the file `scenario` with `wishes` over it, and makes its ground. `threads` draw, as many as there are processors if
    /// 0; the results do not depend on them.
    ///
    /// # Errors
    /// Every fault of the files and the wishes at once, or of the ground.
    pub fn open(scenario: &Path, wishes: &Wishes, threads: usize) -> Result<Self, DriveError> {
        Self::open_upon(None, scenario, wishes, threads)
    }

    /// The same upon the landscape of `other`, where that is the landscape of `scenario` too: it is not made again.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn open_upon(
        other: Option<&Self>,
        scenario: &Path,
        wishes: &Wishes,
        threads: usize,
    ) -> Result<Self, DriveError> {
        let file = scenario.display().to_string();
        let pool = threads::pool(threads);
        let pool = pool.map_err(|error| DriveError::asked(&file, error.to_string(), "fewer threads"))?;
        let (opened, asked) = asked::record(|| open(scenario, wishes));
        let opened = opened.map_err(|error| DriveError::opening(&file, error))?;
        let parameters = parameters(&opened, &asked);
        let machine = pool.install(|| match other {
            Some(other) => opened.machine_stage_upon(&other.opened, &other.bench.machine),
            None => opened.machine_stage(),
        });
        let machine = machine.map_err(|error| DriveError::opening(&file, error))?;
        let bench = Bench::new(&opened, &pool, machine)?;
        let drawing = Drawing::new(&bench.stage, opened.generator.draws_colour(&bench.stage));
        let drawing = drawing.map_err(|error| DriveError::of(&file, &error))?;
        Ok(Self { opened, bench, drawing, pool, parameters })
    }

    /// Name of the scenario's file.
    pub fn file(&self) -> &str {
        self.opened.scenario_file()
    }

    /// What was asked for over the scenario.
    pub fn wishes(&self) -> &Wishes {
        self.opened.wishes()
    }

    /// Title of the scenario.
    pub fn title(&self) -> &str {
        &self.opened.scenario.title
    }

    /// Name of the hardware model or generator that draws.
    pub fn drawn_by(&self) -> &str {
        self.opened.drawn_by()
    }

    /// Number of frames of the scenario.
    pub fn frames(&self) -> u64 {
        self.opened.frames()
    }

    /// Size of a picture and its clock.
    pub fn raster(&self) -> Raster {
        let view = &self.bench.stage.view;
        let scan = self.opened.generator.scan(view).map(|scan| scan.timebase);
        Raster {
            columns: view.columns,
            lines: view.lines,
            sweeps: scan.map_or(0, |clock| clock.sweeps),
            samples: scan.map_or(0, |clock| clock.active_samples),
            sample_us: scan.map_or(0.0, |clock| 1e6 / clock.sample_rate().hertz()),
            update_hz: view.update.hertz(),
            tan_half_field: [view.field.tan_half_width, view.field.tan_half_height],
        }
    }

    /// What was left out when the generator was made ready, and why.
    pub fn omissions(&self) -> Vec<Omission> {
        self.bench.session.omissions()
    }

    /// What is odd about the files, in words.
    pub fn remarks(&self) -> &[String] {
        &self.opened.remarks
    }

    /// Every value of the hardware model, or of the run parameters and gear of another generator and of the view, in alphabetical order of keys.
    pub fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    /// Whether a picture shows something of frames before its own.
    pub fn remembers_frames(&self) -> bool {
        !self.bench.stage.scenery.course().is_empty()
    }

    /// Where the vehicle is in frame `frame` of the path.
    ///
    /// # Errors
    /// If the scenario has no such frame, or the path cannot be driven there.
    pub fn pose(&self, frame: u64) -> Result<EyePose, DriveError> {
        Ok(self.at(frame)?.pose())
    }

    /// Draws frame `frame` of the path.
    ///
    /// # Errors
    /// If the scenario has no such frame, or it cannot be drawn.
    pub fn frame(&self, frame: u64) -> Result<Seen, DriveError> {
        self.at(frame)?.draw()
    }

    /// Draws what is seen from `pose`, as frame `frame`.
    ///
    /// # Errors
    /// As [`from_pose`](Self::from_pose), or if the pose cannot be drawn.
    pub fn look(&self, frame: u64, pose: &EyePose) -> Result<Seen, DriveError> {
        self.from_pose(frame, pose)?.draw()
    }

    /// Frame `frame` of the path.
    ///
    /// # Errors
    /// If the scenario has no such frame, or the path cannot be driven there.
    pub fn at(&self, frame: u64) -> Result<Viewpoint<'_>, DriveError> {
        Ok(self.viewpoint(frame, self.seen_from(frame)?))
    }

    /// What is seen from `pose`, as frame `frame`.
    ///
    /// # Errors
    /// If a number of the pose is none, the pose turns a yoke that the display does not have, or the generator shows something of frames before:
    /// then a [`Loop`](crate::Loop) has what was driven.
    pub fn from_pose(&self, frame: u64, pose: &EyePose) -> Result<Viewpoint<'_>, DriveError> {
        if self.remembers_frames() {
            let title =
                format!("a single look by {}, whose pictures show frames before their own", self.drawn_by());
            let problem = Problem::of_file(self.file(), title).found("a pose without the poses before it");
            let problem = problem.expected("the poses of all frames up to this one");
            return Err(problem.help("look in a loop, which keeps what was driven").into());
        }
        let pose = pose.checked(self.file())?;
        self.expect_yoke(&pose)?;
        Ok(self.viewpoint(frame, pose.seen(self.opened.scenario.channel.as_ref())))
    }

    /// Sees that a display without a yoke is asked for no turned picture: what lies beside its raster is not drawn.
    fn expect_yoke(&self, pose: &EyePose) -> Result<(), DriveError> {
        if pose.yoke_deg == 0.0 || self.bench.stage.view.yoke.is_some() {
            return Ok(());
        }
        let title =
            format!("a pose whose `yoke_deg` is {}: the display has no deflection yoke", pose.yoke_deg);
        let problem = Problem::of_file(self.file(), title).key("yoke_deg").found(pose.yoke_deg.to_string());
        let help = "leave it out, or write `[roll] display = \"yoke\"` into the scenario";
        Err(problem.expected("0").help(help).into())
    }

    fn viewpoint(&self, frame: u64, pose: Pose) -> Viewpoint<'_> {
        Viewpoint { drive: self, bench: &self.bench, frame, pose }
    }

    /// Pose of the picture of frame `frame` of the path.
    pub(crate) fn seen_from(&self, frame: u64) -> Result<Pose, DriveError> {
        let frames = self.frames();
        if frame >= frames {
            let title = format!("no frame {frame}: the scenario has frames 0..{frames}");
            let problem = Problem::of_file(self.file(), title).found(frame.to_string());
            let problem = problem.expected(format!("a frame from 0 to {}", frames - 1));
            return Err(problem.help("drive on in a loop, or set `scenario.frames`").into());
        }
        let table = self.opened.poses(&self.bench.stage, frame..frame + 1);
        let table = table.map_err(|error| DriveError::from(front_door::path_problems(&error)))?;
        Ok(table.rows()[0].pose)
    }
}
