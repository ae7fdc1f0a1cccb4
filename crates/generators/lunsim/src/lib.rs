//! LUNSIM, the program of the report's appendix (section 20): a ground grid, point by point and row by row, onto the
//! plotting positions of a Stromberg-Carlson 4020 film recorder.
//!
//! ```text
//!  pose, field --> viewed area --> grid of n x n points
//!                                       |
//!  levels, craters ------------> heights - s^2 / 2R --> slopes --> Lambert --+
//!                                       |                                    v
//!  sun ---------------------------------+--> march from the sun --> dark --> codes --> film --> planes
//!                                       |                                               ^
//!                                       +--> projection, far to near --> positions -----+
//! ```
//!
//! # Law
//!
//! - **Viewed area** (block 5): the rectangle, along the line of sight and across it, that the field of view covers on
//!   ground between the lowest corner less the deepest crater and the highest corner with the highest rim; clipped at
//!   the map, and at the end of the range programme.
//! - **Grid**: n x n points over it; the increments along and across differ. Height is terrain and craters at the point,
//!   less the drop of the lunoid at its ground range s (block 10): `s^2 / 2R`, or that of the sphere.
//! - **Slopes** (blocks 11, 12): `(h(i+1) - h(i-1))` over twice the increment, along the line of sight and across it; on
//!   the first and last row and column from the one neighbour (blocks 9, 18).
//! - **Light** (block 13): Lambert's law from these slopes, so that far ground leans away by s / R. **Remote shadow**, if
//!   the settings have it: outwards from the sun along a row or column, a roof falls with the sun's rays from the
//!   highest so far; what lies below it is dark.
//! - **Projection** (block 14): each row crosses a column of positions at the point that is projected nearest to the
//!   column's middle. Rows go from far to near and overwrite; positions between two rows show the farther one.
//! - **Codes**: the nearest of `intensity_codes` equal steps from black to the exposure that the display shows white.
//!   A pixel is the mean of the positions whose middles lie in it (`LineMean`), or the position under its middle.
//! - **Restrictions** are errors that give the report's reason. With `restrictions = false` the law is that of the grid
//!   turned to the line of sight, any sun (the roof falls from between two points of the line before), any relief of
//!   the finest level, any law of reflection, any elevation, grids of up to 4096 points. What has no law here (bodies,
//!   tracks, texture, silhouettes, the second level, roll) is left out, and listed as not modelled.
//!
//! # Planes
//!
//! `intensity` is the grey of the codes. All others are of the grid point under the pixel's middle: `normal_*` with the
//! lean of the lunoid, `height` without its drop, `label` terrain or crater.
//!
//! # Signals
//!
//! Rows of the grid, point by point: place, height, slopes, light, shadow, line, code (`rows.rs`). A row stands for a sweep of
//! the probe.
//!
//! # Timing
//!
//! No clocks, no state between frames. [`Program`] counts the pieces of every step of a frame (`work.rs`) and turns them into
//! time by the figures of a [`Hardware`]: a timing record without deadlines, whose events are the output blocks.
//! Rows, points and columns are worked out by the threads of the current rayon pool, each by itself: the bits do not
//! depend on their number. `samples` of the frame's counts are points of the grid, `features` craters whose bounding
//! squares meet the viewed area.
//!
//! # Not modelled
//!
//! Tapes, words of the recorder's instructions and its film; compiler and memory of a 360/65. Shadows of what lies outside the
//! viewed area: the program kept no crater there. Laws of projection, occlusion, features and bodies of the settings are
//! the machine's.
//!
//! # Our choices
//!
//! Number and curve of the codes; square positions, 1024 on the longer side of the picture; the whole grid is held, where
//! the program held three rows; roofs between points; what a gap between rows shows. Operations of a plotting
//! instruction and of an output block, which is a column of positions.
//!
//! # See also
//!
//! `tests/pictures`: closed forms, restrictions, codes, threads. `tests/lunsim` of the workspace: convergence to `exact`,
//! the twelve exhibits.

mod area;
mod explained;
mod film;
mod grid;
mod hardware;
mod inputs;
mod light;
mod observer;
mod parameters;
mod program;
mod projection;
mod restrictions;
mod row;
mod rows;
mod session;
mod shadow;
mod work;

pub use hardware::Hardware;
pub use parameters::Parameters;
pub use program::Program;
pub use projection::POSITIONS;
pub use row::ROW;
pub use session::Lunsim;

/// Its name, as `--machine` says it.
const NAME: &str = ROW.name;
