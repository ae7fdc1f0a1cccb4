//! Corners that are followed from frame to frame, and how far they are off where they should be.

use rayon::prelude::*;

use super::corners::corners;
use super::flow::{HALF, LEVELS, Lost, follow};
use super::image::{Image, Pyramid};

/// Most tracks that are begun. Chosen.
const MOST_TRACKS: usize = 300;
/// A step off the true one above this (pixels) is a jump. Chosen.
pub const JUMP: f64 = 0.1;

/// A corner that is followed.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    /// Pixel where it began.
    pub begun: [usize; 2],
    /// Frames in which it was seen, the first with them.
    pub length: usize,
    /// Largest distance (pixels) from where it should be.
    pub worst: f64,
    /// Why it ended before the last frame.
    pub lost: Option<Lost>,
    place: [f64; 2],
    /// Where it was off its true place in the frame before (pixels).
    off: [f64; 2],
}

/// What tracks did in one frame.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FrameTracks {
    /// Tracks that were found again.
    pub alive: u64,
    /// Number of tracks that broke.
    pub broken: u64,
    /// Tracks that left the picture.
    pub left: u64,
    /// Sum of the squares of what tracks are off (pixels).
    pub squares: f64,
    /// Largest distance of a track from where it should be (pixels).
    pub worst: f64,
    /// Largest change of what a track is off, from the frame before (pixels).
    pub step: f64,
    /// Tracks whose change is above [`JUMP`].
    pub jumps: u64,
    /// Tiles in view that took another level.
    pub level_changes: u64,
}

impl Track {
    /// A track at its pixel of the first picture.
    pub(crate) fn begun(begun: [usize; 2]) -> Self {
        let place = begun.map(|at| at as f64);
        Self { begun, length: 1, worst: 0.0, lost: None, place, off: [0.0; 2] }
    }
}

impl FrameTracks {
    /// Root mean square of what tracks are off (pixels); NaN without tracks.
    pub fn rms(&self) -> f64 {
        (self.squares / self.alive as f64).sqrt()
    }
}

/// The tracks of a sequence of pictures.
pub struct Tracker {
    last: Pyramid,
    /// Tracks in the order in which they were chosen, the strongest corner first.
    pub tracks: Vec<Track>,
}

impl Tracker {
    /// Begins tracks at the corners of `first` that are `usable` and whose windows lie inside the picture.
    pub fn new(first: Image, usable: &dyn Fn([usize; 2]) -> bool) -> Self {
        let room = HALF as usize + 2;
        let size = first.size();
        let is_inside =
            |at: [usize; 2]| (0..2).all(|axis| (room..(size[axis]).max(room) - room).contains(&at[axis]));
        let begun = corners(&first, MOST_TRACKS, &|at| is_inside(at) && usable(at));
        Self { last: Pyramid::new(first, LEVELS), tracks: begun.into_iter().map(Track::begun).collect() }
    }

    /// Goes on to the next picture; `truth` tells where (pixels) track number n should be, `None` if it cannot be in the picture.
    pub fn next(&mut self, next: Image, truth: impl Fn(usize) -> Option<[f64; 2]>) -> FrameTracks {
        let next = Pyramid::new(next, LEVELS);
        let last = &self.last;
        let found: Vec<Option<Result<[f64; 2], Lost>>> = self
            .tracks
            .par_iter()
            .map(|track| track.lost.is_none().then(|| follow(last, &next, track.place)))
            .collect();
        let mut frame = FrameTracks::default();
        for (number, (track, found)) in self.tracks.iter_mut().zip(found).enumerate() {
            let Some(found) = found else { continue };
            let found = found.and_then(|place| Ok((place, truth(number).ok_or(Lost::Left)?)));
            match found {
                Ok((place, true_place)) => frame.add(track, place, true_place),
                Err(lost) => {
                    track.lost = Some(lost);
                    match lost {
                        Lost::Broken => frame.broken += 1,
                        Lost::Left => frame.left += 1,
                    }
                }
            }
        }
        self.last = next;
        frame
    }
}

impl FrameTracks {
    fn add(&mut self, track: &mut Track, place: [f64; 2], true_place: [f64; 2]) {
        let off = [0, 1].map(|axis| place[axis] - true_place[axis]);
        let distance = libm::hypot(off[0], off[1]);
        let step = libm::hypot(off[0] - track.off[0], off[1] - track.off[1]);
        (track.place, track.off) = (place, off);
        track.length += 1;
        track.worst = track.worst.max(distance);
        self.alive += 1;
        self.squares += distance * distance;
        self.worst = self.worst.max(distance);
        self.step = self.step.max(step);
        self.jumps += u64::from(step > JUMP);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Patches of light that drift to the right by `drift` pixels, those of the lower half by `more` besides.
    fn patches(drift: f64, more: f64) -> Image {
        let value = |index: usize| {
            let (x, y) = ((index % 200) as f64, (index / 200) as f64);
            let x = x - drift - if y < 60.0 { 0.0 } else { more };
            (0.5 + 0.3 * libm::sin(x / 4.0) * libm::sin(y / 5.0)) as f32
        };
        Image::new(200, (0..200 * 120).map(value).collect())
    }

    #[test]
    fn tracks_tell_how_far_they_are_off_and_where_they_jump() {
        let mut tracker = Tracker::new(patches(0.0, 0.0), &|[_, y]| y.abs_diff(60) > 12);
        assert!(tracker.tracks.len() > 40);
        let begun: Vec<[f64; 2]> =
            tracker.tracks.iter().map(|track| track.begun.map(|at| at as f64)).collect();
        // The truth drifts by 0.4 pixels a frame; the lower half jumps by 0.25 in the third picture, and stays there.
        let frames: Vec<FrameTracks> = [(0.4, 0.0), (0.8, 0.25), (1.2, 0.25)]
            .into_iter()
            .map(|(drift, more)| {
                tracker
                    .next(patches(drift, more), |number| Some([begun[number][0] + drift, begun[number][1]]))
            })
            .collect();
        let lower = begun.iter().filter(|[_, y]| *y > 60.0).count() as u64;
        assert_eq!(frames.iter().map(|frame| frame.jumps).collect::<Vec<_>>(), [0, lower, 0]);
        assert!((frames[1].step - 0.25).abs() < 0.02 && (frames[2].worst - 0.25).abs() < 0.03, "{frames:?}");
        assert!(frames[0].rms() < 0.01 && frames.iter().all(|frame| frame.broken == 0));
        assert!(tracker.tracks.iter().all(|track| track.length == 4 && track.lost.is_none()));
    }

    #[test]
    fn a_track_whose_place_leaves_the_picture_has_left() {
        let mut tracker = Tracker::new(patches(0.0, 0.0), &|_| true);
        let count = tracker.tracks.len() as u64;
        let frame = tracker.next(patches(0.1, 0.0), |_| None);
        assert_eq!((frame.alive, frame.left, frame.broken), (0, count, 0));
        assert!(frame.rms().is_nan());
        assert_eq!(tracker.next(patches(0.2, 0.0), |_| None), FrameTracks::default());
    }
}
