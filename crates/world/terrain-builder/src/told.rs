//! What is told of a landscape: each feature in numbers, and what its author should know.

use rayon::prelude::*;

use crate::base::Base;
use crate::description::Kind;
use crate::frame::FrameWarning;
use crate::grid::{Axis, Grid};
use crate::ground::Ground;
use crate::height_grid::Area;
use crate::relief::Relief;

/// A feature in numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct FeatureTold {
    /// Name of the feature.
    pub id: String,
    /// Word of the file for its kind.
    pub kind: &'static str,
    /// Whether it is built.
    pub is_enabled: bool,
    /// Box around all that it adds (m); none where it adds no height.
    pub area: Option<Area>,
    /// Volume that it adds, less what it takes away (m3).
    pub volume: f64,
    /// Share of the posts that it changes, 0 to 1; of a texture, that it covers.
    pub share: f64,
    /// Lowest and highest that it adds at a post (m).
    pub range: [f64; 2],
    /// Mean of its roughness (m).
    pub mean_roughness: f64,
    /// Number of its craters.
    pub craters: usize,
    /// Number of its boulders.
    pub boulders: usize,
}

/// Something that the author of a landscape should know; it is built all the same.
#[derive(Debug, Clone, PartialEq)]
pub enum Warning {
    /// The flat axes are doubtful.
    Frame(FrameWarning),
    /// A crater is narrower than the distance between posts: no post may see it. Name of the feature, number of such craters.
    Narrow(String, usize),
    /// Parts of a feature lie outside the landscape. Name of the feature, whether all of it does.
    Outside(String, bool),
    /// Control points on one post: the last one counts. Name of the feature, number that do not count.
    DroppedPoints(String, usize),
    /// Items found no room at their least separation. Name of the feature, number of items.
    LeftOut(String, u64),
    /// Posts are this many times closer than the samples of the base.
    MuchFiner(f64),
    /// The base names no projection: its middle lies under the middle of the landscape.
    Unplaced,
    /// This share of the samples of the base is void.
    Voids(f64),
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Frame(warning) => warning.fmt(f),
            Self::Narrow(id, count) => write!(
                f,
                "feature {id:?}: {count} craters have a radius below the distance between posts, which may miss them"
            ),
            Self::Outside(id, true) => write!(f, "feature {id:?} lies outside the landscape"),
            Self::Outside(id, false) => {
                write!(f, "feature {id:?} lies partly outside the landscape and is cut off")
            }
            Self::DroppedPoints(id, count) => write!(
                f,
                "feature {id:?}: {count} control points do not count, because a later point has the same post"
            ),
            Self::LeftOut(id, count) => write!(
                f,
                "feature {id:?}: {count} items found no room at their `min_separation_m` and are left out"
            ),
            Self::Unplaced => write!(
                f,
                "the elevation file names no projection: its coordinates are passed over, and its middle lies under the middle of the landscape"
            ),
            Self::Voids(share) => write!(
                f,
                "{:.2} % of the samples of the base are void: heights there are filled in from around them",
                100.0 * share
            ),
            Self::MuchFiner(times) => write!(
                f,
                "posts are {times:.1} times closer than the samples of the base: the ground between samples is smooth"
            ),
        }
    }
}

impl Base {
    /// What the author should know of an elevation file.
    pub fn warnings(&self) -> Vec<Warning> {
        let Self::Elevation(base) = self else { return Vec::new() };
        let (is_unplaced, voids) = (base.is_unplaced(), base.voids());
        [is_unplaced.then_some(Warning::Unplaced), (voids > 0.0).then_some(Warning::Voids(voids))]
            .into_iter()
            .flatten()
            .chain(base.much_finer().map(Warning::MuchFiner))
            .collect()
    }
}

impl Ground {
    /// Every feature in numbers, in the order of their names.
    pub fn told(&self) -> Vec<FeatureTold> {
        (0..self.description().features.len())
            .into_par_iter()
            .map(|number| self.feature_told(number))
            .collect()
    }

    fn reliefs_of(&self, feature: usize) -> impl Iterator<Item = &Relief> {
        self.reliefs().iter().filter(move |relief| relief.feature as usize == feature)
    }

