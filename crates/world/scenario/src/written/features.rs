//! `[features]`: craters of a file, and populations that a law strews.

use std::path::Path;

use diagnostics::{Problem, Problems, Reader};
use features::population::{Kind, Primary, SizeLaw};

use super::reference::reference;
use super::{all, area};
use crate::{CraterList, CraterPopulation, CraterWishes};

/// The craters of a `[features]` table.
pub(super) fn features(table: &Reader, folder: &Path, problems: &Problems) -> Option<CraterWishes> {
    let file = reference(table, "list", folder);
    let tables = table.tables("population");
    let populations = all(tables.iter().map(population));
    let list = match file {
        Some(file) => {
            let craters = features::list::read_into(&file, problems)?;
            Some(CraterList { file, craters: craters.into() })
        }
        None if table.has("list") => return None,
        None => None,
    };
    Some(CraterWishes { list, populations: populations? })
}

#[derive(Clone, Copy, PartialEq)]
enum KindWord {
    Fresh,
    Degraded,
    FlatFloored,
    Secondaries,
}

fn population(table: &Reader) -> Option<CraterPopulation> {
    let seed = table.u64("seed").required();
    let kind = kind(table);
    let metres = |key: &str| table.f64(key).between(1e-3, 1e6).unit("m");
    let density = table.f64("density_per_m2").between(1e-18, 1e6).required();
    let reference = metres("reference_m").default(1.0);
    let slope = table.f64("slope").between(0.1, 10.0).default(2.0);
    let radius = |key: &str| metres(key).placed().required();
    let (smallest, largest) = (radius("smallest_radius_m"), radius("largest_radius_m"));
    let area = area(table);
    let (smallest, largest) = (smallest?, largest?);
    if smallest.value > largest.value {
        let title = format!("`{}` = {} is above the largest", smallest.key, smallest.value);
        table.report(Problem::of(&smallest, title).expected(format!("at most {} m", largest.value)));
        return None;
    }
    let sizes = SizeLaw {
        density: density?,
        reference: reference?,
        slope: slope?,
        smallest: smallest.value,
        largest: largest.value,
    };
    Some(CraterPopulation { seed: seed?, area: area?, sizes, kind: kind? })
}

fn kind(table: &Reader) -> Option<Kind> {
    let words = [
        ("fresh", KindWord::Fresh),
        ("degraded", KindWord::Degraded),
        ("flat-floored", KindWord::FlatFloored),
        ("secondaries", KindWord::Secondaries),
    ];
    let word = table.one_of("kind", &words).required();
    let tables = table.tables("primaries");
    let primaries = all(tables.iter().map(primary));
    match word? {
        KindWord::Fresh => Some(Kind::Fresh),
        KindWord::Degraded => Some(Kind::Degraded),
        KindWord::FlatFloored => Some(Kind::FlatFloored),
        KindWord::Secondaries if tables.is_empty() => {
            let problem = table.problem("primaries", "secondaries without primaries");
            table.report(problem.expected("`primaries`, a list of { x_m, y_m, radius_m }"));
            None
        }
        KindWord::Secondaries => Some(Kind::Secondaries(primaries?)),
    }
}

fn primary(table: &Reader) -> Option<Primary> {
    let metres = |key: &str| table.f64(key).between(-1e9, 1e9).unit("m").required();
    let (x, y) = (metres("x_m"), metres("y_m"));
    let radius = table.f64("radius_m").between(1e-3, 1e6).unit("m").required();
    Some(Primary { centre: [x?, y?], radius: radius? })
}
