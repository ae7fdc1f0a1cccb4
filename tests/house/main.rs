//! Rules of the house: floors, licences, what sources may not contain.

mod awake;
mod dependencies;
mod floors;
mod imports;
mod licences;
mod metadata;
mod modules;
mod sources;
mod targets;
mod trust;
