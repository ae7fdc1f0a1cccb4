//! Which setting to choose.

use serde::Serialize;

use crate::ladder::{LadderOutcome, RungOutcome};

/// Errors of the picture for which a setting is named.
const WANTED: [f64; 4] = [0.05, 0.02, 0.01, 0.005];
/// How many times cheaper a pair of factors must be than a single one to be advised.
const CLEARLY: f64 = 1.25;
/// The error that decides.
const DECIDES: &str = "picture rmse";

/// The cheapest setting measured for an error.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Advice {
    /// What is wanted: no more than this RMSE of the picture.
    pub within: f64,
    /// The setting: ladder and rung; `None` if none is so good.
    pub setting: Option<[String; 2]>,
    /// Its time (s a frame).
    pub time_s: Option<f64>,
    /// Its error.
    pub error: Option<f64>,
}

impl Advice {
    /// The advice in words.
    pub fn sentence(&self) -> String {
        match (&self.setting, self.time_s, self.error) {
            (Some([ladder, rung]), Some(time), Some(error)) => format!(
                "For a picture within {} of exact choose {ladder} = {rung}: {:.1} ms a frame, RMSE {error:.5}.",
                self.within,
                1e3 * time
            ),
            _ => format!("No setting that was measured comes within {} of exact.", self.within),
        }
    }
}

/// One advice for each wanted error, over all ladders of frames; none without such ladders. Rungs that change a law are held against the base's.
pub fn advise(ladders: &[LadderOutcome]) -> Vec<Advice> {
    let of_frames = ladders.iter().filter(|ladder| ladder.unit_of_work == "frame");
    let all: Vec<(&LadderOutcome, &RungOutcome, f64, f64)> = of_frames
        .flat_map(|ladder| ladder.rungs.iter().map(move |rung| (ladder, rung)))
        .filter_map(|(ladder, rung)| Some((ladder, rung, rung.time_s?[0], total_error(rung)?)))
        .collect();
    if all.is_empty() {
        return Vec::new();
    }
    // A pair of factors is named where it is clearly cheaper than any one factor.
    let cost = |found: &(&LadderOutcome, &RungOutcome, f64, f64)| {
        found.2 * if found.1.changes > 1 { CLEARLY } else { 1.0 }
    };
    let cheapest = |within: f64| {
        let good = all.iter().filter(|(.., error)| *error <= within);
        good.min_by(|a, b| cost(a).total_cmp(&cost(b)))
    };
    let advice = |within: f64| {
        let found = cheapest(within);
        Advice {
            within,
            setting: found.map(|(ladder, rung, ..)| [ladder.name.to_owned(), rung.label.clone()]),
            time_s: found.map(|found| found.2),
            error: found.map(|found| found.3),
        }
    };
    WANTED.map(advice).into()
}

/// Error of parts, or with the difference of law where there is one.
pub fn total_error(rung: &RungOutcome) -> Option<f64> {
    rung.error("picture rmse, law of the base").or_else(|| rung.error(DECIDES))
}

/// Rungs that no other is both faster and better than, by time: indices of `points` of time and error.
pub fn front(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| points[a][0].total_cmp(&points[b][0]).then(points[a][1].total_cmp(&points[b][1])));
    let mut best = f64::INFINITY;
    order.retain(|&index| {
        let is_better = points[index][1] < best;
        best = best.min(points[index][1]);
        is_better
    });
    order
}

#[cfg(test)]
mod tests {
    use super::{advise, front};
    use crate::figures::ErrorFigure;
    use crate::ladder::{LadderOutcome, RungOutcome};

    fn rung(label: &str, time: f64, error: f64) -> RungOutcome {
        RungOutcome {
            label: label.into(),
            step: None,
            changes: 1,
            time_s: Some([time; 3]),
            work: 0,
            errors: vec![ErrorFigure { name: "picture rmse", unit: "1", value: error }],
            refused: None,
        }
    }

    #[test]
    fn the_front_has_what_nothing_beats() {
        let points = [[1.0, 0.5], [2.0, 0.6], [3.0, 0.1], [2.5, 0.1], [4.0, 0.05]];
        assert_eq!(front(&points), [0, 3, 4]);
    }

    #[test]
    fn the_cheapest_that_will_do_is_advised() {
        let rungs = vec![rung("125", 0.01, 0.04), rung("500", 0.03, 0.015), rung("1000", 0.06, 0.012)];
        let ladder = LadderOutcome::new(("samples", "samples a sweep"), "frame", &[], rungs);
        let advice = advise(&[ladder]);
        let named = |k: usize| advice[k].setting.as_ref().map(|[_, rung]| rung.as_str());
        assert_eq!([named(0), named(1), named(2)], [Some("125"), Some("500"), None]);
        assert!(advice[1].sentence().contains("samples = 500: 30.0 ms"), "{}", advice[1].sentence());
    }
}
