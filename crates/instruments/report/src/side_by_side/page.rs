//! The page of several runs: frames in columns, errors, times, what each leaves out.

use std::collections::BTreeSet;
use std::path::Path;

use compare::difference_any;
use hardware_model::MachineRecord;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use picture::{AnyPicture, Limits, read_any_png};
use replay::picture_name;

use super::{FrameError, MachineFigures, SideBySide};
use crate::ReportError;
use crate::cells::{grouped, percent, shortened};
use crate::machine_section::{omissions, plain};
use crate::page::head;
use crate::run::Run;
use crate::strip::{fitted, spread};

/// Frames that are shown, at most.
const ROWS: u64 = 6;
/// Columns of a picture on the page, at most: three of them fill its width.
const COLUMNS: usize = 640;
/// How many times a difference is enlarged.
const FACTOR: u32 = 4;

const OWN_STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// The page of `runs` in `folder`.
pub(crate) fn page(
    folder: &Path,
    runs: &[(String, Run)],
    figures: &SideBySide,
) -> Result<Markup, ReportError> {
    let (_, first) = runs.first().expect("runs stand side by side");
    let reference = figures.reference.as_deref();
    let frames = frames(folder, runs, reference)?;
    Ok(html! {
        (DOCTYPE)
        html lang="en" {
            (head(&format!("{} – side by side", figures.title), OWN_STYLE))
            body.wide-page {
                header.masthead {
                    div.running { span.house { "lunoid" } span { (if reference.is_some() { "Machines side by side" } else { "Views side by side" }) } }
                    h1 { (figures.title) }
                    p.abstract { (first.scenario.shows) }
                }
                main {
                    @if let Some(reference) = reference { (errors(figures, reference)) }
                    (frames)
                    @if reference.is_none() { (views(runs, figures)) }
                    (laws(runs))
                    (left_out(runs))
                    (every_frame(figures))
                }
                (enlarged(first, reference))
                script { (PreEscaped(SCRIPT)) }
            }
        }
    })
}

/// The window in which a frame is enlarged; the script opens it.
fn enlarged(run: &Run, reference: Option<&str>) -> Markup {
    html! {
        dialog #large aria-labelledby="large-says" data-judge=(reference.unwrap_or_default())
            data-columns=(run.view.columns) data-lines=(run.view.lines) {
            p #large-says aria-live="polite" {}
            img #large-picture alt="" style=(format!("--Aspect:{0:.6};aspect-ratio:{0:.6}", run.aspect()));
            div.controls {
                button #large-before type="button" { "Machine before" }
                button #large-next type="button" { "Next machine" }
                button #large-blink type="button" aria-pressed="false" { "Blink" }
                button #large-close type="button" { "Close" }
                span { "Column, line: " output #large-place { "–" } }
            }
        }
    }
}

/// The table that says which is how good at what cost.
fn errors(figures: &SideBySide, reference: &str) -> Markup {
    html! {
        section #errors aria-labelledby="errors-title" {
            h2 #errors-title { "Error and time" }
            p.lead { "Against " b { (reference) } ", over all pixels of all frames that both have. Root mean square, SSIM "
                "and shares are means over the frames, followed by the worst frame. The horizon is off by so many lines in half "
                "the columns and in 99 of 100, in the worst frame. Shadow agrees where a pixel of the ground is dark in both pictures or in "
                "neither." }
            div.wide tabindex="0" role="group" aria-label="Error and time" { table.figures {
                thead { tr { @for name in ["Machine", "RMSE", "SSIM", "More than 2 levels off", "Horizon, lines", "Shadow agrees",
                    "Time of a frame"] { th scope="col" { (name) } } } }
                tbody { @for machine in &figures.machines { (row(machine)) } }
            } }
        }
    }
}

fn row(machine: &MachineFigures) -> Markup {
    let errors = machine.errors.as_deref().unwrap_or_default();
    let most = |value: fn(&FrameError) -> f64| errors.iter().map(value).fold(f64::NEG_INFINITY, f64::max);
    let least = |value: fn(&FrameError) -> f64| {
        -errors.iter().map(value).map(|value| -value).fold(f64::NEG_INFINITY, f64::max)
    };
    let mean = |value: fn(&FrameError) -> f64| errors.iter().map(value).sum::<f64>() / errors.len() as f64;
    let horizon = |rank: usize| errors.iter().map(|error| error.horizon_lines[rank]).max().unwrap_or(0);
    let rmse = |error: &FrameError| error.rmse;
    let ssim = |error: &FrameError| error.ssim.unwrap_or(1.0);
    let beyond = |error: &FrameError| error.beyond_two_levels;
    let shadow = |error: &FrameError| error.shadow_agreement;
    html! {
        tr {
            th scope="row" { a href=(format!("{}/index.html", machine.name)) { (machine.name) } }
            @if errors.is_empty() {
                td colspan="5" { @if machine.errors.is_none() { "what the others are held against" } @else { "no frame in common" } }
            } @else {
                td { (shortened(mean(rmse), 5)) " " small { (shortened(most(rmse), 5)) } }
                td { (shortened(mean(ssim), 4)) " " small { (shortened(least(ssim), 4)) } }
                td { (percent(mean(beyond))) " " small { (percent(most(beyond))) } }
                td { (horizon(0)) ", " (horizon(1)) }
                td { (percent(mean(shadow))) " " small { (percent(least(shadow))) } }
            }
            td { (time(machine)) }
        }
    }
}

