//! The matrix as rows, as CSV and as Markdown.

use std::collections::BTreeMap;

use super::cell::{Action, Cell};
use super::survey_fit::FitOutcome;

/// Sound and all cells of each row by each method, in the order of the matrix; the first line has the names of the columns.
pub fn summary(cells: &[Cell]) -> Vec<Vec<String>> {
    let (mut order, mut groups): (Vec<(&str, &str)>, BTreeMap<_, Vec<&Cell>>) = (Vec::new(), BTreeMap::new());
    for cell in cells {
        let key = (cell.row, cell.method);
        if !groups.contains_key(&key) {
            order.push(key);
        }
        groups.entry(key).or_default().push(cell);
    }
    let head = ["row", "method", "whose", "cells", "sound", "refused", "worst error (FS)", "at", "seconds"];
    let line = |key: &(&str, &str)| {
        let group = &groups[key];
        let count = |of: &dyn Fn(&Cell) -> bool| group.iter().filter(|cell| of(cell)).count().to_string();
        let worst = group.iter().filter(|cell| cell.error.is_some());
        let worst = worst.max_by(|a, b| a.error.unwrap_or(0.0).total_cmp(&b.error.unwrap_or(0.0)));
        let whose = if group[0].own { "own" } else { "comparison" };
        vec![
            key.0.to_owned(),
            key.1.to_owned(),
            whose.to_owned(),
            group.len().to_string(),
            count(&Cell::is_sound),
            count(&|cell| matches!(cell.action, Action::Refused(_))),
            worst.map_or_else(|| "-".into(), |cell| format!("{:.1e}", cell.error.unwrap_or(0.0))),
            worst.map_or_else(|| "-".into(), |cell| cell.case.clone()),
            format!("{:.3}", group.iter().map(|cell| cell.time_s).sum::<f64>()),
        ]
    };
    [head.map(str::to_owned).into()].into_iter().chain(order.iter().map(line)).collect()
}

/// Every cell of the machine's own methods that does not hold, with what to look at.
pub fn faults(cells: &[Cell]) -> Vec<String> {
    let faulty = cells.iter().filter_map(|cell| Some((cell, cell.fault?)));
    let figure = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| format!("{value:.2e}"));
    let words = |(cell, fault): (&Cell, &str)| {
        let detail = match &cell.action {
            Action::Refused(message) | Action::Panicked(message) => format!("; {message}"),
            _ => format!("; error {} of {} FS", figure(cell.error), figure(cell.allowed)),
        };
        format!("{}, {}, {}: {fault}{detail}", cell.row, cell.case, cell.method)
    };
    faulty.map(words).collect()
}

/// Every cell, one a line.
pub fn csv(cells: &[Cell]) -> String {
    let mut text =
        String::from("row,case,method,own,finite,bounded,error_fs,allowed_fs,action,time_s,fault,message\n");
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\"").replace('\n', " "));
    let figure = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:e}"));
    for cell in cells {
        let message = match &cell.action {
            Action::Refused(message) | Action::Panicked(message) => message.as_str(),
            _ => "",
        };
        text += &format!(
            "{},{},{},{},{},{},{},{},{},{:e},{},{}\n",
            cell.row,
            quoted(&cell.case),
            quoted(cell.method),
            cell.own,
            cell.finite,
            cell.bounded,
            figure(cell.error),
            figure(cell.allowed),
            quoted(&cell.action.words()),
            cell.time_s,
            cell.fault.unwrap_or_default(),
            quoted(message)
        );
    }
    text
}

/// Conditioning of the survey fit, one line a fit after the names.
pub fn fits(outcomes: &[FitOutcome]) -> Vec<Vec<String>> {
    let head = [
        "region (samples)",
        "holes",
        "condition",
        "times, by holes",
        "noise grows by",
        "in holes",
        "iterations",
    ];
    let line = |fit: &FitOutcome| {
        let mut row = vec![fit.region.to_string(), format!("{:.0} %", 100.0 * fit.holes)];
        match &fit.refused {
            Some(why) => row.push(format!("refused: {why}")),
            None => row.extend([
                format!("{:.1e}", fit.condition),
                format!("{:.1}", fit.condition_of_holes),
                format!("{:.2}", fit.growth),
                format!("{:.2}", fit.growth_in_holes),
                fit.iterations.to_string(),
            ]),
        }
        row
    };
    [head.map(str::to_owned).into()].into_iter().chain(outcomes.iter().map(line)).collect()
}

#[cfg(test)]
mod tests {
    use super::{csv, faults, summary};
    use crate::stability::{Cell, Found, Theory};

    #[test]
    fn refusals_and_faults_are_told() {
        let refused = || Found::refused("key = 1, expected 2".into());
        let cells = [
            Cell::own("light", "sun at 0", "ideal", Theory::Refuses, refused()),
            Cell::own("light", "sun at 1", "ideal", Theory::Answers(1.0), refused()),
        ];
        assert_eq!(summary(&cells)[1][..6], ["light", "ideal", "own", "2", "2", "2"]);
        assert_eq!(faults(&cells).len(), 1);
        assert!(faults(&cells)[0].contains("sun at 1") && faults(&cells)[0].contains("expected 2"));
        assert_eq!(csv(&cells).lines().count(), 3);
    }
}
