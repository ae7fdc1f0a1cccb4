//! Ticks at which something happens, frame by frame.

use std::collections::BTreeMap;
use std::ops::Range;

use event_list::DigitalFrame;
use machine::DigitalEvent;
use quantities::Tick;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::{Bench, Place, PlaceError, StateError, Unit};

/// Events of the mission near the place that is looked at.
pub(crate) struct Events<'b, 'a> {
    bench: &'b Bench<'a>,
    known: BTreeMap<u64, Known<'a>>,
}

/// What is known of a frame.
struct Known<'a> {
    frame: DigitalFrame<'a>,
    /// Tick and sweep of every event, each once, ascending; no sweep for what belongs to the frame. Starts of sweeps are among
    /// them.
    ticks: Vec<(u64, Option<u32>)>,
}

impl<'b, 'a> Events<'b, 'a> {
    /// Nothing is known yet.
    pub(crate) fn new(bench: &'b Bench<'a>) -> Self {
        Self { bench, known: BTreeMap::new() }
    }

    /// `count` steps from `place` to ticks at which something happens or a sweep begins, backwards below 0.
    pub(crate) fn step(&mut self, place: Place, count: i64) -> Result<Place, StateError> {
        let clock = self.bench.clock();
        let mut place = place;
        for _ in 0..count.unsigned_abs() {
            let (floor, is_exact) = clock.tick_before(place);
            let found = match count > 0 {
                true => self.after(place.frame, floor)?.ok_or_else(|| clock.behind())?,
                false => self.before(place.frame, floor + u64::from(!is_exact))?.ok_or(PlaceError::Before)?,
            };
            place = clock.place_of(Tick(found)).ok_or_else(|| clock.behind())?;
        }
        Ok(place)
    }

    /// The events at the tick of a place, as they follow from one another; of each what a listing says, and its document.
    pub(crate) fn at(&mut self, place: Place) -> Result<Vec<(String, serde_json::Value)>, StateError> {
        let tick = self.bench.clock().tick(place);
        let mut found = Vec::new();
        for number in self.near(place.frame) {
            let known = self.frame(number)?;
            let first = known.ticks.partition_point(|(at, _)| *at < tick.0);
            let sweeps = known.ticks[first..].iter().take_while(|(at, _)| *at == tick.0);
            for (_, sweep) in sweeps {
                let of_tick = known.events(*sweep).into_iter().filter(|event| event.tick == tick);
                found.extend(of_tick.map(|event| (event_list::told(&event), known.frame.event_json(&event))));
            }
        }
        Ok(found)
    }

    /// The first tick behind `tick`, which is in `frame`.
    fn after(&mut self, frame: u64, tick: u64) -> Result<Option<u64>, StateError> {
        let mut next: Option<u64> = None;
        for number in self.near(frame) {
            let ticks = &self.frame(number)?.ticks;
            let found = ticks.get(ticks.partition_point(|(at, _)| *at <= tick)).map(|(at, _)| *at);
            next = next.into_iter().chain(found).min();
        }
        Ok(next)
    }

    /// The last tick before `tick`, which is in `frame`.
    fn before(&mut self, frame: u64, tick: u64) -> Result<Option<u64>, StateError> {
        let mut last: Option<u64> = None;
        for number in self.near(frame) {
            let ticks = &self.frame(number)?.ticks;
            let found = ticks[..ticks.partition_point(|(at, _)| *at < tick)].last().map(|(at, _)| *at);
            last = last.into_iter().chain(found).max();
        }
        Ok(last)
    }

    /// Frames whose events may fall into `frame`: set-ups and words of craters set out before their frame, and words arrive
    /// behind it.
    fn near(&self, frame: u64) -> Range<u64> {
        frame.saturating_sub(1)..(frame + 2).min(self.bench.clock().frames())
    }

    fn frame(&mut self, number: u64) -> Result<&Known<'a>, StateError> {
        if !self.known.contains_key(&number) {
            self.known.retain(|known, _| known.abs_diff(number) <= 2);
            self.known.insert(number, Known::new(self.bench, number)?);
        }
        Ok(&self.known[&number])
    }
}

impl<'a> Known<'a> {
    fn new(bench: &Bench<'a>, number: u64) -> Result<Self, StateError> {
        let frame = bench.digital_frame(number, true)?;
        let count = bench.sizes().sweeps;
        let starts = |sweep| (bench.clock().tick(Place::start(number, sweep)).0, Some(sweep));
        let of_sweep = |sweep: u32| {
            let mut ticks: Vec<_> =
                frame.sweeps().events(sweep).iter().map(|event| (event.tick.0, Some(sweep))).collect();
            ticks.push(starts(sweep));
            ticks
        };
        let mut ticks: Vec<_> = (0..count).into_par_iter().flat_map_iter(of_sweep).collect();
        ticks.extend(frame.sweeps().frame_events().iter().map(|event| (event.tick.0, None)));
        ticks.sort_unstable();
        ticks.dedup();
        Ok(Self { frame, ticks })
    }

    fn events(&self, sweep: Option<u32>) -> Vec<DigitalEvent> {
        match sweep {
            Some(sweep) => self.frame.sweeps().events(sweep),
            None => self.frame.sweeps().frame_events(),
        }
    }
}

impl Bench<'_> {
    /// The place `count` steps of `unit` from `place`, backwards below 0.
    ///
    /// # Errors
    /// If that leads out of the mission, or a frame on the way cannot be drawn.
    pub fn step(&self, place: Place, unit: Unit, count: i64) -> Result<Place, StateError> {
        match unit {
            Unit::Event => Events::new(self).step(place, count),
            _ => Ok(self.clock().step(place, unit, count)?),
        }
    }
}
