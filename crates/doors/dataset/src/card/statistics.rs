//! Figures of a data set, as tables of its card.

use std::collections::BTreeMap;

use text::markdown;

use crate::Split;
use crate::record::Record;
use crate::row::Row;

/// Samples of each split, and the ground of other splits that they show.
pub(super) fn splits(record: &Record, rows: &[Row]) -> String {
    let plan = &record.plan;
    let mut table = vec![
        [
            "split",
            "share asked for",
            "samples",
            "pixels with ground",
            "of these of another split",
            "nearest of them (m)",
        ]
        .map(str::to_owned)
        .to_vec(),
    ];
    for split in Split::ALL {
        let own: Vec<&Row> = rows.iter().filter(|row| row.split == split).collect();
        let sum = |count: fn(&Row) -> u64| own.iter().map(|row| count(row)).sum::<u64>();
        let (mine, other) = (sum(|row| row.ground.own), sum(|row| row.ground.other));
        let nearest = own.iter().filter_map(|row| row.ground.nearest_other_m).fold(f64::INFINITY, f64::min);
        table.push(vec![
            split.name().to_owned(),
            plan.shares.get(split.name()).copied().unwrap_or_default().to_string(),
            own.len().to_string(),
            (mine + other).to_string(),
            percent(other, mine + other),
            if nearest.is_finite() { format!("{nearest:.1}") } else { "none".into() },
        ]);
    }
    format!(
        "## Splits\n\nGround is cut into square blocks of {} m, and each block belongs to one split, by the hash of seed and block. A sample is of the split of \
         the block where its vehicle stands. All ground within {} m of the vehicle is of the same split. What is seen beyond may be of another: \
         the table has how much, measured on the ranges of the truth.\n\n{}",
        plan.block_m,
        plan.reach_m,
        markdown(&table)
    )
}

/// Samples, light, labels, faults and refused poses.
pub(super) fn contents(rows: &[Row]) -> String {
    let mut text = format!("## Contents\n\n{}", by_machine(rows));
    if rows.iter().any(|row| row.labels.is_some()) {
        text += &format!("\nShare of the pixels by label:\n\n{}", by_label(rows));
    }
    text + &format!("\n{}", refused(rows))
}

/// One line for each scenario, machine and fault.
fn by_machine(rows: &[Row]) -> String {
    let mut groups: BTreeMap<[&str; 3], Vec<&Row>> = BTreeMap::new();
    for row in rows {
        groups.entry([&row.scenario, &row.machine, &row.fault]).or_default().push(row);
    }
    let counters: Vec<&String> = {
        let mut names: Vec<&String> = rows.iter().flat_map(|row| row.counts.keys()).collect();
        names.sort();
        names.dedup();
        names
    };
    let compared = rows.iter().any(|row| row.changed.is_some());
    let mut head: Vec<String> =
        ["scenario", "machine", "fault", "samples", "mean code"].map(str::to_owned).to_vec();
    head.extend(compared.then(|| "pixels changed by the fault".to_owned()));
    head.extend(counters.iter().map(|name| format!("mean `{name}`")));
    let mut table = vec![head];
    for (names, rows) in groups {
        let mut line: Vec<String> = names.map(str::to_owned).to_vec();
        line.push(rows.len().to_string());
        line.push(format!("{:.1}", mean(rows.iter().map(|row| row.mean_code))));
        if compared {
            let pixels = |row: &&Row| (row.shape[0] * row.shape[1]) as u64;
            let changed = rows.iter().filter_map(|row| row.changed).sum();
            line.push(percent(changed, rows.iter().map(pixels).sum()));
        }
        let count = |name: &&String| {
            mean(rows.iter().map(|row| row.counts.get(*name).map_or(0.0, |count| *count as f64)))
        };
        line.extend(counters.iter().map(|name| format!("{:.1}", count(name))));
        table.push(line);
    }
    markdown(&table)
}

fn by_label(rows: &[Row]) -> String {
    let mut sums: BTreeMap<(&str, Split), u64> = BTreeMap::new();
    let mut all: BTreeMap<Split, u64> = BTreeMap::new();
    for row in rows {
        for (word, count) in row.labels.iter().flatten() {
            *sums.entry((word, row.split)).or_default() += count;
            *all.entry(row.split).or_default() += count;
        }
    }
    let mut words: Vec<&str> = sums.keys().map(|(word, _)| *word).collect();
    words.dedup();
    let mut table = vec![["label", "train", "validation", "test"].map(str::to_owned).to_vec()];
    for word in words {
        let share = |split: Split| {
            percent(sums.get(&(word, split)).copied().unwrap_or(0), all.get(&split).copied().unwrap_or(0))
        };
        table.push([word.to_owned()].into_iter().chain(Split::ALL.map(share)).collect());
    }
    markdown(&table)
}

fn refused(rows: &[Row]) -> String {
    let mut sums: BTreeMap<&str, u64> = BTreeMap::new();
    for (reason, count) in rows.iter().flat_map(|row| &row.refused) {
        *sums.entry(reason).or_default() += u64::from(*count);
    }
    let drawn = rows.len() as u64 + sums.values().sum::<u64>();
    let reasons: Vec<String> = sums.iter().map(|(reason, count)| format!("{reason} {count}")).collect();
    let reasons = if reasons.is_empty() {
        "none refused".to_owned()
    } else {
        format!("refused: {}", reasons.join(", "))
    };
    format!("Poses drawn: {drawn}; taken: {}; {reasons}.\n", rows.len())
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len().max(1) as f64;
    values.sum::<f64>() / count
}

/// A share in percent; a dash of nothing.
fn percent(part: u64, of: u64) -> String {
    if of == 0 { "-".into() } else { format!("{:.2} %", 100.0 * part as f64 / of as f64) }
}
