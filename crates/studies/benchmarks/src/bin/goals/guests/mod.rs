//! The generators that are no hybrid machine: against themselves, against the judge, and against Embree and OSMesa over their own
//! faces.
//!
//! `peers/guests.toml` lists what is compared, with what must hold and what is aimed at; the binary `goals` prints it. Both sides of a
//! comparison take turns on two threads, from a pose to finished planes. Medians count.

mod comparison;
mod counted;
mod list;
mod memory;
mod osmesa;
mod side;

pub use comparison::{fastest, table};
pub use counted::{counted_table, draw_counted};
pub use list::{Comparison, Guests, Sense, SideChoice};
pub use memory::{memory_table, peak};
pub use osmesa::OsMesa;
pub use side::Side;
