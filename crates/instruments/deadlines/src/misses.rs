//! Missed deadlines of some sweeps, one a line: from a column of the picture to its cause.

use std::ops::Range;

use text::table;
use timing::{Missed, TimingRecord};

const HEAD: [&str; 10] = [
    "frame",
    "sweep",
    "deadline",
    "crossing",
    "register",
    "corner",
    "range (m)",
    "late (ns)",
    "words",
    "cause",
];

/// A table of the misses in `sweeps` of every frame of the record; `ns` is the length of a sample (ns).
pub fn text(record: &TimingRecord, sweeps: &Range<u64>, ns: f64) -> String {
    let all =
        record.frames.iter().flat_map(|frame| frame.misses.iter().map(move |missed| (frame.frame, missed)));
    let ours = all.filter(|(_, missed)| sweeps.contains(&u64::from(missed.sweep)));
    let rows = rows(ours, ns);
    match rows.len() {
        1 => format!("\nno misses in sweeps {}..{}\n", sweeps.start, sweeps.end),
        _ => format!("\n{}", table(&rows)),
    }
}

/// The same of a generator that scans `line` by `line`, and knows no crossings; `ns` is the length of a tick (ns).
pub fn lines_text(record: &TimingRecord, lines: &Range<u64>, line: &str, ns: f64) -> String {
    let head =
        ["frame", line, "deadline", "part", "due (ticks)", "late (ns)", "cause"].map(String::from).into();
    let all = record.frames.iter().flat_map(|frame| frame.misses.iter().map(move |missed| (frame, missed)));
    let ours = all.filter(|(_, missed)| lines.contains(&u64::from(missed.sweep)));
    let cells = ours.map(|(frame, missed)| {
        vec![
            frame.frame.to_string(),
            missed.sweep.to_string(),
            missed.deadline.to_string(),
            missed.part.clone().unwrap_or_else(|| "-".into()),
            format!("{:.0}", missed.due),
            lateness(missed, ns),
            missed.cause.to_string(),
        ]
    });
    let rows: Vec<Vec<String>> = [head].into_iter().chain(cells).collect();
    match rows.len() {
        1 => format!("\nno misses in {line}s {}..{}\n", lines.start, lines.end),
        _ => format!("\n{}", table(&rows)),
    }
}

fn lateness(missed: &Missed, ns: f64) -> String {
    missed.lateness().map_or("never came".into(), |late| format!("{:.1}", late * ns))
}

/// Head and cells of misses, each with its frame.
pub fn rows<'a>(misses: impl Iterator<Item = (u64, &'a Missed)>, ns: f64) -> Vec<Vec<String>> {
    let head = HEAD.map(String::from).into();
    [head].into_iter().chain(misses.map(|(frame, missed)| cells(frame, missed, ns))).collect()
}

fn cells(frame: u64, missed: &Missed, ns: f64) -> Vec<String> {
    let or_none = |text: Option<String>| text.unwrap_or_else(|| "-".into());
    let words = [&missed.colour, &missed.register, &missed.part].into_iter().flatten();
    let register = words.map(String::as_str).collect::<Vec<_>>().join(" ");
    vec![
        frame.to_string(),
        missed.sweep.to_string(),
        missed.deadline.to_string(),
        or_none(missed.crossing.map(|crossing| crossing.to_string())),
        or_none(Some(register).filter(|register| !register.is_empty())),
        or_none(
            missed
                .crater
                .map(|crater| format!("crater {crater}"))
                .or_else(|| missed.region.map(|[m, n]| format!("{m} {n}"))),
        ),
        or_none(missed.range_m.map(|range| format!("{range:.1}"))),
        lateness(missed, ns),
        missed.words.count_ones().to_string(),
        missed.cause.to_string(),
    ]
}
