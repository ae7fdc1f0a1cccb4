//! Shadows against ray casting, outlines against unions, true ground against `exact` and marching, sequences on disk, lines as waveforms.

mod flat_error;
mod lines;
mod outlines;
mod penumbra;
mod ray_casting;
mod scenes;
mod sequences;
mod shipped;
mod tracks;
mod true_ground;
