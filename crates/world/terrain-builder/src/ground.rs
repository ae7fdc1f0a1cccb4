//! A landscape that is built: its height anywhere, and its boulders.

use rayon::prelude::*;
use solids::{Body, SolidError};

use crate::base::Base;
use crate::boulder::Boulder;
use crate::crater::Crater;
use crate::description::{BoulderLook, Description, Kind};
use crate::heights::Heights;
use crate::places::Places;
use crate::refused::Refused;
use crate::relief::{Made, Relief, items, made};
use crate::switches::Switch;

/// A landscape whose heights can be asked for: `base + sum of the enabled features`, features in the order of their names, items of
/// a distribution in the order of their numbers. So the order of the file, and what was added and removed before, change no bit.
#[derive(Debug)]
pub struct Ground {
    description: Description,
    base: Base,
    reliefs: Vec<Relief>,
    places: Places,
    boulders: Vec<PlacedBoulder>,
    /// What was made of each feature, without its reliefs.
    pub(crate) made: Vec<Made>,
}

/// A boulder on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedBoulder {
    /// Number of its feature in the description.
    pub feature: u32,
    /// Shape and place of the boulder.
    pub boulder: Boulder,
    /// Height of the ground below it (m).
    pub ground: f64,
    /// Height of its middle (m).
    pub middle: f64,
}

impl PlacedBoulder {
    /// The boulder as a body of the polyhedron generator, of this object number.
    ///
    /// # Errors
    /// If its polyhedron does not close; no seed is known to do that.
    pub fn body(&self, object: u32) -> Result<Body, SolidError> {
        self.boulder.body(object, self.middle - self.boulder.lift()?)
    }
}

/// A feature that cannot be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum GroundError {
    /// A number of a feature is out of range.
    #[error("feature {feature:?}: {refused}")]
    Feature {
        /// Name of the feature.
        feature: String,
        /// Key of the number, what was found and what was expected.
        refused: Refused,
    },
    /// A boulder whose polyhedron does not close.
    #[error("feature {feature:?}: boulder at {at:?} m: {source}; give the feature another `seed`")]
    Boulder {
        /// Name of the feature.
        feature: String,
        /// Place of the boulder: north, east (m).
        at: [f64; 2],
        /// What is wrong with the polyhedron.
        source: SolidError,
    },
}

impl Ground {
    /// Builds all enabled features over a base.
    ///
    /// # Errors
    /// If a number of a feature is out of range.
    pub fn new(description: Description, base: Base) -> Result<Self, GroundError> {
        let number = |index: usize| index as u32;
        let all = description.features.par_iter().enumerate().map(|(index, feature)| {
            let nothing = || Ok(Made::default());
            let made = if feature.is_enabled { made(&description, number(index)) } else { nothing() };
            made.map_err(|refused| GroundError::Feature { feature: feature.id.clone(), refused })
        });
        let mut made: Vec<Made> = all.collect::<Result<_, _>>()?;
        let reliefs: Vec<Relief> =
            made.iter_mut().flat_map(|made| std::mem::take(&mut made.reliefs)).collect();
        let places = Places::new(description.grid.extent(), &reliefs);
        let mut ground = Self { description, base, reliefs, places, boulders: Vec::new(), made };
        ground.boulders = ground.placed()?;
        Ok(ground)
    }

    /// What it was built from.
    pub fn description(&self) -> &Description {
        &self.description
    }

    /// What the features lie on.
    pub fn base(&self) -> &Base {
        &self.base
    }

    /// Height (m) at a place: north, east (m), boulders apart.
    pub fn height(&self, place: [f64; 2]) -> f64 {
        self.height_of(place, |_| true)
    }

    /// Height (m) of the base and of the reliefs whose numbers are asked for.
    pub(crate) fn height_of(&self, place: [f64; 2], is_asked: impl Fn(u32) -> bool) -> f64 {
        let near = self.places.near(place).iter().filter(|number| is_asked(**number));
        near.fold(self.base.height(place), |sum, &number| sum + self.reliefs[number as usize].height(place))
    }

    /// Heights of all posts, worked out row by row by the threads of the caller's pool.
    pub fn heights(&self) -> Heights {
        let grid = self.description.grid;
        let [rows, columns] = grid.size();
        let row = |row: usize| (0..columns).map(move |column| self.height(grid.place(row, column)));
        let values = (0..rows).into_par_iter().flat_map_iter(row).collect();
        Heights::new(grid, values)
    }

    /// Everything that adds height, in the order in which it is added up.
    pub fn reliefs(&self) -> &[Relief] {
        &self.reliefs
    }

    /// All craters, with the number of their feature.
    pub fn craters(&self) -> impl Iterator<Item = (u32, &Crater)> {
        self.reliefs.iter().filter_map(|relief| Some((relief.feature, relief.crater()?)))
    }

    /// All boulders in the order of features and items.
    pub fn boulders(&self) -> &[PlacedBoulder] {
        &self.boulders
    }

    fn placed(&mut self) -> Result<Vec<PlacedBoulder>, GroundError> {
        let mut placed = Vec::new();
        for index in 0..self.description.features.len() {
            let feature = &self.description.features[index];
            let name = feature.id.clone();
            if !feature.is_enabled {
                continue;
            }
            let (boulders, left_out) = boulders(&self.description, &feature.kind)
                .map_err(|refused| GroundError::Feature { feature: name.clone(), refused })?;
            self.made[index].left_out += left_out;
            let seated = boulders.into_par_iter().map(|boulder| {
                self.seated(index as u32, boulder).map_err(|source| GroundError::Boulder {
                    feature: name.clone(),
                    at: boulder.at(),
                    source,
                })
            });
            placed.extend(seated.collect::<Result<Vec<_>, _>>()?);
        }
        Ok(placed)
    }

    fn seated(&self, feature: u32, boulder: Boulder) -> Result<PlacedBoulder, SolidError> {
        let ground = self.height(boulder.at());
        let is_on_ground = !self.description.reported.has(Switch::MeanRadiusBoulders);
        let middle = if is_on_ground { ground + boulder.lift()? } else { 0.0 };
        Ok(PlacedBoulder { feature, boulder, ground, middle })
    }
}

/// Boulders of a feature, and how many found no room.
fn boulders(of: &Description, kind: &Kind) -> Result<(Vec<Boulder>, u64), Refused> {
    let made =
        |at, radius, look: &BoulderLook, seeds| Boulder::new(at, radius, look.shape, look.burial, seeds);
    match kind {
        Kind::Boulder { at, radius, look, seed } => Ok((vec![made(*at, *radius, look, [*seed, 0])?], 0)),
        Kind::Boulders { distribution, look } => {
            let (items, left_out) = items(of, distribution)?;
            let boulders =
                items.iter().map(|item| made(item.at, item.radius, look, [distribution.seed, item.number]));
            Ok((boulders.collect::<Result<_, _>>()?, left_out))
        }
        Kind::Crater(_) | Kind::Growth(_) | Kind::Area(_) | Kind::Texture(_) | Kind::Craters { .. } => {
            Ok((Vec::new(), 0))
        }
    }
}
