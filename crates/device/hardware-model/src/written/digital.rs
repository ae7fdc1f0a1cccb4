//! The keys of processor, drums, channels and storage buffer. Times become whole master ticks here.

use diagnostics::Reader;
use quantities::{Rate, radians};

use crate::{Channels, Cpu, DataBanks, Drum, DrumQueue, LevelTurn};

/// Most instructions of a crossing, cycles of an instruction, cycles of a word: their products stay far from the end of
/// 64 bits.
const MOST_OF_A_KIND: u32 = 1000;

/// A table whose times are counted in ticks of the master clock, where that is known.
pub(super) struct Clocked<'r, 'a> {
    pub table: &'r Reader<'a>,
    pub clock: Option<Rate>,
}

impl Clocked<'_, '_> {
    pub fn nanoseconds(&self, key: &str) -> Option<u64> {
        self.time(key, "ns", 1.0)
    }

    pub fn microseconds(&self, key: &str) -> Option<u64> {
        self.time(key, "µs", 1e3)
    }

    pub fn milliseconds(&self, key: &str) -> Option<u64> {
        self.time(key, "ms", 1e6)
    }

    /// At most ten seconds: sums of a few stay far from the end of 64 bits.
    fn time(&self, key: &str, unit: &str, scale: f64) -> Option<u64> {
        let time = self.table.f64(key).between(0.0, 1e10 / scale).unit(unit).required();
        Some(ticks(scale * time?, self.clock?))
    }
}

/// Whole ticks that `nanoseconds` take: a word is there at the first tick after it came.
fn ticks(nanoseconds: f64, clock: Rate) -> u64 {
    let ticks = nanoseconds * clock.hertz() / 1e9;
    // 950 ns at 20 MHz is 19 ticks, not 20 because of a last bit.
    (ticks - 1e-9 * ticks).ceil() as u64
}

pub(super) fn cpu(table: &Reader, clock: Option<Rate>) -> Option<Cpu> {
    let clocked = Clocked { table, clock };
    let memory_cycle = clocked.nanoseconds("memory_cycle_ns");
    let memory_banks = table.u32("memory_banks").between(1, MOST_OF_A_KIND).required();
    let multiply = clocked.microseconds("multiply_us");
    let interrupt = clocked.microseconds("interrupt_us");
    let longest_instruction = clocked.microseconds("longest_instruction_us");
    let count = |key| table.u32(key).between(0, MOST_OF_A_KIND).required();
    let crossing_instructions = count("crossing_instructions");
    let instruction_cycles = count("instruction_cycles");
    let crossing_multiplications = count("crossing_multiplications");
    let dma_cycles_per_word = count("dma_cycles_per_word");
    let sweep_setup = clocked.microseconds("sweep_setup_us");
    let frame_tables = clocked.milliseconds("frame_tables_ms");
    let vertex = clocked.microseconds("vertex_us");
    let levels = table.u32("priority_levels").between(1, 1000).or_word("unlimited").required();
    Some(Cpu {
        memory_cycle: memory_cycle?,
        memory_banks: memory_banks?,
        multiply: multiply?,
        interrupt: interrupt?,
        longest_instruction: longest_instruction?,
        crossing_instructions: crossing_instructions?,
        instruction_cycles: instruction_cycles?,
        crossing_multiplications: crossing_multiplications?,
        dma_cycles_per_word: dma_cycles_per_word?,
        sweep_setup: sweep_setup?,
        frame_tables: frame_tables?,
        vertex: vertex?,
        priority_levels: levels?,
    })
}

/// The drums, or nothing for words that are all at hand: the other figures stand in every model, so that it can be
/// changed by one.
pub(super) fn drum(table: &Reader, clock: Option<Rate>) -> Option<Option<Drum>> {
    let rotation = Clocked { table, clock }.milliseconds("rotation_ms");
    let word = ticks_a_word(table, clock);
    let record = table.u32("record_words").must("9 n² for a square of n x n corners", is_square_of_corners);
    let record_words = record.required();
    let queues = [("fifo", DrumQueue::Fifo), ("shortest-latency", DrumQueue::ShortestLatency)];
    let queue = table.one_of("queue", &queues).required();
    let count = table.u32("count").between(1, 1000).required();
    let drum =
        Drum { rotation: rotation?, word: word?, record_words: record_words?, queue: queue?, count: count? };
    Some((drum.rotation > 0).then_some(drum))
}

/// The channels between drums and storage buffer.
pub(super) fn channels(table: &Reader, clock: Option<Rate>) -> Option<Channels> {
    let count = table.u32("count").between(1, 1000).or_word("unlimited").required();
    let word = ticks_a_word(table, clock);
    Some(Channels { count: count?, word: word? })
}

/// Ticks of one word of two bytes at the rate of a table.
fn ticks_a_word(table: &Reader, clock: Option<Rate>) -> Option<f64> {
    let rate = table.f64("rate_mb_s").between(1e-3, 1e6).unit("MB/s").or_word("unlimited").required();
    rate?.map_or(Some(0.0), |rate| Some(2.0 * clock?.hertz() / (1e6 * rate)))
}

fn is_square_of_corners(words: &u32) -> bool {
    let corners = words / 9;
    words.is_multiple_of(9)
        && corners > 0
        && corners <= 1 << 20
        && corners.isqrt() * corners.isqrt() == corners
}

pub(super) fn data_banks(
    drum: Option<Drum>,
    channels: Option<Channels>,
    buffer: &Reader,
) -> Option<DataBanks> {
    let words = buffer.u32("words").at_least(9).or_word("unlimited").required();
    Some(DataBanks { drum, channels: channels?, buffer_words: words? })
}

/// Without the table the switch of the levels stays where it is.
pub(super) fn level_turn(table: &Reader) -> Option<LevelTurn> {
    let rate = table.f64("rate_deg_s").above(0.0).at_most(1000.0).unit("degrees/s").map(radians);
    let rate = rate.or_word("never").default(None);
    let share = table.f64("range_pct").between(1.0, 100.0).unit("%").default(50.0);
    let (rate, share) = (rate?, 0.01 * share?);
    Some(rate.map_or(LevelTurn::NEVER, |rate| LevelTurn { rate, share }))
}
