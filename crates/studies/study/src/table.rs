//! Outcomes of ladders as rows of tables.

use crate::ladder::{LadderOutcome, RungOutcome};

/// Errors that a table leaves to the files, which have all of them.
const LEFT_TO_FILES: [&str; 7] = [
    "height max",
    "height rms of full scale",
    "slope max",
    "slope rms of full scale",
    "reflectivity max",
    "ridge max",
    "picture psnr",
];

/// The rows of a ladder, the first with the names of the columns: the errors that tell most.
pub fn table(ladder: &LadderOutcome) -> Vec<Vec<String>> {
    let mut names = ladder.error_names();
    names.retain(|(name, _)| !LEFT_TO_FILES.contains(name));
    let mut head = vec![ladder.name.to_owned(), format!("ms a {}", ladder.unit_of_work)];
    head.extend(
        names
            .iter()
            .map(|(name, unit)| if *unit == "1" { (*name).to_owned() } else { format!("{name} ({unit})") }),
    );
    let row = |rung: &RungOutcome| {
        let mut row = vec![rung.label.clone()];
        if let Some(refused) = &rung.refused {
            row.push(format!("refused: {refused}"));
            return row;
        }
        row.push(rung.time_s.map_or_else(String::new, |[median, ..]| figure(1e3 * median)));
        row.extend(names.iter().map(|(name, _)| rung.error(name).map_or_else(|| "-".to_owned(), figure)));
        row
    };
    [head].into_iter().chain(ladder.rungs.iter().map(row)).collect()
}

/// All ladders as CSV: one row an error.
pub fn csv(ladders: &[LadderOutcome]) -> String {
    let mut text =
        String::from("ladder,rung,step,work,time_median_s,time_min_s,time_max_s,error,unit,value,refused\n");
    for ladder in ladders {
        for rung in &ladder.rungs {
            let optional = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:e}"));
            let times = [0, 1, 2].map(|k| optional(rung.time_s.map(|times| times[k])));
            let head = format!(
                "{},{},{},{},{}",
                quoted(ladder.name),
                quoted(&rung.label),
                optional(rung.step),
                rung.work,
                times.join(",")
            );
            for error in &rung.errors {
                text += &format!("{head},{},{},{:e},\n", quoted(error.name), error.unit, error.value);
            }
            if let Some(refused) = &rung.refused {
                text += &format!("{head},,,,{}\n", quoted(refused));
            }
        }
    }
    text
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// Returns a number with about four significant digits.
fn figure(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if (1e-3..1e5).contains(&size) => {
            let decimals = (3 - libm::log10(size).floor() as i32).clamp(0, 6) as usize;
            format!("{value:.decimals$}")
        }
        _ => format!("{value:.2e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{csv, figure, table};
    use crate::figures::ErrorFigure;
    use crate::ladder::{LadderOutcome, RungOutcome};

    #[test]
    fn every_rung_has_its_row() {
        let rung = RungOutcome {
            label: "1000, f32".into(),
            step: Some(1e-3),
            changes: 2,
            time_s: Some([0.02, 0.01, 0.03]),
            work: 7,
            errors: vec![ErrorFigure { name: "height rms", unit: "m", value: 1.25e-5 }],
            refused: None,
        };
        let refused =
            RungOutcome { errors: vec![], time_s: None, refused: Some("no".into()), ..rung.clone() };
        let ladder = LadderOutcome::new(("pair", "both"), "frame", &[], vec![rung, refused]);
        let rows = table(&ladder);
        assert_eq!(rows[0], ["pair", "ms a frame", "height rms (m)"]);
        assert_eq!(rows[1], ["1000, f32", "20.00", "1.25e-5"]);
        assert_eq!(rows[2][1], "refused: no");
        let text = csv(&[ladder]);
        assert!(text.contains("pair,\"1000, f32\",1e-3,7,2e-2,1e-2,3e-2,height rms,m,1.25e-5,\n"), "{text}");
        assert!(text.ends_with(",,,,no\n"), "{text}");
    }

    #[test]
    fn figures_have_four_digits() {
        assert_eq!(
            [0.0, 12.3456, 0.001_234_6, 1.0e-7, 123_456.0].map(figure),
            ["0", "12.35", "0.001235", "1.00e-7", "1.23e5"]
        );
    }
}
