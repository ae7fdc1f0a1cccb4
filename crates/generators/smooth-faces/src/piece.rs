//! A piece of a face on the screen, and its ramp along a scan line.

use std::ops::Range;

use faces::{Interpolation, in_space};
use glam::DVec3;
use scene_sampler::{Camera, NEAR};
use smallvec::SmallVec;

/// A corner of a face in camera axes (m) with its brightness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// Place: right, down, ahead (m).
    pub place: DVec3,
    /// Brightness, 0 or more.
    pub brightness: f64,
}

/// A corner on the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Place (pixels): x to the right, y down.
    pub at: [f64; 2],
    /// How near it is (1/m).
    pub q: f64,
    /// Brightness, 0 or more.
    pub brightness: f64,
}

/// A convex piece of a face on the screen.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// Its corners around it, in either direction.
    pub spots: SmallVec<[Spot; 4]>,
    /// Linear red, green, blue of full brightness.
    pub colour: [f64; 3],
    /// Number of its list, in the order of their priorities.
    pub list: u32,
    /// Number of its face in the list.
    pub face: u32,
}

/// Where a scan line enters or leaves a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct End {
    /// Place along the line (pixels).
    pub at: f64,
    /// How near it is (1/m).
    pub q: f64,
    /// Brightness, 0 or more.
    pub brightness: f64,
}

/// A piece along a scan line: where it enters, at the lower place, and where it leaves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramp(pub [End; 2]);

impl Piece {
    /// The piece of a face before the near plane; `None` where no sample of a screen of `size` (columns, lines) can be in it.
    pub fn new(
        corners: &[Corner],
        (camera, size): (&Camera, [usize; 2]),
        colour: [f64; 3],
        [list, face]: [u32; 2],
    ) -> Option<Self> {
        let kept = before_the_eye(corners);
        let spot = |corner: &Corner| Spot {
            at: camera.projection.project(corner.place),
            q: 1.0 / corner.place.z,
            brightness: corner.brightness,
        };
        let piece = Self { spots: kept.iter().map(spot).collect(), colour, list, face };
        let has_samples = |axis: usize| !samples(piece.extent(axis), size[axis]).is_empty();
        (kept.len() >= 3 && has_samples(0) && has_samples(1)).then_some(piece)
    }

    /// Least and largest place along an axis of the screen (pixels).
    pub fn extent(&self, axis: usize) -> [f64; 2] {
        let places = self.spots.iter().map(|spot| spot.at[axis]);
        places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
    }

    /// The piece along the line at `line` across axis `across` of the screen; `None` where the line misses it.
    pub fn ramp(&self, across: usize, line: f64, interpolation: Interpolation) -> Option<Ramp> {
        let mut ends: SmallVec<[End; 2]> = SmallVec::new();
        for (k, from) in self.spots.iter().enumerate() {
            let to = &self.spots[(k + 1) % self.spots.len()];
            // From the lower to the upper corner, so that both pieces of an edge have the same bits.
            let [from, to] = if from.at[across] <= to.at[across] { [from, to] } else { [to, from] };
            if from.at[across] <= line && line < to.at[across] {
                let share = (line - from.at[across]) / (to.at[across] - from.at[across]);
                ends.push(between(from, to, 1 - across, share, interpolation));
            }
        }
        let first = *ends.iter().min_by(|a, b| a.at.total_cmp(&b.at))?;
        let last = *ends.iter().max_by(|a, b| a.at.total_cmp(&b.at))?;
        Some(Ramp([first, last]))
    }
}

/// Samples of `count` along an axis whose middles lie between two places (pixels), the first one with them.
pub fn samples(places: [f64; 2], count: usize) -> Range<usize> {
    let [first, last] = places.map(|at| (at - 0.5).ceil().clamp(0.0, count as f64) as usize);
    first..last.max(first)
}

/// The part of a convex face that lies before the near plane.
fn before_the_eye(corners: &[Corner]) -> SmallVec<[Corner; 8]> {
    let mut kept = SmallVec::new();
    for (k, from) in corners.iter().enumerate() {
        let to = &corners[(k + 1) % corners.len()];
        if from.place.z >= NEAR {
            kept.push(*from);
        }
        if (from.place.z >= NEAR) != (to.place.z >= NEAR) {
            // From the nearer to the farther corner, so that both faces of an edge are cut at the same bits.
            let [near, far] = if from.place.z < to.place.z { [from, to] } else { [to, from] };
            let share = (NEAR - near.place.z) / (far.place.z - near.place.z);
            let place = near.place.lerp(far.place, share);
            let brightness = near.brightness + share * (far.brightness - near.brightness);
            kept.push(Corner { place: DVec3::new(place.x, place.y, NEAR), brightness });
        }
    }
    kept
}

/// A place between two corners; `along` is the axis of the scan line.
fn between(from: &Spot, to: &Spot, along: usize, share: f64, interpolation: Interpolation) -> End {
    let mix = |a: f64, b: f64, share: f64| a + share * (b - a);
    End {
        at: mix(from.at[along], to.at[along], share),
        q: mix(from.q, to.q, share),
        brightness: mix(
            from.brightness,
            to.brightness,
            part(share, || depths([from.q, to.q]), interpolation),
        ),
    }
}

/// Part of the way of brightness at part `share` of the way on the screen, between two depths (m).
#[inline(always)]
fn part(share: f64, depths: impl FnOnce() -> [f64; 2], interpolation: Interpolation) -> f64 {
    match interpolation {
        Interpolation::Screen => share,
        Interpolation::Perspective => in_space(share, depths()),
    }
}

/// Depths (m) of two nearnesses (1/m).
fn depths(nearness: [f64; 2]) -> [f64; 2] {
    nearness.map(|q| 1.0 / q)
}

/// A ramp from sample to sample: what all of them have in common is worked out once.
#[derive(Debug, Clone, Copy)]
pub struct Course {
    ramp: Ramp,
    /// Length on the screen (pixels).
    length: f64,
    /// Depths of its ends (m).
    depths: [f64; 2],
    interpolation: Interpolation,
    /// Change of brightness from pixel to pixel, where it is linear on the screen.
    pub slope: f64,
}

impl Course {
    /// How near the piece is (1/m), and its brightness, at a place (pixels).
    #[inline(always)]
    pub fn at(&self, place: f64) -> [f64; 2] {
        let Ramp([from, to]) = self.ramp;
        let share = if self.length > 0.0 { ((place - from.at) / self.length).clamp(0.0, 1.0) } else { 0.0 };
        let part = part(share, || self.depths, self.interpolation);
        [from.q + share * (to.q - from.q), from.brightness + part * (to.brightness - from.brightness)]
    }
}

impl Ramp {
    /// Samples whose middles lie in it, of a line of `count`.
    pub fn samples(&self, count: usize) -> Range<usize> {
        samples(self.0.map(|end| end.at), count)
    }

    /// The ramp with brightness interpolated so.
    pub fn course(self, interpolation: Interpolation) -> Course {
        let [from, to] = self.0;
        let length = to.at - from.at;
        let slope = if length > 0.0 { (to.brightness - from.brightness) / length } else { 0.0 };
        Course { ramp: self, length, depths: depths([from.q, to.q]), interpolation, slope }
    }
}
