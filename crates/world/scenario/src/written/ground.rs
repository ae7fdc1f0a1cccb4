//! `[landscape]`: a bank or a seeded landscape.

use std::path::{Path, PathBuf};

use diagnostics::Reader;
use landscape::relief::{Craters, MAX_WAVES, Massif, Meander, Relief, ReliefError, Rille, Undulation};
use limits::Limit;
use quantities::radians;

use super::reference::reference;
use super::scenery::report_limit;
use crate::GroundSource;

/// The ground of a `[landscape]` table, and the ground around it.
pub(super) fn ground(table: &Reader, folder: &Path) -> Option<(GroundSource, Option<Relief>)> {
    let ground = fine(table, folder);
    let coarse = table.optional_table("coarse").map(|coarse| relief(&coarse));
    let Some(coarse) = coarse else { return ground.map(|ground| (ground, None)) };
    match (ground?, coarse?) {
        (GroundSource::Generated(fine), coarse) => {
            let title = "the coarse level does not fit around the fine one";
            fine.check_two(&coarse).map_err(|error| report(table, title, &error)).ok()?;
            Some((GroundSource::Generated(fine), Some(coarse)))
        }
        (GroundSource::Bank(_), _) => {
            let problem = table.problem("coarse", "`landscape.coarse` around a bank");
            table.report(problem.expected("`landscape.generated`: a bank has its own levels"));
            None
        }
    }
}

fn fine(table: &Reader, folder: &Path) -> Option<GroundSource> {
    let bank = reference(table, "bank", folder).map(GroundSource::Bank);
    let generated = table.optional_table("generated");
    let relief = generated.and_then(|generated| relief(&generated)).map(GroundSource::Generated);
    let (has_bank, has_generated) = (table.has("bank"), table.has("generated"));
    if has_bank == has_generated {
        let title = match has_bank {
            true => "`landscape.bank` and `landscape.generated` both say what the ground is",
            false => "missing key `landscape.bank` or table `landscape.generated`",
        };
        table.report(table.problem("bank", title).expected("one of the two"));
        return None;
    }
    bank.or(relief)
}

fn relief(table: &Reader) -> Option<Relief> {
    let seed = table.u64("seed").required();
    let extent = table.f64_array::<2>("extent_m").above(0.0).unit("m").required();
    let region_size = table.f64("region_size_m").above(0.0).unit("m").required();
    let tilt = table.f64_array::<2>("tilt_m_per_m").between(-1.0, 1.0).unit("m/m").default([0.0; 2]);
    let undulation = table.optional_table("undulation").map(|table| undulation(&table));
    let craters = table.optional_table("craters").map(|table| craters(&table));
    let (massifs, rilles) = (table.tables("massif"), table.tables("rille"));
    let landforms = (massifs.len() + rilles.len()) as u64;
    if !Limit::Landforms.allows(landforms) {
        report_limit(table, Limit::Landforms, format!("{landforms} massifs and rilles"));
        massifs.iter().chain(&rilles).for_each(Reader::ignore_rest);
        return None;
    }
    let massifs: Vec<_> = massifs.iter().map(massif).collect();
    let rilles: Vec<_> = rilles.iter().map(rille).collect();
    let relief = Relief {
        seed: seed?,
        extent: extent?,
        region_size: region_size?,
        tilt: tilt?,
        undulation: all_read(undulation)?,
        craters: all_read(craters)?,
        massifs: massifs.into_iter().collect::<Option<_>>()?,
        rilles: rilles.into_iter().collect::<Option<_>>()?,
    };
    check(table, &relief)?;
    Some(relief)
}

/// A part that is missing is no fault; one that could not be read is.
fn all_read<T>(part: Option<Option<T>>) -> Option<Option<T>> {
    part.map_or(Some(None), |part| part.map(Some))
}

/// Rules that span several keys are the landscape's own.
fn check(table: &Reader, relief: &Relief) -> Option<()> {
    let title = "the generated landscape does not fit together";
    relief.check().map_err(|error| report(table, title, &error)).ok()
}

