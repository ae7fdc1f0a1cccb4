//! What stands in a scene for other generators than the hybrid machine: bodies that move, surfaces that do not close, groups
//! with a sun of their own.

use std::num::NonZeroU16;
use std::sync::Arc;

use glam::{DMat3, DVec3};
use landscape::{Attitude, Sun};
use quantities::radians;
use solids::{Body, Kind, Solid};

use crate::Stance;

/// How an object moves: straight from station to station, and a turn of its own on top.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Moves {
    /// Stations, ascending in time; before the first and after the last the object rests. None: it stays in its place.
    pub stations: Vec<MoveStation>,
    /// Rate at which its heading turns, clockwise from above (rad/s), from the start of the mission.
    pub spin: f64,
}

/// Where an object is at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoveStation {
    /// Time since the start of the mission (s).
    pub time: f64,
    /// Foot point and attitude.
    pub stance: Stance,
    /// Height of the foot point above the ground under it (m).
    pub above: f64,
}

/// A foot point and an attitude in space at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Time since the start of the mission (s).
    pub time: f64,
    /// North, east, up (m).
    pub foot: DVec3,
    /// Roll, pitch and heading at that time (rad).
    pub attitude: Attitude,
}

/// A part of an object that moves, or that is open. Its place is a function of time.
#[derive(Debug, Clone, PartialEq)]
pub struct Guest {
    /// First time at which it stands (s).
    pub from: f64,
    /// Time from which on it is gone (s); infinite if it stays.
    pub until: f64,
    /// Number of its object.
    pub object: u32,
    /// Shape of the part, in body axes.
    pub solid: Arc<Solid>,
    /// How many times as large as its shape.
    pub scale: f64,
    /// Frames, ascending in time; never empty.
    pub frames: Vec<Frame>,
    /// Rate at which its heading turns (rad/s).
    pub spin: f64,
    /// Priority where two things are equally near, as in [`Body::priority`].
    pub priority: i8,
    /// Number of its group, as in [`Body::group`].
    pub group: Option<NonZeroU16>,
}

impl Guest {
    /// Whether `moves` of its object says where it is: a part that closes is a guest for no other reason.
    pub fn moves(&self) -> bool {
        self.frames.len() > 1 || self.spin != 0.0 || !self.solid.is_open()
    }

    /// Distance (m) of a place (north, east, up; m) from where its foot ever is.
    pub(crate) fn distance(&self, place: DVec3) -> f64 {
        let feet = || self.frames.iter().map(|frame| frame.foot);
        // The last foot stands for itself: one frame is a way of no length.
        let ways = feet().zip(feet().skip(1).chain(feet().next_back()));
        ways.map(|way| distance_from(way, place)).fold(f64::INFINITY, f64::min)
    }

    /// Foot point (north, east, up; m) and turn from body axes to north, east, up at `time` (s), if it is there.
    pub fn axes(&self, time: f64) -> Option<(DVec3, DMat3)> {
        (self.from <= time && time < self.until).then(|| Frame::at(&self.frames, self.spin, time))?
    }

    /// The body at `time` (s), if it is there.
    pub fn body(&self, time: f64) -> Option<Body> {
        let (foot, turn) = self.axes(time)?;
        let mut body = Body::place(self.object, Kind::Culture, &self.solid, foot, &turn, self.scale);
        (body.priority, body.group) = (self.priority, self.group);
        Some(body)
    }
}

impl Frame {
    /// Foot point (m) and turn from body axes (forward, starboard, up) to north, east, up at `time` (s), in proportion between two of
    /// `frames`, with `spin` (rad/s) on top; `None` if there are no frames.
    pub(crate) fn at(frames: &[Self], spin: f64, time: f64) -> Option<(DVec3, DMat3)> {
        let frame = Self::between(frames, time)?;
        let heading = frame.attitude.heading + spin * time;
        let stance =
            Stance { at: [frame.foot.x, frame.foot.y], attitude: Attitude { heading, ..frame.attitude } };
        Some((frame.foot, stance.to_ground()))
    }

    /// The frame at `time` (s), in proportion between two of `frames`.
    fn between(frames: &[Self], time: f64) -> Option<Self> {
        let next = frames.partition_point(|frame| frame.time <= time);
        let before = frames.get(next.saturating_sub(1))?;
        let Some(after) = frames.get(next).filter(|_| next > 0) else { return Some(*before) };
        let share = (time - before.time) / (after.time - before.time);
        let mix = |from: f64, to: f64| from + share * (to - from);
        let (a, b) = (before.attitude, after.attitude);
        let attitude = Attitude {
            roll: mix(a.roll, b.roll),
            pitch: mix(a.pitch, b.pitch),
            heading: mix(a.heading, b.heading),
        };
        Some(Self { time, foot: before.foot + share * (after.foot - before.foot), attitude })
    }
}

/// Distance of a place from a straight way.
fn distance_from((from, to): (DVec3, DVec3), place: DVec3) -> f64 {
    let way = to - from;
    let share = way.dot(place - from) / way.length_squared().max(f64::MIN_POSITIVE);
    place.distance(from + share.clamp(0.0, 1.0) * way)
}

/// Objects that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// How objects call it.
    pub name: String,
    /// Its own sun, where it has one; else the scene's.
    pub sun: Option<GroupSun>,
}

/// The sun of a group: it goes around at a rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroupSun {
    /// Where it stands at the start.
    pub first: Sun,
    /// Rate of its azimuth, clockwise from above (rad/s).
    pub rate: f64,
}

impl GroupSun {
    /// The sun at `time` (s).
    pub fn at(&self, time: f64) -> Sun {
        // A whole turn changes nothing, and small angles are sharper.
        let azimuth = (self.first.azimuth + self.rate * time) % radians(360.0);
        Sun { azimuth, ..self.first }
    }
}
