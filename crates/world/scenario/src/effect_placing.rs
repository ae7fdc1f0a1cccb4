//! Lights, sheets, overlays and discs of the sky on their ground, as functions of time.

use std::iter;

use glam::DVec3;
use landscape::{Attitude, Landscape, Sun};
use quantities::radians;

use crate::effect_wishes::{LightPlace, LightWish, OverlayWish, SheetPlace, SheetWish, Spot};
use crate::objects::{Stay, stays};
use crate::placing::{events_of, frames, frames_of, ground_under};
use crate::{
    Carried, DatedSky, DiscFace, EarthSeen, EffectWishes, Effects, Event, Frame, LightPoint, LightSource,
    MoveStation, Moves, Overlay, Presence, Scenario, SceneryProblem, Sheet, SkyDisc, Stance, Star, polygon,
};

/// Angle that the sun's disc fills without a date (rad). Derived: 0.532906 degrees at its mean distance, in three digits.
fn usual_sun() -> f64 {
    radians(0.533)
}

/// Lights in the order of the file, then sheets and overlays. Every one that has no ground under it is a problem.
pub(crate) fn in_scene(
    scenario: &Scenario,
    landscape: &Landscape,
    keep: &mut impl FnMut(SceneryProblem),
) -> Vec<Carried> {
    let events = events_of(scenario);
    let mut placer = Placer { scenario, events, landscape, keep, lights: 0, carried: Vec::new() };
    let EffectWishes { lights, sheets, overlays, .. } = &scenario.effects;
    lights.iter().for_each(|light| placer.light(light));
    sheets.iter().zip(0..).for_each(|(sheet, id)| placer.sheet(sheet, id));
    overlays.iter().zip(0..).for_each(|(wish, id)| placer.carried.push(overlay(wish, id)));
    placer.carried
}

/// The Earth, the sun's disc at each of `suns` (time from which on it holds, s), and the stars, whose numbers follow those of
/// all lamps. `sky` is what stands over the ground at the start, where the mission has a date.
pub(crate) fn in_sky(wishes: &EffectWishes, suns: &[(f64, Sun)], sky: Option<&DatedSky>) -> Vec<Carried> {
    let first = suns[0].1;
    let earth = wishes.earth.and_then(|earth| Some((earth.seen.or(sky.map(earth_of))?, earth.albedo)));
    let earth = earth.map(|(EarthSeen { direction, angular_diameter }, albedo)| {
        let face = DiscFace::Ball { albedo, sun: to_sun(first) };
        disc(SkyDisc { direction, angular_diameter, face })
    });
    let sun_discs = wishes.sun_disc.then(|| sun_discs(suns, sky));
    earth.into_iter().chain(sun_discs.into_iter().flatten()).chain(stars(wishes, sky)).collect()
}

fn earth_of(sky: &DatedSky) -> EarthSeen {
    let seen = sky.sky.earth;
    let sun = Sun { azimuth: sky.on_ground(seen.azimuth), elevation: seen.elevation };
    EarthSeen { direction: to_sun(sun), angular_diameter: seen.angular_diameter }
}

fn to_sun(sun: Sun) -> DVec3 {
    DVec3::from_array(sun.direction())
}

fn disc(disc: SkyDisc) -> Carried {
    Carried::still(Effects { discs: vec![disc], ..Effects::default() })
}

/// The sun's disc where the light comes from, step by step.
fn sun_discs(suns: &[(f64, Sun)], sky: Option<&DatedSky>) -> Vec<Carried> {
    let angular_diameter = sky.map_or_else(usual_sun, |sky| sky.sky.sun.angular_diameter);
    let ends = suns.iter().skip(1).map(|(from, _)| *from).chain(iter::once(f64::INFINITY));
    let step = |((from, sun), until): (&(f64, Sun), f64)| {
        let face = DiscFace::Sun { colour: [1.0; 3] };
        let still = disc(SkyDisc { direction: to_sun(*sun), angular_diameter, face });
        Carried { from: *from, until, ..still }
    };
    suns.iter().zip(ends).map(step).collect()
}

