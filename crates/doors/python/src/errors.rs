//! Errors of the crate `drive` as `lunoid.InputError`.

use drive::{DriveError, Fault};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// The Python exception of `error`: its text, and each fault with its fields.
pub fn raise(py: Python<'_>, error: &DriveError) -> PyErr {
    input_error(py, error).unwrap_or_else(|failed| failed)
}

fn input_error(py: Python<'_>, error: &DriveError) -> PyResult<PyErr> {
    let class = py.import("lunoid._errors")?.getattr("InputError")?;
    let faults = PyList::empty(py);
    for fault in error.faults() {
        faults.append(fields(py, fault)?)?;
    }
    Ok(PyErr::from_value(class.call1((error.to_string(), faults))?))
}

fn fields(py: Python<'_>, fault: Fault) -> PyResult<Bound<'_, PyDict>> {
    let Fault { file, line, column, key, title, found, expected, help } = fault;
    let fields = PyDict::new(py);
    fields.set_item("file", file)?;
    fields.set_item("line", line)?;
    fields.set_item("column", column)?;
    fields.set_item("key", key)?;
    fields.set_item("title", title)?;
    fields.set_item("found", found)?;
    fields.set_item("expected", expected)?;
    fields.set_item("help", help)?;
    Ok(fields)
}
