//! The data card: what the data set is, how it was made, what is in it, and what it is not.

mod statistics;

use text::markdown;

use crate::folder::{LICENCE, LOADERS, MANIFEST, PLAN, RECORD, SHEET};
use crate::record::Record;
use crate::row::Row;

/// The card of the samples `rows`, as Markdown. It is a function of the record's head and the rows.
pub(crate) fn card(record: &Record, rows: &[Row]) -> String {
    let plan = &record.plan;
    let [start, end] = record.samples;
    let part = match end - start == record.of {
        true => String::new(),
        false => format!("\nThis folder is a part: samples {start}..{end} of 0..{}.\n", record.of),
    };
    [
        format!("# {}\n\n{}\n{part}\n![]({SHEET})\n", plan.title, plan.about),
        facts(record),
        sample(record),
        how(record),
        statistics::splits(record, rows),
        statistics::contents(rows),
        LIMITS.to_owned(),
    ]
    .join("\n")
}

fn facts(record: &Record) -> String {
    let (plan, program) = (&record.plan, &record.made_from.program);
    let [start, end] = record.samples;
    let row = |what: &str, value: String| vec![what.to_owned(), value];
    markdown(&[
        row("what", "value".into()),
        row("samples", (end - start).to_string()),
        row("scenarios", plan.scenarios.join(", ")),
        row("machines", plan.machines.join(", ")),
        row("faults", plan.faults.keys().cloned().collect::<Vec<_>>().join(", ")),
        row("seed", plan.seed.to_string()),
        row("licence", format!("{} ({LICENCE})", plan.licence)),
        row(
            "made by",
            format!("{} {}, result family {}", program.name, program.version, program.result_family),
        ),
    ])
}

fn sample(record: &Record) -> String {
    let mut rows = vec![["array", "type", "shape", "unit", "meaning"].map(str::to_owned).to_vec()];
    for array in &record.arrays {
        let text = |key: &str| array[key].as_str().map_or_else(|| array[key].to_string(), str::to_owned);
        rows.push(["name", "dtype", "shape", "unit", "meaning"].map(text).to_vec());
    }
    let [numpy, torch] = LOADERS.map(|(name, _)| name);
    format!(
        "## A sample\n\nA sample is one file of NumPy arrays (`.npz`) in the folder of its split, and one line of `{MANIFEST}`: file and hash, \
         scenario, machine, fault, what was drawn, pose, sun, field of view, and labels of the whole picture.\n\n{}\n\
         `{numpy}` reads the data set with NumPy alone, and `{torch}` is a data set of PyTorch. `{RECORD}` has every array with its codes and its error.\n",
        markdown(&rows)
    )
}

fn how(record: &Record) -> String {
    let plan = &record.plan;
    let mut rows = vec![vec!["quantity".to_owned(), "drawn from".to_owned()]];
    rows.extend(plan.drawn.iter().map(|(name, range)| vec![format!("`{name}`"), range.clone()]));
    for (name, fault) in &plan.faults {
        for (key, range) in fault["drawn"].as_object().into_iter().flatten() {
            rows.push(vec![
                format!("`{key}` of fault {name}"),
                range.as_str().unwrap_or_default().to_owned(),
            ]);
        }
    }
    let set: Vec<String> = plan.set.iter().map(|(key, value)| format!("`{key}={value}`")).collect();
    let set = if set.is_empty() { String::new() } else { format!("All samples have {}.\n", set.join(", ")) };
    format!(
        "## How it was made\n\nThe plan is `{PLAN}`. Sample n has the combination of scenario, machine and fault whose number is n modulo the number of \
         combinations. Every draw is the hash of seed, sample, attempt and the name of the quantity, so any sample can be made alone: \
         `lunoid dataset {} --only 7`, where the plan was written and not from here: the files that it names lie beside it. Each value of a range is as likely.\n\n{}\n{set}\
         The vehicle stands where it is drawn, by the law of the vehicle. A pose that it cannot take, or that has ground of another split within reach, \
         is drawn again.\n",
        record.made_from.plan.file,
        markdown(&rows)
    )
}

const LIMITS: &str = "\
## Limits

- Pictures are drawn by models of image generators. They are no photographs, and nothing here says how far a method that learns from them holds on any.
- Samples are single looks, each as the first picture of a drive. There is no motion between them.
- Every range is drawn evenly. No frequency of a real mission is in it.
- Beyond the reach a picture may show ground of another split, mountains above all. The plane `split` marks these pixels, and the manifest counts them.
- The split of ground goes by its coordinates. Two scenarios that have the same ground at other coordinates share it unnoticed.
- Blocks of ground meet: a place at the border belongs to one block, and its neighbour a millimetre away to another.
- An eye inside a rock or another body is not drawn again.
- The truth is that of the ray through the centre of each pixel. What lies between centres is not in it.
";