/// All stars together, where the scenario has any.
fn stars(wishes: &EffectWishes, sky: Option<&DatedSky>) -> Option<Carried> {
    let wish = wishes.stars.as_ref()?;
    let to_ground = wish.to_ground(sky);
    let first: u32 = wishes.lights.iter().map(LightWish::lamps).sum();
    let point = |(star, id): (Star, u32)| LightPoint {
        id,
        source: LightSource::Star {
            direction: to_ground * star.direction,
            magnitude: star.magnitude - wishes.white_magnitude,
        },
        colour: star.colour,
        intensity: 1.0,
        lobe: None,
        priority: 0,
        calligraphic: wish.calligraphic,
    };
    let lights = wish.stars().into_iter().zip(first..).map(point).collect();
    Some(Carried::still(Effects { lights, ..Effects::default() }))
}

fn overlay(wish: &OverlayWish, id: u32) -> Carried {
    let OverlayWish { corners, colour, share, priority, presence, .. } = wish;
    let overlay =
        Overlay { id, corners: corners.clone(), colour: *colour, share: *share, priority: *priority };
    carried(*presence, Effects { overlays: vec![overlay], ..Effects::default() })
}

/// Effects in the axes of the ground for some time.
fn carried(Presence { from, until }: Presence, effects: Effects) -> Carried {
    Carried { from, until, ..Carried::still(effects) }
}

/// What lights and sheets are placed by, and what comes of it.
struct Placer<'a, K> {
    scenario: &'a Scenario,
    /// Events of each object, ascending in time.
    events: Vec<Vec<Event>>,
    landscape: &'a Landscape,
    keep: &'a mut K,
    /// Light points so far.
    lights: u32,
    carried: Vec<Carried>,
}

