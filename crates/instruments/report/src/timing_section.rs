//! Timing of the digital side.

use maud::{Markup, html};
use timing::{BINS, Slack};

use crate::cells::{duration, grouped, percent};
use crate::data::shell_words;
use crate::{Beside, DeadlineLine, TimingSummary, UnitLine};

/// Returns the section about timing.
pub(crate) fn timing(beside: &Beside, takes_time: bool) -> Markup {
    html! {
        section #timing aria-labelledby="timing-title" {
            h2 #timing-title { "Timing" }
            @match &beside.timing {
                Some(summary) if summary.deadlines.is_empty() => (program(summary, beside)),
                Some(summary) => (summary_of(summary, beside)),
                None if takes_time => p { "Not summed up for this folder. The same " code { "lunoid replay" } " again does it." },
                None => p { "A closed form takes no time: there is nothing that could be late." },
            }
        }
    }
}

fn summary_of(summary: &TimingSummary, beside: &Beside) -> Markup {
    let missed: u64 = summary.deadlines.iter().map(|line| line.slack.missed).sum();
    html! {
        p.lead {
            (frames(&summary.frames)) ". "
            @if missed == 0 { "Every deadline was met." } @else { b.bad { (grouped(missed)) " deadlines were missed." } }
            " " (grouped(summary.folds)) " folds, " (grouped(summary.sets.wanted)) " register sets wanted, "
            (grouped(summary.sets.late)) " late, " (grouped(summary.late_words)) " words late."
        }
        (deadlines(summary))
        div.columns {
            div { h3 { "Units at work" } (units(&summary.units)) }
            div { h3 { "Misses by cause" } (causes(summary)) }
        }
        @if !summary.sweeps.is_empty() { (misses_by_sweep(summary, beside)) }
        (all_of_it(beside))
    }
}

/// A program has no deadlines: it takes the time that it takes.
fn program(summary: &TimingSummary, beside: &Beside) -> Markup {
    let mean_s = summary.ticks as f64 * summary.tick_s / summary.frames.len().max(1) as f64;
    html! {
        p.lead {
            (frames(&summary.frames)) ". A frame takes " (format!("{mean_s:.1}")) " s of the gear of 1969, by the operations "
            "that were counted. There are no deadlines."
        }
        h3 { "Units at work" } (units(&summary.units))
        (all_of_it(beside))
    }
}

fn all_of_it(beside: &Beside) -> Markup {
    html! {
        @if !beside.stage.is_empty() {
            p.more { "All of it: " code { "lunoid timing show " (shell_words(&beside.stage)) } }
        }
    }
}

fn frames(frames: &[u64]) -> String {
    let words: Vec<String> = frames.iter().map(ToString::to_string).collect();
    match words.as_slice() {
        [one] => format!("Frame {one}"),
        many => format!("{} frames of the run ({})", many.len(), many.join(", ")),
    }
}

fn deadlines(summary: &TimingSummary) -> Markup {
    html! {
        div.wide tabindex="0" role="group" aria-label="Deadlines" { table.numbers {
            thead { tr { th scope="col" { "Deadline" } th scope="col" { "Met" } th scope="col" { "Missed" }
                th scope="col" { "Least slack" } th scope="col" { "In frame" }
                th.bins scope="col" { "Slack" small { "missed | met" } } } }
            tbody { @for line in &summary.deadlines { tr {
                th scope="row" { (line.deadline.word()) }
                td { (grouped(line.slack.count - line.slack.missed.min(line.slack.count))) }
                td.bad[line.slack.missed > 0] { (grouped(line.slack.missed)) }
                td { (least(line, summary.tick_s)) }
                td { @match line.worst_frame { Some(frame) => a href=(format!("#frame={frame}")) { (frame) }, None => "–" } }
                td.bins { (histogram(&line.slack)) }
            } } }
        } }
    }
}

fn least(line: &DeadlineLine, tick_s: f64) -> String {
    line.slack.least.map_or("–".into(), |ticks| duration(ticks as f64 * tick_s))
}

