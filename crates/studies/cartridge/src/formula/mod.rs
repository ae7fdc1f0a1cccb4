//! Closed forms, by name.

pub mod along;
pub mod basis;
pub mod distance;
pub mod horizon;
pub mod light;
pub mod processor;
pub mod response;
