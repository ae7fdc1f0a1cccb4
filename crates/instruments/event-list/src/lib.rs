//! The digital side of one frame: its events as a listing, and its registers at an instant.
//!
//! [`DigitalFrame`] is the frame. [`list`] works its events out sweep by sweep, in the order of their ticks, and hands
//! out those that a [`Filter`] lets pass. [`Registers`] are those of all colours at an instant ([`At`]).

mod error;
mod filter;
mod frame;
mod late_place;
mod listing;
mod registers;
mod seen;

use std::ops::Range;

use machine::DigitalEvent;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::listing::Listing;
use crate::seen::Seen;

pub use error::EventListError;
pub use filter::{Filter, LEVELS, unit};
pub use frame::{At, DigitalFrame};
pub use late_place::{LatePlace, PlaceOf};
pub use listing::{Form, told};
pub use registers::Registers;

/// Sweeps that are worked out side by side.
const AT_ONCE: u32 = 32;

/// Which events of a frame are listed, and as what.
#[derive(Debug, Clone)]
pub struct Order<'a> {
    /// Sweeps whose events are listed.
    pub sweeps: Range<u32>,
    /// Whether events of no sweep are listed too.
    pub is_whole: bool,
    /// What an event must be.
    pub filter: &'a Filter,
    /// What the listing is written as.
    pub form: Form,
    /// Most events that are listed, and those of the same tick as the last.
    pub limit: Option<u64>,
}

/// Lists events in the order of their ticks, by all threads of the current pool. `write` takes the text piece by piece: a
/// sweep's events are held back only while those of the next may come before them. Returns what is to be said beside
/// the listing: why it is empty, or where it goes on.
///
/// # Errors
/// If the ticks asked for are those of no event, or `write` fails.
pub fn list<E: From<EventListError>>(
    frame: &DigitalFrame<'_>,
    order: &Order<'_>,
    mut write: impl FnMut(&str) -> Result<(), E>,
) -> Result<Option<String>, E> {
    let Order { sweeps, filter, .. } = order;
    let is_meant = |event: &DigitalEvent| event.sweep.map_or(order.is_whole, |sweep| sweeps.contains(&sweep));
    let mut listing = Listing::new(frame, order.form, order.limit);
    let mut seen = Seen::default();
    let mut passes = |event: &DigitalEvent| {
        seen.look(event);
        filter.passes(event)
    };
    let mut waiting: Vec<DigitalEvent> = frame.sweeps.frame_events();
    waiting.retain(|event| is_meant(event) && passes(event));
    let mut next = sweeps.start;
    while next < sweeps.end && !listing.is_full() {
        let until = sweeps.end.min(next + AT_ONCE);
        let of = |sweep: u32| frame.sweeps.events(sweep);
        let found: Vec<Vec<DigitalEvent>> = (next..until).into_par_iter().map(of).collect();
        waiting.extend(found.into_iter().flatten().filter(&mut passes));
        waiting.sort_by_key(|event| event.tick);
        // Words of craters set out with the retrace before their sweep: nothing of a sweep comes before.
        let safe = frame.tick(until, -f64::from(frame.timebase.retrace_samples).max(1.0));
        let whole = waiting.partition_point(|event| until == sweeps.end || event.tick < safe);
        write(&listing.add(waiting.drain(..whole)))?;
        next = until;
    }
    let none = if listing.is_empty() { Some(filter.explain_none(&seen)?) } else { None };
    let note = none.or(listing.more());
    write(&listing.end())?;
    Ok(note)
}