/// Deadlines by slack; the root of a count is its height, so that one miss among thousands is seen.
fn histogram(slack: &Slack) -> Markup {
    let most = slack.bins.iter().copied().max().unwrap_or(0).max(1) as f64;
    let height = |count: u64| if count == 0 { 0.0 } else { (26.0 * (count as f64 / most).sqrt()).max(1.5) };
    let labels = slack.histogram();
    html! {
        svg.histogram viewBox="0 0 132 30" width="132" height="30" role="img"
            aria-label=(format!("{} of {} missed", slack.missed, slack.count)) {
            line.axis x1="0" x2="132" y1="28" y2="28" {}
            line.zero x1="66" x2="66" y1="0" y2="30" {}
            @for (bin, (label, _)) in labels.iter().enumerate() {
                @let tall = height(slack.bins[bin]);
                @if tall > 0.0 {
                    rect.late[bin < BINS / 2] x=(format!("{:.2}", 2.0 + 8.0 * bin as f64)) y=(format!("{:.2}", 28.0 - tall))
                        width="7" height=(format!("{tall:.2}")) { title { (label) " ticks: " (grouped(slack.bins[bin])) } }
                }
            }
        }
    }
}

fn units(units: &[UnitLine]) -> Markup {
    if units.is_empty() {
        return html! { p { "The model has no unit that takes time." } };
    }
    let (busy, at_rest): (Vec<_>, Vec<_>) =
        units.iter().partition(|unit| unit.most > 0.0 || unit.longest_queue > 0);
    html! {
        div.wide tabindex="0" role="group" aria-label="Units at work" { table.numbers.units {
            thead { tr { th scope="col" { "Unit" } th.bar scope="col" { "At work" } th scope="col" { "Mean" }
                th scope="col" { "Most" } th scope="col" { "Queue" } } }
            tbody { @for unit in &busy { tr {
                th scope="row" { (unit.unit) }
                td.bar { (bar(unit)) }
                td { (percent(unit.mean)) }
                td.bad[unit.most > 1.0] { (percent(unit.most)) }
                td { (unit.longest_queue) }
            } } }
        } }
        @if !at_rest.is_empty() {
            p.rest { "At rest throughout: "
                (at_rest.iter().map(|unit| unit.unit.as_str()).collect::<Vec<_>>().join(", ")) "." }
        }
    }
}

/// Mean as a bar, idlest to busiest frame as a line over it.
fn bar(unit: &UnitLine) -> Markup {
    let at = |share: f64| format!("{:.2}", 100.0 * share.clamp(0.0, 1.0));
    let reach = format!("{:.2}", 100.0 * (unit.most.clamp(0.0, 1.0) - unit.least.clamp(0.0, 1.0)).max(0.0));
    html! {
        svg.share viewBox="0 0 100 10" preserveAspectRatio="none" aria-hidden="true" {
            rect.room x="0" y="1" width="100" height="8" {}
            rect.use.over[unit.most > 1.0] x="0" y="1" width=(at(unit.mean)) height="8" {}
            rect.reach x=(at(unit.least)) y="4" width=(reach) height="2" {}
        }
    }
}

fn causes(summary: &TimingSummary) -> Markup {
    if summary.causes.is_empty() {
        return html! { p { "There are none." } };
    }
    html! {
        table.numbers { tbody { @for (cause, count) in &summary.causes {
            tr { th scope="row" { (cause.word()) } td { (grouped(*count)) } }
        } } }
    }
}

/// Misses over the columns of the picture.
fn misses_by_sweep(summary: &TimingSummary, beside: &Beside) -> Markup {
    let sweeps = beside.sight.as_ref().map_or(0, |sight| sight.sweeps);
    let last = summary.sweeps.iter().map(|(sweep, _)| sweep + 1).max().unwrap_or(1);
    let width = sweeps.max(last);
    let most = summary.sweeps.iter().map(|(_, misses)| *misses).max().unwrap_or(1).max(1);
    let path: String = summary
        .sweeps
        .iter()
        .map(|(sweep, misses)| format!("M{sweep} 40h1v-{:.2}h-1z", 40.0 * *misses as f64 / most as f64))
        .collect();
    html! {
        figure.plate {
            svg.misses viewBox=(format!("0 0 {width} 40")) preserveAspectRatio="none" role="img"
                aria-label="Misses by sweep" { path d=(path) {} }
            figcaption { "Misses by sweep, left to right as in the picture; the most are " (grouped(most))
                ", summed over the frames above." }
        }
    }
}
