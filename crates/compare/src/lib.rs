//! Error of one picture against another.
