//! The interface of every image generator.
//!
//! [`Generator::prepare`] elaborates a [`Stage`] into a [`Session`]; [`Session::frame`] fills named [`Planes`]
//! for one pose. No files, no clock, no state between frames that is not in the arguments: any frame can be made
//! alone, in any order, by any number of threads.

mod counts;
mod omission;
mod planes;

use std::sync::Arc;

use hardware_model::Settings;
use landscape::Landscape;
use quantities::Timebase;
use scenario::{Pose, Scenery};
use signal::{Probe, Signal, Wire};

pub use counts::FrameCounts;
pub use omission::{Omission, Weight};
pub use planes::{Label, Plane, PlaneKind, Planes, Shade};

/// What there is to draw, and how: everything but the pose.
#[derive(Debug, Clone)]
pub struct Stage {
    /// The ground.
    pub landscape: Arc<Landscape>,
    /// Light, bodies and tracks over time.
    pub scenery: Arc<Scenery>,
    /// The settings of the run.
    pub settings: Settings,
}

/// Why a generator cannot draw a stage.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PrepareError {
    /// The generator lacks something that the stage asks for.
    #[error("{generator} cannot do {what}: {remedy}")]
    Unsupported {
        /// Name of the generator.
        generator: &'static str,
        /// What is asked for.
        what: String,
        /// What to do instead.
        remedy: String,
    },
}

/// Why a frame cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FrameError {
    /// The eye does not see the ground from above.
    #[error("frame {frame}: the eye is {below:.3} m under the ground; expected it above the ground")]
    EyeUnderGround {
        /// Frame number.
        frame: u64,
        /// How far below the ground (m).
        below: f64,
    },
    /// The eye is outside the problem area.
    #[error("frame {frame}: the eye at x = {x:.1} m, y = {y:.1} m is outside the problem area")]
    OutsideProblemArea {
        /// Frame number.
        frame: u64,
        /// North (m).
        x: f64,
        /// East (m).
        y: f64,
    },
    /// Shadow boundaries cannot be kept.
    #[error(
        "frame {frame}: shadow boundaries cannot be kept: {reason}; name a folder that can be written by \
             --shadow-cache, or leave it out"
    )]
    ShadowCache {
        /// Frame number.
        frame: u64,
        /// What the system says.
        reason: String,
    },
    /// The generator lacks something that the pose asks for.
    #[error("frame {frame}: {reason}")]
    Unsupported {
        /// Frame number.
        frame: u64,
        /// The generator, what it cannot do, and what to do instead.
        reason: String,
    },
    /// The fan of sweeps cannot cover the view.
    #[error(
        "frame {frame}: pitch {pitch_deg:.1} deg brings the nadir or the zenith near the picture; \
             expected |pitch| + half the vertical field of view below {limit_deg:.0} deg"
    )]
    Pitch {
        /// Frame number.
        frame: u64,
        /// Pitch (deg).
        pitch_deg: f64,
        /// The limit (deg).
        limit_deg: f64,
    },
}

/// The eye stands over the finest level of `landscape` and above its ground: sight begins there.
///
/// # Errors
/// If it does not.
pub fn check_eye(landscape: &Landscape, frame: u64, pose: &Pose) -> Result<(), FrameError> {
    let [x, y, height] = pose.eye;
    let inside = landscape.level().locate(x, y).is_some();
    let ground = landscape.height(x, y).filter(|_| inside);
    let ground = ground.ok_or(FrameError::OutsideProblemArea { frame, x, y })?;
    match height > ground {
        true => Ok(()),
        false => Err(FrameError::EyeUnderGround { frame, below: ground - height }),
    }
}

/// An image generator: the hybrid machine, `exact`, and others of the field's history.
pub trait Generator: Sync {
    /// Name, as `--machine` says it.
    fn name(&self) -> &'static str;

    /// The signals that its sessions can record.
    fn signals(&self) -> &'static [Signal];

    /// The planes that its sessions fill; others that are asked for keep what they held. Intensity alone unless it says
    /// more.
    fn planes(&self) -> &'static [PlaneKind] {
        &[PlaneKind::Intensity]
    }

    /// Whether it draws by sweeps of the report's machine, with clocks and deadlines.
    fn is_machine(&self) -> bool {
        false
    }

    /// Clocks that its waveforms are told against: as many sweeps and samples as they have. One that has no clocks makes
    /// them up.
    fn timebase(&self, settings: &Settings) -> Timebase {
        settings.timebase
    }

    /// Elaborates `stage`: after this nothing is looked up by name.
    ///
    /// # Errors
    /// If the generator cannot draw what the stage asks for.
    fn prepare(&self, stage: Stage) -> Result<Box<dyn Session>, PrepareError>;
}

/// A generator made ready for one stage.
pub trait Session: Send + Sync {
    /// Draws frame `frame` from `pose` into the planes that `planes` holds, and records what `probe` wants.
    /// Uses the threads of the current rayon pool; the bits do not depend on their number. The planes must have
    /// as many columns and lines as the settings' raster; if there are none, no picture is wanted, and no more is
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

    /// Whether [`frame`](Self::frame) can draw frame `frame` from `pose`; nothing is drawn.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError>;

    /// What was left out at elaboration, and why.
    fn omissions(&self) -> Vec<Omission>;

    /// The signals that this session can record, with their full scales; those of blocks that are left out are not
    /// among them.
    fn wires(&self) -> Vec<Wire>;
}
