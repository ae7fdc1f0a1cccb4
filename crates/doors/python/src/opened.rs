//! An opened scenario.

use std::path::PathBuf;
use std::sync::Arc;

use drive::{Codes, Economy, Scalar, TruthPlane, Weight, Wishes};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::looped::Loop;
use crate::patience::{obedient, released};
use crate::picture::Picture;
use crate::poses::{Numbers, numbers, pose};
use crate::waves::document;

/// A scenario on its ground, with the generator that draws it.
#[pyclass(frozen, module = "lunoid._native")]
pub struct Drive(Arc<drive::Drive>);

/// Name, unit, array, words of codes, bound.
type Plane<'py> = (&'static str, &'static str, Bound<'py, PyAny>, Vec<&'static str>, f64);

#[pymethods]
impl Drive {
    #[new]
    #[pyo3(signature = (scenario, *, machine=None, overlays=Vec::new(), set=Vec::new(), channel=None, bank=None, sweeps=None,
                        samples=None, scalar=None, economy="normal", shadow_cache=None, threads=0))]
    #[expect(clippy::too_many_arguments, reason = "each is an option of the command")]
    fn new(
        py: Python<'_>,
        scenario: PathBuf,
        machine: Option<String>,
        overlays: Vec<PathBuf>,
        set: Vec<(String, String)>,
        channel: Option<String>,
        bank: Option<PathBuf>,
        sweeps: Option<u32>,
        samples: Option<u32>,
        scalar: Option<&str>,
        economy: &str,
        shadow_cache: Option<PathBuf>,
        threads: usize,
    ) -> PyResult<Self> {
        let scalar =
            scalar.map(|word| one_of(word, &[("f32", Scalar::F32), ("f64", Scalar::F64)])).transpose()?;
        let economy = one_of(
            economy,
            &[
                ("normal", Economy::Normal),
                ("bounded", Economy::Bounded),
                ("lossless", Economy::Lossless),
                ("everything", Economy::Everything),
                ("preview", Economy::Instants(1)),
            ],
        )?;
        let wishes =
            Wishes { machine, overlays, set, channel, bank, sweeps, samples, scalar, economy, shadow_cache };
        let opened = released(py, || drive::Drive::open(&scenario, &wishes, threads))?;
        Ok(Self(Arc::new(opened)))
    }

    /// What is known without drawing.
    fn facts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (drive, facts) = (&self.0, PyDict::new(py));
        let raster = drive.raster();
        facts.set_item("file", drive.file())?;
        facts.set_item("title", drive.title())?;
        facts.set_item("drawn_by", drive.drawn_by())?;
        facts.set_item("frames", drive.frames())?;
        facts.set_item("columns", raster.columns)?;
        facts.set_item("lines", raster.lines)?;
        facts.set_item("sweeps", raster.sweeps)?;
        facts.set_item("samples", raster.samples)?;
        facts.set_item("update_hz", raster.update_hz)?;
        facts.set_item("remembers_frames", drive.remembers_frames())?;
        facts.set_item("remarks", drive.remarks())?;
        let omissions = drive.omissions().into_iter();
        let omissions =
            omissions.map(|omission| (omission.block, omission.what, omission.why, weight(omission.weight)));
        facts.set_item("omissions", omissions.collect::<Vec<_>>())?;
        Ok(facts)
    }

    fn pose(&self, py: Python<'_>, frame: u64) -> PyResult<Numbers> {
        Ok(numbers(&released(py, || self.0.pose(frame))?))
    }

    fn frame(&self, py: Python<'_>, frame: u64) -> PyResult<Picture> {
        let seen = released(py, || self.0.frame(frame))?;
        Picture::new(py, seen)
    }

    fn look(&self, py: Python<'_>, frame: u64, told: Numbers) -> PyResult<Picture> {
        let seen = released(py, || self.0.look(frame, &pose(told)))?;
        Picture::new(py, seen)
    }

    fn truth<'py>(
        &self,
        py: Python<'py>,
        frame: u64,
        names: &str,
    ) -> PyResult<(Vec<Plane<'py>>, Vec<&'static str>)> {
        let truth = released(py, || self.0.truth(frame, names))?;
        let planes = truth.planes.into_iter().map(|plane| array(py, plane)).collect::<PyResult<_>>()?;
        Ok((planes, truth.error.to_vec()))
    }

    fn probe<'py>(
        &self,
        py: Python<'py>,
        patterns: Vec<String>,
        frame: u64,
        sweeps: (u32, u32),
    ) -> PyResult<Bound<'py, PyDict>> {
        let traces = released(py, || self.0.probe(&patterns, frame, sweeps.0..sweeps.1))?;
        document(py, traces)
    }

    /// Cause, reasons, text, document as JSON.
    fn explain(
        &self,
        py: Python<'_>,
        frame: u64,
        pixel: (usize, usize),
    ) -> PyResult<(String, Vec<String>, String, String)> {
        let told = released(py, || self.0.explain(frame, [pixel.0, pixel.1]))?;
        Ok((told.cause, told.because, told.text, told.document.to_string()))
    }

    /// The table of a study of error against run time, as CSV.
    fn study(&self, py: Python<'_>, only: Vec<String>) -> PyResult<String> {
        Ok(obedient(py, |goes_on| self.0.study(&only, goes_on))?.csv())
    }

    fn closed_loop(&self) -> Loop {
        Loop::new(drive::Loop::new(Arc::clone(&self.0)))
    }
}

fn one_of<T: Copy>(word: &str, words: &[(&str, T)]) -> PyResult<T> {
    let found = words.iter().find(|(name, _)| *name == word).map(|(_, value)| *value);
    let names: Vec<&str> = words.iter().map(|(name, _)| *name).collect();
    found.ok_or_else(|| PyValueError::new_err(format!("{word:?}: expected one of {}", names.join(", "))))
}

fn weight(weight: Weight) -> String {
    match weight {
        Weight::Lossless => "lossless".into(),
        Weight::NotModelled => "not modelled".into(),
        Weight::Bounded(levels) => format!("at most {levels} levels of 255"),
    }
}

fn array(py: Python<'_>, plane: TruthPlane) -> PyResult<Plane<'_>> {
    let TruthPlane { name, unit, shape, values, codes, bound } = plane;
    let values = match (values, &shape[..]) {
        (Codes::Codes(codes), &[lines, columns]) => {
            PyArray1::from_vec(py, codes).reshape([lines, columns])?.into_any()
        }
        (Codes::Codes(codes), _) => PyArray1::from_vec(py, codes).into_any(),
        (Codes::Numbers(numbers), &[lines, columns]) => {
            PyArray1::from_vec(py, numbers).reshape([lines, columns])?.into_any()
        }
        (Codes::Numbers(numbers), &[lines, columns, parts]) => {
            PyArray1::from_vec(py, numbers).reshape([lines, columns, parts])?.into_any()
        }
        (Codes::Numbers(numbers), _) => PyArray1::from_vec(py, numbers).into_any(),
    };
    Ok((name, unit, values, codes, bound))
}
