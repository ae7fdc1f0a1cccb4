//! A large problem area as files, and the time from nothing to its first frame.

use machine::Prepare;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use files::{Npy, write_npy};
use hardware_model::Economy;
use landscape::{Bank, Level, bank_file};
use quantities::unit_interval;
use signal::Probe;

use crate::{Choice, TimedScene};

/// Corners along a side of the bank: a million in all.
const SIDE: usize = 1000;
/// Side of a region (m).
const REGION: f64 = 20.0;

/// Writes a bank of a million corners, a list of `craters` craters and a scenario over both into `folder`; returns the
/// scenario.
///
/// # Errors
/// If a file cannot be written.
pub fn prepare(folder: &Path, craters: usize) -> Result<PathBuf, String> {
    let words = (0..SIDE * SIDE).map(|corner| {
        let mut words = [0.0; 9];
        words[0] = 4.0 * unit_interval(1, &[corner as u64]);
        words
    });
    let level =
        Level::new(REGION, [0.0; 2], [SIDE; 2], words.collect()).map_err(|error| error.to_string())?;
    let bank = Bank::new("start-up", vec![level], None).map_err(|error| error.to_string())?;
    bank_file::write(folder.join("large.bank"), &bank).map_err(|error| error.to_string())?;
    let side = REGION * (SIDE - 1) as f64;
    let row = |crater: u64| {
        let [x, y, size] = [0, 1, 2].map(|part| unit_interval(2, &[crater, part]));
        let radius = 0.8 / (0.01 + size).sqrt();
        let place = |share: f64| 20.0 + share * (side - 40.0);
        [place(x), place(y), radius, 0.2 * radius, 0.03 * radius, 2.0]
    };
    let mut features = "";
    if craters > 0 {
        let rows: Vec<f64> = (0..craters as u64).flat_map(row).collect();
        let array = Npy::new(vec![craters, 6], rows).map_err(|error| error.to_string())?;
        write_npy(folder.join("craters.npy"), &array).map_err(|error| error.to_string())?;
        features = "[features]\nlist = \"craters.npy\"\n";
    }
    let middle = 0.5 * side;
    let text = format!(
        "format = 1\ntitle = \"Start-up\"\nshows = \"How long it takes to begin.\"\nmachine = \"ideal\"\nframes = 1\n\
         [landscape]\nbank = \"large.bank\"\n{features}[sun]\nazimuth_deg = 60\nelevation_deg = 25\n\
         [path]\nkeyframes = [ {{ t_s = 0, x_m = {middle}, y_m = {middle} }}, {{ t_s = 1, x_m = {}, y_m = {middle} }} ]\n\
         [raster]\nsweeps = 525\nsamples_per_sweep = 1000\n[range]\nprogramme = \"geometric\"\nstart_m = 2\nend_m = 5000\n",
        middle + 1.0
    );
    let path = folder.join("startup.toml");
    fs::write(&path, text).map_err(|error| error.to_string())?;
    Ok(path)
}

/// What a beginning took.
#[derive(Debug, Clone, Copy)]
pub struct Beginning {
    /// Reading the files and making the landscape (s).
    pub landscape: f64,
    /// Elaborating the machine (s).
    pub machine: f64,
    /// The first frame (s).
    pub frame: f64,
    /// The least of three frames after it (s).
    pub next: f64,
}

/// Begins with a scenario, as a run of this economy does.
///
/// # Errors
/// If a frame cannot be drawn.
pub fn begin(scenario: &Path, economy: Economy) -> Result<Beginning, String> {
    let mut clock = Instant::now();
    let mut lap = || std::mem::replace(&mut clock, Instant::now()).elapsed().as_secs_f64();
    let scene = TimedScene::read(scenario, &Choice { economy, ..Choice::default() });
    let (mut planes, pose) = (scene.planes(), scene.pose);
    let landscape = lap();
    let session = scene.stage.prepare();
    let machine = lap();
    let mut draw = || {
        session.frame(0, &pose, &mut planes, &mut Probe::off()).map_err(|error| error.to_string())?;
        Ok::<f64, String>(lap())
    };
    let frame = draw()?;
    let next = (0..3).map(|_| draw()).collect::<Result<Vec<f64>, String>>()?;
    Ok(Beginning { landscape, machine, frame, next: next.into_iter().fold(f64::INFINITY, f64::min) })
}
