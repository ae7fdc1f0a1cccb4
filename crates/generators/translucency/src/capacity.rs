//! How many features a sampling point can hold before its nearest opaque one.

/// Slots of each sampling point; `None` is without limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Capacity {
    /// Slots of their own, so that a lamp does not push out a sheet of dust. Chosen: the claims ask for a limit on lights alone.
    Separate {
        /// K: translucent surfaces that are kept.
        translucent: Option<u32>,
        /// L: lights that are kept.
        lights: Option<u32>,
    },
    /// One stack for both, as claim 4 says: the fault `shared-stack`. The slots are K + L.
    Shared(Option<u32>),
}

impl Capacity {
    /// Without limits: the reference for what limits lose.
    pub const UNLIMITED: Self = Self::Separate { translucent: None, lights: None };
}
