//! The machine that drew: its blocks, what was left out and why, its work, its parts.

use maud::{Markup, html};
use run_record::{OmissionRecord, WeightRecord};
use serde_json::Value;

use crate::cells::{grouped, shortened};
use crate::diagram::diagram;
use crate::run::Run;

/// Returns the section about the machine.
pub(crate) fn machine(run: &Run) -> Markup {
    html! {
        section #machine aria-labelledby="machine-title" {
            h2 #machine-title { "Machine" }
            @if run.has_sweeps() {
                p.lead { "The hybrid machine with the parts of " b { (run.model.name) } ", as it was elaborated for this scene." }
                figure.plate {
                    (diagram(&run.omissions))
                    figcaption { "Blocks and wires. Broken lines: left out with all that joins them. A dot: parts of it are left out." }
                }
            } @else {
                p.lead { "Drawn by " b { (run.generator) } ", without the blocks and sweeps of the hybrid machine." }
            }
            h3 { "Left out" }
            (omissions(&run.omissions))
            div.columns {
                div { h3 { "Work" } (work(run)) }
                div { h3 { "Laws and range" } (laws(run)) }
            }
            @if run.has_sweeps() { (parts(run)) }
        }
    }
}

pub(crate) fn omissions(list: &[OmissionRecord]) -> Markup {
    if list.is_empty() {
        return html! { p { "Nothing was left out." } };
    }
    html! {
        div.wide tabindex="0" role="group" aria-label="What was left out" { table.omissions {
            thead { tr { th scope="col" { "Block" } th scope="col" { "What" } th scope="col" { "Why" }
                th scope="col" { "Difference to the picture" } } }
            tbody { @for omission in list { tr {
                th scope="row" { (omission.block) }
                td { (omission.what) }
                td { (omission.why) }
                td.weight.lossless[omission.weight == WeightRecord::Lossless] { (weight(omission.weight)) }
            } } }
        } }
    }
}

fn weight(weight: WeightRecord) -> String {
    match weight {
        WeightRecord::Lossless => "none: the same bits".into(),
        WeightRecord::NotModelled => "not modelled".into(),
        WeightRecord::Bounded(levels) => format!("at most {} grey levels of 255", shortened(levels, 2)),
    }
}

/// What the run took; counters that are zero are not named.
fn work(run: &Run) -> Markup {
    let rows = run.totals.named().filter(|(_, count)| *count > 0);
    html! {
        table.counts { tbody { @for (name, count) in rows {
            tr { th scope="row" { (name.replace('_', " ")) } td { (grouped(count)) } }
        } } }
    }
}

fn laws(run: &Run) -> Markup {
    let laws = run.view.laws.iter().map(|(law, word)| (law.replace('_', " "), word.clone()));
    let range = run.machine.iter().flat_map(|machine| &machine.range);
    let range = range.map(|(key, value)| (key.replace('_', " "), plain(value)));
    html! {
        table.counts { tbody {
            @for (name, value) in laws.chain(range) { tr { th scope="row" { (name) } td { (value) } } }
            @if let Some(machine) = &run.machine {
                tr { th scope="row" { "scalar" } td { (machine.scalar) } }
                tr { th scope="row" { "sample clock" } td { (machine.clocks.sample) } }
                tr { th scope="row" { "master clock" } td { (machine.clocks.master) } }
            } @else {
                tr { th scope="row" { "range" } td { (ranges(run)) } }
            }
        } }
    }
}

/// Where ground begins and ends to be seen.
fn ranges(run: &Run) -> String {
    let [near, far] = run.view.ranges_m.map(|range| shortened(range, 2));
    format!("{near} to {far} m")
}

/// A value without the quotation marks of JSON.
pub(crate) fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => number.as_f64().map_or(number.to_string(), |value| shortened(value, 6)),
        other => other.to_string(),
    }
}

/// Returns the table of all values of the effective model.
fn parts(run: &Run) -> Markup {
    html! {
        details {
            summary { "Hardware model: " (run.model.values.len()) " values of " (run.model.name) }
            div.wide tabindex="0" role="group" aria-label="Hardware model" { table {
                thead { tr { th scope="col" { "Key" } th scope="col" { "Value" } th scope="col" { "From" } } }
                tbody { @for value in &run.model.values { tr {
                    th scope="row" { (value.key) } td { (value.value) } td.origin { (value.origin) }
                } } }
            } }
        }
    }
}