/// Reports what a relief in `table` cannot be, at the key at fault.
fn report(table: &Reader, title: &str, error: &ReliefError) {
    let name = match error {
        ReliefError::Parameter { name, .. } => name,
        ReliefError::TooManyCraters(_) => "craters.smallest_radius",
        ReliefError::TooManyCorners { .. } | ReliefError::Level(_) => "region_size",
    };
    report_at(table, name, format!("{title}: {error}"));
}

/// Reports at a parameter by the landscape's name: `massifs[2].height` is `height_m` of the third `[[massif]]`.
fn report_at(table: &Reader, name: &str, title: String) {
    if let Some((part, rest)) = name.split_once('.') {
        let numbered = part.trim_end_matches(']').split_once("s[");
        let inner = match numbered.and_then(|(part, index)| Some((part, index.parse::<usize>().ok()?))) {
            Some((part, index)) => table.tables(part).into_iter().nth(index),
            None => table.optional_table(part),
        };
        return report_at(&inner.unwrap_or_else(|| table.table_or_empty(part)), rest, title);
    }
    // Keys end in their unit, and an axis is none.
    let word = name.split(' ').next().unwrap_or(name);
    let key = table.keys().into_iter().find(|key| key.starts_with(word));
    table.report(table.problem(key.unwrap_or(word), title));
}

fn undulation(table: &Reader) -> Option<Undulation> {
    let rms_height = table.f64("rms_height_m").at_least(0.0).unit("m").required();
    let hurst = table.f64("hurst").between(0.0, 1.0).required();
    let longest = table.f64("longest_m").above(0.0).unit("m").required();
    let shortest = table.f64("shortest_m").above(0.0).unit("m").required();
    let waves = table.usize("waves").between(1, MAX_WAVES).default(400);
    Some(Undulation {
        rms_height: rms_height?,
        hurst: hurst?,
        longest: longest?,
        shortest: shortest?,
        waves: waves?,
    })
}

fn craters(table: &Reader) -> Option<Craters> {
    let smallest_radius = table.f64("smallest_radius_m").above(0.0).unit("m").required();
    let largest_radius = table.f64("largest_radius_m").above(0.0).unit("m").required();
    let density = table.f64("density").between(0.0, 1.0).default(0.08);
    let subdued = table.f64("subdued_depth_ratio").above(0.0).at_most(0.25).default(0.03);
    let fresh = table.f64("fresh_depth_ratio").above(0.0).at_most(0.25).default(0.2);
    Some(Craters {
        smallest_radius: smallest_radius?,
        largest_radius: largest_radius?,
        density: density?,
        subdued: subdued?,
        fresh: fresh?,
    })
}

fn massif(table: &Reader) -> Option<Massif> {
    let at = table.f64_array::<2>("at_m").unit("m").required();
    let height = table.f64("height_m").unit("m").required();
    let radius = table.f64("radius_m").above(0.0).unit("m").required();
    let detail = table.f64("detail_m").above(0.0).unit("m").required();
    let ruggedness = table.f64("ruggedness").between(0.0, 1.0).default(0.0);
    Some(Massif { at: at?, height: height?, radius: radius?, detail: detail?, ruggedness: ruggedness? })
}

fn rille(table: &Reader) -> Option<Rille> {
    let through = table.f64_array::<2>("through_m").unit("m").required();
    let azimuth = table.f64("azimuth_deg").between(-360.0, 360.0).unit("degrees").required();
    let width = table.f64("width_m").above(0.0).unit("m").required();
    let depth = table.f64("depth_m").unit("m").required();
    let meander = table.optional_table("meander").map(|table| meander(&table));
    Some(Rille {
        through: through?,
        azimuth: radians(azimuth?),
        width: width?,
        depth: depth?,
        meander: all_read(meander)?,
    })
}

fn meander(table: &Reader) -> Option<Meander> {
    let swing = table.f64("swing_m").at_least(0.0).unit("m").required();
    let length = table.f64("length_m").above(0.0).unit("m").required();
    Some(Meander { swing: swing?, length: length? })
}

/// The terrain database of the same ground, where there is one.
pub(super) fn database(table: &Reader, folder: &Path) -> Option<Option<PathBuf>> {
    let file = reference(table, "database", folder);
    (file.is_some() || !table.has("database")).then_some(file)
}
