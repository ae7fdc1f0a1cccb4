//! Light points of a frame, near to far, and the chords of their discs, sweep by sweep.

use scenario::LightPoint;

use crate::placing::{Optics, Point};

/// A sweep within the disc of a light point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chord {
    /// Number of the point in its table.
    pub point: u32,
    /// Upper and lower end: line positions from the top of the raster.
    pub ends: [f32; 2],
}

/// What is ready of the light points of a frame as its sweeps begin.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PointTable {
    points: Vec<Point>,
    /// Sweep by sweep, each near to far.
    chords: Vec<Chord>,
    /// First chord of each sweep, and their number.
    starts: Vec<usize>,
}

impl PointTable {
    /// Of the lights that shine in a frame, in any order.
    pub fn new(lights: &[LightPoint], optics: &Optics<'_>) -> Self {
        let mut placed: Vec<_> = lights.iter().filter_map(|light| optics.place(light)).collect();
        placed.sort_by(|(one, _), (other, _)| {
            let nearer = other.depth.total_cmp(&one.depth).then(other.priority.cmp(&one.priority));
            nearer.then(one.light.cmp(&other.light))
        });
        let sweeps = optics.reading.view.fan.sweeps as usize;
        let mut by_sweep = vec![Vec::new(); sweeps];
        for ((_, chords), point) in placed.iter().zip(0..) {
            for &(sweep, ends) in &chords.all {
                by_sweep[sweep as usize].push(Chord { point, ends });
            }
        }
        let mut starts = vec![0];
        starts.extend(by_sweep.iter().scan(0, |end, chords| {
            *end += chords.len();
            Some(*end)
        }));
        Self {
            points: placed.into_iter().map(|(point, _)| point).collect(),
            chords: by_sweep.concat(),
            starts,
        }
    }

    /// Points whose discs meet the picture, near to far.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Whether no disc meets the picture.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Discs that a sweep meets, near to far; none beyond the last sweep.
    pub fn sweep(&self, sweep: u32) -> &[Chord] {
        match self.starts.get(sweep as usize..sweep as usize + 2) {
            Some(&[start, end]) => &self.chords[start..end],
            _ => &[],
        }
    }

    /// The point of a chord.
    pub(crate) fn point(&self, chord: &Chord) -> &Point {
        &self.points[chord.point as usize]
    }
}
