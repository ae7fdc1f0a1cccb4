//! Waveforms of recorded sweeps.

use std::path::Path;

use maud::{Markup, html};
use text::named_signals;

use crate::data::{embedded, shell_words};
use crate::{Beside, ReportError, ScopePlot};

/// Bytes of plots that are part of the page; the others are read from beside it. Several hundred fit.
const MOST_EMBEDDED: u64 = 32 << 20;
const MAX_BYTES: u64 = 1 << 28;

/// Returns the section of recorded waveforms.
pub(crate) fn scopes(folder: &Path, beside: &Beside, line: Option<&str>) -> Result<Markup, ReportError> {
    let sources = sources(folder, &beside.scopes)?;
    Ok(html! {
        section #waveforms aria-labelledby="waveforms-title" {
            h2 #waveforms-title { "Waveforms" }
            @match line {
                None => p { "There are no sweeps, and no signals." },
                Some(line) => {
                    @if beside.scopes.is_empty() { (how_to_record(beside, line)) }
                    @for (plot, source) in beside.scopes.iter().zip(&sources) {
                        (figure(plot, source, line, beside.sight.is_some(), has_values(beside, plot)))
                    }
                }
            }
        }
    })
}

fn how_to_record(beside: &Beside, line: &str) -> Markup {
    html! {
        @if beside.sight.is_some() {
            p { "No sweep was recorded. Click a column of the picture for the commands that look into its sweep, or record "
                "some with the run:" }
        } @else {
            p { "No " (line) " was recorded. Record some with the run:" }
        }
        p.more { code { "lunoid replay " (shell_words(&beside.stage)) " --probe FRAME:" (line.to_uppercase()) } }
    }
}

/// Whether the page has the values of a plot.
fn has_values(beside: &Beside, plot: &ScopePlot) -> bool {
    embedded(&beside.waves).iter().any(|of| (of.frame, of.sweep) == (plot.frame, plot.sweep))
}

/// A sweep that is seen as a column can be shown in the picture; a row of a grid is seen nowhere as a line.
fn figure(plot: &ScopePlot, source: &str, line: &str, is_seen: bool, has_values: bool) -> Markup {
    let ScopePlot { frame, sweep, .. } = plot;
    html! {
        figure.plate.scope id=(format!("scope-{frame}-{sweep}")) tabindex="-1" {
            a.sheet-of href=(plot.file()) { img src=(source) loading="lazy" decoding="async"
                alt=(format!("Waveforms of {line} {sweep} of frame {frame}")); }
            figcaption {
                b { "Frame " (frame) ", " (line) " " (sweep) "." } " " (named_signals(&plot.signals, &plot.asked)) ". "
                @if is_seen {
                    button.needs-script type="button" data-frame=(frame) data-sweep=(sweep) { "Show in the picture" }
                }
            }
            @if has_values {
                details.live.needs-script data-frame=(frame) data-of=(sweep) { summary { "Values, zoom and X-Y" } }
            }
        }
    }
}

/// Where each plot is read from: the page itself, as long as there is room.
fn sources(folder: &Path, plots: &[ScopePlot]) -> Result<Vec<String>, ReportError> {
    let mut room = MOST_EMBEDDED;
    let source = |plot: &ScopePlot| {
        let bytes = files::read_all(folder.join(plot.file()), MAX_BYTES)?;
        match room.checked_sub(bytes.len() as u64) {
            Some(left) => {
                room = left;
                Ok(text::data_url(replay::SCOPE_KIND, &bytes))
            }
            None => Ok(plot.file()),
        }
    };
    plots.iter().map(source).collect()
}
