//! One list of an effect file.

use diagnostics::{Problem, Reader};

use super::{Setting, faces, pattern, sequence, sun};
use crate::error::FaceError;
use crate::group::{Detail, Group};
use crate::mesh::Loaded;
use crate::normals::Weights;
use crate::sun::SunProgramme;
use crate::warning::Warning;

/// A list whose faces are given, or follow from a pattern.
pub(super) fn group(table: &Reader, setting: Setting, warnings: &mut Vec<Warning>) -> Option<Group> {
    let name = table.string("name").required();
    let priority = table.i64("priority").between(i64::from(i32::MIN), i64::from(i32::MAX)).required();
    let details = [("replace", Detail::Replace), ("add", Detail::Add), ("add-soft", Detail::AddSoft)];
    let detail = table.one_of("detail", &details).default(Detail::Replace);
    let weights = [("equal", Weights::Equal), ("angle", Weights::Angle)];
    let weights = table.one_of("weights", &weights).default(Weights::Equal);
    let gain = table.f64("gain").above(0.0).at_most(1.0).default(1.0);
    let sun = sun::programme(table, setting.frames, warnings);
    let list = name.clone().unwrap_or_default();
    let loaded = match table.has("pattern") {
        true => pattern::squares(table, &list, sun, setting.most, warnings),
        false => faces::given(table, &list, setting.most).map(|loaded| (loaded, 1.0)),
    };
    let sequences = sequence::sequences(table, setting.signals);
    let (Loaded { mesh, kept, warnings: dropped }, held) = loaded?;
    warnings.extend(dropped);
    let group = Group::new(name?, mesh, priority? as i32).weighted(weights?).under(sun?).detailed(detail?);
    let group = group.with_gain(gain? * held);
    let sequences = sequences?.into_iter().map(|sequence| sequence.of_faces(&kept));
    let sequences = sequences.collect::<Result<Vec<_>, FaceError>>();
    let made = sequences.and_then(|sequences| group.with_sequences(sequences));
    made.map_err(|error| report(table, "sequence", &error)).ok()
}

/// Reports an error of the data at a key of the table.
pub(super) fn report(table: &Reader, key: &str, error: &FaceError) {
    table.report(table.problem(key, error.to_string()));
}

/// Reports an error of the data at a table.
pub(super) fn report_at(table: &Reader, error: &FaceError) {
    table.report(Problem::at(table.table_place(), error.to_string()));
}

/// The sun of a list, where it has one of its own.
pub(super) fn turning(sun: SunProgramme) -> Option<crate::sun::TurningSun> {
    match sun {
        SunProgramme::Scenario => None,
        SunProgramme::Turning(sun) => Some(sun),
    }
}
