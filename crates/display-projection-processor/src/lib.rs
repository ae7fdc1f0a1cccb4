//! Display projection processor (fig. 30).
