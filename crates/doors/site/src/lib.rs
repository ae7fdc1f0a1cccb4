//! The page with the machine in it: its files, and what it knows of scenarios.
//!
//! ```text
//! crate browser ─▶ cargo ─▶ lunoid.wasm ─┐
//! crates/doors/site/page ────────────────┼─▶ site/          a folder for any static host
//! crates/instruments/scope/page ─────────┤
//! scenarios, and the files they name ────┤
//! docs ─▶ MkDocs, with books/ ───────────┘
//!
//! crates/doors/site/page, drive ─▶ page, OF_A_PROGRAM ─▶ `lunoid drive`
//! ```
//!
//! # Law
//! - The same inputs give the same bytes: no date and no machine stands in the folder.
//! - The folder is whole or not there. A folder that is no site is never replaced.
//! - A page of the folder loads from its own origin alone, and from any path below it.
//! - One page has two homes. The file `here.js` says which, and nothing else of the page knows.
//!
//! # See also
//! `docs/browser.md`: how to build the folder and use its script. `browser`: the module. `loop-server`: who serves the page of a program.

mod page;
mod row;

pub use page::{File, OF_A_PROGRAM, page};
pub use row::{LIST, list, row};
