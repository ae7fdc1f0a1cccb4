//! From a scenario to its scenery: everything placed on the ground, events resolved into stretches of time.

use glam::DVec3;
use landscape::Landscape;
use solids::{Body, Kind};

use crate::objects::{Object, Stay, stays};
use crate::rocks::Clear;
use crate::{Scenario, Scenery, SceneryProblem, SceneryProblems, Standing};

impl Scenery {
    /// Light, bodies and tracks of `scenario` on its ground. Objects have the numbers of their order in the file,
    /// rocks those after them.
    ///
    /// # Errors
    /// Everything that has no place on the ground.
    pub fn of(scenario: &Scenario, landscape: &Landscape) -> Result<Self, SceneryProblems> {
        let mut problems = Vec::new();
        let mut keep = |problem| problems.push(problem);
        let culture = culture(scenario, landscape, &mut keep);
        let clear = Clear { path: &scenario.path, vehicle: &scenario.vehicle, culture: &culture };
        let first = scenario.objects.len() as u32;
        let rocks = scenario.rocks.map(|rocks| rocks.place(landscape, &clear, first)).transpose();
        let rocks = rocks.map_err(&mut keep).ok().flatten().unwrap_or_default();
        let tracks = scenario.tracks.map(|tracks| tracks.lay(&scenario.path, &scenario.vehicle, landscape));
        let patches = tracks.transpose().map_err(&mut keep).ok().flatten().unwrap_or_default();
        if !problems.is_empty() {
            return Err(SceneryProblems(problems));
        }
        // Tens of thousands of rocks stay where they are in memory.
        let mut standing = rocks;
        standing.splice(0..0, culture);
        standing.shrink_to_fit();
        Ok(Self::under(suns(scenario))
            .with_bodies(standing)
            .with_patches(patches)
            .with_vehicle(scenario.vehicle_shape.clone()))
    }
}

fn suns(scenario: &Scenario) -> Vec<(f64, landscape::Sun)> {
    match &scenario.drift {
        None => vec![(0.0, scenario.sun)],
        Some(drift) => drift.suns(scenario.sun),
    }
}

fn culture(
    scenario: &Scenario,
    landscape: &Landscape,
    keep: &mut impl FnMut(SceneryProblem),
) -> Vec<Standing> {
    let mut standing = Vec::new();
    for (number, object) in scenario.objects.iter().enumerate() {
        let events = scenario.events.iter().filter(|event| event.object == number);
        for stay in stays(object, events.copied()) {
            match bodies(number as u32, object, &stay, landscape) {
                Some(bodies) => standing.extend(bodies),
                None => keep(outside(object, &stay, landscape)),
            }
        }
    }
    standing
}

/// The parts of an object for one stay; nothing where there is no ground under its foot.
fn bodies(number: u32, object: &Object, stay: &Stay, landscape: &Landscape) -> Option<Vec<Standing>> {
    let [x, y] = stay.stance.at;
    landscape.level().locate(x, y)?;
    let foot = DVec3::new(x, y, landscape.height(x, y)?);
    let to_ground = stay.stance.to_ground();
    let standing = |part| {
        let body = Body::place(number, Kind::Culture, part, foot, &to_ground, object.scale);
        Standing { from: stay.from, until: stay.until, body }
    };
    Some(object.parts.iter().map(standing).collect())
}

fn outside(object: &Object, stay: &Stay, landscape: &Landscape) -> SceneryProblem {
    let [x, y] = stay.stance.at;
    let (id, extent) = (object.id.clone(), landscape.level().extent());
    SceneryProblem::ObjectOutside { id, time: stay.from, x, y, extent }
}