/// How each view is turned, what it shows, and what it took.
fn views(runs: &[(String, Run)], figures: &SideBySide) -> Markup {
    let degrees = |value: f64| format!("{}°", shortened(value, 2));
    html! {
        section #views aria-labelledby="views-title" {
            h2 #views-title { "Views" }
            div.wide tabindex="0" role="group" aria-label="Views" { table.figures {
                thead { tr { @for name in ["View", "Heading", "Pitch", "Roll", "Field", "Time of a frame"] {
                    th scope="col" { (name) } } } }
                tbody { @for ((name, run), machine) in runs.iter().zip(&figures.machines) { tr {
                    th scope="row" { a href=(format!("{name}/index.html")) { (name) } }
                    @for angle in run.channel.iter().flat_map(|of| [of.heading_deg, of.pitch_deg, of.roll_deg]) {
                        td { (degrees(angle)) } }
                    td { (run.view.field_of_view_deg.map(degrees).join(" × ")) }
                    td { (time(machine)) }
                } } }
            } }
        }
    }
}

fn time(machine: &MachineFigures) -> String {
    let Some((time, seconds)) = machine.time.and_then(|time| Some((time, time.of_a_frame()?))) else {
        return "not kept".into();
    };
    let threads = if time.threads == 1 { "thread" } else { "threads" };
    format!("{} ms, {} frames on {} {threads}", shortened(1e3 * seconds, 1), time.frames_drawn, time.threads)
}

/// Frames in columns; below each its difference from the reference, if there is one.
fn frames(folder: &Path, runs: &[(String, Run)], reference: Option<&str>) -> Result<Markup, ReportError> {
    let (_, first) = runs.first().expect("runs stand side by side");
    let chosen = spread(0, first.frames.len() as u64, ROWS);
    let rows = chosen.into_iter().map(|at| {
        let record = &first.frames[at as usize];
        let cells = runs.iter().map(|(name, run)| cell(folder, (name, run), reference, record.frame));
        Ok((record.frame, record.time_s, cells.collect::<Result<Vec<_>, _>>()?))
    });
    let rows = rows.collect::<Result<Vec<_>, ReportError>>()?;
    let style = format!("grid-template-columns:repeat({}, minmax(0, 1fr))", runs.len());
    Ok(html! {
        section #frames aria-labelledby="frames-title" {
            h2 #frames-title { "Frames" }
            p.lead { (rows.len()) " of " (first.frames.len()) " frames, evenly spread. " @if first.view.columns as usize > COLUMNS {
                "They are made smaller. " }
                "A click enlarges one; there the arrow keys go from machine to machine, and B blinks between two. "
                @if let Some(reference) = reference { "Below each is its difference from " b { (reference) } ", " (FACTOR)
                    " times enlarged: grey is equal, brighter is brighter." } }
            @for (frame, time, cells) in &rows {
                h3 { "Frame " (frame) ", " (shortened(*time, 2)) " s" }
                div.side style=(style) { @for cell in cells { (cell) } }
            }
        }
    })
}

fn cell(
    folder: &Path,
    (name, run): (&str, &Run),
    reference: Option<&str>,
    frame: u64,
) -> Result<Markup, ReportError> {
    let picture = picture_name(frame * run.showings());
    let path = folder.join(name).join(&picture);
    let Some(whole) = path.exists().then(|| read_any_png(&path, &Limits::default())).transpose()? else {
        return Ok(html! { div { p.whose { (name) ": not drawn" } } });
    };
    let judge =
        reference.filter(|judge| *judge != name).map(|judge| (judge, folder.join(judge).join(&picture)));
    let difference = match judge.filter(|(_, file)| file.exists()) {
        Some((judge, file)) => {
            let of_judge = read_any_png(&file, &Limits::default())?;
            let refused = |source| ReportError::Compare { path: path.clone(), source };
            let difference = difference_any(&whole, &of_judge, FACTOR).map_err(refused)?;
            Some((judge, shown(&path, &difference, run)?))
        }
        None => None,
    };
    let shown = shown(&path, &whole.to_eight_bits(), run)?;
    Ok(html! {
        div {
            p.whose { (name) }
            a href=(format!("{name}/{picture}")) data-machine=(name) data-frame=(frame) { img src=(shown) loading="lazy" alt=(format!("Frame {frame} by {name}"))
                style=(format!("aspect-ratio:{:.6}", run.aspect())); }
            @if let Some((judge, url)) = difference { img src=(url) loading="lazy" alt=(format!("Difference of {name} from {judge}"))
                style=(format!("aspect-ratio:{:.6}", run.aspect())); }
        }
    })
}

