//! Shadow controller (fig. 25, 26): boundary segments into a blanking gate.
