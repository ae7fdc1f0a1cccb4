//! What crosses crates, in one program: shadows of a ground under a sun are found once for all of its tests.

mod artefacts;
mod explain;
mod faces;
mod guest;
mod landscape;
mod late_words;
mod lunsim;
mod one_place;
mod overlays;
mod scenarios;
mod second_opinion;
mod signals;
mod state;
mod timing;
