//! The poses of a mission, one a frame, as far as they are known.

use std::iter::from_fn;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};

use crate::Pose;

/// Poses in the first chunk; each later chunk has twice as many.
const FIRST_CHUNK: usize = 64;

/// Chunks of a course: together they have more frames than a mission may have.
const CHUNKS: usize = 40;

/// A cell is written once.
type Chunk = Box<[OnceLock<Pose>]>;

/// Poses of the pictures of a mission, from frame 0 on. Its clones are the same course.
///
/// A course grows while generators hold it, and no pose ever changes. So what a generator has worked out from the poses before stays true, and a
/// closed loop need not make its generator ready again for each frame.
#[derive(Debug, Clone, Default)]
pub struct Course(Arc<Poses>);

#[derive(Debug)]
struct Poses {
    chunks: [OnceLock<Chunk>; CHUNKS],
    frames: AtomicUsize,
}

impl Default for Poses {
    fn default() -> Self {
        Self { chunks: [const { OnceLock::new() }; CHUNKS], frames: AtomicUsize::new(0) }
    }
}

impl Course {
    /// Number of frames whose poses are known.
    pub fn len(&self) -> usize {
        self.0.frames.load(Ordering::Acquire)
    }

    /// Whether no pose is known.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Pose of the picture of frame `frame`, if it is known.
    pub fn get(&self, frame: usize) -> Option<&Pose> {
        let (chunk, place) = place(frame);
        self.0.chunks.get(chunk)?.get()?[place].get()
    }

    /// Adds the pose of the next frame, for all clones of the course.
    ///
    /// # Panics
    /// If the course has some 10^13 frames already.
    pub fn push(&self, pose: Pose) {
        let mut frame = self.len();
        // Where another thread has added a pose meanwhile, the next frame is a later one.
        while self.cell(frame).set(pose).is_err() {
            frame += 1;
        }
        self.0.frames.fetch_max(frame + 1, Ordering::AcqRel);
    }

    /// The known poses in the order of frames.
    pub fn iter(&self) -> impl Iterator<Item = &Pose> {
        let mut frames = 0..self.len();
        from_fn(move || self.get(frames.next()?))
    }

    /// The known poses as a list of their own.
    pub fn to_vec(&self) -> Vec<Pose> {
        self.iter().copied().collect()
    }

    fn cell(&self, frame: usize) -> &OnceLock<Pose> {
        let (chunk, place) = place(frame);
        let cells = || (0..FIRST_CHUNK << chunk).map(|_| OnceLock::new()).collect();
        &self.0.chunks[chunk].get_or_init(cells)[place]
    }
}

/// Chunk of a frame, and its place there.
fn place(frame: usize) -> (usize, usize) {
    let chunk = (frame / FIRST_CHUNK + 1).ilog2() as usize;
    (chunk, frame - FIRST_CHUNK * ((1 << chunk) - 1))
}

impl FromIterator<Pose> for Course {
    fn from_iter<I: IntoIterator<Item = Pose>>(poses: I) -> Self {
        let course = Self::default();
        poses.into_iter().for_each(|pose| course.push(pose));
        course
    }
}

impl From<Vec<Pose>> for Course {
    fn from(poses: Vec<Pose>) -> Self {
        poses.into_iter().collect()
    }
}

/// Courses are equal if their poses are.
impl PartialEq for Course {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

#[cfg(test)]
mod tests {
    use std::thread;

    use landscape::Attitude;

    use super::*;

    fn pose(frame: usize) -> Pose {
        let attitude = Attitude { heading: 0.0, pitch: 0.0, roll: 0.0 };
        Pose { time: frame as f64, eye: [0.0; 3], attitude, yoke: 0.0 }
    }

    #[test]
    fn each_frame_has_its_own_place_however_long_the_course() {
        let poses: Vec<Pose> = (0..1000).map(pose).collect();
        let course = Course::from(poses.clone());
        assert_eq!((course.len(), course.to_vec()), (1000, poses));
        assert_eq!(
            [course.get(999), course.get(1000), course.get(usize::MAX - 64)],
            [Some(&pose(999)), None, None]
        );
        let places = [0, 63, 64, 191, 192].map(place);
        assert_eq!(places, [(0, 0), (0, 63), (1, 0), (1, 127), (2, 0)]);
    }

    #[test]
    fn clones_grow_together_and_a_copy_stays() {
        let course: Course = (0..3).map(pose).collect();
        let (same, copy) = (course.clone(), course.iter().copied().collect::<Course>());
        let first = course.get(0).unwrap();
        course.push(pose(3));
        assert_eq!((same.get(3), first), (Some(&pose(3)), &pose(0)));
        assert_eq!((same == course, copy == course, copy.len()), (true, false, 3));
    }

    #[test]
    fn poses_that_several_threads_add_are_all_there() {
        let course = Course::default();
        let add = &|from: usize| (from..from + 500).for_each(|frame| course.push(pose(frame)));
        thread::scope(|scope| {
            let both = [0, 500].map(|from| scope.spawn(move || add(from)));
            both.into_iter().for_each(|thread| thread.join().unwrap());
        });
        let mut times: Vec<f64> = course.iter().map(|pose| pose.time).collect();
        times.sort_by(f64::total_cmp);
        assert_eq!(times, (0..1000).map(|time| time as f64).collect::<Vec<_>>());
    }
}
