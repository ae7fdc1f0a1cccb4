//! Tiles with levels: the document's flight, edges without gaps, morphing with exact ends, counts of triangles.

mod counts;
mod edges;
mod flight;
mod morphing;
mod pieces;
