//! A data bank that turns its drums tick by tick, with lists instead of order statistics and sums instead of remainders.
//! It shares with the block what the seed drew, and no code.

use std::collections::BTreeSet;

use data_bank::{DrumSpell, DrumUnit, FrameSupply, Missing};
use hardware_model::{Channels, Drum, DrumQueue};
use proptest::collection::vec;
use proptest::prelude::{Just, Strategy, any, prop_assert_eq, prop_oneof, proptest};
use quantities::Tick;

use crate::{OneStore, bank_of, demand};

enum Heads {
    Idle,
    Turning(u32),
    Reading(u32, u64),
}

struct SlowDrum {
    unit: DrumUnit,
    count: u32,
    angle: u64,
    queue: Vec<u32>,
    heads: Heads,
}

impl SlowDrum {
    fn place(&self, record: u32) -> u64 {
        (0..record / self.count).fold(0, |place, _| (place + self.unit.transfer) % self.unit.rotation)
    }

    fn choose(&self, queue: DrumQueue) -> Option<usize> {
        let mut angle = self.angle;
        while queue == DrumQueue::ShortestLatency && !self.queue.is_empty() {
            if let Some(at) = self.queue.iter().position(|&record| self.place(record) == angle) {
                return Some(at);
            }
            angle = (angle + 1) % self.unit.rotation;
        }
        (!self.queue.is_empty()).then_some(0)
    }

    /// With free heads, on to the next request.
    fn serve(&mut self, queue: Option<DrumQueue>) {
        if let (Heads::Idle, Some(at)) = (&self.heads, queue.and_then(|queue| self.choose(queue))) {
            self.heads = Heads::Turning(self.queue.remove(at));
        }
    }

    /// The record that passes under the heads in this instant, if it is wanted.
    fn passing(&self) -> Option<u32> {
        match self.heads {
            Heads::Turning(record) if self.angle == self.place(record) => Some(record),
            _ => None,
        }
    }

    fn is_reading(&self) -> bool {
        matches!(self.heads, Heads::Reading(..))
    }

    /// Notes what the heads are at from this tick to the next.
    fn note(&self, drum: u32, tick: u64, spells: &mut Vec<DrumSpell>) {
        let (Heads::Turning(record) | Heads::Reading(record, _)) = self.heads else { return };
        if spells.last().is_none_or(|last| (last.record, last.until) != (record, tick)) {
            spells.push(DrumSpell { drum, record, begun: tick, under: tick, until: tick });
        }
        let Some(spell) = spells.last_mut() else { return };
        spell.until = tick + 1;
        if !self.is_reading() {
            spell.under = tick + 1;
        }
    }

    fn turn(&mut self) {
        self.angle = (self.angle + 1) % self.unit.rotation;
        if let Heads::Reading(_, left) = &mut self.heads {
            *left -= 1;
        }
    }
}

struct SlowBank {
    design: Drum,
    drums: Vec<SlowDrum>,
    channels: usize,
    capacity: usize,
    columns: u32,
    /// Record, frame and rank of its last demand.
    held: Vec<(u32, u64, usize)>,
    ordered: Vec<(u32, u64)>,
    /// What came while no frame ran.
    between: Vec<(u32, u64)>,
    tick: u64,
    begun: bool,
}

/// What came of a run.
struct Run {
    /// Busy ticks of the drums, and of the channels.
    busy: [Vec<u64>; 2],
    spells: Vec<DrumSpell>,
    /// Records with the tick at which each arrived.
    arrived: Vec<(u32, u64)>,
}

impl SlowBank {
    fn new(
        design: Drum,
        channels: Option<u32>,
        buffer_words: Option<u32>,
        columns: u32,
        units: Vec<DrumUnit>,
    ) -> Self {
        let count = units.len() as u32;
        let drum = |unit: DrumUnit| SlowDrum {
            unit,
            count,
            angle: unit.start_angle,
            queue: vec![],
            heads: Heads::Idle,
        };
        let drums = units.into_iter().map(drum).collect();
        let capacity = buffer_words.map_or(usize::MAX, |words| (words / design.record_words) as usize);
        Self {
            design,
            drums,
            channels: channels.map_or(count as usize, |channels| channels.min(count) as usize),
            capacity,
            columns,
            held: vec![],
            ordered: vec![],
            between: vec![],
            tick: 0,
            begun: false,
        }
    }

    fn record_of(&self, corner: u32) -> u32 {
        let side = (1..).take_while(|side| side * side * 9 <= self.design.record_words).last().unwrap();
        let squares_in_a_row = (0..self.columns).filter(|column| column % side == 0).count() as u32;
        (corner / self.columns / side) * squares_in_a_row + (corner % self.columns) / side
    }

