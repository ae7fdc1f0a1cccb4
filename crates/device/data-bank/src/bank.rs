//! Drums and the stores that share them: from the demand of a frame to what it has to do without.

use std::collections::BTreeMap;

use hardware_model::{Channels, Drum};
use quantities::Tick;

use crate::channel::{self, ChannelWork};
use crate::drum::{DrumAtWork, DrumUnit};
use crate::key::Key;
use crate::span::Span;
use crate::state::BankState;
use crate::store::{Store, StoreDesign};
use crate::wanted::Wanted;
use crate::{Demand, DrumSpell, FrameSupply};

/// Drums and channels, with the stores of all kinds of data that lie on them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataBank {
    stores: Vec<Store>,
    drums: Vec<DrumAtWork>,
    /// Channels that the drums share in turn; at most one each.
    channels: usize,
}

impl DataBank {
    /// Drums of the design `drum` on `channels`, with the records of `stores`. `seed` draws start angle and speed of each drum.
    pub fn new(drum: Drum, channels: Channels, stores: &[StoreDesign], seed: u64) -> Self {
        let stores: Vec<Store> = stores.iter().map(Store::new).collect();
        let count = drum.count.max(1);
        let unit = |number: u32| {
            let of_store = |store: &Store| DrumUnit::drawn(&drum, &channels, store.words, seed, number);
            DrumAtWork::new(stores.iter().map(of_store).collect(), drum.queue, count)
        };
        Self {
            drums: (0..count).map(unit).collect(),
            channels: channels.count.unwrap_or(count).clamp(1, count) as usize,
            stores,
        }
    }

    /// The drums as the seed drew them, with the transfer of a record of store `store`.
    pub fn drums(&self, store: usize) -> impl ExactSizeIterator<Item = DrumUnit> {
        self.drums.iter().map(move |drum| drum.unit(store as u32))
    }

    /// What the bank remembers between the frames that it has followed and the next one.
    pub fn state(&self) -> BankState {
        BankState {
            stores: self.stores.iter().map(Store::state).collect(),
            drums: self.drums.iter().map(DrumAtWork::state).collect(),
        }
    }

    /// What it takes to fill the buffers with the first demand of a mission, which a bank that has not begun yet finds there
    /// as the mission begins. The drums turn as in its first frame.
    pub fn first_load(&self, demand: &Demand) -> Vec<FrameSupply> {
        let mut empty = self.clone();
        empty.stores.iter_mut().for_each(|store| store.loaded = true);
        empty.frame(&Demand { end: Tick(u64::MAX), ..demand.clone() })
    }

    /// Follows the bank through one frame: what each store gets of its demand. The first call is the first frame of the mission.
    pub fn frame(&mut self, demand: &Demand) -> Vec<FrameSupply> {
        let drums = vec![0; self.drums.len()];
        let empty = FrameSupply { busy: drums, carried: vec![0; self.channels], ..FrameSupply::default() };
        let mut supplies = vec![empty; self.stores.len()];
        let start = demand.start.0;
        // What arrives between two frames, in which no request is served.
        self.turn(Span { start, end: start }, false, &mut supplies);
        let wanted: Vec<Wanted> = self
            .stores
            .iter()
            .zip(&demand.wants)
            .map(|(store, pieces)| store.wanted(demand.frame, pieces))
            .collect();
        self.order(&wanted, start, &mut supplies);
        let asked = self.stores.iter().zip(&demand.wants).zip(&mut supplies);
        let absent: Vec<_> = asked.map(|((store, pieces), supply)| store.absent(pieces, supply)).collect();
        let arrivals = self.turn(Span { start, end: demand.end.0 }, true, &mut supplies);
        for (number, supply) in supplies.iter_mut().enumerate() {
            let store = &self.stores[number];
            let drum = |records: &[u32]| records.first().map_or(0, |&record| self.drum_of(record)) as u32;
            let missing = absent[number]
                .iter()
                .map(|(piece, records)| store.missing(*piece, records, drum(records), &arrivals[number]));
            supply.missing = missing.collect();
            supply.pending = store.open();
            supply.spells.sort_by_key(|spell| (spell.drum, spell.begun));
        }
        supplies
    }

    /// Writes the lists of requests anew, and makes room for what they ask for.
    fn order(&mut self, wanted: &[Wanted], start: u64, supplies: &mut [FrameSupply]) {
        for ((store, wanted), supply) in self.stores.iter_mut().zip(wanted).zip(&mut *supplies) {
            store.load_before_mission(wanted);
            supply.cancelled = store.cancel(wanted);
        }
        let keeps = |key: Key| wanted[key.store as usize].keeps(key.record);
        self.drums.iter_mut().for_each(|drum| drum.clear(start, keeps));
        let kinds = self.stores.len() as u32;
        for number in 0..self.stores.len() {
            let supply = &mut supplies[number];
            let asked = self.stores[number].order(&wanted[number], start, supply);
            self.stores[number].count(&wanted[number], supply);
            for (record, turn) in asked {
                let (drum, store) = (self.drum_of(record), number as u32);
                // The kinds take turns: the most urgent record of each, then the second of each.
                let rank = turn.saturating_mul(kinds).saturating_add(store);
                self.drums[drum].enqueue(Key { store, record }, rank);
            }
        }
        let longest = self.drums.iter().map(DrumAtWork::open).max().unwrap_or(0) as u32;
        supplies.iter_mut().for_each(|supply| supply.longest_queue = longest);
    }

    fn drum_of(&self, record: u32) -> usize {
        record as usize % self.drums.len()
    }

    /// Lets the drums turn through `span`; the arrival of each record that came, by store.
    fn turn(&mut self, span: Span, serves: bool, supplies: &mut [FrameSupply]) -> Vec<BTreeMap<u32, u64>> {
        let mut arrived = Vec::new();
        for (channel, work) in self.follow(span, serves).into_iter().enumerate() {
            for (number, key, [begun, under, until]) in work.spells {
                let drum = channel + number * self.channels;
                let supply = &mut supplies[key.store as usize];
                let spell = DrumSpell { drum: drum as u32, record: key.record, begun, under, until };
                supply.note_spell(channel, spell);
            }
            arrived.extend(work.arrived);
        }
        arrived.sort_by_key(|&(key, tick)| (tick, key));
        let of_store = |(number, (store, supply)): (usize, (&mut Store, &mut FrameSupply))| {
            let own = arrived.iter().filter(|(key, _)| key.store as usize == number);
            let own: Vec<(u32, u64)> = own.map(|&(key, tick)| (key.record, tick)).collect();
            store.take_in(&own, span, supply)
        };
        self.stores.iter_mut().zip(supplies).enumerate().map(of_store).collect()
    }

    /// Follows every channel through `span`.
    fn follow(&mut self, span: Span, serves: bool) -> Vec<ChannelWork> {
        let of_channel = |channel| {
            let drums = self.drums.iter_mut().skip(channel).step_by(self.channels);
            channel::work(&mut drums.collect::<Vec<_>>(), span, serves)
        };
        (0..self.channels).map(of_channel).collect()
    }
}
