//! Sweeps recorded for a page.

use std::path::Path;

use generator::{Planes, Scan, Session};
use replay::{RunFolder, SCOPES, scope_name};
use report::{Beside, ScopePlot};
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
        beside.add(plot(making, &*session, row, (request, sweep, scan), folder.path())?);
    }
    Ok(())
}

/// Sweeps of `request` that are not there, or with other signals.
fn missing<'a>(making: &Making, request: &'a Request, beside: &Beside) -> Vec<(&'a Request, u32)> {
    let asked = request.patterns(&*making.job.generator);
    let is_there = |sweep: u32| {
        let same = |plot: &ScopePlot| (plot.frame, plot.sweep, &plot.asked) == (request.frame, sweep, &asked);
        beside.scopes.iter().any(same)
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
) -> Result<ScopePlot, PageError> {
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
    Ok(ScopePlot {
        frame: row.frame,
        sweep,
        asked,
        signals: wanted.into_iter().map(str::to_owned).collect(),
        blake3: file_hash(&path)?,
    })
}

/// Names of the signals that a plot shows: those `asked` for that are there and run along the sweep or row.
fn shown(waveforms: &[Waveform], asked: &[String], scan: &Scan) -> Vec<&'static str> {
    let signals = waveforms.iter().map(|waveform| waveform.signal).filter(|signal| runs_along(signal, scan));
    let is_asked = |signal: &Signal| asked.iter().any(|pattern| signal.matches(pattern));
    signals.filter(is_asked).map(|signal| signal.name).collect()
}