    fn holds(&self, record: u32) -> bool {
        self.held.iter().any(|held| held.0 == record)
    }

    /// Turns to `end`; drums choose only while `serving`.
    fn run(&mut self, end: u64, serving: bool) -> Run {
        let mut spells: Vec<Vec<DrumSpell>> = vec![vec![]; self.drums.len()];
        let mut busy = [vec![0; self.drums.len()], vec![0; self.channels]];
        let mut arrived = vec![];
        loop {
            let queue = (serving && self.tick < end).then_some(self.design.queue);
            (0..self.channels).for_each(|channel| self.instant(channel, queue, &mut arrived));
            if self.tick >= end {
                return Run { busy, spells: spells.concat(), arrived };
            }
            for (number, drum) in self.drums.iter_mut().enumerate() {
                busy[0][number] += u64::from(!matches!(drum.heads, Heads::Idle));
                busy[1][number % self.channels] += u64::from(drum.is_reading());
                drum.note(number as u32, self.tick, &mut spells[number]);
                drum.turn();
            }
            self.tick += 1;
        }
    }

    /// What happens in this instant to the drums of a channel: what has been read arrives, then what passes is read if
    /// the channel is free, the lower number first.
    fn instant(&mut self, channel: usize, queue: Option<DrumQueue>, arrived: &mut Vec<(u32, u64)>) {
        let of_channel = (0..self.drums.len()).filter(|number| number % self.channels == channel);
        let of_channel: Vec<usize> = of_channel.collect();
        of_channel.iter().for_each(|&number| self.drums[number].serve(queue));
        let mut let_pass = vec![];
        loop {
            let mut numbers = of_channel.iter().copied();
            let read = numbers.clone().find_map(|number| match self.drums[number].heads {
                Heads::Reading(record, 0) => Some((number, record)),
                _ => None,
            });
            if let Some((number, record)) = read {
                arrived.push((record, self.tick));
                self.drums[number].heads = Heads::Idle;
                self.drums[number].serve(queue);
                continue;
            }
            let is_taken = numbers.clone().any(|number| self.drums[number].is_reading());
            let is_next =
                |number: &usize| self.drums[*number].passing().is_some() && !let_pass.contains(number);
            let Some(number) = numbers.find(is_next) else { return };
            let drum = &mut self.drums[number];
            match drum.passing() {
                Some(record) if !is_taken => drum.heads = Heads::Reading(record, drum.unit.transfer),
                _ => let_pass.push(number),
            }
        }
    }

    fn take_in(&mut self, arrived: &[(u32, u64)], frame: u64, wanted: &[u32], supply: &mut FrameSupply) {
        for &(record, arrival) in arrived {
            let at = self.ordered.iter().position(|ordered| ordered.0 == record).unwrap();
            let latency = arrival - self.ordered.remove(at).1;
            let rank = wanted.iter().position(|&wanted| wanted == record).unwrap();
            self.held.push((record, frame, rank));
            supply.delivered += 1;
            supply.latency_sum += latency;
            supply.latency_max = supply.latency_max.max(latency);
        }
    }

    fn frame(&mut self, frame: u64, end: u64, corners: &[u32], before: &[u32]) -> FrameSupply {
        let mut supply = FrameSupply::default();
        let unique = |corners: &[u32]| {
            let mut wanted = vec![];
            for &corner in corners {
                let record = self.record_of(corner);
                if !wanted.contains(&record) {
                    wanted.push(record);
                }
            }
            wanted
        };
        let (wanted, before) = (unique(corners), unique(before));
        let between = std::mem::take(&mut self.between);
        self.take_in(&between, frame.saturating_sub(1), &before, &mut supply);
        let kept = &wanted[..wanted.len().min(self.capacity)];
        if !self.begun {
            self.begun = true;
            self.held = kept.iter().enumerate().map(|(rank, &record)| (record, frame, rank)).collect();
        }
        self.order(frame, &wanted, kept, &mut supply);
        for &corner in corners {
            if !self.holds(self.record_of(corner)) {
                let drum = self.record_of(corner) % self.drums.len() as u32;
                supply.missing.push(Missing { item: corner, drum, arrival: None });
            }
        }
        let named: BTreeSet<u32> = corners.iter().copied().collect();
        supply.pieces = named.len() as u64;
        supply.missing.sort_by_key(|missing| missing.item);
        supply.missing.dedup();
        let Run { busy: [busy, carried], spells, arrived } = self.run(end, true);
        self.take_in(&arrived, frame, &wanted, &mut supply);
        for missing in &mut supply.missing {
            let record = self.record_of(missing.item);
            missing.arrival = arrived.iter().find(|arrived| arrived.0 == record).map(|found| Tick(found.1));
        }
        FrameSupply { busy, carried, spells, pending: self.ordered.len() as u64, ..supply }
    }

