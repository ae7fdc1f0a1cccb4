//! Sweeps recorded for a page.

use std::path::Path;

use generator::{Planes, Scan, Session};
use replay::{RunFolder, SCOPES, scope_name};
use report::{Beside, ScopePlot, SweepWaves, Wave};
use run_record::file_hash;
use scenario::PoseRow;
use signal::{Probe, Signal, Waveform};

use crate::{Making, PageError, Request};
use scope::{Recorded, columns_of, light_or_dark_svg, needs, runs_along};

/// Draws a plot of every sweep asked for that `beside` does not have, and adds it there.
pub fn record(
    making: &Making,
    poses: &[PoseRow],
    folder: &RunFolder,
    beside: &mut Beside,
) -> Result<(), PageError> {
    let missing: Vec<(&Request, u32)> =
        making.requests.iter().flat_map(|request| missing(making, request, beside)).collect();
    if missing.is_empty() {
        return Ok(());
    }
    folder.make(SCOPES)?;
    let session = making.pool.install(|| making.job.generator.prepare(making.job.stage.clone()))?;
    for (request, sweep) in missing {
        let row = poses.iter().find(|row| row.frame == request.frame);
        let Some(row) = row else { continue };
        let Some(scan) = making.scan() else { continue };
        let (plot, waves) = plot(making, &*session, row, (request, sweep, scan), folder.path())?;
        beside.add(plot, Some(waves));
    }
    Ok(())
}

/// Sweeps of `request` that are not there, or with other signals, or without values.
fn missing<'a>(making: &Making, request: &'a Request, beside: &Beside) -> Vec<(&'a Request, u32)> {
    let asked = request.patterns(&*making.job.generator);
    let is_there = |sweep: u32| {
        let same = |plot: &ScopePlot| (plot.frame, plot.sweep, &plot.asked) == (request.frame, sweep, &asked);
        let has_values = beside.waves.iter().any(|of| (of.frame, of.sweep) == (request.frame, sweep));
        has_values && beside.scopes.iter().any(same)
    };
    let lines = making.scan().map_or(0, |scan| scan.timebase.sweeps);
    let sweeps = request.sweeps(lines).unwrap_or(0..0);
    sweeps.map(|sweep| sweep as u32).filter(|&sweep| !is_there(sweep)).map(|sweep| (request, sweep)).collect()
}

fn plot(
    making: &Making,
    session: &dyn Session,
    row: &PoseRow,
    (request, sweep, scan): (&Request, u32, Scan),
    folder: &Path,
) -> Result<(ScopePlot, SweepWaves), PageError> {
    let view = &making.job.stage.view;
    let mut planes = Planes::new(view.columns as usize, view.lines as usize, &[]);
    let asked = request.patterns(&*making.job.generator);
    let patterns = asked.iter().cloned().chain(needs(&scan).into_iter().map(str::to_owned)).collect();
    let mut probe = Probe::new(patterns, sweep..sweep + 1);
    making.pool.install(|| session.frame(row.frame, &row.pose, &mut planes, &mut probe))?;
    let wanted = shown(&probe.waveforms, &asked, &scan);
    let title = format!("{}, {}", making.job.scenario.title, making.opened.drawn_by());
    let recorded = Recorded {
        title: &title,
        waveforms: &probe.waveforms,
        wires: &session.wires(),
        wanted: &wanted,
        scan,
        display: view.display,
        columns: &columns_of(making.job.stage.landscape.bank()),
    };
    let path = folder.join(scope_name(row.frame, sweep));
    let svg = light_or_dark_svg(&recorded)?;
    files::write_atomic(&path, |out| out.write_all(svg.as_bytes()))?;
    let waves = waves(&probe.waveforms, &wanted, (row.frame, sweep), &scan);
    let signals = wanted.into_iter().map(str::to_owned).collect();
    Ok((ScopePlot { frame: row.frame, sweep, asked, signals, blake3: file_hash(&path)? }, waves))
}

/// The values of the signals `wanted`, for the scope of the page. A reader of a picture sees no more than 32 bits have.
fn waves(waveforms: &[Waveform], wanted: &[&str], (frame, sweep): (u64, u32), scan: &Scan) -> SweepWaves {
    let of = |name: &str| waveforms.iter().find(|waveform| waveform.signal.name == name);
    let numbers = |values: &[f64]| values.iter().map(|&value| value as f32).collect::<Vec<f32>>();
    let wave = |waveform: &Waveform| Wave {
        name: waveform.signal.name.to_owned(),
        unit: waveform.signal.unit.symbol().to_owned(),
        kind: waveform.signal.kind.name().to_owned(),
        times: numbers(&waveform.times),
        values: numbers(&waveform.values)
            .into_iter()
            .map(|value| value.is_finite().then_some(value))
            .collect(),
    };
    SweepWaves {
        frame,
        sweep,
        sample_us: 1e6 / scan.timebase.sample_rate().hertz(),
        place: scan.place.to_owned(),
        places: of(scan.place).map(|waveform| numbers(&waveform.values)).unwrap_or_default(),
        signals: wanted.iter().filter_map(|name| of(name)).map(wave).collect(),
    }
}

/// Names of the signals that a plot shows: those `asked` for that are there and run along the sweep or row.
fn shown(waveforms: &[Waveform], asked: &[String], scan: &Scan) -> Vec<&'static str> {
    let signals = waveforms.iter().map(|waveform| waveform.signal).filter(|signal| runs_along(signal, scan));
    let is_asked = |signal: &Signal| asked.iter().any(|pattern| signal.matches(pattern));
    signals.filter(is_asked).map(|signal| signal.name).collect()
}
