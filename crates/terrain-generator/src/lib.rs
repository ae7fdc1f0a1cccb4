//! Terrain generator (fig. 16-22).