    /// Lets time pass between two frames.
    fn pause(&mut self, ticks: u64) {
        self.between = self.run(self.tick + ticks, false).arrived;
    }

    fn order(&mut self, frame: u64, wanted: &[u32], kept: &[u32], supply: &mut FrameSupply) {
        let open = self.ordered.len();
        self.ordered.retain(|ordered| kept.contains(&ordered.0));
        supply.cancelled = (open - self.ordered.len()) as u64;
        for drum in &mut self.drums {
            drum.queue.clear();
            match drum.heads {
                Heads::Turning(record) | Heads::Reading(record, _) if !kept.contains(&record) => {
                    drum.heads = Heads::Idle;
                }
                _ => {}
            }
        }
        for held in &mut self.held {
            if let Some(rank) = wanted.iter().position(|&wanted| wanted == held.0) {
                (held.1, held.2) = (frame, rank);
            }
        }
        for &record in kept.iter().filter(|&&record| !self.held.iter().any(|held| held.0 == record)) {
            if !self.ordered.iter().any(|ordered| ordered.0 == record) {
                self.ordered.push((record, self.tick));
                supply.requests += 1;
            }
            let which = record as usize % self.drums.len();
            let drum = &mut self.drums[which];
            if !matches!(drum.heads, Heads::Turning(at) | Heads::Reading(at, _) if at == record) {
                drum.queue.push(record);
            }
        }
        while self.held.len() + self.ordered.len() > self.capacity {
            let worst = (0..self.held.len())
                .min_by_key(|&at| (self.held[at].1, usize::MAX - self.held[at].2))
                .unwrap();
            self.held.remove(worst);
            supply.evicted += 1;
        }
        let waiting = |drum: &SlowDrum| drum.queue.len() + usize::from(!matches!(drum.heads, Heads::Idle));
        supply.wanted = wanted.len() as u64;
        supply.present = wanted.iter().filter(|&&record| self.holds(record)).count() as u64;
        supply.no_room = supply.wanted - supply.present - self.ordered.len() as u64;
        supply.longest_queue = self.drums.iter().map(waiting).max().unwrap() as u32;
        supply.words_held =
            (self.held.len() + self.ordered.len()) as u64 * u64::from(self.design.record_words);
    }
}

fn designs() -> impl Strategy<Value = Drum> {
    let queue = prop_oneof![Just(DrumQueue::Fifo), Just(DrumQueue::ShortestLatency)];
    let words = prop_oneof![Just(9), Just(36), Just(81)];
    let rotation = prop_oneof![1..40_u64, 1..300_u64];
    let word = prop_oneof![Just(0.0), 0.0..0.7];
    (rotation, word, words, queue, 1..4_u32).prop_map(|(rotation, word, record_words, queue, count)| Drum {
        rotation,
        word,
        record_words,
        queue,
        count,
    })
}

proptest! {
    #[test]
    fn every_figure_of_every_frame_is_that_of_a_drum_turned_by_hand(
        design in designs(),
        buffer in prop_oneof![Just(None), (0..15_u32).prop_map(Some)],
        channels in (prop_oneof![Just(None), (1..4_u32).prop_map(Some)], prop_oneof![Just(0.0), 0.0..0.9]),
        size in [1..9_usize, 1..9_usize],
        seed in any::<u64>(),
        frames in vec((0..120_u64, 0..3_u64, vec(any::<proptest::sample::Index>(), 0..12)), 1..12),
    ) {
        let buffer = buffer.map(|records| records * design.record_words + records);
        let channels = Channels { count: channels.0, word: channels.1 };
        let mut bank = bank_of(design, channels, buffer, size, seed);
        let mut slow = SlowBank::new(design, channels.count, buffer, size[1] as u32, bank.drums(0).collect());
        let mut before = vec![];
        for (frame, (length, gap, chosen)) in (0..).zip(frames) {
            let corners: Vec<_> = chosen.iter().map(|index| index.index(size[0] * size[1]) as u32).collect();
            let start = slow.tick;
            let found = bank.one(&demand(frame, start, start + length, corners.iter().copied()));
            prop_assert_eq!(found, slow.frame(frame, start + length, &corners, &before));
            slow.pause(gap);
            before = corners;
        }
    }
}