    fn feature_told(&self, number: usize) -> FeatureTold {
        let feature = &self.description().features[number];
        let grid = &self.description().grid;
        let [rows, columns] = grid.size();
        let mut added = vec![0.0; rows * columns];
        let places =
            [grid.north, grid.east].map(|axis| (0..axis.posts()).map(|post| axis.place(post)).collect());
        for relief in self.reliefs_of(number) {
            add(relief, &places, &mut added);
        }
        let widths = places.each_ref().map(|places| widths(places));
        let changed = added.iter().filter(|height| **height != 0.0).count();
        let volume =
            |(index, height): (usize, &f64)| height * widths[0][index / columns] * widths[1][index % columns];
        FeatureTold {
            id: feature.id.clone(),
            kind: feature.kind.word(),
            is_enabled: feature.is_enabled,
            area: self.reliefs_of(number).map(|relief| relief.area).reduce(around),
            volume: added.iter().enumerate().map(volume).sum(),
            share: match &feature.kind {
                Kind::Texture(wish) => covered(grid, wish.tile),
                _ => changed as f64 / added.len() as f64,
            },
            range: added.iter().fold([0.0; 2], |[low, high], height| [low.min(*height), high.max(*height)]),
            mean_roughness: self.made[number].mean_roughness,
            craters: self.reliefs_of(number).filter(|relief| relief.crater().is_some()).count(),
            boulders: self.boulders().iter().filter(|boulder| boulder.feature as usize == number).count(),
        }
    }

    /// What the author should know, in the order of the features.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut warnings: Vec<Warning> =
            self.description().frame.warnings().into_iter().map(Warning::Frame).collect();
        warnings.extend(self.base().warnings());
        for number in 0..self.description().features.len() {
            self.warn_of(number, &mut warnings);
        }
        warnings
    }

    fn warn_of(&self, number: usize, warnings: &mut Vec<Warning>) {
        let feature = &self.description().features[number];
        let id = || feature.id.clone();
        let resolution = self.description().grid.north.resolution;
        let narrow = self
            .reliefs_of(number)
            .filter_map(Relief::crater)
            .filter(|crater| crater.form().radius < resolution);
        let narrow = narrow.count();
        warnings.extend((narrow > 0).then(|| Warning::Narrow(id(), narrow)));
        let made = &self.made[number];
        warnings.extend((made.dropped_points > 0).then(|| Warning::DroppedPoints(id(), made.dropped_points)));
        warnings.extend((made.left_out > 0).then(|| Warning::LeftOut(id(), made.left_out)));
        // Items of a distribution may reach over the border: their range says where they belong.
        let is_one = !matches!(feature.kind, Kind::Craters { .. } | Kind::Boulders { .. });
        let area = self.reliefs_of(number).map(|relief| relief.area).reduce(around).filter(|_| is_one);
        warnings.extend(
            area.and_then(|area| outside(area, self.description().grid.extent()))
                .map(|all| Warning::Outside(id(), all)),
        );
    }
}

/// Share of the posts that a texture covers.
fn covered(grid: &Grid, tile: Option<[usize; 2]>) -> f64 {
    let share = |axis: &Axis, tile: usize| {
        let is_last = tile + 1 == axis.tiles();
        (axis.tile_cells() + usize::from(is_last)) as f64 / axis.posts() as f64
    };
    tile.map_or(1.0, |[row, column]| share(&grid.north, row) * share(&grid.east, column))
}

/// Whether all of an area lies outside another, where a part does.
fn outside(area: Area, of: Area) -> Option<bool> {
    let is_apart = (0..2).any(|axis| area[1][axis] < of[0][axis] || area[0][axis] > of[1][axis]);
    let slack = 1e-6;
    let is_inside =
        (0..2).all(|axis| area[0][axis] >= of[0][axis] - slack && area[1][axis] <= of[1][axis] + slack);
    (!is_inside).then_some(is_apart)
}

fn around(a: Area, b: Area) -> Area {
    [[0, 1].map(|axis| a[0][axis].min(b[0][axis])), [0, 1].map(|axis| a[1][axis].max(b[1][axis]))]
}

/// Adds a relief to the posts in its box.
fn add(relief: &Relief, places: &[Vec<f64>; 2], added: &mut [f64]) {
    let range = |axis: usize| {
        let low = places[axis].partition_point(|place| *place < relief.area[0][axis]);
        low..places[axis].partition_point(|place| *place <= relief.area[1][axis])
    };
    for row in range(0) {
        for column in range(1) {
            added[row * places[1].len() + column] += relief.height([places[0][row], places[1][column]]);
        }
    }
}

/// Ground that each post stands for along an axis (m): half of the way to either neighbour.
fn widths(places: &[f64]) -> Vec<f64> {
    let last = places.len() - 1;
    (0..=last).map(|post| 0.5 * (places[(post + 1).min(last)] - places[post.saturating_sub(1)])).collect()
}
