//! The keys of the banks beside the terrain's: who shares drums, records, buffers, editing.

use diagnostics::Reader;
use quantities::Rate;

use crate::{BankPlace, KindBank, KindBanks};

/// Most words of a record, and most regions along the side of a square: their products stay within 32 bits.
const MOST_WORDS: u32 = 1 << 20;
const MOST_REGIONS: u32 = 1 << 10;

/// The banks of all kinds. `terrain` are the tables of drums and of buffers.
pub(super) fn kind_banks(
    root: &Reader,
    terrain: [&Option<Reader>; 2],
    clock: Option<Rate>,
) -> Option<KindBanks> {
    let [drums, buffers] = terrain;
    let places = [("apart", BankPlace::Apart), ("together", BankPlace::Together)];
    let coarse = drums.as_ref().and_then(|table| table.one_of("coarse", &places).required());
    let terrain_edit = buffers.as_ref().and_then(|table| edit(table, clock));
    let [features, shadows, polyhedra] = ["feature_bank", "shadow_bank", "polyhedron_bank"]
        .map(|name| root.table(name).and_then(|table| kind_bank(&table, clock)));
    Some(KindBanks {
        coarse: coarse?,
        terrain_edit: terrain_edit?,
        features: features?,
        shadows: shadows?,
        polyhedra: polyhedra?,
    })
}

/// The other figures stand in every model, so that it can be changed by one word.
fn kind_bank(table: &Reader, clock: Option<Rate>) -> Option<KindBank> {
    let places =
        [("local", BankPlace::Local), ("apart", BankPlace::Apart), ("together", BankPlace::Together)];
    let place = table.one_of("drums", &places).required();
    let record_words = table.u32("record_words").between(9, MOST_WORDS).required();
    let record_regions = table.u32("record_regions").between(1, MOST_REGIONS).required();
    let buffer_words = table.u32("buffer_words").at_least(9).or_word("unlimited").required();
    let edit = edit(table, clock);
    Some(KindBank {
        place: place?,
        record_words: record_words?,
        record_regions: record_regions?,
        buffer_words: buffer_words?,
        edit: edit?,
    })
}

/// Ticks to edit one word; a record takes whole ticks.
fn edit(table: &Reader, clock: Option<Rate>) -> Option<f64> {
    let nanoseconds = table.f64("edit_ns").between(0.0, 1e7).unit("ns").required();
    Some(1e-9 * nanoseconds? * clock?.hertz())
}
