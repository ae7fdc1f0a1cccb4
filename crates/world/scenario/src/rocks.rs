//! Rocks strewn over the ground.

use std::sync::Arc;

use glam::DVec3;
use landscape::{Attitude, Landscape};
use limits::Limit;
use solids::{Body, Kind, Rock, RockField, SizeLaw, Solid, rocks};

use crate::objects::Stance;
use crate::ride::{Lane, distance, instants};
use crate::{Guest, Path, SceneryProblem, Standing, Vehicle};

/// Rocks that a scenario asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rocks {
    /// Names the field: the same seed, the same rocks.
    pub seed: u64,
    /// How many of which size.
    pub law: SizeLaw,
    /// Area in which the rocks lie.
    pub area: RockArea,
}

/// Area in which rocks lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RockArea {
    /// In a box: south, west, north, east edge (m).
    Box([f64; 4]),
    /// Along the path: the smallest within this distance (m), others as many times as far as they are larger, so that
    /// a rock is left out only where it would look small.
    AlongPath(f64),
}

/// Ground under a Lunar Roving Vehicle's chassis, 14 inches, and width of its wheels, 9 inches (m): rocks that the
/// vehicle would hit are cleared away (our choice; it drives on the ground and does not feel rocks).
const CLEARANCE: f64 = 0.36;
const WHEEL: f64 = 0.23;

/// What rocks must keep clear of.
pub(crate) struct Clear<'a> {
    pub path: &'a Path,
    pub vehicle: &'a Vehicle,
    pub culture: &'a [Standing],
    pub guests: &'a [Guest],
}

impl Rocks {
    /// The rocks on `landscape`, as bodies of objects from `first_object` on, in a fixed order.
    pub(crate) fn place(
        &self,
        landscape: &Landscape,
        clear: &Clear,
        first_object: u32,
    ) -> Result<Vec<Standing>, SceneryProblem> {
        let shapes = rocks::shapes(self.seed).map_err(SceneryProblem::RockShape)?;
        let shapes: Vec<Arc<Solid>> = shapes.into_iter().map(Arc::new).collect();
        let widest = clear.vehicle.track + WHEEL + self.law.largest;
        let lane = Lane::new(instants(clear.path, 0.5)?.iter().map(|instant| instant.at), widest.max(1.0));
        let mut found = self.strewn(landscape, clear.path)?;
        found.retain(|rock| {
            landscape.has_data(rock.at[0], rock.at[1])
                && !is_hit(rock, lane.distance(rock.at), clear.vehicle)
                && !is_under(rock, clear.culture)
                && !is_on_way(rock, clear.guests, landscape)
        });
        if !Limit::Rocks.allows(found.len() as u64) {
            return Err(SceneryProblem::TooManyRocks { found: found.len() as f64 });
        }
        let standing = |(number, rock): (usize, &Rock)| {
            let object = first_object + number as u32;
            place(rock, object, &shapes, landscape)
        };
        Ok(found.iter().enumerate().filter_map(standing).collect())
    }

    /// All rocks of the area, before any is cleared away.
    fn strewn(&self, landscape: &Landscape, path: &Path) -> Result<Vec<Rock>, SceneryProblem> {
        let extent = landscape.level().extent();
        match self.area {
            RockArea::Box(area) => self.in_box(area),
            RockArea::AlongPath(radius) => self.along(path, radius, extent),
        }
    }

    fn in_box(&self, [south, west, north, east]: [f64; 4]) -> Result<Vec<Rock>, SceneryProblem> {
        let [low, high] = [[south, west], [north, east]];
        let field = RockField::new(self.seed, [low, high], self.law)?;
        expect_few(field.expected(low, high, 0.0))?;
        Ok(field.rocks_in_box(low, high))
    }

    /// Octave by octave, each over the squares that it reaches.
    fn along(&self, path: &Path, radius: f64, extent: [f64; 4]) -> Result<Vec<Rock>, SceneryProblem> {
        let [south, west, north, east] = extent;
        let field = RockField::new(self.seed, [[south, west], [north, east]], self.law)?;
        let mut found = Vec::new();
        let mut expected = 0.0;
        let SizeLaw { smallest, largest, .. } = self.law;
        let octaves = std::iter::successors(Some(smallest), |low| Some(2.0 * low));
        for low in octaves.take_while(|low| *low < largest) {
            let reach = 2.0 * radius * low / smallest;
            let points = instants(path, 0.05 * reach)?;
            let lane = Lane::new(points.iter().map(|instant| instant.at), reach);
            let squares = lane.squares();
            let count = |from: &[[f64; 2]; 2], size| field.expected(from[0], from[1], size);
            expected +=
                squares.iter().map(|square| count(square, low) - count(square, 2.0 * low)).sum::<f64>();
            // Corners of squares out of reach hold more than half of what is expected of them.
            expect_few(0.25 * expected)?;
            for [from, to] in squares {
                let rocks = field.larger_in_box(from, to, low).into_iter();
                found.extend(rocks.filter(|rock| rock.size < 2.0 * low).filter(|rock| {
                    lane.distance(rock.at).is_some_and(|way| way <= radius * rock.size / smallest)
                }));
            }
        }
        Ok(found)
    }
}

fn expect_few(expected: f64) -> Result<(), SceneryProblem> {
    let few = expected <= Limit::Rocks.value() as f64;
    if few { Ok(()) } else { Err(SceneryProblem::TooManyRocks { found: expected }) }
}

/// Whether the vehicle would hit a rock at this distance from the line that its centre drives.
fn is_hit(rock: &Rock, way: Option<f64>, vehicle: &Vehicle) -> bool {
    let Some(way) = way else { return false };
    let reach = 0.5 * (rock.size + WHEEL);
    let is_in_lane = way < 0.5 * vehicle.track + reach;
    is_in_lane && (rock.size > CLEARANCE || way > 0.5 * vehicle.track - reach)
}

/// Whether a rock lies where a man-made thing stands at any time.
fn is_under(rock: &Rock, culture: &[Standing]) -> bool {
    culture.iter().any(|standing| {
        let body = &standing.body;
        distance([body.centre.x, body.centre.y], rock.at) < body.radius + 0.5 * rock.size
    })
}

/// Whether a guest comes over a rock at any time, however it turns: one that passes well above leaves it.
fn is_on_way(rock: &Rock, guests: &[Guest], landscape: &Landscape) -> bool {
    let [x, y] = rock.at;
    let comes = |guest: &Guest, height: f64| {
        let reach = guest.scale * guest.solid.radius() + 0.5 * rock.size;
        guest.distance(DVec3::new(x, y, height)) < reach
    };
    !guests.is_empty()
        && landscape.height(x, y).is_some_and(|height| guests.iter().any(|guest| comes(guest, height)))
}

fn place(rock: &Rock, object: u32, shapes: &[Arc<Solid>], landscape: &Landscape) -> Option<Standing> {
    let height = landscape.height(rock.at[0], rock.at[1])?;
    let attitude = Attitude { heading: rock.heading, ..Attitude::default() };
    let to_ground = Stance { at: rock.at, attitude }.to_ground();
    let foot = DVec3::new(rock.at[0], rock.at[1], height);
    let body = Body::place(object, Kind::Rock, &shapes[rock.shape], foot, &to_ground, rock.size);
    Some(Standing { from: 0.0, until: f64::INFINITY, body })
}
