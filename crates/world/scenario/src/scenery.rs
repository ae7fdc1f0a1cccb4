//! What stands on the ground and how it is lit, at any time of a mission.

use std::num::NonZeroU16;
use std::sync::Arc;

use landscape::{Attitude, Photometry, Sun};
use solids::Body;

use crate::{Carried, Channel, Course, DatedSky, Effects, FaceLists, Group, Guest, Pose, VehicleShape};

/// A body that stands from one time to another.
#[derive(Debug, Clone, PartialEq)]
pub struct Standing {
    /// First time at which it stands (s).
    pub from: f64,
    /// Time from which on it is gone (s); infinite if it stays.
    pub until: f64,
    /// Body that stands there in that time.
    pub body: Body,
}

/// A small patch of remote shadow that a wheel leaves (section 17).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrackPatch {
    /// Time at which it is laid (s).
    pub laid: f64,
    /// Corners (north, east; m) of a convex quadrangle, clockwise seen from above.
    pub corners: [[f64; 2]; 4],
}

/// Light, bodies and tracks of a mission: each is a function of time alone, so any frame can be made alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Scenery {
    suns: Vec<(f64, Sun)>,
    sky: Option<DatedSky>,
    standing: Vec<Standing>,
    guests: Vec<Guest>,
    effects: Vec<Carried>,
    groups: Vec<Group>,
    patches: Vec<TrackPatch>,
    start: Option<Pose>,
    course: Course,
    vehicle: Option<VehicleShape>,
    channel: Option<Channel>,
    face_lists: Arc<FaceLists>,
}

impl Scenery {
    /// One sun, nothing on the ground.
    pub fn still(sun: Sun) -> Self {
        Self::under(vec![(0.0, sun)])
    }

    /// Suns that follow one another, each with the time (s, ascending) from which on it holds; nothing on the ground.
    pub(crate) fn under(suns: Vec<(f64, Sun)>) -> Self {
        Self {
            suns,
            sky: None,
            standing: Vec::new(),
            guests: Vec::new(),
            effects: Vec::new(),
            groups: Vec::new(),
            patches: Vec::new(),
            start: None,
            course: Course::default(),
            vehicle: None,
            channel: None,
            face_lists: Arc::default(),
        }
    }

    /// The same with the sky that the first sun is of, where it has a date.
    pub(crate) fn with_sky(self, sky: Option<DatedSky>) -> Self {
        Self { sky, ..self }
    }

    /// The same with bodies.
    pub fn with_bodies(self, standing: Vec<Standing>) -> Self {
        Self { standing, ..self }
    }

    /// The same with bodies that move or are open.
    pub fn with_guests(self, guests: Vec<Guest>) -> Self {
        Self { guests, ..self }
    }

    /// The same with light points, sheets, overlays and discs of the sky.
    pub fn with_effects(self, effects: Vec<Carried>) -> Self {
        Self { effects, ..self }
    }

    /// The same with lists of faces: sea, ships, effects of files.
    pub fn with_face_lists(self, face_lists: Arc<FaceLists>) -> Self {
        Self { face_lists, ..self }
    }

    /// Lists of faces of the mission: sea, ships, effects of files.
    pub fn face_lists(&self) -> &Arc<FaceLists> {
        &self.face_lists
    }

    /// The same with groups; bodies have their numbers from 1.
    pub fn with_groups(self, groups: Vec<Group>) -> Self {
        Self { groups, ..self }
    }

    /// The same with tracks, ascending in time.
    pub fn with_patches(self, patches: Vec<TrackPatch>) -> Self {
        Self { patches, ..self }
    }

    /// The same with a vehicle that casts its own shadow, if there is one.
    pub fn with_vehicle(self, vehicle: Option<VehicleShape>) -> Self {
        Self { vehicle, ..self }
    }

    /// The same with the pose of frame 0, without a yoke, where there is one.
    pub fn with_start(self, start: Option<Pose>) -> Self {
        Self { start, ..self }
    }

    /// Pose of frame 0, without a yoke: what is chosen once for a mission may depend on it. None if nobody told it, or the path cannot be
    /// driven there.
    pub fn start(&self) -> Option<&Pose> {
        self.start.as_ref()
    }

    /// The same as it is seen through a channel, if there is one.
    pub fn through(self, channel: Option<Channel>) -> Self {
        Self { channel, ..self }
    }

