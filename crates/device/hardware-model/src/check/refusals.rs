//! What cannot be built.

use super::{Check, short};
use crate::{BankPlace, CrossingServer, FoldDetect, KindBank};

pub(super) fn check(check: &mut Check) {
    narrow_memory(check);
    fold_without_comparator(check);
    buffer(check);
    kind_banks(check);
    standing_still(check);
    never_acquired(check);
}

/// One access of a core memory brings one word of 32 bits (hardware 2.1): two coefficients.
fn narrow_memory(check: &mut Check) {
    let loader = &check.model.loader;
    let words = loader.words_per_access;
    let is_so = loader.served_by != CrossingServer::WiredPointers && words > 2;
    check.refuse_if(is_so, &["loader.words_per_access", "loader.served_by"], || {
        format!(
            "{words} words an access through one memory of 32-bit words: it brings 2; \
             only wired pointers have a bank a colour that is as wide as a set"
        )
    });
}

fn fold_without_comparator(check: &mut Check) {
    let analog = &check.model.analog;
    let is_so = analog.sweep.fold_detect == FoldDetect::Comparator
        && analog.comparator.delay == 0.0
        && analog.comparator.hysteresis == 0.0;
    check.refuse_if(
        is_so,
        &["sweep.fold_detect", "comparator.delay_ns", "comparator.hysteresis_pct"],
        || "folds are found by a comparator, and there is none: its delay and hysteresis are 0".into(),
    );
}

fn buffer(check: &mut Check) {
    let banks = &check.model.data_banks;
    let Some(words) = banks.buffer_words else { return };
    check.refuse_if(banks.drum.is_none(), &["buffer.words", "drum.rotation_ms"], || {
        format!("a buffer of {words} words with no drum behind it: what it does not hold never comes")
    });
    let record = banks.drum.map_or(0, |drum| drum.record_words);
    check.refuse_if(record > words, &["buffer.words", "drum.record_words"], || {
        format!(
            "a buffer of {words} words cannot take in one record of {record}; buffer.words = {record} would do for one"
        )
    });
}

/// A bank that is not local needs a drum, and a buffer that takes in a record.
fn kind_banks(check: &mut Check) {
    let model = check.model;
    let has_drum = model.data_banks.drum.is_some();
    let is_shared = model.kind_banks.coarse == BankPlace::Together;
    check.refuse_if(is_shared && !has_drum, &["drum.coarse", "drum.rotation_ms"], || {
        "the coarse level lies with the finest one on drums, and there are none: drum.rotation_ms is 0".into()
    });
    for ((name, bank), keys) in model.kind_banks.kinds().into_iter().zip(KIND_KEYS) {
        let &KindBank { place, record_words, buffer_words, .. } = bank;
        let is_there = place != BankPlace::Local;
        check.refuse_if(is_there && !has_drum, &[keys[0], "drum.rotation_ms"], || {
            format!("records of [{name}] lie on drums, and there are none: drum.rotation_ms is 0")
        });
        let held = buffer_words.unwrap_or(u32::MAX);
        check.refuse_if(is_there && record_words > held, &[keys[1], keys[2]], || {
            format!(
                "a buffer of {held} words cannot take in one record of {record_words}; \
                 buffer_words = {record_words} would do for one"
            )
        });
    }
}

/// Keys of the three banks: where they lie, words of the buffer, words of a record.
const KIND_KEYS: [[&str; 3]; 3] = [
    ["feature_bank.drums", "feature_bank.buffer_words", "feature_bank.record_words"],
    ["shadow_bank.drums", "shadow_bank.buffer_words", "shadow_bank.record_words"],
    ["polyhedron_bank.drums", "polyhedron_bank.buffer_words", "polyhedron_bank.record_words"],
];

fn standing_still(check: &mut Check) {
    let analog = &check.model.analog;
    let (slew, hysteresis) = (analog.amplifier.slew, analog.comparator.hysteresis);
    check.refuse_if(slew == Some(0.0), &["amplifier.slew_v_us"], || {
        "amplifiers with a slew rate of 0: no output ever moves".into()
    });
    let wires = analog.wires;
    check.refuse_if(wires.slew == Some(0.0) && !wires.is_ideal(), &["wires.slew_v_us"], || {
        "main wires with a slew rate of 0: none ever leaves its first value".into()
    });
    check.refuse_if(hysteresis >= 1.0, &["comparator.hysteresis_pct"], || {
        format!("a hysteresis of {} % of full scale: no comparator ever trips", short(100.0 * hysteresis))
    });
}

fn never_acquired(check: &mut Check) {
    let (acquire, active) = (check.model.analog.sample_hold.acquire, check.budget.sweep.active);
    check.refuse_if(acquire > active, &["sample_hold.acquire_ns"], || {
        let (acquire, active) = (short(1e6 * acquire), short(1e6 * active));
        format!("acquisition takes {acquire} µs, longer than the drawn {active} µs of a sweep: nothing is ever held")
    });
}
