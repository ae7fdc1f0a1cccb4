//! Elevation files into coefficient banks.
