//! Files that mean harm: every reader refuses them with one error that names the file, does not panic, and asks for no more
//! memory than a file of that size may.
//!
//! - `corpus/`: hand-made files by reader and class, and every one that a search has found; each has to be refused.
//! - `claims`: headers that claim what no file of theirs can hold, made by code.
//! - `search`: whole files, damaged at random, to every reader; a printed number makes each of them again.
//! - `pictures`: scenarios damaged at random, drawn by the machine and by `exact` where they can be.
//!
//! ```sh
//! cargo test -p lunoid-tests --test hostile                               # as in CI
//! cargo test -p lunoid-tests --test hostile_long -- --nocapture long_     # the long run
//! ```

mod allocation;
#[path = "../../crates/doors/lunoid/tests/bad_input/build.rs"]
#[allow(dead_code, reason = "other tests need the rest")]
mod build;
mod claims;
mod corpus;
mod mutation;
mod pictures;
mod readers;
mod search;
mod seeds;
