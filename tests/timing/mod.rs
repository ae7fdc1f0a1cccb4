//! The machine in time, held to the formulas of the hardware report (sections 4, 7 and 8), to itself, and to baselines.

mod baselines;
mod before_mission;
mod crossings;
mod drums;
mod late_sets;
mod loads;
mod order;
mod panels;
mod processor;
mod program;
mod rig;
mod states;
