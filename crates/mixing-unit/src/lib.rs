//! Mixing unit (fig. 28, 29).
