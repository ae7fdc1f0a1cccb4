//! Pictures of tiles: without cracks, without pops, in any order, by any number of threads, and near the judge.

mod boulders;
mod cracks;
mod detailed;
mod eye;
mod faults;
mod order;
mod parameters;
mod pops;
mod shots;
mod stored;
mod time;
mod told;
