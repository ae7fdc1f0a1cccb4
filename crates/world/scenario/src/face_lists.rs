//! Lists of faces of a mission, each with what carries it.

use faces::ship::{Attitude, Motion};
use faces::{Group, Sea};
use glam::{DMat3, DVec3};
use landscape::Landscape;
use quantities::{Rate, sin_cos};
use wind_waves::WindWaves;

use crate::{FacePlace, Guest, Object, Pose, Scenery};

/// What a list of faces shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FaceKind {
    /// Water of a flat sea, or of the box around a hull.
    Sea,
    /// A second level of detail upon the sea: churned water.
    Level,
    /// Foam that stands up.
    Wake,
    /// The hull of a ship.
    Ship,
    /// An effect of a file, or dust.
    Effect,
}

/// A list of faces that is there for the whole mission.
#[derive(Debug, Clone, PartialEq)]
pub struct FaceList {
    /// Its faces, their sun and their turns.
    pub group: Group,
    /// What its faces show.
    pub kind: FaceKind,
    /// What carries the list.
    pub carrier: Carrier,
    /// The priority that it has for an eye on the other side of a plane, where it has one.
    pub other_side: Option<OtherSide>,
    /// The pattern of a sea or of a level upon it, for whoever renumbers its normals.
    pub sea: Option<Sea>,
    /// Who draws the list.
    pub drawn_by: DrawnBy,
}

/// Who draws a list of faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DrawnBy {
    /// Drawn by machines and by `exact`.
    All,
    /// Machines alone: a hull that ends at the water, a box around a hull.
    Machines,
    /// `exact` alone: the true hull behind such a means, cut by the water.
    Exact,
}

/// A plane through the origin of a list that separates it from another list: for an eye beyond it the two change places.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OtherSide {
    /// Direction in the axes of the list to where its own priority holds.
    pub towards: DVec3,
    /// The priority beyond the plane.
    pub priority: i32,
}

impl FaceList {
    /// A list that all draw, with one priority and no pattern.
    pub fn new(group: Group, kind: FaceKind, carrier: Carrier) -> Self {
        Self { group, kind, carrier, other_side: None, sea: None, drawn_by: DrawnBy::All }
    }

    /// Its priority for an eye (north, east, up; m) when it has `axes`.
    pub fn priority(&self, axes: &ListAxes, eye: DVec3) -> i32 {
        match self.other_side {
            Some(other) if (axes.turn * other.towards).dot(eye - axes.place) < 0.0 => other.priority,
            _ => self.group.priority,
        }
    }
}

/// What carries a list of faces.
#[derive(Debug, Clone, PartialEq)]
pub enum Carrier {
    /// Nothing: its axes are those of the map, at a height (m).
    Map(f64),
    /// A place with a turn from forward, starboard, up.
    Fixed {
        /// Place of the list's origin: north, east, up (m).
        place: DVec3,
        /// Direction of its first axis, clockwise from north (rad).
        heading: f64,
    },
    /// The vehicle: forward, starboard (m) from its centre.
    Vehicle([f64; 2]),
    /// An object that moves, by its number: forward, starboard, up (m) from its foot point.
    Object(u32, DVec3),
    /// A ship on its course.
    Ship(ShipCourse),
}

/// A ship on a straight course over a level sea.
#[derive(Debug, Clone, PartialEq)]
pub struct ShipCourse {
    /// Place of its waterline amidships at the start: north, east, up (m).
    pub start: DVec3,
    /// Its course, clockwise from north (rad).
    pub heading: f64,
    /// Its speed (m/s), 0 or more.
    pub speed: f64,
    /// Frames of a second.
    pub frames: Rate,
    /// Its motion; none for what only follows place and course.
    pub motion: Motion,
    /// Place of the list's origin: forward, starboard, up (m).
    pub origin: DVec3,
    /// Turn of the list about its origin, clockwise from forward (rad).
    pub yaw: f64,
}

/// All lists of faces of a mission.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FaceLists {
    /// The lists; no two that machines draw have one priority.
    pub lists: Vec<FaceList>,
    /// Whether a ship asks for the order by depth.
    pub by_depth: bool,
    /// What the user should know of them, in words.
    pub warnings: Vec<String>,
    /// The sea of true waves in place of the flat one, for `exact` alone.
    pub open_sea: Option<OpenSea>,
}

/// A sea of true waves within an area.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenSea {
    /// Waves of its wind.
    pub waves: WindWaves,
    /// South, west, north, east edge (m).
    pub area: [f64; 4],
    /// Height of the calm water (m).
    pub height: f64,
    /// Linear red, green, blue of water that faces the sun.
    pub colour: [f64; 3],
}

