//! A closed loop.

use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

use pyo3::prelude::*;

use crate::patience::released;
use crate::picture::Picture;
use crate::poses::{Numbers, numbers, pose};

/// A drive that grows with each pose.
#[pyclass(frozen, module = "lunoid._native")]
pub struct Loop(Mutex<drive::Loop>);

impl Loop {
    /// The loop as Python has it.
    pub fn new(inner: drive::Loop) -> Self {
        Self(Mutex::new(inner))
    }

    /// One thread drives at a time; never waited for with the interpreter held.
    fn inner(&self) -> MutexGuard<'_, drive::Loop> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[pymethods]
impl Loop {
    fn frames(&self, py: Python<'_>) -> u64 {
        py.detach(|| self.inner().frames())
    }

    fn look(&self, py: Python<'_>, told: Numbers) -> PyResult<Picture> {
        let seen = released(py, || self.inner().look(&pose(told)))?;
        Picture::new(py, seen)
    }

    fn ahead(&self, py: Python<'_>, from: Numbers, metres: f64) -> PyResult<Numbers> {
        Ok(numbers(&released(py, || self.inner().ahead(&pose(from), metres))?))
    }

    fn save(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        released(py, || self.inner().save(&folder))
    }
}
