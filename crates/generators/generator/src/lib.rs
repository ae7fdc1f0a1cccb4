//! The interface of every image generator.
//!
//! ```text
//! registry: Row ── run parameters, gear ──▶ Generator ── Stage: world and view ──▶ Session ── Pose ──▶ Planes
//!                                               └────────────────────────────▶ Timed   ── Pose ──▶ FrameTiming
//! ```
//!
//! - [`Stage`]: the world and the view, which all generators share. What else a generator reads is its own: it has read
//!   it before it is a [`Generator`].
//! - [`Session::frame`] fills named [`Planes`] for one pose. No files, no clock, no state between frames that is not in
//!   the arguments: any frame can be made alone, in any order, by any number of threads.
//! - [`Row`]: what is known of a generator before it draws. The crate `registry` lists the rows.
//! - [`Counter`], [`FrameError::Refused`]: counters and refusals are lists of each generator's own.

mod beam_list;
mod colours;
mod counts;
mod detailed;
mod error;
mod faces;
mod fact;
mod inputs_hash;
mod omission;
mod planes;
mod row;
mod timed;

use std::sync::Arc;

use landscape::Landscape;
use quantities::Timebase;
use scenario::{Pose, Scenery, View};
use serde_json::Value;
use signal::{Probe, Signal, Waveform, Wire};
use std::ops::Range;

pub use beam_list::BeamEntry;
pub use counts::{Counter, FrameCounts, Joined};
pub use detailed::{Detailed, DrawnGround, DrawnPosts, Errors, GroundLoss};
pub use error::{FrameError, PrepareError, check_eye, check_free_eye};
pub use faces::{FaceScene, Look, Looks, ScreenFace};
pub use fact::Fact;
pub use inputs_hash::InputsHash;
pub use omission::{Omission, Weight, face_lists_beside, photographs_beside};
pub use planes::{Label, Loss, Plane, PlaneKind, Planes, Shade};
pub use row::{Against, DetailWay, ErrorLadder, Gear, LampWay, Role, Row};
pub use timed::{ReportedTime, SizedFigure, Timed};

/// The world and the view: everything that generators share but the pose.
#[derive(Debug, Clone)]
pub struct Stage {
    /// Ground: terrain, craters, texture and albedo.
    pub landscape: Arc<Landscape>,
    /// Light, bodies and tracks over time.
    pub scenery: Arc<Scenery>,
    /// What is asked of the picture.
    pub view: View,
}

impl Stage {
    /// Whether anything on it has a colour: generators without colour draw its luminance.
    pub fn is_colourful(&self) -> bool {
        let mut still = self.scenery.standing().iter().map(|standing| &standing.body.solid);
        let mut guests = self.scenery.all_guests().iter().map(|guest| &guest.solid);
        self.landscape.albedo_map().is_some_and(|map| map.texels().is_colourful())
            || still.any(|solid| solid.is_colourful())
            || guests.any(|solid| solid.is_colourful())
            || self.scenery.all_effects().iter().any(|carried| colours::has_colour(&carried.effects))
    }
}

/// How the signals of a generator run: line by line, sample by sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Scan {
    /// Word for one line: "sweep", "row".
    pub line: &'static str,
    /// Clocks: lines of a frame as sweeps, and the samples of each.
    pub timebase: Timebase,
    /// Signal that says where a sample is.
    pub place: &'static str,
    /// What the samples of a line follow one another along.
    pub along: Along,
}

impl Scan {
    /// Signal that says how far ahead a whole line is, where lines lie across the view.
    pub fn ahead(&self) -> Option<&'static str> {
        match self.along {
            Along::Across { ahead } => Some(ahead),
            Along::Range | Along::Raster => None,
        }
    }
}

/// What the samples of a line follow one another along.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Along {
    /// Ground range (m), in time.
    Range,
    /// The way across the line of sight (m).
    Across {
        /// Signal that says how far ahead the whole line is (m).
        ahead: &'static str,
    },
    /// A line of the raster; places are counted.
    Raster,
}

/// An image generator with its own settings: the hybrid machine, `exact`, and others of the field's history.
pub trait Generator: Send + Sync {
    /// Name: that of its row, or "hybrid".
    fn name(&self) -> &'static str;

    /// The counters that its frames have.
    fn counters(&self) -> &'static [Counter];

