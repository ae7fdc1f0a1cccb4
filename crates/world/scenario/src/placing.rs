//! From a scenario to its scenery: everything placed on the ground, events resolved into stretches of time.

use std::sync::Arc;

use glam::DVec3;
use landscape::Landscape;
use quantities::Rate;
use solids::{Body, Kind, Solid};

use crate::effect_placing;
use crate::objects::{Event, Object, Stay, stays};
use crate::rocks::Clear;
use crate::{
    Frame, Guest, MoveStation, Pose, PoseTable, Scenario, Scenery, SceneryProblem, SceneryProblems, Standing,
};

impl Scenery {
    /// Light, bodies and tracks of `scenario` on its ground, at `update` frames a second. Objects have the numbers of their
    /// order in the file, rocks those after them.
    ///
    /// # Errors
    /// Everything that has no place on the ground, and a date without a sun.
    pub fn of(scenario: &Scenario, landscape: &Landscape, update: Rate) -> Result<Self, SceneryProblems> {
        let mut problems = Vec::new();
        let mut keep = |problem| problems.push(problem);
        let length = scenario.frames(update) as f64 / update.hertz();
        let light = scenario.sun.suns(landscape.bank(), length).map_err(&mut keep).ok();
        let culture = culture(scenario, landscape, &mut keep);
        let guests = guests(scenario, landscape, &mut keep);
        let mut effects = effect_placing::in_scene(scenario, landscape, &mut keep);
        let clear =
            Clear { path: &scenario.path, vehicle: &scenario.vehicle, culture: &culture, guests: &guests };
        let first = scenario.objects.len() as u32;
        let rocks = scenario.rocks.map(|rocks| rocks.place(landscape, &clear, first)).transpose();
        let rocks = rocks.map_err(&mut keep).ok().flatten().unwrap_or_default();
        let tracks = scenario.tracks.map(|tracks| tracks.lay(&scenario.path, &scenario.vehicle, landscape));
        let patches = tracks.transpose().map_err(&mut keep).ok().flatten().unwrap_or_default();
        let (Some((suns, sky)), true) = (light, problems.is_empty()) else {
            return Err(SceneryProblems(problems));
        };
        effects.extend(effect_placing::in_sky(&scenario.effects, &suns, sky.as_ref()));
        // Tens of thousands of rocks stay where they are in memory.
        let mut standing = rocks;
        standing.splice(0..0, culture);
        standing.shrink_to_fit();
        Ok(Self::under(suns)
            .with_sky(sky)
            .with_bodies(standing)
            .with_guests(guests)
            .with_effects(effects)
            .with_groups(scenario.groups.clone())
            .with_patches(patches)
            .with_start(start(scenario, landscape, update))
            .with_vehicle(scenario.vehicle_shape.clone()))
    }
}

/// Pose of frame 0; `None` if it cannot be driven, which whoever draws it reports.
fn start(scenario: &Scenario, landscape: &Landscape, update: Rate) -> Option<Pose> {
    let table = PoseTable::resolve(scenario, landscape, update, None, 0..1).ok()?;
    table.rows().first().map(|row| row.pose)
}

/// The events of each object, ascending in time.
pub(crate) fn events_of(scenario: &Scenario) -> Vec<Vec<Event>> {
    let mut own = vec![Vec::new(); scenario.objects.len()];
    scenario.events.iter().for_each(|event| own[event.object].push(*event));
    own
}

fn culture(
    scenario: &Scenario,
    landscape: &Landscape,
    keep: &mut impl FnMut(SceneryProblem),
) -> Vec<Standing> {
    let mut standing = Vec::new();
    for ((number, object), events) in scenario.objects.iter().enumerate().zip(events_of(scenario)) {
        // What moves has frames of its own.
        let stays = if object.moves.is_some() { Vec::new() } else { stays(object, events.into_iter()) };
        for stay in stays {
            match bodies(number as u32, object, &stay, landscape) {
                Some(bodies) => standing.extend(bodies),
                None => keep(outside(object, &stay, landscape)),
            }
        }
    }
    standing
}

