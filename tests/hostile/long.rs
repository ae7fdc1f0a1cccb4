//! The long form of the searches for hostile files, only where it is asked for by name: docs/robustness.md.

mod allocation;
#[path = "../../crates/doors/lunoid/tests/bad_input/build.rs"]
#[allow(dead_code, reason = "other tests need the rest")]
mod build;
mod mutation;
mod pictures;
#[allow(dead_code, reason = "the corpus needs the rest")]
mod readers;
mod search;
mod seeds;

#[test]
fn long_search_of_every_reader() {
    search::search_all(1_000_000..1_005_000);
}

#[test]
fn long_search_from_scenario_to_picture() {
    pictures::search(1_000_000..1_001_000);
}
