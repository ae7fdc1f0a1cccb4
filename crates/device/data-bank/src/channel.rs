//! Drums that share a channel, followed in order of time.

use crate::drum::{DrumAtWork, Event};
use crate::key::Key;
use crate::span::Span;

/// What a channel and its drums did.
#[derive(Debug)]
pub(crate) struct ChannelWork {
    /// What its drums were at: number of the drum on the channel, record, and the ticks at which the drum began to turn to it, began
    /// to read it, and was done.
    pub(crate) spells: Vec<(usize, Key, [u64; 3])>,
    /// Records that arrived, with their tick.
    pub(crate) arrived: Vec<(Key, u64)>,
}

/// The drums of one channel through `span`: what arrives with its last tick belongs to it. With `serves` a drum that is free
/// turns to its next request. A record that passes while the channel carries another waits for the next turn; of two that
/// pass in one tick that of the drum with the lower number is read (our choice).
pub(crate) fn work(drums: &mut [&mut DrumAtWork], span: Span, serves: bool) -> ChannelWork {
    let mut done = ChannelWork { spells: Vec::new(), arrived: Vec::new() };
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
            done.note(number, drums[number], span);
            done.arrived.extend(drums[number].finish());
            if serves && tick < span.end {
                drums[number].take_next(tick);
            }
        }
    }
    drums.iter().enumerate().for_each(|(number, drum)| done.note(number, drum, span));
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
    /// Notes the record that a drum is at.
    fn note(&mut self, number: usize, drum: &DrumAtWork, span: Span) {
        self.spells.extend(drum.spell(span).map(|(key, ticks)| (number, key, ticks)));
    }
}
