//! Digital processing unit (fig. 15): the digital side of every sweep (sections 6.3, 6.5, 17; hardware section 4).
//!
//! ```text
//! folds ──▶ pointers of the four colours ──▶ requests ──▶ server ──▶ XFIRST, YFIRST (or hold, when late)
//!                                                          ▲ storage buffer, a bank a colour
//! ```
//!
//! **Law.** At a fold two colours take their preload register into hold; their pointers move by one array step
//! (two corners) along the sweep, and both preload registers of both colours are asked for anew: 18 words used,
//! 36 loaded. `XFIRST(c) = array_c[ptr_c + (cx, 0)]`, `YFIRST(c) = array_c[ptr_c + (0, cy)]`.
//! **Who answers** ([`hardware_model::CrossingServer`]). Wired pointers: a bank of the storage buffer for each colour,
//! side by side. An I/O processor or the processor itself: one line for all. An I/O processor is started once a fold by an
//! order, fetches a command of its chain for each set, and edits each word behind its access. A set takes its pointer arithmetic, then
//! one access after another, each of `words_per_access` words; the strobe of one overlaps with the next. An interrupt
//! is recognised after the instruction that runs (with one priority level: after the set-up), saves its state and moves
//! the pointers by its instructions, once a fold.
//! **Timing.** A fold is seen at the first master tick at or after it. With no access, pointer or strobe time the
//! transfer is wired and words arrive with the fold itself. Words that come after the fold that needs them are late:
//! the model's policy says whether they go straight through to hold or are lost.
//! **Order.** Of the sets that wait, the one that the next stop of the other axis transfers is urgent; with
//! `urgent_first` it goes before the others, else first asked, first served. A third preload register, if there is
//! one, holds the corner beyond both stops: then nothing is urgent, since it moves over with the fold.
//! **Our choices.** Home registers: at sweep start all registers are full, and the queue is empty: what waits at the
//! last fold is served on into retrace, so that sweeps do not depend on one another. A set whose colour has moved on is dropped if it waits, and overwritten
//! if it is on its way; the access that has begun is finished. Pointers that leave the stored area clamp to its edge.
//! A corner that the data bank has not delivered brings words of 0.
//! **Watching.** [`Watch`] is told of every event ([`ServiceEvent`]), once and with its tick: listing, timing record and
//! registers at an instant are made of what it tells. With `()` nothing of that is compiled.

mod accesses;
mod at_once;
mod cpu;
mod crossing;
mod home;
mod server;
mod service;
mod unit;
mod visible;
mod watch;

pub use cpu::{CpuFrame, CpuLoad, CpuTime, CrossingTime, cpu_frame, held_by_set_ups};
pub use home::{HOME_SETS, Pointers, home_load};
pub use unit::{CrossingService, MissingCorner, TimedFold};
pub use visible::Sector;
pub use watch::{AskedCorner, AskedSet, CornerArrival, LineUse, Register, ServiceEvent, Watch};
