//! What a feature adds to the ground: closed forms and grids, each with the box outside which there is nothing.

use crate::crater::{Crater, CraterForm, Decay, USUAL_EXTENT};
use crate::description::{Description, Feature, Kind};
use crate::distribution::{Distribution, Item};
use crate::draw::{Use, draw};
use crate::growth::{GrowthReported, posts_over};
use crate::height_grid::{Area, HeightGrid};
use crate::refused::Refused;
use crate::switches::Switch;

/// One thing that adds height.
#[derive(Debug, Clone)]
pub struct Relief {
    /// Number of its feature in the description.
    pub feature: u32,
    /// Box outside which it adds nothing (m).
    pub area: Area,
    law: Law,
}

#[derive(Debug, Clone)]
enum Law {
    Crater(Crater),
    Grid(HeightGrid),
}

/// Reliefs of a feature, and what is to be told of them.
#[derive(Debug, Clone, Default)]
pub struct Made {
    /// In the order in which they are added up.
    pub reliefs: Vec<Relief>,
    /// Control points that a later one on the same post has replaced.
    pub dropped_points: usize,
    /// Items that found no room.
    pub left_out: u64,
    /// Mean of the roughness over its posts (m).
    pub mean_roughness: f64,
}

impl Relief {
    /// Height that it adds (m) at a place: north, east (m).
    pub fn height(&self, place: [f64; 2]) -> f64 {
        match &self.law {
            Law::Crater(crater) => crater.height(place),
            Law::Grid(grid) => grid.height(place),
        }
    }

    /// The crater that it is, where it is one.
    pub fn crater(&self) -> Option<&Crater> {
        match &self.law {
            Law::Crater(crater) => Some(crater),
            Law::Grid(_) => None,
        }
    }

    fn of_crater(feature: u32, crater: Crater) -> Self {
        let ([north, east], reach) = (crater.form().centre, crater.reach());
        let area = [[north - reach, east - reach], [north + reach, east + reach]];
        Self { feature, area, law: Law::Crater(crater) }
    }

    fn of_grid(feature: u32, grid: HeightGrid) -> Self {
        Self { feature, area: grid.posts().area, law: Law::Grid(grid) }
    }

    /// A crater as heights on own posts, as the document keeps it.
    fn resampled(self, spacing: f64) -> Result<Self, Refused> {
        if self.crater().is_none() {
            return Ok(self);
        }
        let posts = posts_over(self.area, spacing)?;
        let grid = HeightGrid::new(posts, |post| self.height(posts.place(post)));
        Ok(Self::of_grid(self.feature, grid))
    }
}

/// Everything that a feature adds to the ground.
///
/// # Errors
/// If a number of the feature is out of range.
pub fn made(of: &Description, number: u32) -> Result<Made, Refused> {
    let feature = &of.features[number as usize];
    let mut made = own(of, feature, number)?;
    if of.reported.has(Switch::FeatureGrids) {
        let spacing = of.grid.north.resolution;
        let resampled = made.reliefs.into_iter().map(|relief| relief.resampled(spacing));
        made.reliefs = resampled.collect::<Result<_, _>>()?;
    }
    if let (Some(roughness), Some(area)) = (&feature.roughness, extent(of, feature, &made)) {
        let heights = roughness.heights(area, of.reported.has(Switch::RoughnessLift))?;
        made.mean_roughness = heights.mean();
        made.reliefs.push(Relief::of_grid(number, heights));
    }
    Ok(made)
}

fn own(of: &Description, feature: &Feature, number: u32) -> Result<Made, Refused> {
    let made = match &feature.kind {
        Kind::Crater(form) => {
            Made { reliefs: vec![Relief::of_crater(number, Crater::new(*form)?)], ..Made::default() }
        }
        Kind::Growth(growth) => {
            let reported = GrowthReported {
                is_sum: of.reported.has(Switch::GrowthSums),
                divides_by_between: of.reported.has(Switch::CurveDivision),
            };
            let (grid, dropped_points) = growth.grown(reported)?;
            Made { reliefs: vec![Relief::of_grid(number, grid)], dropped_points, ..Made::default() }
        }
        Kind::Craters { distribution, wall, depth } => {
            let (items, left_out) = items(of, distribution)?;
            let crater = |item: &Item| {
                let form = form(item, distribution.seed, *wall, *depth);
                Ok(Relief::of_crater(number, Crater::new(form)?))
            };
            let reliefs = items.iter().map(crater).collect::<Result<_, Refused>>()?;
            Made { reliefs, left_out, ..Made::default() }
        }
        Kind::Area(_) | Kind::Texture(_) | Kind::Boulder { .. } | Kind::Boulders { .. } => Made::default(),
    };
    Ok(made)
}

/// Items of a distribution, and how many found no room.
pub fn items(of: &Description, distribution: &Distribution) -> Result<(Vec<Item>, u64), Refused> {
    let is_even_in_angle = of.reported.has(Switch::EvenInAngle);
    let distribution = Distribution { is_even_in_angle, ..*distribution };
    let (items, count) = (distribution.items(&of.frame)?, distribution.count(&of.frame)?);
    let left_out = count - items.len() as u64;
    Ok((items, left_out))
}

/// A crater of a distribution: straight down, linear wall (reported); wall and depth even between their bounds.
fn form(item: &Item, seed: u64, wall: [f64; 2], depth: [f64; 2]) -> CraterForm {
    let between = |[low, high]: [f64; 2], purpose| low + (high - low) * draw(seed, item.number, purpose, 0);
    CraterForm {
        centre: item.at,
        radius: item.radius,
        wall: between(wall, Use::Wall),
        depth: between(depth, Use::Depth),
        decay: Decay::Linear,
        extent: USUAL_EXTENT,
        impact_elevation: std::f64::consts::FRAC_PI_2,
        impact_direction: 0.0,
    }
}

/// The box around all of a feature; for a distribution its range.
fn extent(of: &Description, feature: &Feature, made: &Made) -> Option<Area> {
    let range = |distribution: &Distribution| {
        let [south, north] = distribution.latitude;
        let [west, east] = distribution.longitude;
        [of.frame.forward(south, west), of.frame.forward(north, east)]
    };
    match &feature.kind {
        Kind::Area(area) => Some(*area),
        Kind::Craters { distribution, .. } => Some(range(distribution)),
        Kind::Crater(_) | Kind::Growth(_) => made.reliefs.first().map(|relief| relief.area),
        Kind::Texture(_) | Kind::Boulder { .. } | Kind::Boulders { .. } => None,
    }
}
