//! `[stars]`: a catalogue, or a sky of a seed.

use std::path::Path;

use diagnostics::{Problems, Reader};
use limits::Limit;
use quantities::radians;

use super::effect_keys::has_none;
use super::reference::reference;
use super::star_list;
use crate::{SeededSky, StarSource, StarWish};

/// Stars; of a mission that `is_dated` the date turns the sky.
pub(super) fn stars(table: &Reader, is_dated: bool, folder: &Path, problems: &Problems) -> Option<StarWish> {
    let source = source(table, folder, problems);
    let calligraphic = table.bool("calligraphic").default(false);
    let turn = table.f64_array::<3>("turn_deg").between(-360.0, 360.0).unit("degrees");
    let turn = turn.map(|angles| angles.map(radians)).default([0.0; 3]);
    let reason = "beside `sun.at`: the date says how the sky stands";
    let is_turned_once =
        !is_dated || has_none(table, &["turn_deg"], reason, "a date, or angles, and not both");
    let wish = StarWish { source: source?, calligraphic: calligraphic?, turn: turn? };
    is_turned_once.then_some(wish)
}

const OF_A_SEED: [&str; 4] = ["seed", "count", "brightest", "faintest"];

fn source(table: &Reader, folder: &Path, problems: &Problems) -> Option<StarSource> {
    let file = reference(table, "file", folder);
    if table.has("file") {
        OF_A_SEED.into_iter().for_each(|key| table.know(key));
        let reason = "beside `file`, which has the stars";
        let is_alone = has_none(table, &OF_A_SEED, reason, "a catalogue, or a seed, and not both");
        let file = file?;
        let stars = star_list::read(&file, problems)?.into();
        return is_alone.then_some(StarSource::Catalogue { file, stars });
    }
    if !table.has("seed") && !table.has("count") {
        OF_A_SEED.into_iter().for_each(|key| table.know(key));
        let [file, seed] = ["file", "seed"].map(|key| table.path(key));
        let title = format!("missing key `{file}` or `{seed}`");
        table.report(table.problem("file", title).expected("a catalogue, or a seed and a count"));
        return None;
    }
    seeded(table).map(StarSource::Seeded)
}

fn seeded(table: &Reader) -> Option<SeededSky> {
    let seed = table.u64("seed").required();
    let most = u32::try_from(Limit::Stars.value()).unwrap_or(u32::MAX);
    let count = table.u32("count").between(1, most).help(Limit::Stars.to_string()).required();
    let magnitude = |key: &str| table.f64(key).between(-50.0, 50.0);
    // Chosen: Sirius, the brightest star of the sky, and what the bare eye sees.
    let brightest = magnitude("brightest").default(-1.5);
    let faintest = magnitude("faintest").default(6.0);
    let (brightest, faintest) = (brightest?, faintest?);
    if faintest <= brightest {
        let title = format!("`{}` = {faintest} is not above the brightest", table.path("faintest"));
        table.report(table.problem("faintest", title).expected(format!("more than {brightest}")));
        return None;
    }
    Some(SeededSky { seed: seed?, count: count?, brightest, faintest })
}
