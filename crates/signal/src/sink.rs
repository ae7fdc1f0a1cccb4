//! Waveforms into plain files: NPZ to compute with, CSV to look at.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;

use files::{FileError, Npy, write_atomic, write_npz as write_arrays};

use crate::Waveform;

/// Writes one array `[sweep, sample]` (f64) a signal, named as the signal, and `sweeps`, the numbers of the rows.
///
/// # Errors
/// If the file cannot be written.
///
/// # Panics
/// If two waveforms of one signal differ in length.
pub fn write_npz(path: &Path, waveforms: &[Waveform]) -> Result<(), FileError> {
    let mut by_signal: BTreeMap<&str, Vec<&Waveform>> = BTreeMap::new();
    for waveform in waveforms {
        by_signal.entry(waveform.signal.name).or_default().push(waveform);
    }
    let mut arrays: Vec<(&str, Npy)> = by_signal.iter().map(|(name, rows)| (*name, rows_of(rows))).collect();
    if let Some(rows) = by_signal.values().next() {
        let sweeps: Vec<f64> = rows.iter().map(|row| f64::from(row.sweep)).collect();
        arrays.push(("sweeps", array(vec![rows.len()], sweeps)));
    }
    write_arrays(path, arrays.iter().map(|(name, array)| (*name, array)))
}

fn rows_of(rows: &[&Waveform]) -> Npy {
    let samples = rows[0].values.len();
    let data = rows.iter().flat_map(|row| row.values.iter().copied()).collect();
    array(vec![rows.len(), samples], data)
}

fn array(shape: Vec<usize>, values: Vec<f64>) -> Npy {
    Npy::new(shape, values).expect("all waveforms of a signal have one length")
}

/// Writes one row a sample: frame, sweep, sample, then a column a signal with its unit in the heading.
///
/// # Errors
/// If the file cannot be written.
pub fn write_csv(path: &Path, waveforms: &[Waveform]) -> Result<(), FileError> {
    let mut by_sweep: BTreeMap<(u64, u32), Vec<&Waveform>> = BTreeMap::new();
    for waveform in waveforms {
        by_sweep.entry((waveform.frame, waveform.sweep)).or_default().push(waveform);
    }
    write_atomic(path, |file| {
        if let Some(columns) = by_sweep.values().next() {
            write!(file, "frame,sweep,index")?;
            for column in columns {
                write!(file, ",{} [{}]", column.signal.name, column.signal.unit)?;
            }
            writeln!(file)?;
        }
        by_sweep.iter().try_for_each(|(&(frame, sweep), columns)| write_rows(file, frame, sweep, columns))
    })
}

fn write_rows(file: &mut dyn Write, frame: u64, sweep: u32, columns: &[&Waveform]) -> std::io::Result<()> {
    let rows = columns.iter().map(|column| column.values.len()).max().unwrap_or(0);
    for index in 0..rows {
        write!(file, "{frame},{sweep},{index}")?;
        for column in columns {
            match column.values.get(index) {
                Some(value) => write!(file, ",{value}")?,
                None => write!(file, ",")?,
            }
        }
        writeln!(file)?;
    }
    Ok(())
}