/// The parts of objects that move or are open, stay by stay.
fn guests(scenario: &Scenario, landscape: &Landscape, keep: &mut impl FnMut(SceneryProblem)) -> Vec<Guest> {
    let mut guests = Vec::new();
    for ((number, object), events) in scenario.objects.iter().enumerate().zip(events_of(scenario)) {
        let parts: Vec<_> = object.parts.iter().filter(|part| is_guest(object, part)).collect();
        if parts.is_empty() {
            continue;
        }
        for stay in stays(object, events.into_iter()) {
            let Some(frames) = frames(object, &stay, landscape, keep) else { continue };
            guests.extend(parts.iter().map(|part| Guest {
                from: stay.from,
                until: stay.until,
                object: number as u32,
                solid: Arc::clone(part),
                scale: object.scale,
                frames: frames.clone(),
                spin: object.moves.as_ref().map_or(0.0, |moves| moves.spin),
                priority: object.priority,
                group: object.group,
            }));
        }
    }
    guests
}

/// Whether a part is no body that stands still and closes.
fn is_guest(object: &Object, part: &Solid) -> bool {
    object.moves.is_some() || part.is_open()
}

/// The frames of an object for one stay; every one that has no ground under it is a problem.
pub(crate) fn frames(
    object: &Object,
    stay: &Stay,
    landscape: &Landscape,
    keep: &mut impl FnMut(SceneryProblem),
) -> Option<Vec<Frame>> {
    let rest = [MoveStation { time: stay.from, stance: stay.stance, above: 0.0 }];
    let stations = object.moves.as_ref().map_or(&[][..], |moves| &moves.stations);
    let stations = if stations.is_empty() { &rest[..] } else { stations };
    frames_of(stations, landscape, |MoveStation { time, stance, .. }| {
        keep(outside(object, &Stay { from: *time, until: *time, stance: *stance }, landscape));
    })
}

/// The frames of stations, if all have ground under them; `report` is told of every one that has none.
pub(crate) fn frames_of(
    stations: &[MoveStation],
    landscape: &Landscape,
    mut report: impl FnMut(&MoveStation),
) -> Option<Vec<Frame>> {
    let mut frame = |station: &MoveStation| {
        let MoveStation { time, stance, above } = *station;
        let ground = ground_under(landscape, stance.at);
        if ground.is_none() {
            report(station);
        }
        let [x, y] = stance.at;
        Some(Frame { time, foot: DVec3::new(x, y, ground? + above), attitude: stance.attitude })
    };
    let frames: Vec<_> = stations.iter().map(&mut frame).collect();
    frames.into_iter().collect()
}

/// Height of the ground under a place (north, east; m) inside the finest level.
pub(crate) fn ground_under(landscape: &Landscape, [x, y]: [f64; 2]) -> Option<f64> {
    landscape.level().locate(x, y)?;
    landscape.height(x, y)
}

/// The parts of an object for one stay; nothing where there is no ground under its foot.
fn bodies(number: u32, object: &Object, stay: &Stay, landscape: &Landscape) -> Option<Vec<Standing>> {
    let [x, y] = stay.stance.at;
    let foot = DVec3::new(x, y, ground_under(landscape, stay.stance.at)?);
    let to_ground = stay.stance.to_ground();
    let standing = |part: &Arc<Solid>| {
        let mut body = Body::place(number, Kind::Culture, part, foot, &to_ground, object.scale);
        (body.priority, body.group) = (object.priority, object.group);
        Standing { from: stay.from, until: stay.until, body }
    };
    Some(object.parts.iter().filter(|part| !is_guest(object, part)).map(standing).collect())
}

fn outside(object: &Object, stay: &Stay, landscape: &Landscape) -> SceneryProblem {
    let [x, y] = stay.stance.at;
    let (id, extent) = (object.id.clone(), landscape.level().extent());
    SceneryProblem::ObjectOutside { id, time: stay.from, x, y, extent }
}
