//! Where secondaries lie: groups thrown out from their primaries.

use quantities::sin_cos;

use super::draw::{Draw, Purpose};
use super::{Population, PopulationError, within};

/// A crater whose throw-out made secondaries; it need not be drawn itself, nor lie in the area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Primary {
    /// Centre: north, east (m).
    pub centre: [f64; 2],
    /// Radius of its rim crest (m).
    pub radius: f64,
}

/// Craters of a group, on the mean.
const IN_A_GROUP: u64 = 12;

/// Distances of groups from the centre of their primary, in its radii: the continuous blanket of throw-out covers
/// what is nearer.
const NEAREST: f64 = 2.0;
const FARTHEST: f64 = 8.0;

/// Draws before a place is given up.
const ATTEMPTS: u64 = 1000;

/// A chain or a cluster.
struct Group {
    /// Its middle: north, east (m).
    centre: [f64; 2],
    /// Unit vector away from the primary.
    outward: [f64; 2],
    /// Extent outwards and across (m).
    extent: [f64; 2],
}

/// All groups of a population.
pub(super) struct Throw<'p> {
    population: &'p Population,
    groups: Vec<Group>,
}

impl<'p> Throw<'p> {
    pub fn new(
        population: &'p Population,
        primaries: &[Primary],
        craters: u64,
    ) -> Result<Self, PopulationError> {
        if primaries.is_empty() {
            return Err(PopulationError::NoPrimaries);
        }
        for primary in primaries {
            within("radius of a primary (m)", primary.radius, 1e-3, 1e6)?;
            within("place of a primary to the north (m)", primary.centre[0], -1e9, 1e9)?;
            within("place of a primary to the east (m)", primary.centre[1], -1e9, 1e9)?;
        }
        let group = |number| inside(population, primaries, &Draw::new(population, number));
        let groups = (0..craters.div_ceil(IN_A_GROUP)).map(group).collect::<Option<_>>();
        Ok(Self { population, groups: groups.ok_or(PopulationError::NoRoom)? })
    }

    /// A place for a crater of an outer radius (m): in its group, or in another if it does not fit the area there.
    pub fn place(&self, draw: &Draw, outer: f64) -> Result<[f64; 2], PopulationError> {
        let places = (0..ATTEMPTS).map(|attempt| {
            let group = draw.again(Purpose::Group, attempt) * self.groups.len() as f64;
            self.groups[group as usize].place(draw, attempt)
        });
        let mut fitting = places.filter(|place| self.population.holds(*place, outer));
        fitting.next().ok_or(PopulationError::NoRoom)
    }
}

/// The first group drawn whose middle lies in the area.
fn inside(population: &Population, primaries: &[Primary], draw: &Draw) -> Option<Group> {
    let mut groups = (0..ATTEMPTS).map(|attempt| group(primaries, draw, attempt));
    groups.find(|group| population.holds(group.centre, 0.0))
}

fn group(primaries: &[Primary], draw: &Draw, attempt: u64) -> Group {
    let unit = |purpose| draw.again(purpose, attempt);
    let primary = pick(primaries, unit(Purpose::Primary));
    let (east, north) = sin_cos(2.0 * std::f64::consts::PI * unit(Purpose::Azimuth));
    let near = unit(Purpose::Distance);
    let distance = primary.radius * (NEAREST + (FARTHEST - NEAREST) * near * near);
    let form = unit(Purpose::Form);
    // Chains run outwards, clusters are round; both grow with the primary.
    let extent = if form < 0.5 { [0.6 + 1.2 * form, 0.06] } else { [0.5 * form, 0.5 * form] };
    Group {
        centre: [primary.centre[0] + distance * north, primary.centre[1] + distance * east],
        outward: [north, east],
        extent: extent.map(|share| share * primary.radius),
    }
}

/// A primary, larger ones oftener, by the area they cover.
fn pick(primaries: &[Primary], unit: f64) -> &Primary {
    let area = |primary: &Primary| primary.radius * primary.radius;
    let mut left = unit * primaries.iter().map(area).sum::<f64>();
    let hit = primaries.iter().find(|primary| {
        left -= area(primary);
        left < 0.0
    });
    hit.unwrap_or(&primaries[primaries.len() - 1])
}

impl Group {
    fn place(&self, draw: &Draw, attempt: u64) -> [f64; 2] {
        let offset = |purpose, extent: f64| (draw.again(purpose, attempt) - 0.5) * extent;
        let (along, across) =
            (offset(Purpose::Along, self.extent[0]), offset(Purpose::Across, self.extent[1]));
        let [north, east] = self.outward;
        [self.centre[0] + along * north - across * east, self.centre[1] + along * east + across * north]
    }
}