    /// The same with the pose of every frame from the first: what a data bank has to have fetched depends on all.
    pub fn with_course(self, course: impl Into<Course>) -> Self {
        Self { course: course.into(), ..self }
    }

    /// Poses of the mission, one a frame; none if nobody needs to know how a frame was come by.
    pub fn course(&self) -> &Course {
        &self.course
    }

    /// The sun at `time` (s): that of the last step up to it.
    pub fn sun(&self, time: f64) -> Sun {
        let next = self.suns.partition_point(|(from, _)| *from <= time);
        self.suns[next.saturating_sub(1)].1
    }

    /// Sun and Earth at the start, where the mission has a date.
    pub fn sky(&self) -> Option<&DatedSky> {
        self.sky.as_ref()
    }

    /// The sun of a group at `time` (s), if it has one of its own.
    pub fn sun_of_group(&self, group: Option<NonZeroU16>, time: f64) -> Option<Sun> {
        let group = self.groups.get(usize::from(group?.get()) - 1)?;
        Some(group.sun?.at(time))
    }

    /// Returns the groups of objects.
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// Bodies that move or are open, as they are at `time` (s), in a fixed order. [`bodies`](Self::bodies) has none of them.
    pub fn guests(&self, time: f64) -> impl Iterator<Item = Body> {
        self.guests.iter().filter_map(move |guest| guest.body(time))
    }

    /// The same of the whole mission.
    pub fn all_guests(&self) -> &[Guest] {
        &self.guests
    }

    /// Light points, sheets, overlays and discs of the sky at `time` (s).
    pub fn effects(&self, time: f64) -> Effects {
        let mut effects = Effects::default();
        self.effects.iter().for_each(|carried| carried.add_at(time, &mut effects));
        effects
    }

    /// The same of the whole mission.
    pub fn all_effects(&self) -> &[Carried] {
        &self.effects
    }

    /// Whether an object moves.
    pub fn has_moving_objects(&self) -> bool {
        self.guests.iter().any(Guest::moves)
    }

    /// Whether an object returns light by a law of its own.
    pub fn has_laws_of_objects(&self) -> bool {
        let standing = self.standing.iter().map(|standing| &standing.body.solid);
        let mut solids = standing.chain(self.guests.iter().map(|guest| &guest.solid));
        solids.any(|solid| solid.photometry() != Photometry::Lambert)
    }

    /// Whether an object has an open surface.
    pub fn has_open_surfaces(&self) -> bool {
        self.guests.iter().any(|guest| guest.solid.is_open())
    }

    /// Whether a body that stands still has a sun of its group.
    pub fn has_suns_of_groups(&self) -> bool {
        self.standing.iter().any(|standing| self.sun_of_group(standing.body.group, 0.0).is_some())
    }

    /// Bodies that stand still and close, at `time` (s), in a fixed order.
    pub fn bodies(&self, time: f64) -> impl Iterator<Item = &Body> {
        let stands = move |standing: &&Standing| standing.from <= time && time < standing.until;
        self.standing.iter().filter(stands).map(|standing| &standing.body)
    }

    /// What casts the vehicle's own shadow.
    pub fn vehicle(&self) -> Option<&VehicleShape> {
        self.vehicle.as_ref()
    }

    /// The vehicle's parts where they stand with the eye at `eye` (north, east, up; m) and the picture's attitude: they cast shadow, and
    /// are not seen.
    pub fn own_bodies(&self, eye: [f64; 3], attitude: Attitude) -> Vec<Body> {
        let attitude = self.channel.as_ref().map_or(attitude, |channel| channel.off(attitude));
        self.vehicle.iter().flat_map(|shape| shape.bodies(eye, attitude)).collect()
    }

    /// Every sun of the mission, each with the time (s) from which on it holds; never empty.
    pub fn suns(&self) -> &[(f64, Sun)] {
        &self.suns
    }

    /// Bodies of the whole mission that stand still and close.
    pub fn standing(&self) -> &[Standing] {
        &self.standing
    }

    /// Track patches that lie at `time` (s), in order of laying.
    pub fn patches(&self, time: f64) -> &[TrackPatch] {
        &self.patches[..self.patches.partition_point(|patch| patch.laid <= time)]
    }
}