    /// The planes that its sessions fill; others that are asked for keep what they held. Intensity alone unless it says
    /// more.
    fn planes(&self) -> &'static [PlaneKind] {
        &[PlaneKind::Intensity]
    }

    /// Whether its pictures of `stage` have colour: then red, green and blue are among its planes, and its intensity is
    /// their luminance.
    fn draws_colour(&self, _stage: &Stage) -> bool {
        false
    }

    /// The signals that its sessions can record.
    fn signals(&self) -> &'static [Signal] {
        &[]
    }

    /// How its signals run under `view`; `None` if it has no signals.
    fn scan(&self, _view: &View) -> Option<Scan> {
        None
    }

    /// The signals along the lines that a read beam scans; none if it has no read beam.
    fn line_signals(&self) -> &'static [Signal] {
        &[]
    }

    /// How those run, line by line in the order of time; `None` if it has no read beam.
    fn line_scan(&self) -> Option<Scan> {
        None
    }

    /// Whether a picture may show something of frames before its own: its stage must then have the course of the mission
    /// ([`Scenery::course`](scenario::Scenery::course)).
    fn remembers_frames(&self) -> bool {
        false
    }

    /// Whether the time of a frame depends on frames before it; then a stage for its timing must have the course too.
    fn timing_remembers_frames(&self) -> bool {
        self.remembers_frames()
    }

    /// Its own settings, for the record of a run: everything that decides its pictures beside the stage, and that does
    /// not stand in the view.
    fn record(&self) -> Value {
        Value::Null
    }

    /// Elaborates `stage`: after this nothing is looked up by name.
    ///
    /// # Errors
    /// If the generator cannot draw what the stage asks for.
    fn prepare(&self, stage: Stage) -> Result<Box<dyn Session>, PrepareError>;

    /// Whether its timing records have deadlines.
    fn has_deadlines(&self) -> bool {
        false
    }

    /// The generator on `stage` as a job that takes time; `None` if its frames take none.
    ///
    /// # Errors
    /// If the generator cannot draw what the stage asks for.
    fn timed(&self, _stage: Stage) -> Result<Option<Box<dyn Timed>>, PrepareError> {
        Ok(None)
    }
}

/// A generator made ready for one stage.
pub trait Session: Send + Sync {
    /// Draws frame `frame` from `pose` into the planes that `planes` holds, and records what `probe` wants.
    /// Uses the threads of the current rayon pool; the bits do not depend on their number. The planes must have
    /// as many columns and lines as the view; if there are none, no picture is wanted, and no more is
    /// worked out than what `probe` looks at.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError>;

    /// The same for whoever looks at column `column` of the picture alone, and draws no more than that takes. Returns the columns of
    /// `planes` that are as [`frame`](Self::frame) draws them, that one among them; the others hold anything.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn column(
        &self,
        frame: u64,
        pose: &Pose,
        _column: usize,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<Range<usize>, FrameError> {
        self.frame(frame, pose, planes, probe)?;
        Ok(0..planes.columns())
    }

    /// Draws showing `showing` of frame `frame`, from 0, as a display repeats it at the refresh rate. `false` if every showing is
    /// what [`frame`](Self::frame) draws: then `planes` keep what they hold. Otherwise `frame` draws the last showing.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn repeat(
        &self,
        _frame: u64,
        _pose: &Pose,
        _showing: u64,
        _planes: &mut Planes,
    ) -> Result<bool, FrameError> {
        Ok(false)
    }

    /// Whether [`frame`](Self::frame) can draw frame `frame` from `pose`; nothing is drawn.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError>;

    /// What was left out at elaboration, and why.
    fn omissions(&self) -> Vec<Omission>;

    /// The signals that this session can record, with their full scales; those of blocks that are left out are not
    /// among them.
    fn wires(&self) -> Vec<Wire> {
        Vec::new()
    }

    /// Waveforms along `lines` of the read beam in frame `frame` from `pose`, counted in the order in which it scans them; none if
    /// there is no read beam.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn lines(&self, _frame: u64, _pose: &Pose, _lines: Range<u32>) -> Result<Vec<Waveform>, FrameError> {
        Ok(Vec::new())
    }

    /// Direction over the ground (unit vector: north, east) of line `line` of its signals in frame `frame` from `pose`;
    /// `None` if its lines do not run straight out from the eye.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn direction(&self, _frame: u64, _pose: &Pose, _line: u32) -> Result<Option<[f64; 2]>, FrameError> {
        Ok(None)
    }

    /// How pixel `pixel` (column and line inside the picture, from 0 at the top left) of frame `frame` came about, fact by
    /// fact; none if the generator has no more to say than its planes.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn explain(&self, _frame: u64, _pose: &Pose, _pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        Ok(Vec::new())
    }

    /// Everything that sampling point `number` of pixel `pixel` holds in frame `frame`, as a document; `None` if the generator has no
    /// such sampling point.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn sampling_point(
        &self,
        _frame: u64,
        _pose: &Pose,
        _pixel: [usize; 2],
        _number: usize,
    ) -> Result<Option<Value>, FrameError> {
        Ok(None)
    }

    /// The faces of frame `frame` on the screen without any limit of the generator, for a judge that draws them by area; `None` if it draws
    /// no faces, or something that is no face.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn faces(&self, _frame: u64, _pose: &Pose) -> Result<Option<FaceScene>, FrameError> {
        Ok(None)
    }

    /// Distance (m) along the view axis from `pose` to the ground as it is drawn; infinite for sky. Levels of detail are those for the first of
    /// `levels`, at the moment when they change to or from those for the second; where both are `pose`, those of its picture. `None` if the
    /// generator has no levels of detail.
    ///
    /// # Errors
    /// If a pose cannot be drawn.
    fn sounding(&self, _frame: u64, _pose: &Pose, _levels: [&Pose; 2]) -> Result<Option<f64>, FrameError> {
        Ok(None)
    }

    /// What the session tells of its levels of detail; `None` if it has none.
    fn detailed(&self) -> Option<&dyn Detailed> {
        None
    }

    /// The light points of frame `frame` that leave the generator for a beam, in the order of drawing; `None` if it has no beam.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn beam_list(&self, _frame: u64, _pose: &Pose) -> Result<Option<Vec<BeamEntry>>, FrameError> {
        Ok(None)
    }
}
