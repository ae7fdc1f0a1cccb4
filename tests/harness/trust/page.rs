//! `docs/trust.md`: kept results as tables, and what was written by hand.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use serde_json::Value;

use super::coverage::{FileCoverage, stretches};
use super::{EVIDENCE, Evidence, Form, Kept, kept};

/// The page made of the results in `folder`, and of `head.md` and `foot.md` there.
///
/// # Errors
/// If a file cannot be read, or is no result.
pub fn page(folder: &Path) -> Result<String, String> {
    let hand = |name: &str| {
        let path = folder.join(name);
        fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
    };
    let mut text = hand("head.md")?;
    for evidence in EVIDENCE {
        let _ = write!(text, "\n## {}\n\n", evidence.title);
        match evidence.form {
            Form::Awake => match kept::<Value>(folder, evidence.name)? {
                None => not_measured(&mut text, evidence),
                Some(found) => awake(&mut text, evidence, &found),
            },
            _ => match kept::<Kept>(folder, evidence.name)? {
                None => not_measured(&mut text, evidence),
                Some(found) => section(&mut text, evidence, &found),
            },
        }
    }
    text.push('\n');
    Ok(text + &hand("foot.md")?)
}

fn not_measured(text: &mut String, evidence: &Evidence) {
    let _ = writeln!(text, "Not measured yet: `{}`.", evidence.command);
}

fn section(text: &mut String, evidence: &Evidence, kept: &Kept) {
    let Kept { date, commit, command, seconds, passed, said } = kept;
    let outcome = if *passed { "held" } else { "**did not hold**" };
    let _ = writeln!(text, "{outcome}, {date}, commit {commit}, {seconds} s:\n\n```sh\n{command}\n```\n");
    let whole = said.join("\n");
    if let (Form::Coverage, Ok(files)) = (evidence.form, serde_json::from_str::<Vec<FileCoverage>>(&whole)) {
        return coverage(text, &files);
    }
    match (evidence.form, serde_json::from_str::<Value>(&whole)) {
        (Form::Cartridges, Ok(found)) => cartridges(text, &found),
        (Form::Lockstep, Ok(found)) => lockstep(text, &found),
        // A command that ended before its table was whole.
        (Form::Cartridges | Form::Lockstep, Err(_)) if whole.is_empty() => {
            text.push_str("It printed nothing.\n")
        }
        _ => {
            let _ = writeln!(text, "```text\n{whole}\n```");
        }
    }
}

/// A member of a JSON object as text, numbers to three digits.
fn cell(value: &Value, key: &str) -> String {
    match &value[key] {
        Value::String(text) => text.replace('|', "/"),
        Value::Number(number) => match number.as_f64() {
            Some(number) if number.fract() != 0.0 => format!("{number:.2e}"),
            _ => number.to_string(),
        },
        other => other.to_string(),
    }
}

fn list<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value[key].as_array().map_or(&[], Vec::as_slice)
}

fn cartridges(text: &mut String, found: &Value) {
    let summary = &found["summary"];
    let _ = writeln!(
        text,
        "{} of {} cartridges passed, {} answers; {} of {} overlays under which they must fail were caught. The worst answer used \
         {} of its tolerance: {}.\n",
        cell(summary, "passed"),
        cell(summary, "cartridges"),
        cell(summary, "answers"),
        cell(summary, "overlays_caught"),
        cell(summary, "overlays"),
        cell(summary, "worst_tolerance_used"),
        cell(summary, "worst"),
    );
    text.push_str("| cartridge | shows | answers | worst share of a tolerance | overlays caught |\n|---|---|---|---|---|\n");
    for cartridge in list(found, "cartridges") {
        let answers = list(cartridge, "answers");
        let used = answers.iter().filter_map(|answer| answer["tolerance_used"].as_f64()).fold(0.0, f64::max);
        let overlays = list(cartridge, "overlays");
        let caught = overlays.iter().filter(|overlay| overlay["caught"] == Value::Bool(true)).count();
        let _ = writeln!(
            text,
            "| {} | {} | {} | {used:.1e} | {caught} of {} |",
            cell(cartridge, "name"),
            cell(cartridge, "title"),
            answers.len(),
            overlays.len()
        );
    }
}

fn lockstep(text: &mut String, found: &Value) {
    let events = found["events"].as_object();
    let told = events.into_iter().flatten().map(|(kind, count)| format!("{count} {kind}s"));
    let _ = writeln!(
        text,
        "{} samples compared; events: {}; first difference: {}.\n",
        cell(found, "samples"),
        told.collect::<Vec<_>>().join(", "),
        if found["first_difference"].is_null() { "none".into() } else { cell(found, "first_difference") }
    );
    text.push_str("| signal | samples | worst difference (full scales) | too near a threshold | not compared |\n|---|---|---|---|---|\n");
    for signal in list(found, "signals") {
        let left_out = signal["not_compared"].as_object().into_iter().flatten();
        let left_out: Vec<String> = left_out.map(|(why, count)| format!("{count} {why}")).collect();
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} |",
            cell(signal, "signal"),
            cell(signal, "samples"),
            cell(signal, "worst"),
            cell(signal, "doubtful"),
            left_out.join("; ")
        );
    }
}

/// `part` of `whole` with its share.
fn share(part: usize, whole: usize) -> String {
    match whole {
        0 => "none".into(),
        _ => format!("{part} of {whole}, {:.1} %", 100.0 * part as f64 / whole as f64),
    }
}

fn coverage(text: &mut String, files: &[FileCoverage]) {
    let mut crates: BTreeMap<&str, [usize; 4]> = BTreeMap::new();
    for file in files {
        let name = file.file.split('/').nth(2).unwrap_or_default();
        for of in [name, "all"] {
            let sums = crates.entry(of).or_default();
            sums.iter_mut().zip(file.counts()).for_each(|(sum, count)| *sum += count);
        }
    }
    text.push_str("| crate | lines reached | branches taken |\n|---|---|---|\n");
    for (name, [reached, lines, taken, branches]) in crates {
        let _ = writeln!(text, "| {name} | {} | {} |", share(reached, lines), share(taken, branches));
    }
    text.push_str("\n| file | lines reached | lines not reached | branches taken |\n|---|---|---|---|\n");
    for file in files {
        let [reached, lines, taken, branches] = file.counts();
        let (name, missed) = (&file.file, stretches(&file.missed));
        let _ =
            writeln!(text, "| {name} | {} | {missed} | {} |", share(reached, lines), share(taken, branches));
    }
}

fn awake(text: &mut String, evidence: &Evidence, found: &Value) {
    let outcomes = list(found, "outcomes");
    let caught = outcomes.iter().filter(|outcome| outcome["caught_by"].is_string()).count();
    let _ = writeln!(
        text,
        "{}, commit {}:\n\n```sh\n{}\n```\n\n{caught} of {} breaks were caught, none of them by a golden picture; the list has {}.\n",
        cell(found, "date"),
        cell(found, "commit"),
        evidence.command,
        outcomes.len(),
        cell(found, "breaks")
    );
    text.push_str("| break | caught by |\n|---|---|\n");
    for outcome in outcomes {
        let is_caught = outcome["caught_by"].is_string();
        let by =
            if is_caught { format!("`{}`", cell(outcome, "caught_by")) } else { "**not caught**".into() };
        let _ = writeln!(text, "| {} | {by} |", cell(outcome, "what"));
    }
}
