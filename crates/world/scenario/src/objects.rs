//! Man-made things, and what happens to them during a mission.

use std::num::NonZeroU16;
use std::path::PathBuf;
use std::sync::Arc;

use glam::{DMat3, DVec3};
use landscape::Attitude;
use solids::Solid;

use crate::Moves;

/// A thing of one or more convex parts.
#[derive(Debug, Clone, PartialEq)]
pub struct Object {
    /// How events and messages call it.
    pub id: String,
    /// Files of its shape: its own, and those that one names; none for a model.
    pub files: Vec<PathBuf>,
    /// Whether shapes of its file may be open.
    pub open: bool,
    /// Its parts, in common body axes (forward, starboard, up; m), the foot point at the origin.
    pub parts: Vec<Arc<Solid>>,
    /// How many times as large as its shape.
    pub scale: f64,
    /// Where it stands, or will when it is added.
    pub stance: Stance,
    /// Whether it stands from the start.
    pub present: bool,
    /// How it moves, where it does.
    pub moves: Option<Moves>,
    /// Number of its group, from 1.
    pub group: Option<NonZeroU16>,
    /// Which of two things that coincide is seen: the higher; the ground's is 0.
    pub priority: i8,
}

/// Where a thing stands and how it is turned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stance {
    /// Foot point: north, east (m).
    pub at: [f64; 2],
    /// Roll, pitch, heading; the ground under it does not tilt it.
    pub attitude: Attitude,
}

impl Stance {
    /// From body axes (forward, starboard, up) to north, east, up.
    pub fn to_ground(&self) -> DMat3 {
        let flip = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
        flip * self.attitude.to_terrain() * flip
    }
}

/// Something that happens to an object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Time since the start of the mission (s).
    pub time: f64,
    /// Index of the object.
    pub object: usize,
    /// Change that happens to the object.
    pub action: Action,
}

/// Change that an event makes to an object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Action {
    /// It stands elsewhere from now on.
    Move {
        /// Foot point: north, east (m).
        at: [f64; 2],
        /// Clockwise from north (rad); as before if open.
        heading: Option<f64>,
    },
    /// It is gone from now on.
    Delete,
    /// It stands from now on, where it was last.
    Add,
}

/// A stretch of time (s; from, until) in which an object stands in one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stay {
    pub from: f64,
    pub until: f64,
    pub stance: Stance,
}

/// Where `object` stands over a mission whose `events` (of this object alone, ascending in time) fit together.
pub(crate) fn stays(object: &Object, events: impl Iterator<Item = Event>) -> Vec<Stay> {
    let mut stance = object.stance;
    let mut since = object.present.then_some(0.0);
    let mut stays = Vec::new();
    for Event { time, action, .. } in events {
        let ended = since.take().map(|from| Stay { from, until: time, stance });
        stays.extend(ended.filter(|stay| stay.until > stay.from));
        since = match action {
            Action::Delete => None,
            Action::Add => Some(time),
            Action::Move { at, heading } => {
                let heading = heading.unwrap_or(stance.attitude.heading);
                stance = Stance { at, attitude: Attitude { heading, ..stance.attitude } };
                Some(time)
            }
        };
    }
    stays.extend(since.map(|from| Stay { from, until: f64::INFINITY, stance }));
    stays
}

#[cfg(test)]
mod tests {
    use super::{Action, Event, Object, Stance, stays};
    use glam::DVec3;
    use landscape::Attitude;
    use quantities::radians;

    fn stance(heading: f64) -> Stance {
        Stance { at: [1.0, 2.0], attitude: Attitude { roll: 0.0, pitch: 0.0, heading: radians(heading) } }
    }

    #[test]
    fn body_axes_are_forward_starboard_up() {
        let [forward, starboard, up] =
            [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| stance(90.0).to_ground() * axis);
        for (found, expected) in [(forward, DVec3::Y), (starboard, -DVec3::X), (up, DVec3::Z)] {
            assert!((found - expected).length() < 1e-15, "{found} {expected}");
        }
        let pitched =
            Stance { attitude: Attitude { pitch: radians(30.0), ..stance(0.0).attitude }, ..stance(0.0) };
        assert!((pitched.to_ground() * DVec3::X).z > 0.49, "nose up");
    }

    #[test]
    fn a_thing_that_comes_moves_and_goes() {
        let object = Object {
            id: "lm".into(),
            files: vec![],
            open: false,
            parts: vec![],
            scale: 1.0,
            stance: stance(10.0),
            present: false,
            moves: None,
            group: None,
            priority: 0,
        };
        let event = |time, action| Event { time, object: 0, action };
        let events = [
            event(2.0, Action::Add),
            event(3.0, Action::Move { at: [5.0, 6.0], heading: None }),
            event(4.0, Action::Delete),
            event(9.0, Action::Add),
        ];
        let found = stays(&object, events.into_iter());
        let times: Vec<_> = found.iter().map(|stay| (stay.from, stay.until, stay.stance.at[0])).collect();
        assert_eq!(times, [(2.0, 3.0, 1.0), (3.0, 4.0, 5.0), (9.0, f64::INFINITY, 5.0)]);
        assert!(found.iter().all(|stay| stay.stance.attitude == stance(10.0).attitude));
        let always = Object { present: true, ..object };
        assert_eq!(stays(&always, std::iter::empty())[0].until, f64::INFINITY);
    }
}
