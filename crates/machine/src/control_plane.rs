//! The digital side of a frame: fan, start of every sweep, folds, sweep programs.

use dpu::{CrossingService, Sector, TimedFold};
use generator::{FrameError, Stage};
use hardware_model::Settings;
use landscape::{Level, Sun};
use quantities::{degrees, sin_cos};
use scenario::Pose;
use sweep_generator::{Folds, RangeTable, set_up};
use sweep_program::{Fan, SweepProgram};

/// What the control plane works out once a frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FramePlan {
    /// Frame number.
    pub frame: u64,
    /// Azimuths of the sweeps.
    pub fan: Fan,
    /// Cosine and sine of the heading.
    pub heading: [f64; 2],
    /// Pitch of the eye (rad).
    pub pitch: f64,
    /// Eye: north, east, height (m).
    pub eye: [f64; 3],
    /// The sun.
    pub sun: Sun,
}

impl FramePlan {
    /// Checks that the pose can be drawn and spreads the fan.
    pub fn new(frame: u64, pose: &Pose, stage: &Stage) -> Result<Self, FrameError> {
        let Stage { landscape, scenery, settings } = stage;
        let [x, y, height] = pose.eye;
        let ground = landscape.height(x, y).ok_or(FrameError::OutsideProblemArea { frame, x, y })?;
        let above = height > ground;
        if !above {
            return Err(FrameError::EyeUnderGround { frame, below: ground - height });
        }
        let raster = &settings.raster;
        let pitch = pose.attitude.pitch;
        let fan = Fan::covering(settings.laws.projection, pitch, &raster.field, raster.sweeps);
        let (sin, cos) = sin_cos(pose.attitude.heading);
        Ok(Self {
            frame,
            fan: fan.ok_or_else(|| pitch_error(frame, pitch))?,
            heading: [cos, sin],
            pitch,
            eye: pose.eye,
            sun: scenery.sun(pose.time),
        })
    }

    /// Regions that the frame can show, out to `range` (m).
    pub fn visible_regions(&self, level: &Level, range: f64) -> usize {
        let [x, y, _] = self.eye;
        let edges = [0, self.fan.sweeps - 1].map(|sweep| self.fan.direction(sweep, self.heading));
        let range = range / level.region_size();
        Sector { foot: level.in_regions(x, y), edges, range }.regions(level).count()
    }

    /// Writes the program of one sweep into `program`.
    pub fn write_program(
        &self,
        sweep: u32,
        level: &Level,
        settings: &Settings,
        table: &RangeTable,
        program: &mut SweepProgram,
    ) {
        let [x, y, _] = self.eye;
        let foot = level.in_regions(x, y);
        let direction = self.fan.direction(sweep, self.heading);
        let start = set_up(foot, direction);
        let end_range = way_to_edge(level, foot, direction).min(settings.range.end);
        let mut time_of = table.times();
        let folds = Folds::new(&start)
            .map(|(regions, fold)| {
                let range = regions * level.region_size();
                TimedFold { time: time_of(range), range, fold }
            })
            .take_while(|fold| fold.range <= end_range);
        let service = CrossingService { level, loader: &settings.loader, timebase: &settings.timebase };
        let range_at = |time| table.range_at(time);
        service.write_program((self.frame, sweep), start, folds, end_range, range_at, program);
    }
}

/// Ground range at which a straight sweep leaves the stored area (m).
fn way_to_edge(level: &Level, foot: [f64; 2], direction: [f64; 2]) -> f64 {
    let corners = level.corners();
    let regions = (0..2).map(|axis| {
        let last = (corners[axis] - 1) as f64;
        match direction[axis] {
            cosine if cosine > 0.0 => (last - foot[axis]) / cosine,
            cosine if cosine < 0.0 => -foot[axis] / cosine,
            _ => f64::INFINITY,
        }
    });
    regions.fold(f64::INFINITY, f64::min) * level.region_size()
}

fn pitch_error(frame: u64, pitch: f64) -> FrameError {
    FrameError::Pitch { frame, pitch_deg: degrees(pitch), limit_deg: degrees(Fan::steepest()) }
}
