//! Drums that share a channel, followed in order of time.

use crate::drum::{DrumAtWork, Event};
use crate::key::Key;
use crate::span::Span;

/// What a channel and its drums did.
#[derive(Debug)]
pub(crate) struct ChannelWork {
    /// Ticks in which it carried a record, by store.
    pub(crate) carried: Vec<u64>,
    /// Ticks in which each of its drums turned to a record or read it, by store.
    pub(crate) busy: Vec<Vec<u64>>,
    /// Records that arrived, with their tick.
    pub(crate) arrived: Vec<(Key, u64)>,
}

/// The drums of one channel through `span`, with records of `stores` stores: what arrives with its last tick belongs to it. With `serves` a drum that is free
/// turns to its next request. A record that passes while the channel carries another waits for the next turn; of two that
/// pass in one tick that of the drum with the lower number is read (our choice).
pub(crate) fn work(drums: &mut [&mut DrumAtWork], stores: usize, span: Span, serves: bool) -> ChannelWork {
    let (carried, busy) = (vec![0; stores], vec![vec![0; stores]; drums.len()]);
    let mut done = ChannelWork { carried, busy, arrived: Vec::new() };
    if serves && span.start < span.end {
        drums
            .iter_mut()
            .filter(|drum| drum.next_event().is_none())
            .for_each(|drum| drum.take_next(span.start));
    }
    while let Some((tick, event, number)) = next_event(drums).filter(|&(tick, ..)| tick <= span.end) {
        if event == Event::Passage {
            match drums.iter().find_map(|drum| drum.carries_until()) {
                Some(free) => drums[number].let_pass(free),
                None => drums[number].read(),
            }
        } else {
            done.count(number, drums[number], span);
            done.arrived.extend(drums[number].finish());
            if serves && tick < span.end {
                drums[number].take_next(tick);
            }
        }
    }
    drums.iter().enumerate().for_each(|(number, drum)| done.count(number, drum, span));
    done
}

/// Tick, what happens, number of the drum.
fn next_event(drums: &[&mut DrumAtWork]) -> Option<(u64, Event, usize)> {
    let events = drums.iter().enumerate().filter_map(|(number, drum)| {
        let (tick, event) = drum.next_event()?;
        Some((tick, event, number))
    });
    events.min()
}

impl ChannelWork {
    /// Counts the record that a drum is at.
    fn count(&mut self, number: usize, drum: &DrumAtWork, span: Span) {
        let Some((key, [busy, carried])) = drum.time_at_record(span) else { return };
        self.busy[number][key.store as usize] += busy;
        self.carried[key.store as usize] += carried;
    }
}
