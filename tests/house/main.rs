//! Rules of the house: floors, licences, what sources may not contain, what pages may claim.

mod awake;
mod citations;
mod comments;
mod dependencies;
mod floors;
mod gate;
mod imports;
mod laws;
mod licences;
mod metadata;
mod modules;
mod not_modelled;
mod pages;
mod sources;
mod targets;
mod touch;
mod trust;
