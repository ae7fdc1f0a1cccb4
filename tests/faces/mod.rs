//! Generators of faces on their shipped scenarios: the figures of `scenarios/README.md`.

mod beacon;
mod figures;
mod link;
mod lod;
mod panels;
mod smooth;
mod town;
