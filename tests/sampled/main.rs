//! The sampled generator on its shipped scenarios: the figures of `scenarios/README.md`, and its pictures against `exact`.

mod beacon;
mod figures;
