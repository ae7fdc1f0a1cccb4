//! Commands that hold generators to what is known: studies, test cartridges, and machine and interpreter side by side. Each module is a command
//! of `lunoid`: its arguments and help, its calls of a library, what it prints.
//!
//! # See also
//! `command-line`: what commands share. `study`, `cartridge`, `lockstep`: the libraries that do the work.

pub mod cartridge;
pub mod lockstep;
pub mod study;
