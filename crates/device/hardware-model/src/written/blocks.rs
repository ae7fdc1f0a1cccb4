//! The keys of the blocks beside the terrain path.

use diagnostics::{Field, Reader};
use quantities::radians;
use scenario::Yoke;

use crate::{FeatureParts, Gate, MixingParts, Organisation, ShadowParts};

/// Most parts of a kind that a machine can be given.
const MOST_PARTS: u32 = 1_000_000;

/// Least rate of loads (words/µs): one takes hours then, of a sweep of less than a second.
const SLOWEST_LOADS: f64 = 1e-9;

/// A number of parts, or as many as there is work for.
fn parts<'a>(table: &Reader<'a>, key: &str) -> Field<'a, Option<u32>> {
    table.u32(key).between(1, MOST_PARTS).or_word("unlimited")
}

pub(super) fn feature_generator(table: &Reader) -> Option<FeatureParts> {
    let organisations = [("by-region", Organisation::ByRegion), ("scheduled", Organisation::Scheduled)];
    let organisation = table.one_of("organisation", &organisations).required();
    let sub_generators = parts(table, "sub_generators").required();
    Some(FeatureParts { organisation: organisation?, sub_generators: sub_generators? })
}

/// Words a second; any number if the inner value is `None`.
pub(super) fn load_words(table: &Reader) -> Option<Option<f64>> {
    let rate = table.f64("load_words_us").between(SLOWEST_LOADS, 1e6).unit("words/µs");
    rate.map(|rate| 1e6 * rate).or_word("unlimited").required()
}

/// Both variants' figures stand in every model, so that it can be changed by one word.
pub(super) fn shadow_controller(table: &Reader) -> Option<ShadowParts> {
    let is_digital = table.one_of("variant", &[("digital", true), ("scan-converter", false)]).required();
    let line_generators = parts(table, "line_generators").required();
    let offset = table.f64_array::<2>("registration_offset_pct").between(-50.0, 50.0).unit("%").required();
    let gain = table.f64("registration_gain_pct").between(-50.0, 50.0).unit("%").required();
    let (line_generators, offset, gain) = (line_generators?, offset?, gain?);
    Some(match is_digital? {
        true => ShadowParts::Digital { line_generators },
        false => ShadowParts::ScanConverter { offset: offset.map(|part| 0.01 * part), gain: 0.01 * gain },
    })
}

pub(super) fn mixing_unit(table: &Reader) -> Option<MixingParts> {
    let gate =
        table.one_of("gate", &[("presence", Gate::Presence), ("self-keyed", Gate::SelfKeyed)]).required();
    let threshold = table.f64("threshold").between(0.0, 1.0).required();
    Some(MixingParts { gate: gate?, threshold: threshold? })
}

pub(super) fn yoke(table: &Reader) -> Option<Yoke> {
    let step = table.f64("step_deg").between(0.0, 10.0).unit("degrees").map(radians).required();
    let rate = table.f64("rate_deg_s").above(0.0).at_most(1000.0).unit("degrees/s").map(radians).required();
    let travel = table.f64("travel_deg").between(0.0, 180.0).unit("degrees").map(radians).required();
    let natural = table.f64("natural_hz").above(0.0).at_most(1e6).unit("Hz").or_word("unlimited").required();
    let damping = table.f64("damping").between(0.0, 100.0).required();
    Some(Yoke { step: step?, rate: rate?, travel: travel?, natural: natural?, damping: damping? })
}
