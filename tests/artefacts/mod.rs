//! The artefacts A1 to A26 (hardware section 5) and A27 (section 8): a cause and a detector each, and the matrix of all by all.
//!
//! - [`causes`]: the overlay that puts each in.
//! - [`scene`], [`scenes`]: where it is looked for; [`look`]: what a run shows, beside the clean one.
//! - [`detectors`]: from what a run shows to one number with a threshold.
//! - [`matrix`]: every cause on every scene before every detector; [`figures`]: the diagonal against its formulas;
//!   [`signs`]: proportions, and what artefacts leave alone; [`begin`]: what a sweep begins with.

mod begin;
mod causes;
mod detectors;
mod figures;
mod look;
mod matrix;
mod scene;
mod scenes;
mod signs;
