//! A picture whose arrays are its own memory.

use drive::{PlaneKind, Seen};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::patience::released;
use crate::poses::{Numbers, numbers};

/// A drawn frame with its pose.
#[pyclass(frozen, module = "lunoid._native")]
pub struct Picture {
    seen: Seen,
    codes: Py<PyAny>,
}

impl Picture {
    /// The picture of `seen`; its codes become an array of bytes.
    pub fn new(py: Python<'_>, seen: Seen) -> PyResult<Self> {
        let (columns, lines) = (seen.picture.columns(), seen.picture.lines());
        let codes = match &seen.picture {
            picture if picture.is_colour() => bytes(picture.to_colour().codes()),
            picture => bytes(picture.grey().map_or(&[], |grey| grey.codes())),
        };
        let depth = codes.len() / (columns * lines).max(1);
        let flat = PyArray1::from_vec(py, codes);
        let codes = match depth {
            3 => flat.reshape([lines, columns, 3])?.into_any(),
            _ => flat.reshape([lines, columns])?.into_any(),
        };
        Ok(Self { seen, codes: codes.unbind() })
    }
}

/// Codes of 8 bits.
fn bytes(codes: &[u16]) -> Vec<u8> {
    codes.iter().map(|code| *code as u8).collect()
}

#[pymethods]
impl Picture {
    #[getter]
    fn frame(&self) -> u64 {
        self.seen.frame
    }

    #[getter]
    fn pose(&self) -> Numbers {
        numbers(&self.seen.pose)
    }

    #[getter]
    fn codes(&self, py: Python<'_>) -> Py<PyAny> {
        self.codes.clone_ref(py)
    }

    fn hash(&self) -> String {
        self.seen.hash()
    }

    fn png<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = released(py, || self.seen.png())?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Linear light by the name of its plane, copied.
    fn light<'py>(&self, py: Python<'py>) -> PyResult<Vec<(&'static str, Bound<'py, PyAny>)>> {
        let planes = &self.seen.light;
        let shape = [planes.lines(), planes.columns()];
        let kinds = [PlaneKind::Intensity, PlaneKind::Red, PlaneKind::Green, PlaneKind::Blue];
        let there = kinds.into_iter().filter_map(|kind| Some((kind.name(), planes.get(kind)?)));
        there
            .map(|(name, plane)| Ok((name, PyArray1::from_slice(py, plane).reshape(shape)?.into_any())))
            .collect()
    }
}
