//! The crate `drive` as a Python module. Names and units of the package stand in `python/lunoid`.
//!
//! ```text
//! lunoid (Python) ─▶ _native.Drive ─▶ drive::Drive      the interpreter is released in every call that draws
//!                        └─▶ _native.Loop ─▶ drive::Loop
//! ```

mod errors;
mod looped;
mod opened;
mod patience;
mod picture;
mod poses;
mod waves;

use pyo3::prelude::*;

/// The native part of the package `lunoid`.
#[pymodule]
mod _native {
    #[pymodule_export]
    use super::looped::Loop;
    #[pymodule_export]
    use super::opened::Drive;
    #[pymodule_export]
    use super::picture::Picture;
}
