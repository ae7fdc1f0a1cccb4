//! Settings that nothing beats, by two errors of the picture, and how far the base lies behind them.

use serde::Serialize;

use crate::advice::{Measured, Setting, measured, total_error};
use crate::ladder::{LadderOutcome, RungOutcome};

/// The share of pixels that are off by more than two grey levels of 255.
const BEYOND: &str = "picture beyond two levels";

/// Settings that no other is both faster and better than, by one error.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Front {
    /// Name of the error.
    pub error: &'static str,
    /// Settings on the front, from the fastest to the best.
    pub settings: Vec<OnFront>,
    /// Time of the base over that of the fastest setting that is as good; 1 on the front.
    pub base_behind: Option<f64>,
}

/// A setting on the front.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OnFront {
    /// Its ladder and rung, or the base.
    pub setting: Setting,
    /// Median time (s a frame).
    pub time_s: f64,
    /// Error of the picture at this setting.
    pub value: f64,
}

impl Front {
    /// The front in words.
    pub fn sentence(&self) -> String {
        let name = |on: &OnFront| match &on.setting {
            Setting::Base => format!("the base ({:.1} ms)", 1e3 * on.time_s),
            Setting::Rung([ladder, rung]) => format!("{ladder} {rung} ({:.1} ms)", 1e3 * on.time_s),
        };
        let settings: Vec<String> = self.settings.iter().map(name).collect();
        let base = self.base_behind.map_or_else(String::new, |behind| match behind {
            1.0 => " The base is on it.".to_owned(),
            _ => format!(" The base takes {behind:.2} times the time of a setting that is as good."),
        });
        format!("Front by {}: {}.{base}", self.error, settings.join(", "))
    }
}

/// The fronts over all ladders of frames, by RMSE and by the share of pixels beyond two grey levels; none without such ladders.
pub fn fronts(ladders: &[LadderOutcome]) -> Vec<Front> {
    // Against another law than the base's the share says nothing.
    let beyond = |rung: &RungOutcome| match rung.error("picture rmse, law of the base") {
        Some(_) => None,
        None => rung.error(BEYOND),
    };
    let all = [("picture rmse", measured(ladders, total_error)), (BEYOND, measured(ladders, beyond))];
    all.into_iter().filter(|(_, all)| !all.is_empty()).map(|(error, all)| front_of(error, all)).collect()
}

fn front_of(error: &'static str, all: Vec<Measured>) -> Front {
    let points: Vec<[f64; 2]> = all.iter().map(|measured| [measured.time_s, measured.error]).collect();
    let on = |index: usize| OnFront {
        setting: all[index].setting.clone(),
        time_s: all[index].time_s,
        value: all[index].error,
    };
    let base = all.iter().find(|measured| measured.setting == Setting::Base);
    let behind = |base: &Measured| {
        let as_good = all.iter().filter(|measured| measured.error <= base.error);
        base.time_s / as_good.map(|measured| measured.time_s).fold(base.time_s, f64::min)
    };
    Front { error, settings: front(&points).into_iter().map(on).collect(), base_behind: base.map(behind) }
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
    use super::{BEYOND, front, fronts};
    use crate::advice::Setting;
    use crate::figures::ErrorFigure;
    use crate::ladder::{LadderOutcome, RungOutcome};

    fn rung(label: &str, changes: usize, time: f64, [rmse, beyond]: [f64; 2]) -> RungOutcome {
        let figure = |(name, value)| ErrorFigure { name, unit: "1", value };
        RungOutcome {
            label: label.into(),
            step: None,
            changes,
            time_s: Some([time; 3]),
            work: 0,
            errors: [("picture rmse", rmse), (BEYOND, beyond)].map(figure).into(),
            refused: None,
        }
    }

    #[test]
    fn the_base_is_held_against_what_is_as_good() {
        let rungs = vec![
            rung("1000", 0, 0.08, [0.010, 0.02]),
            rung("2000", 1, 0.02, [0.009, 0.03]),
            rung("250", 1, 0.01, [0.05, 0.2]),
        ];
        let [rmse, beyond] = &fronts(&[LadderOutcome::new(("samples", "a"), "frame", &[], rungs)])[..] else {
            panic!("two fronts")
        };
        let named = |front: &super::Front| front.settings.iter().map(|on| on.value).collect::<Vec<_>>();
        assert_eq!((named(rmse), rmse.base_behind), (vec![0.05, 0.009], Some(4.0)));
        assert_eq!((named(beyond), beyond.base_behind), (vec![0.2, 0.03, 0.02], Some(1.0)));
        assert_eq!(beyond.settings[2].setting, Setting::Base);
        assert!(rmse.sentence().ends_with("4.00 times the time of a setting that is as good."));
        assert!(beyond.sentence().ends_with("the base (80.0 ms). The base is on it."));
        assert!(fronts(&[]).is_empty());
    }

    #[test]
    fn the_front_has_what_nothing_beats() {
        let points = [[1.0, 0.5], [2.0, 0.6], [3.0, 0.1], [2.5, 0.1], [4.0, 0.05]];
        assert_eq!(front(&points), [0, 3, 4]);
    }
}
