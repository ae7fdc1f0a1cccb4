//! The landscape of a scenario over a bank.

use std::sync::Arc;

use features::{Crater, Craters, Features, MOST_CRATERS};
use landscape::{Bank, CraterGrain, Landscape};
use scenario::{CraterList, CraterPopulation, Scenario};

use crate::StageError;
use crate::albedo::albedo_map;
use crate::database::posts;
use crate::photographs::photographs;

/// The ground of `bank` with craters, texture and mountains of `scenario`.
///
/// # Errors
/// If the picture of the albedo, a photograph or the terrain database cannot be read, a crater is not wholly inside the problem area, a population cannot be strewn over it, there are too many craters, or the scenario goes over
/// to a coarse level that the bank does not have.
pub fn landscape(bank: Bank, scenario: &Scenario) -> Result<Landscape, StageError> {
    if scenario.levels.is_some() && bank.levels().len() < 2 {
        return Err(StageError::OneLevel);
    }
    let level = bank.finest();
    let features = Features::of(craters(scenario, level.extent())?);
    let texture = scenario.texture.as_ref().map(|wish| wish.over(level.region_size(), level.origin()));
    let texture = texture.transpose()?;
    let crater_grain = scenario.texture.as_ref().and_then(|wish| CraterGrain::new(wish.crater_gain));
    let extent = level.extent();
    let map = scenario.albedo_map.as_ref().map(|wish| albedo_map(wish, extent)).transpose()?;
    let place = bank.map();
    let posts = scenario.database.as_ref().map(|file| posts(file, extent, place)).transpose()?;
    let landscape = Landscape::new(bank, scenario.albedo).with_albedo_map(map).with_posts(posts);
    let landscape = landscape.with_photographs(photographs(&scenario.photographs)?);
    let landscape = landscape.with_features(features).with_texture(texture).with_crater_grain(crater_grain);
    Ok(landscape.with_photometry(scenario.photometry).with_silhouettes(scenario.silhouettes.clone()))
}

/// Whether both scenarios have one landscape: all that bank and [`landscape`] are made of is equal.
pub(crate) fn has_same(one: &Scenario, other: &Scenario) -> bool {
    made_of(one) == made_of(other)
}

fn made_of(scenario: &Scenario) -> impl PartialEq + '_ {
    let Scenario { title, ground, coarse, features, database, levels, albedo, albedo_map, .. } = scenario;
    let Scenario { photographs, photometry, texture, silhouettes, .. } = scenario;
    let ground = (title, ground, coarse, features, database, levels.is_some());
    (ground, albedo, albedo_map, photographs, photometry, texture, silhouettes)
}

/// Those of the list, then those of each population.
fn craters(scenario: &Scenario, extent: [f64; 4]) -> Result<Arc<Craters>, StageError> {
    let mut listed = Arc::default();
    if let Some(list) = &scenario.features.list {
        expect_inside(list, extent)?;
        listed = Arc::clone(&list.craters);
        expect_countable(listed.len())?;
    }
    if scenario.features.populations.is_empty() {
        return Ok(listed);
    }
    let mut craters: Craters = listed.iter().collect();
    for (number, wish) in scenario.features.populations.iter().enumerate() {
        craters.extend(strewn(number, wish, extent)?);
        expect_countable(craters.len())?;
    }
    Ok(Arc::new(craters))
}

fn expect_countable(count: usize) -> Result<(), StageError> {
    if count > MOST_CRATERS { Err(StageError::Craters { count }) } else { Ok(()) }
}

fn strewn(number: usize, wish: &CraterPopulation, extent: [f64; 4]) -> Result<Vec<Crater>, StageError> {
    let found = wish.over(extent).craters();
    let found = found.map_err(|error| StageError::Population { number: number + 1, error })?;
    match found.iter().all(|crater| is_inside(crater, extent)) {
        true => Ok(found),
        false => Err(StageError::PopulationOutside { number: number + 1, extent }),
    }
}

fn expect_inside(list: &CraterList, extent: [f64; 4]) -> Result<(), StageError> {
    let outside = |crater: &Crater| !is_inside(crater, extent);
    let count = list.craters.iter().filter(outside).count();
    let Some(index) = list.craters.iter().position(|crater| !is_inside(&crater, extent)) else {
        return Ok(());
    };
    let crater = list.craters.get(index as u32);
    let file = list.file.clone();
    Err(StageError::CraterOutside { file, row: index + 1, crater: Box::new(crater), extent, more: count - 1 })
}

fn is_inside(crater: &Crater, [south, west, north, east]: [f64; 4]) -> bool {
    let (low, high) = ([south, west], [north, east]);
    let (centre, outer) = (crater.centre(), crater.outer());
    (0..2).all(|axis| centre[axis] - outer >= low[axis] && centre[axis] + outer <= high[axis])
}

#[cfg(test)]
mod tests {
    use super::{MOST_CRATERS, expect_countable};

    #[test]
    fn more_craters_than_can_be_told_apart_are_refused() {
        assert!(expect_countable(MOST_CRATERS).is_ok());
        let refused = expect_countable(MOST_CRATERS + 1).unwrap_err().to_string();
        assert!(refused.contains("268435457 craters") && refused.contains("at most 268435456"), "{refused}");
    }
}