impl<K: FnMut(SceneryProblem)> Placer<'_, K> {
    fn light(&mut self, wish: &LightWish) {
        let first = self.lights;
        self.lights += wish.lamps();
        let place = &wish.place;
        let placed = match place {
            LightPlace::Ground { spot, diameter, moves: None } => {
                let at = self.spot(wish, spot);
                at.map(|at| vec![still(wish, first, [LightSource::Lamp { at, diameter: *diameter }])])
            }
            LightPlace::Ground { spot, diameter, moves: Some(moves) } => {
                self.moving(wish, (spot, *diameter), moves, first).map(|carried| vec![carried])
            }
            LightPlace::String { ends, count, diameter } => {
                // Every lamp is asked for, so that each one without ground is told.
                let spots = (0..*count).map(|number| between(ends, f64::from(number) / f64::from(count - 1)));
                let places: Vec<_> = spots.map(|spot| self.spot(wish, &spot)).collect();
                let places: Option<Vec<_>> = places.into_iter().collect();
                places.map(|places| {
                    let lamp = |at| LightSource::Lamp { at, diameter: *diameter };
                    vec![still(wish, first, places.into_iter().map(lamp))]
                })
            }
            LightPlace::Object { object, at, diameter } => {
                Some(self.on_object(wish, *object, LightSource::Lamp { at: *at, diameter: *diameter }, first))
            }
            LightPlace::Sky { direction, magnitude } => {
                let star = LightSource::Star {
                    direction: *direction,
                    magnitude: magnitude - self.scenario.effects.white_magnitude,
                };
                Some(vec![still(wish, first, [star])])
            }
        };
        self.carried.extend(placed.into_iter().flatten());
    }

    /// A place over the ground: north, east, up (m).
    fn spot(&mut self, wish: &LightWish, spot: &Spot) -> Option<DVec3> {
        let ground = self.ground("light", &wish.id, wish.presence.from, spot.at)?;
        let [x, y] = spot.at;
        Some(DVec3::new(x, y, ground + spot.above))
    }

    /// Height of the ground under a place (m); a problem where there is none.
    fn ground(&mut self, what: &'static str, id: &str, time: f64, at: [f64; 2]) -> Option<f64> {
        let ground = ground_under(self.landscape, at);
        if ground.is_none() {
            (self.keep)(outside(what, id, time, at, self.landscape));
        }
        ground
    }

    fn moving(
        &mut self,
        wish: &LightWish,
        (spot, diameter): (&Spot, f64),
        moves: &Moves,
        id: u32,
    ) -> Option<Carried> {
        let stance = Stance { at: spot.at, attitude: Attitude::default() };
        let rest = [MoveStation { time: wish.presence.from, stance, above: 0.0 }];
        let stations = if moves.stations.is_empty() { &rest[..] } else { &moves.stations };
        let frames = self.frames("light", &wish.id, stations)?;
        let source = LightSource::Lamp { at: DVec3::new(0.0, 0.0, spot.above), diameter };
        Some(Carried { frames, spin: moves.spin, ..still(wish, id, [source]) })
    }

    /// Frames of stations; a problem for every one that has no ground.
    fn frames(&mut self, what: &'static str, id: &str, stations: &[MoveStation]) -> Option<Vec<Frame>> {
        let (keep, landscape) = (&mut *self.keep, self.landscape);
        frames_of(stations, landscape, |station| {
            keep(outside(what, id, station.time, station.stance.at, landscape));
        })
    }

    /// The same lamp for each stay of its object. A stay without ground is a problem of the object.
    fn on_object(&self, wish: &LightWish, number: usize, source: LightSource, id: u32) -> Vec<Carried> {
        let object = &self.scenario.objects[number];
        let events = self.events[number].iter().copied();
        let stay = |stay: Stay| {
            let frames = frames(object, &stay, self.landscape, &mut |_| ())?;
            let Presence { from, until } = wish.presence;
            let (from, until) = (from.max(stay.from), until.min(stay.until));
            let spin = object.moves.as_ref().map_or(0.0, |moves| moves.spin);
            (from < until).then(|| Carried { from, until, frames, spin, ..still(wish, id, [source]) })
        };
        stays(object, events).into_iter().filter_map(stay).collect()
    }

    fn sheet(&mut self, wish: &SheetWish, id: u32) {
        let placed = match &wish.place {
            SheetPlace::Foot => self.on_foot(wish),
            SheetPlace::Ground => self.on_ground(wish),
            SheetPlace::Datum | SheetPlace::Moving(_) => Some(wish.corners.clone()),
        };
        let (frames, spin) = match &wish.place {
            SheetPlace::Moving(moves) => (self.frames("sheet", &wish.id, &moves.stations), moves.spin),
            _ => (Some(Vec::new()), 0.0),
        };
        let Some((corners, frames)) = placed.zip(frames) else { return };
        let SheetWish { colour, medium, priority, presence, .. } = *wish;
        let effects =
            Effects { sheets: vec![Sheet { id, corners, colour, medium, priority }], ..Effects::default() };
        self.carried.push(Carried { frames, spin, ..carried(presence, effects) });
    }

    /// Corners over the ground under the first of them.
    fn on_foot(&mut self, wish: &SheetWish) -> Option<Vec<DVec3>> {
        let [x, y, _] = wish.corners[0].to_array();
        let ground = self.ground("sheet", &wish.id, wish.presence.from, [x, y])?;
        Some(wish.corners.iter().map(|corner| *corner + ground * DVec3::Z).collect())
    }

    /// Corners each over its own ground, if they are a flat convex polygon.
    fn on_ground(&mut self, wish: &SheetWish) -> Option<Vec<DVec3>> {
        let mut over = |corner: &DVec3| {
            let ground = self.ground("sheet", &wish.id, wish.presence.from, [corner.x, corner.y])?;
            Some(*corner + ground * DVec3::Z)
        };
        let corners: Vec<_> = wish.corners.iter().map(&mut over).collect();
        let corners = corners.into_iter().collect::<Option<Vec<_>>>()?;
        let refuse = |fault| (self.keep)(SceneryProblem::SheetShape { id: wish.id.clone(), fault });
        polygon::check(&corners).map_err(refuse).ok().map(|()| corners)
    }
}

fn outside(
    what: &'static str,
    id: &str,
    time: f64,
    [x, y]: [f64; 2],
    landscape: &Landscape,
) -> SceneryProblem {
    SceneryProblem::EffectOutside { what, id: id.into(), time, x, y, extent: landscape.level().extent() }
}

/// A place so far (0 to 1) from the first to the second.
fn between([from, to]: &[Spot; 2], share: f64) -> Spot {
    let mix = |from: f64, to: f64| from + share * (to - from);
    Spot { at: [0, 1].map(|axis| mix(from.at[axis], to.at[axis])), above: mix(from.above, to.above) }
}

/// Light points of one light, numbered from `first`, while it is there and lit.
fn still(wish: &LightWish, first: u32, sources: impl IntoIterator<Item = LightSource>) -> Carried {
    let LightWish { colour, intensity, priority, calligraphic, beam: lobe, .. } = *wish;
    let point = |(source, id)| LightPoint { id, source, colour, intensity, lobe, priority, calligraphic };
    let lights = sources.into_iter().zip(first..).map(point).collect();
    Carried { flash: wish.flash, ..carried(wish.presence, Effects { lights, ..Effects::default() }) }
}
