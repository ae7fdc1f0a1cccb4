//! Which setting to choose.

use serde::Serialize;

use crate::ladder::{EXACT, LadderOutcome, RungOutcome};
use crate::work::spread;

/// Errors of the picture for which a setting is named.
const WANTED: [f64; 4] = [0.05, 0.02, 0.01, 0.005];
/// How many times cheaper a pair of factors must be than a single one to be advised.
const CLEARLY: f64 = 1.25;
/// The error that decides.
const DECIDES: &str = "picture rmse";

/// A setting that was measured.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Setting {
    /// The base: what the scenario says, with nothing changed.
    Base,
    /// A ladder and one of its rungs.
    Rung([String; 2]),
}

/// The cheapest setting measured for an error.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Advice {
    /// What is wanted: no more than this RMSE of the picture.
    pub within: f64,
    /// The setting; `None` if none is so good.
    pub setting: Option<Setting>,
    /// Its time (s a frame).
    pub time_s: Option<f64>,
    /// RMSE of the picture at this setting.
    pub error: Option<f64>,
}

impl Advice {
    /// The advice in words.
    pub fn sentence(&self) -> String {
        let (Some(setting), Some(time), Some(error)) = (&self.setting, self.time_s, self.error) else {
            return format!("No setting that was measured comes within {} of exact.", self.within);
        };
        let choice = match setting {
            Setting::Base => "the base setting will do".to_owned(),
            Setting::Rung([ladder, rung]) => format!("choose {ladder} = {rung}"),
        };
        let (within, time) = (self.within, 1e3 * time);
        format!("For a picture within {within} of exact {choice}: {time:.1} ms a frame, RMSE {error:.5}.")
    }
}

/// A setting with what it takes and how far it is off.
pub(crate) struct Measured {
    pub setting: Setting,
    changes: usize,
    pub time_s: f64,
    pub error: f64,
}

impl Measured {
    /// A pair of factors is named where it is clearly cheaper than any one factor.
    fn cost(&self) -> f64 {
        self.time_s * if self.changes > 1 { CLEARLY } else { 1.0 }
    }
}

/// One advice for each wanted error, over all ladders of frames; none without such ladders. Rungs that change a law are held against the base's.
pub fn advise(ladders: &[LadderOutcome]) -> Vec<Advice> {
    let all = measured(ladders, total_error);
    if all.is_empty() {
        return Vec::new();
    }
    let advice = |within: f64| {
        let good = all.iter().filter(|measured| measured.error <= within);
        let found = good.min_by(|a, b| a.cost().total_cmp(&b.cost()));
        Advice {
            within,
            setting: found.map(|found| found.setting.clone()),
            time_s: found.map(|found| found.time_s),
            error: found.map(|found| found.error),
        }
    };
    WANTED.map(advice).into()
}

/// Every setting of a frame once, with an error of its own: many ladders have the base among their rungs, and the fastest of many measurements of one thing
/// would win by chance.
pub(crate) fn measured(
    ladders: &[LadderOutcome],
    error: impl Fn(&RungOutcome) -> Option<f64>,
) -> Vec<Measured> {
    let of_frames = ladders.iter().filter(|ladder| ladder.unit_of_work == "frame" && ladder.against == EXACT);
    let rungs = of_frames.flat_map(|ladder| ladder.rungs.iter().map(move |rung| (ladder, rung)));
    let one = |(ladder, rung): (&LadderOutcome, &RungOutcome)| {
        let setting = Setting::Rung([ladder.name.to_owned(), rung.label.clone()]);
        Some(Measured {
            setting: if rung.changes == 0 { Setting::Base } else { setting },
            changes: rung.changes,
            time_s: rung.time_s?[0],
            error: error(rung)?,
        })
    };
    let (base, mut all): (Vec<_>, Vec<_>) =
        rungs.filter_map(one).partition(|measured| measured.setting == Setting::Base);
    let times: Vec<f64> = base.iter().map(|measured| measured.time_s).collect();
    all.extend(base.into_iter().next().map(|first| Measured { time_s: spread(&times)[0], ..first }));
    all
}

/// Error of parts, or with the difference of law where there is one.
pub fn total_error(rung: &RungOutcome) -> Option<f64> {
    rung.error("picture rmse, law of the base").or_else(|| rung.error(DECIDES))
}

#[cfg(test)]
mod tests {
    use super::{Setting, advise};
    use crate::figures::ErrorFigure;
    use crate::ladder::{LadderOutcome, RungOutcome};

    fn rung(label: &str, changes: usize, time: f64, error: f64) -> RungOutcome {
        RungOutcome {
            label: label.into(),
            step: None,
            changes,
            time_s: Some([time; 3]),
            work: 0,
            errors: vec![ErrorFigure { name: "picture rmse", unit: "1", value: error }],
            refused: None,
        }
    }

    fn ladder(name: &'static str, rungs: Vec<RungOutcome>) -> LadderOutcome {
        LadderOutcome::new((name, "a factor"), "frame", &[], rungs)
    }

    #[test]
    fn the_cheapest_that_will_do_is_advised() {
        let samples = [("125", 0.01, 0.04), ("500", 0.03, 0.015), ("1000", 0.06, 0.012)];
        let rungs = samples.map(|(label, time, error)| rung(label, 1, time, error)).into();
        let advice = advise(&[ladder("samples", rungs)]);
        let named = |k: usize| match &advice[k].setting {
            Some(Setting::Rung([_, rung])) => Some(rung.as_str()),
            _ => None,
        };
        assert_eq!([named(0), named(1), named(2)], [Some("125"), Some("500"), None]);
        assert!(advice[1].sentence().contains("samples = 500: 30.0 ms"), "{}", advice[1].sentence());
    }

    /// The base is measured in every ladder, each time a little different.
    #[test]
    fn the_base_is_named_as_what_it_is() {
        let samples = ladder("samples", vec![rung("125", 1, 0.01, 0.04), rung("1000", 0, 0.066, 0.004)]);
        let scalar = ladder("scalar", vec![rung("f32", 0, 0.064, 0.004), rung("f64", 1, 0.065, 0.004)]);
        let projection = ladder("projection", vec![rung("exact", 0, 0.070, 0.004)]);
        let advice = advise(&[samples.clone(), projection.clone()]);
        assert_eq!(advice[3].setting, Some(Setting::Base));
        assert!(advice[3].sentence().contains("exact the base setting will do: 70.0 ms"), "{:?}", advice[3]);
        // Of 64, 66 and 70 ms the one in the middle stands for the base.
        let advice = advise(&[samples, scalar, projection]);
        assert_eq!(advice[3].setting, Some(Setting::Rung(["scalar", "f64"].map(str::to_owned))));
    }
}