/// Axes of a list in a frame: `turn` leads from its axes to north, east, up; then comes `place` (m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ListAxes {
    /// From the axes of the list to north, east, up.
    pub turn: DMat3,
    /// Place of its origin: north, east, up (m).
    pub place: DVec3,
}

impl FaceLists {
    /// Whether there is no list.
    pub fn is_empty(&self) -> bool {
        self.lists.is_empty()
    }

    /// The lists that machines draw.
    pub fn of_machines(&self) -> impl Iterator<Item = &FaceList> {
        self.lists.iter().filter(|list| list.drawn_by != DrawnBy::Exact)
    }

    /// The lists that `exact` draws.
    pub fn of_exact(&self) -> impl Iterator<Item = &FaceList> {
        self.lists.iter().filter(|list| list.drawn_by != DrawnBy::Machines)
    }

    /// Height (m) at which `exact` cuts hulls, where there is a flat sea. True waves hide a hull by depth.
    pub fn cut(&self) -> Option<f64> {
        if self.open_sea.is_some() {
            return None;
        }
        self.lists.iter().find_map(|list| match (list.kind, &list.carrier) {
            (FaceKind::Sea, Carrier::Map(height)) => Some(*height),
            _ => None,
        })
    }
}

impl Carrier {
    /// The carrier of a place that a scenario names, among its objects.
    pub fn of(place: FacePlace, objects: &[Object], landscape: &Landscape) -> Self {
        match place {
            FacePlace::Vehicle(at) => Self::Vehicle(at),
            FacePlace::Ground([north, east, above], heading) => {
                Self::Fixed { place: on_ground(landscape, [north, east], above), heading }
            }
            FacePlace::Object(number, at) => match &objects[number] {
                object if object.moves.is_some() => Self::Object(number as u32, DVec3::from_array(at)),
                object => {
                    let heading = object.stance.attitude.heading;
                    let foot = on_ground(landscape, object.stance.at, at[2]);
                    let turn = Attitude::default().turn(heading);
                    Self::Fixed { place: foot + turn * DVec3::new(at[0], at[1], 0.0), heading }
                }
            },
        }
    }

    /// The axes of the list in `frame`, for a vehicle with the eye at `pose`; `None` where what carries it is not there.
    pub fn axes(
        &self,
        frame: u64,
        pose: &Pose,
        (scenery, landscape): (&Scenery, &Landscape),
    ) -> Option<ListAxes> {
        Some(match self {
            Self::Map(height) => ListAxes { turn: DMat3::IDENTITY, place: DVec3::Z * *height },
            Self::Fixed { place, heading } => {
                ListAxes { turn: Attitude::default().turn(*heading), place: *place }
            }
            Self::Vehicle([forward, starboard]) => {
                let (sin, cos) = sin_cos(pose.attitude.heading);
                let north = pose.eye[0] + forward * cos - starboard * sin;
                let east = pose.eye[1] + forward * sin + starboard * cos;
                let place = on_ground(landscape, [north, east], 0.0);
                ListAxes { turn: Attitude::default().turn(pose.attitude.heading), place }
            }
            Self::Object(number, at) => {
                let of_object = |guest: &&Guest| guest.object == *number;
                let mut guests = scenery.all_guests().iter().filter(of_object);
                let (foot, turn) = guests.find_map(|guest| guest.axes(pose.time))?;
                ListAxes { turn, place: foot + turn * *at }
            }
            Self::Ship(course) => course.axes(frame),
        })
    }

    /// Value of a signal that drives a sequence, in `frame`; 0 for one that the carrier does not have.
    pub fn signal(&self, name: &str, frame: u64) -> f64 {
        match self {
            Self::Ship(course) if name == faces::ship::PITCH => {
                quantities::degrees(course.motion.at(frame).pitch)
            }
            _ => 0.0,
        }
    }
}

/// A place above the ground (north, east, up; m); at the datum where there is no ground.
fn on_ground(landscape: &Landscape, [north, east]: [f64; 2], above: f64) -> DVec3 {
    DVec3::new(north, east, landscape.height(north, east).unwrap_or(0.0) + above)
}

impl ShipCourse {
    fn axes(&self, frame: u64) -> ListAxes {
        let [per_second, seconds] = self.frames.fraction();
        let way = self.speed * (frame as f64 * seconds as f64 / per_second as f64);
        let (sin, cos) = sin_cos(self.heading);
        let attitude = self.motion.at(frame);
        let place = attitude.origin(self.start + DVec3::new(cos, sin, 0.0) * way, self.heading);
        let place = place + attitude.turn(self.heading) * self.origin;
        ListAxes { turn: attitude.turn(self.heading + self.yaw), place }
    }
}

impl ListAxes {
    /// A place of the list on the map: north, east, up (m).
    pub fn place(&self, at: DVec3) -> DVec3 {
        self.turn * at + self.place
    }
}