/// A picture as a `data:` URL, no wider than the page shows it.
fn shown(path: &Path, picture: &AnyPicture, run: &Run) -> Result<String, ReportError> {
    let refused = |source| ReportError::Strip { path: path.to_owned(), source };
    let png = fitted(picture, run, COLUMNS).map_err(refused)?.encode_png(&[]).map_err(refused)?;
    Ok(text::data_url("image/png", &png))
}

/// Laws and rasters: what differs by them is no error of parts.
fn laws(runs: &[(String, Run)]) -> Markup {
    let (_, first) = runs.first().expect("runs stand side by side");
    let of = |run: &Run, law: &str| run.view.laws.get(law).cloned().unwrap_or_default();
    let raster = |run: &Run| {
        let of = |machine: &MachineRecord| machine.raster.counts().map(grouped).join(" × ");
        run.machine.as_ref().map_or_else(|| "none".into(), of)
    };
    let keys: BTreeSet<&String> = runs
        .iter()
        .filter_map(|(_, run)| run.machine.as_ref())
        .flat_map(|machine| machine.range.keys())
        .collect();
    let range = |run: &Run, key: &String| {
        let found = run.machine.as_ref().and_then(|machine| machine.range.get(key));
        found.map_or_else(String::new, plain)
    };
    html! {
        section #laws aria-labelledby="laws-title" {
            h2 #laws-title { "Settings" }
            div.wide tabindex="0" role="group" aria-label="Settings" { table {
                thead { tr { th scope="col" { "Setting" } @for (name, _) in runs { th scope="col" { (name) } } } }
                tbody {
                    tr { th scope="row" { "sweeps × samples" } @for (_, run) in runs { td { (raster(run)) } } }
                    tr { th scope="row" { "economy" } @for (_, run) in runs { td { (economy(run)) } } }
                    @for law in first.view.laws.keys() {
                        tr { th scope="row" { (law.replace('_', " ")) } @for (_, run) in runs { td { (of(run, law)) } } }
                    }
                    @for key in &keys {
                        tr { th scope="row" { "range: " (key.replace('_', " ")) }
                            @for (_, run) in runs { td { (range(run, key)) } } }
                    }
                }
            } }
        }
    }
}

/// What a run was allowed to leave out: a preview, or the whole picture.
fn economy(run: &Run) -> &str {
    match run.machine.as_ref().map(|machine| machine.economy.as_str()) {
        Some("preview") => "preview: signals at the samples alone",
        Some(word) => word,
        None => "drawn whole",
    }
}

fn left_out(runs: &[(String, Run)]) -> Markup {
    html! {
        section #left-out aria-labelledby="left-out-title" {
            h2 #left-out-title { "Left out" }
            @for (name, run) in runs { h3 { (name) } (omissions(&run.omissions)) }
        }
    }
}

fn every_frame(figures: &SideBySide) -> Markup {
    let machines: Vec<(&str, &[FrameError])> = figures
        .machines
        .iter()
        .filter_map(|machine| Some((machine.name.as_str(), machine.errors.as_deref()?)))
        .collect();
    let Some((_, frames)) = machines.first() else { return html! {} };
    html! {
        section #every-frame aria-labelledby="every-title" {
            h2 #every-title { "Frame by frame" }
            details {
                summary { "RMSE and shadow agreement of " (frames.len()) " frames; " code { (super::SIDE_BY_SIDE) } " has the rest" }
                div.wide tabindex="0" role="group" aria-label="Error of every frame" { table {
                    thead { tr { th scope="col" { "Frame" } @for (name, _) in &machines { th scope="col" { (name) } } } }
                    tbody { @for error in *frames { tr {
                        th scope="row" { (error.frame) }
                        @for (_, errors) in &machines { td { @if let Some(error) = errors.iter().find(|other| other.frame == error.frame) {
                            (shortened(error.rmse, 5)) ", " (percent(error.shadow_agreement)) } } }
                    } } }
                } }
            }
        }
    }
}
