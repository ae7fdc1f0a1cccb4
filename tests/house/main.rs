//! Rules of the house: floors, licences, what sources may not contain.

mod awake;
mod dependencies;
mod floors;
mod licences;
mod metadata;
mod sources;
mod targets;
mod trust;
