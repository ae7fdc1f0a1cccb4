//! Relations that hold for any scene, whatever its answer (trust 3.2), over random scenes; and the determinism matrix
//! (trust 3.11).

mod added;
mod determinism;
mod moved;
mod parts;
mod wires;
