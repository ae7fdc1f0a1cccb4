//! The hybrid machine: elaboration, control plane, signal plane (fig. 14).
