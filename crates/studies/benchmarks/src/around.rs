//! What stands before and between frames: the making of ground, shadow boundaries, a survey, whole missions.

use machine::Prepare;
use std::time::Instant;

use quantities::unit_interval;
use rayon::ThreadPool;
use signal::Probe;
use survey::{Affine, Elevation, Frame, SurveyOptions, survey};

use crate::{Choice, REAL_TIME, TimedScene};

/// A mission, from its scenario's file to the planes of its last frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mission {
    /// Number of frames of the mission.
    pub frames: usize,
    /// Reading, and the making of the ground (s).
    pub ground: f64,
    /// Elaboration and the first frame, with the shadow boundaries and footings that it needs (s).
    pub first: f64,
    /// All other frames, with what of these they come to need (s).
    pub others: f64,
    samples: u64,
}

impl Mission {
    /// Draws all frames of the scenario called `name`, with `choice` made, on the threads of `pool`.
    ///
    /// # Errors
    /// If a frame cannot be drawn.
    pub fn draw(name: &str, choice: &Choice, pool: &ThreadPool) -> Result<Self, String> {
        let begin = Instant::now();
        let scene = TimedScene::shipped(name, choice);
        let ground = begin.elapsed().as_secs_f64();
        let (mut planes, samples, poses) = (scene.planes(), scene.samples(), scene.poses());
        let begin = Instant::now();
        let session = scene.stage.prepare();
        let mut first = 0.0;
        for (frame, pose) in poses.iter().enumerate() {
            let drawn = pool.install(|| session.frame(frame as u64, pose, &mut planes, &mut Probe::off()));
            drawn.map_err(|error| error.to_string())?;
            if frame == 0 {
                first = begin.elapsed().as_secs_f64();
            }
        }
        let others = begin.elapsed().as_secs_f64() - first;
        Ok(Self { frames: poses.len(), ground, first, others, samples })
    }

    /// Frames a second of all but the first.
    pub fn rate(&self) -> f64 {
        (self.frames - 1) as f64 / self.others
    }

    /// Times real time, ground and first frame included.
    pub fn real_time(&self) -> f64 {
        let whole = self.ground + self.first + self.others;
        (self.frames as u64 * self.samples) as f64 / whole / REAL_TIME
    }
}

/// Side of a region of the survey in samples, as `lunoid survey` has it by itself.
const SAMPLES_A_REGION: f64 = 4.0;

/// Elevation samples of a rough plain, 1 m apart, to be surveyed.
pub struct RoughPlain(Elevation);

impl RoughPlain {
    /// Of `side` x `side` samples.
    pub fn new(side: usize) -> Self {
        let height = |index: usize| {
            let [north, east] = [index / side, index % side];
            let wave = |metres: usize, length: f64| libm::sin(metres as f64 / length);
            5.0 * wave(north, 31.0) * wave(east, 47.0) + 0.1 * unit_interval(3, &[index as u64])
        };
        let affine = Affine { first: [0.0; 2], step: [1.0; 2] };
        Self(Elevation::new(side, side, (0..side * side).map(height).collect(), affine, Frame::Plane(None)))
    }

    /// Fits its regions, on the threads of the present pool; how many samples the finest level went by.
    ///
    /// # Errors
    /// If that does not come to an end.
    pub fn survey(&self) -> Result<usize, String> {
        let options = SurveyOptions::new(SAMPLES_A_REGION);
        let found = survey(&self.0, &options, &mut |_| {}).map_err(|error| error.to_string())?;
        Ok(found.report.levels[0].used)
    }
}

/// Time (s) of a survey of `side` x `side` samples of a [`RoughPlain`], on the threads of `pool`.
///
/// # Errors
/// If it does not come to an end.
pub fn surveyed(side: usize, pool: &ThreadPool) -> Result<f64, String> {
    let plain = RoughPlain::new(side);
    let begin = Instant::now();
    let used = pool.install(|| plain.survey())?;
    let seconds = begin.elapsed().as_secs_f64();
    assert!(used > 0);
    Ok(seconds)
}
