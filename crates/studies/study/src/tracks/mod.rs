//! A stand-in for navigation by camera: corners that are followed over frames, as levels of detail change below them.
//!
//! **Law.** Two tests, each of which follows the corners of its first picture (the files `flow` and `corners`).
//! *Held*: the camera stands at the pose of the middle frame, and the levels of detail go on from frame to frame. Every corner should stay where
//! it began. *Flown*: the camera goes on too. A corner should be where the pinhole shows the place of the ground that it began at. That place
//! follows from the pose of the first frame and the distance that the finest ground alone has there. A track is *off* by its distance from
//! where it should be. A *jump* is a change of that by more than [`JUMP`] pixels from one frame to the next.
//! **Grey.** Pictures are followed as they are displayed, at 16 bits, after a binomial filter of 5 x 5 pixels. Without the filter, edges with
//! steps hold a window back: light that is looked up once a pixel has such edges.
//! **Our choices.** The tracker is our own: a page of closed form whose bits depend on no library, on no vector unit, and on no number of threads.
//! Corners beside sky or beside an edge of ground before farther ground are not begun. Nothing tells a track that its ground is now hidden: the
//! finest ground says how often that happens.

mod corners;
mod flow;
mod image;
mod sight;
mod tracker;

use generator::{Detailed, PlaneKind, Planes, Session};
use picture::{Depth, Encoder};
use scenario::{Pose, View};
use serde::Serialize;
use signal::Probe;

use self::image::Image;
use self::sight::{Sight, shown};
use self::tracker::Tracker;
use crate::StudyError;
use crate::figures::transfer;

pub use flow::Lost;
pub use tracker::{FrameTracks, JUMP, Track};

/// Tracks stay within this (pixels) where they are of use (specification of the thesis, test 12).
pub const WITHIN: f64 = 0.5;
/// Share of the tracks that stay within [`WITHIN`], over that of the finest rung, for a rung of a ladder to pass. Chosen.
pub const MOSTLY: f64 = 0.95;

/// The frames of a study.
pub struct Flight<'a> {
    /// What is asked of the pictures.
    pub view: &'a View,
    /// Number of the first frame.
    pub first: u64,
    /// Poses of the frames, one after the other; at least one.
    pub poses: &'a [Pose],
}

/// What came of a test in one way of drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct TrackOutcome {
    /// Name of the way, or of the rung.
    pub name: String,
    /// Tracks, the strongest corner first.
    pub tracks: Vec<Track>,
    /// What they did in each frame but the first.
    pub frames: Vec<FrameTracks>,
}

/// Figures of an outcome.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TrackFigures {
    /// Name of the way, or of the rung.
    pub name: String,
    /// Tracks that were begun.
    pub begun: usize,
    /// Median length of a track (frames).
    pub median_frames: f64,
    /// Mean length of a track (frames).
    pub mean_frames: f64,
    /// Number of tracks that broke.
    pub broken: usize,
    /// Tracks that left the picture.
    pub left: usize,
    /// Root mean square of what tracks are off, over all frames (pixels).
    pub rms_px: f64,
    /// Largest distance of a track from where it should be (pixels).
    pub worst_px: f64,
    /// Largest change of that from one frame to the next (pixels), and the later frame.
    pub largest_step: Option<Step>,
    /// Number of changes above [`JUMP`].
    pub jumps: u64,
    /// Frames that have any.
    pub jump_frames: Vec<u64>,
    /// Frames in which tiles in view took another level.
    pub level_change_frames: usize,
    /// Share of the tracks that neither broke nor were ever off by more than [`WITHIN`]; none without tracks.
    pub share_within: Option<f64>,
}

/// The largest change of what a track is off.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Step {
    /// Number of the later frame.
    pub frame: u64,
    /// Size of the change (pixels).
    pub pixels: f64,
}

/// The part of a session that knows its levels.
///
/// # Errors
/// If it has none.
fn detailed(session: &dyn Session) -> Result<&dyn Detailed, StudyError> {
    session.detailed().ok_or_else(|| StudyError::Ladder("the generator has no levels of detail".into()))
}

/// Distances (m) of the first frame as `session` draws them, which must be the finest ground alone: what the truth of [`flown`] follows from.
///
/// # Errors
/// If the frame cannot be drawn.
pub fn distances(session: &dyn Session, flight: &Flight<'_>) -> Result<Vec<f32>, StudyError> {
    let mut planes = flight.planes(&[PlaneKind::Distance]);
    session.frame(flight.first, &flight.poses[0], &mut planes, &mut Probe::off())?;
    Ok(planes.get(PlaneKind::Distance).unwrap_or_default().to_vec())
}

