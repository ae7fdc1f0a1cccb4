//! The keys of the loader, of the I/O processor, and of single words that are held back.

use std::collections::{BTreeMap, BTreeSet};

use diagnostics::Reader;
use quantities::Rate;
use sweep_program::{Colour, PreloadRegister};

use super::digital::Clocked;
use crate::{CrossingServer, IoProcessor, LatePolicy, LoadDelay, Loader};

const COLOURS: [(&str, Colour); 4] =
    [("yellow", Colour::Yellow), ("green", Colour::Green), ("black", Colour::Black), ("red", Colour::Red)];

const REGISTERS: [(&str, PreloadRegister); 2] =
    [("x-first", PreloadRegister::XFirst), ("y-first", PreloadRegister::YFirst)];

const SERVERS: [(&str, CrossingServer); 3] = [
    ("wired-pointers", CrossingServer::WiredPointers),
    ("io-processor", CrossingServer::IoProcessor),
    ("cpu-interrupt", CrossingServer::CpuInterrupt),
];

const POLICIES: [(&str, LatePolicy); 2] =
    [("strobe-through", LatePolicy::StrobeThrough), ("latched", LatePolicy::Latched)];

pub(super) fn io_processor(table: &Reader, clock: Option<Rate>) -> Option<IoProcessor> {
    let clocked = Clocked { table, clock };
    let order = clocked.nanoseconds("order_ns");
    let chain = clocked.nanoseconds("chain_ns");
    let edit = clocked.nanoseconds("edit_ns");
    Some(IoProcessor { order: order?, chain: chain?, edit: edit? })
}

pub(super) fn loader(
    table: &Reader,
    clock: Option<Rate>,
    io_processor: Option<IoProcessor>,
) -> Option<Loader> {
    let clocked = Clocked { table, clock };
    let served_by = table.one_of("served_by", &SERVERS).required();
    let words_per_access = table.u32("words_per_access").between(1, 9).required();
    let access = clocked.nanoseconds("access_ns");
    let pointer = clocked.nanoseconds("pointer_ns");
    let strobe = clocked.nanoseconds("strobe_ns");
    let urgent_first = table.bool("urgent_first").required();
    let diagonal_register = table.bool("diagonal_register").required();
    let late_policy = table.one_of("late_policy", &POLICIES).required();
    let stop_after_crossings = table.u32("stop_after_crossings").or_word("never").required();
    let tables = table.tables("delay");
    let delays: Vec<_> = tables.iter().map(delay).collect();
    refuse_twins(&tables, &delays);
    Some(Loader {
        served_by: served_by?,
        words_per_access: words_per_access?,
        access: access?,
        pointer: pointer?,
        io_processor: io_processor?,
        strobe: strobe?,
        urgent_first: urgent_first?,
        diagonal_register: diagonal_register?,
        stop_after_crossings: stop_after_crossings?,
        late_policy: late_policy?,
        delays: delays.into_iter().collect::<Option<_>>()?,
    })
}

/// One word of one request can be held back once: two entries would send it twice.
fn refuse_twins(tables: &[Reader], delays: &[Option<LoadDelay>]) {
    let mut known: BTreeMap<_, BTreeSet<Option<u64>>> = BTreeMap::new();
    for (table, delay) in tables.iter().zip(delays) {
        let Some(LoadDelay { frame, sweep, crossing, colour, register, word, .. }) = *delay else { continue };
        let frames = known.entry((sweep, crossing, colour as u8, register as u8, word)).or_default();
        // A delay without a frame is one of every frame.
        let meets =
            frames.contains(&frame) || frames.contains(&None) || frame.is_none() && !frames.is_empty();
        frames.insert(frame);
        if meets {
            let problem = table.problem("word", "the same word of the same crossing is delayed twice");
            let help = "join both entries into one, or give them different frames";
            table.report(problem.expected("one entry for each word").help(help));
        }
    }
}

fn delay(table: &Reader) -> Option<LoadDelay> {
    let frame = table.u64("frame").optional();
    let sweep = table.u32("sweep").below(8192).required();
    let crossing = table.u32("crossing").required();
    let colour = table.one_of("colour", &COLOURS).required();
    let register = table.one_of("register", &REGISTERS).required();
    let orders = table.u64_list("word").must("the two orders [p, q], each 0 to 2", |orders| {
        orders.len() == 2 && orders.iter().all(|&order| order <= 2)
    });
    let word = orders.map(|orders| (3 * orders[0] + orders[1]) as usize).required();
    let ticks = table.u64("ticks").required();
    Some(LoadDelay {
        frame,
        sweep: sweep?,
        crossing: crossing?,
        colour: colour?,
        register: register?,
        word: word?,
        ticks: ticks?,
    })
}

/// The list of delays as a model file has it, in one line.
pub(crate) fn delays_as_written(delays: &[LoadDelay]) -> String {
    let tables: Vec<String> = delays.iter().map(delay_as_written).collect();
    format!("[{}]", tables.join(", "))
}

fn delay_as_written(delay: &LoadDelay) -> String {
    let frame = delay.frame.map_or(String::new(), |frame| format!("frame = {frame}, "));
    let LoadDelay { sweep, crossing, ticks, .. } = delay;
    let colour = word(&COLOURS, delay.colour);
    let register = word(&REGISTERS, delay.register);
    let [p, q] = [delay.word / 3, delay.word % 3];
    format!(
        "{{ {frame}sweep = {sweep}, crossing = {crossing}, colour = {colour:?}, register = {register:?}, \
         word = [{p}, {q}], ticks = {ticks} }}"
    )
}

fn word<T: PartialEq>(words: &[(&'static str, T)], meaning: T) -> &'static str {
    words.iter().find(|(_, known)| *known == meaning).map_or("", |(word, _)| word)
}
