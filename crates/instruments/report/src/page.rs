//! Writes the whole page of a run.

use std::io::Write;
use std::path::{Path, PathBuf};

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::data::{data, in_script};
use crate::film::film;
use crate::live::LIVE_POLICY;
use crate::machine_section::machine;
use crate::masthead::masthead;
use crate::record_section::{error, record};
use crate::run::Run;
use crate::scope_section::scopes;
use crate::strip::strip;
use crate::timing_section::timing;
use crate::viewer::{contact_sheet, viewer};
use crate::{Beside, ReportError};

const STYLE: &str = include_str!("page.css");
const THEME: &str = include_str!("theme.js");
const SCRIPT: &str = include_str!("page.js");
const SCOPES: &str = include_str!("page-scope.js");

/// Nothing from anywhere but this file and the folder that it lies in.
const POLICY: &str = "default-src 'none'; img-src 'self' file: data:; style-src 'unsafe-inline'; \
                      script-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";

const SECTIONS: [(&str, &str); 7] = [
    ("picture", "Picture"),
    ("contact-sheet", "Contact sheet"),
    ("machine", "Machine"),
    ("timing", "Timing"),
    ("waveforms", "Waveforms"),
    ("error", "Error"),
    ("record", "Record"),
];

/// Which page of a run is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// One file that needs nothing else.
    Whole,
    /// The page that a program serves, whose unrecorded sweeps that program computes.
    Served,
}

/// Writes the page of the finished run in `folder`, from what the folder holds; where it is. A page that is there and
/// right is not touched.
///
/// # Errors
/// If the folder holds no finished run, its files are not what a run writes, or the page cannot be written.
pub fn write_page(folder: &Path) -> Result<PathBuf, ReportError> {
    let text = page(folder, Kind::Whole)?.into_string();
    let text = text::visible(&text);
    let path = folder.join(replay::PAGE);
    if !files::holds(&path, text.as_bytes()) {
        files::write_atomic(&path, |out: &mut dyn Write| out.write_all(text.as_bytes()))?;
    }
    Ok(path)
}

/// The page of the finished run in `folder` as a program serves it, with [`LIVE_FILES`](crate::LIVE_FILES) beside it: a sweep that was not recorded is
/// computed on a click. Nothing is written.
///
/// # Errors
/// If the folder holds no finished run, or its files are not what a run writes.
pub fn live_page(folder: &Path) -> Result<String, ReportError> {
    let text = page(folder, Kind::Served)?.into_string();
    Ok(text::visible(&text).into_owned())
}

/// The head of a page with a style of its own beside that of all pages.
pub(crate) fn head(title: &str, own_style: &str) -> Markup {
    head_with(title, own_style, POLICY)
}

/// The same with another content security policy.
pub(crate) fn head_with(title: &str, own_style: &str, policy: &str) -> Markup {
    html! {
        head {
            meta charset="utf-8";
            meta name="generator" content="lunoid";
            meta http-equiv="Content-Security-Policy" content=(policy);
            meta name="viewport" content="width=device-width, initial-scale=1";
            meta name="color-scheme" content="light dark";
            link rel="icon" href="data:,";
            title { (title) }
            style { (PreEscaped(STYLE)) (PreEscaped(own_style)) }
            script { (PreEscaped(THEME)) }
        }
    }
}

fn page(folder: &Path, kind: Kind) -> Result<Markup, ReportError> {
    let is_served = kind == Kind::Served;
    let run = Run::read(folder)?;
    let beside = Beside::read(folder, &run.fingerprint)?;
    let strip = strip(folder, &run)?;
    let film = film(folder, &run)?;
    let waveforms = scopes(folder, &beside, run.line.as_deref())?;
    let data = in_script(&data(&run, &beside, &strip, &film));
    Ok(html! {
        (DOCTYPE)
        html lang="en" {
            (head_with(&format!("{} – run of lunoid", run.scenario.title), "", if is_served { LIVE_POLICY } else { POLICY }))
            body {
                a.skip href="#picture" { "To the picture" }
                (masthead(&run))
                nav.contents aria-label="Sections" { ol { @for (id, title) in SECTIONS { li { a href=(format!("#{id}")) { (title) } } } } }
                main {
                    (viewer(&run, &film))
                    (contact_sheet(&run, &strip, &film))
                    (machine(&run))
                    (timing(&beside, run.line.is_some()))
                    (waveforms)
                    (error(&run, &beside))
                    (record(&run))
                }
                script #data type="application/json" { (PreEscaped(data)) }
                // The page works before its frames are read.
                script { (PreEscaped(SCRIPT)) }
                @if is_served || !beside.waves.is_empty() {
                    script { (PreEscaped(scope::live_script())) }
                    script { (PreEscaped(SCOPES)) }
                }
                @if is_served { script type="module" src="live-sweep.js" {} }
                (film.elements())
            }
        }
    })
}