/// Tracks of a camera that stands at the pose of the middle frame while levels go on over all frames.
///
/// # Errors
/// If a frame cannot be drawn, or the session has no levels of detail.
pub fn held(name: &str, session: &dyn Session, flight: &Flight<'_>) -> Result<TrackOutcome, StudyError> {
    let detailed = detailed(session)?;
    let middle = flight.poses.len() / 2;
    let (frame, pose) = (flight.first + middle as u64, flight.poses[middle]);
    let mut planes = flight.planes(&[PlaneKind::Intensity, PlaneKind::Distance]);
    let mut draw = |levels: &Pose| -> Result<(Image, Vec<f32>), StudyError> {
        detailed.held_frame(frame, &pose, levels, &mut planes)?;
        Ok((flight.grey(&planes)?, planes.get(PlaneKind::Distance).unwrap_or_default().to_vec()))
    };
    let (first, distances) = draw(&flight.poses[0])?;
    let sight = Sight::new(&pose, flight.view, distances);
    let mut tracker = Tracker::new(first, &|pixel| sight.is_ground(pixel));
    let begun: Vec<[f64; 2]> = tracker.tracks.iter().map(|track| track.begun.map(|at| at as f64)).collect();
    let mut frames = Vec::new();
    for pair in flight.poses.windows(2) {
        let (picture, _) = draw(&pair[1])?;
        let found = tracker.next(picture, |number| Some(begun[number]));
        let level_changes = detailed.level_changes(frame, &pose, [&pair[0], &pair[1]])?;
        frames.push(FrameTracks { level_changes, ..found });
    }
    Ok(TrackOutcome { name: name.into(), tracks: tracker.tracks, frames })
}

/// Tracks of a camera that flies, against the places that the finest ground has by its `distances` in the first frame.
///
/// # Errors
/// If a frame cannot be drawn, or the session has no levels of detail.
pub fn flown(
    name: &str,
    session: &dyn Session,
    flight: &Flight<'_>,
    distances: &[f32],
) -> Result<TrackOutcome, StudyError> {
    let detailed = detailed(session)?;
    let mut planes = flight.planes(&[PlaneKind::Intensity]);
    let mut draw = |frame: u64, pose: &Pose| -> Result<Image, StudyError> {
        session.frame(frame, pose, &mut planes, &mut Probe::off())?;
        flight.grey(&planes)
    };
    let first = draw(flight.first, &flight.poses[0])?;
    let sight = Sight::new(&flight.poses[0], flight.view, distances.to_vec());
    let mut tracker = Tracker::new(first, &|pixel| sight.is_ground(pixel));
    let places: Vec<_> = tracker.tracks.iter().map(|track| sight.place(track.begun)).collect();
    let mut frames = Vec::new();
    for (number, pair) in (flight.first + 1..).zip(flight.poses.windows(2)) {
        let picture = draw(number, &pair[1])?;
        let found = tracker.next(picture, |track| shown(&pair[1], flight.view, places[track]?));
        let level_changes = detailed.level_changes(number, &pair[1], [&pair[0], &pair[1]])?;
        frames.push(FrameTracks { level_changes, ..found });
    }
    Ok(TrackOutcome { name: name.into(), tracks: tracker.tracks, frames })
}

impl Flight<'_> {
    fn planes(&self, kinds: &[PlaneKind]) -> Planes {
        Planes::new(self.view.columns as usize, self.view.lines as usize, kinds)
    }

    /// A picture as it is displayed.
    fn grey(&self, planes: &Planes) -> Result<Image, StudyError> {
        let [columns, lines] = [self.view.columns, self.view.lines].map(|count| count as usize);
        let encoder = Encoder::new(transfer(&self.view.display)?, Depth::Sixteen);
        let shown = encoder.encode(planes.get(PlaneKind::Intensity).unwrap_or_default(), columns, lines)?;
        Ok(Image::new(columns, shown.levels().map(|level| level as f32).collect()).smoothed())
    }
}

impl TrackOutcome {
    /// Figures of the outcome; `first` is the number of the first frame.
    pub fn figures(&self, first: u64) -> TrackFigures {
        let count = self.tracks.len();
        let mut lengths: Vec<usize> = self.tracks.iter().map(|track| track.length).collect();
        lengths.sort_unstable();
        let lost = |why: Lost| self.tracks.iter().filter(|track| track.lost == Some(why)).count();
        let stays = |track: &&Track| track.lost != Some(Lost::Broken) && track.worst <= WITHIN;
        let numbered = || (first + 1..).zip(&self.frames);
        let larger = |most: Step, next: Step| if next.pixels > most.pixels { next } else { most };
        let seen: u64 = self.frames.iter().map(|frame| frame.alive).sum();
        let share = |part: f64, whole: usize| (whole > 0).then(|| part / whole as f64);
        TrackFigures {
            name: self.name.clone(),
            begun: count,
            median_frames: median(&lengths),
            mean_frames: share(lengths.iter().sum::<usize>() as f64, count).unwrap_or(0.0),
            broken: lost(Lost::Broken),
            left: lost(Lost::Left),
            rms_px: (self.frames.iter().map(|frame| frame.squares).sum::<f64>() / seen as f64).sqrt(),
            worst_px: self.frames.iter().map(|frame| frame.worst).fold(0.0, f64::max),
            largest_step: numbered().map(|(frame, found)| Step { frame, pixels: found.step }).reduce(larger),
            jumps: self.frames.iter().map(|frame| frame.jumps).sum(),
            jump_frames: numbered().filter(|(_, found)| found.jumps > 0).map(|(frame, _)| frame).collect(),
            level_change_frames: self.frames.iter().filter(|frame| frame.level_changes > 0).count(),
            share_within: share(self.tracks.iter().filter(stays).count() as f64, count),
        }
    }
}

/// Median of rising lengths; 0 of none.
fn median(lengths: &[usize]) -> f64 {
    match lengths.len() {
        0 => 0.0,
        count => (lengths[(count - 1) / 2] + lengths[count / 2]) as f64 / 2.0,
    }
}
