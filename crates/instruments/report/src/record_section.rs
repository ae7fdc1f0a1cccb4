//! Error, and the record from which the page was made.

use maud::{Markup, html};
use run_record::{CheckRecord, CheckedSweep, FileRecord};

use crate::data::shell_words;
use crate::run::Run;
use crate::{Beside, check_plot};

/// How far the pictures are from `exact`.
pub(crate) fn error(run: &Run, beside: &Beside) -> Markup {
    html! {
        section #error aria-labelledby="error-title" {
            h2 #error-title { "Error" }
            @match &run.check {
                Some(check) => (figures(check)),
                None if !run.has_sweeps() => p { "The run is its own reference: " (run.generator) " is what error is measured against." },
                None => (unchecked(run, beside)),
            }
        }
    }
}

fn figures(check: &CheckRecord) -> Markup {
    let percent = 100.0 * check.confidence;
    html! {
        p { (check.sweeps) " sweeps, drawn at random and spread over the run, against the closed form: signals sample by sample, and
            the column of the picture at the sweep. Intervals hold the error of all sweeps with " (percent) " % confidence ("
            (check.interval_by) "). performance.json has the time that it took." }
        table.counts {
            thead { tr { th { "error" } th { "root mean square" } th { "interval" } th { "largest" } } }
            tbody { @for error in &check.errors { tr {
                th scope="row" { (error.error) @if error.unit != "1" { " (" (error.unit) ")" } }
                td { (figure(error.rms)) }
                td { @match error.interval {
                    Some([low, high]) => { (figure(low)) " to " (figure(high)) }
                    None => "of one sweep none",
                } }
                td { (figure(error.max)) }
            } } }
        }
        (check_plot::plot(&check.checked))
        (worst(check))
    }
}

/// Where the picture is worst, of the sweeps that were checked.
fn worst(check: &CheckRecord) -> Markup {
    let rms = |sweep: &CheckedSweep| sweep.rms_and_max[0].map_or(0.0, |[rms, _]| rms);
    let worst = check.checked.iter().max_by(|a, b| rms(a).total_cmp(&rms(b)));
    html! {
        @if let Some(sweep) = worst {
            p { "The largest error of a column: " (figure(rms(sweep))) ", "
                a href=(format!("#frame={}&sweep={}", sweep.frame, sweep.sweep)) {
                    "frame " (sweep.frame) ", sweep " (sweep.sweep)
                } "." }
        }
    }
}

/// Returns a number with four decimals, or with three digits and an exponent.
fn figure(value: f64) -> String {
    if value == 0.0 || (1e-3..1e4).contains(&value) { format!("{value:.4}") } else { format!("{value:.2e}") }
}

fn unchecked(run: &Run, beside: &Beside) -> Markup {
    let (first, end) = (run.frames[0].frame, run.frames[run.frames.len() - 1].frame + 1);
    let (all, end) = (end, end.min(first + 2));
    let frames = format!("--frames {first}..{end}{}", run.picture_words());
    html! {
        p { "Not checked. Twenty sweeps of this run, and its first frames, against the closed form:" }
        pre.more { code {
            "lunoid replay " (shell_words(&beside.stage)) " " (format!("--frames {}..{}{}", first, all, run.picture_words())) " --check 20\n"
            "lunoid replay " (shell_words(&exact_words(&beside.stage))) " " (frames) " --out runs/exact\n"
            "lunoid replay " (shell_words(&beside.stage)) " " (frames) " --out runs/checked\n"
            "lunoid compare runs/checked runs/exact"
        } }
    }
}

/// The words of the stage, drawn by `exact`.
fn exact_words(words: &[String]) -> Vec<String> {
    let mut kept: Vec<String> = Vec::with_capacity(words.len() + 2);
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match word.as_str() {
            "--machine" => drop(words.next()),
            _ => kept.push(word.clone()),
        }
    }
    kept.extend(["--machine", "exact"].map(str::to_owned));
    kept
}

/// What decided the pixels, and the files beside the page.
pub(crate) fn record(run: &Run) -> Markup {
    let program = &run.program;
    let inputs: Vec<&FileRecord> =
        run.scenario.file.iter().chain(&run.references).chain(&run.model.files).collect();
    let own = ["run.json", "performance.json"].into_iter();
    let beside: Vec<&str> = own.chain(run.outputs.iter().map(|output| output.file.as_str())).collect();
    html! {
        section #record aria-labelledby="record-title" {
            h2 #record-title { "Record" }
            p { "Drawn by " (program.name) " " (program.version) ", commit " code { (program.commit) }
                ", result family " (program.result_family) ". Runs of the same fingerprint are equal to the bit." }
            dl.hashes {
                div { dt { "fingerprint" } dd { code { (run.fingerprint) } } }
                @for file in inputs { div { dt { (file.file) } dd { code { (file.blake3) } } } }
            }
            p { "Beside this page: "
                @for (index, file) in beside.iter().enumerate() {
                    @if index > 0 { ", " } a href=(file) { (file) }
                } "." }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::exact_words;

    #[test]
    fn exact_takes_the_place_of_the_machine() {
        let words = ["a.toml", "--machine", "pra-nominal", "--sweeps", "40"].map(str::to_owned);
        assert_eq!(exact_words(&words), ["a.toml", "--sweeps", "40", "--machine", "exact"]);
        assert_eq!(exact_words(&words[..1]), ["a.toml", "--machine", "exact"]);
    }
}
