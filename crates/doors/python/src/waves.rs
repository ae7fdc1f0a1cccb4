//! Signals as arrays.

use drive::{Trace, Traces};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// The signals, each with name, unit, axis, meaning, values, counts and times; then sweeps, places and what is left out.
pub fn document<'py>(py: Python<'py>, traces: Traces) -> PyResult<Bound<'py, PyDict>> {
    let document = PyDict::new(py);
    let signals = PyList::empty(py);
    for trace in traces.signals {
        signals.append(signal(py, trace)?)?;
    }
    document.set_item("signals", signals)?;
    document.set_item("sweeps", (traces.sweeps.start, traces.sweeps.end))?;
    document.set_item("left_out", traces.left_out)?;
    document.set_item("place", traces.place)?;
    document.set_item("places", PyArray1::from_vec(py, traces.places))?;
    Ok(document)
}

fn signal(py: Python<'_>, trace: Trace) -> PyResult<Bound<'_, PyDict>> {
    let fields = PyDict::new(py);
    fields.set_item("name", trace.signal.name)?;
    fields.set_item("unit", trace.signal.unit.symbol())?;
    fields.set_item("axis", trace.signal.axis.name())?;
    fields.set_item("meaning", trace.signal.meaning)?;
    fields.set_item("values", PyArray1::from_vec(py, trace.values))?;
    fields.set_item("counts", trace.counts)?;
    fields.set_item("times", PyArray1::from_vec(py, trace.times))?;
    Ok(fields)
}
