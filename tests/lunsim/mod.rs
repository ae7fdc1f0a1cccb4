//! LUNSIM beside `exact`: convergence with the grid, the exhibits, lifted restrictions.

mod convergence;
mod exhibits;
mod shared;
