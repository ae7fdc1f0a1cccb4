//! The ladders of a machine.

use hardware_model::{Economy, HardwareModel, ShadowParts};
use scenario::{Projection, RangeLaw, RangeProgramme, Scalar};

use crate::Subject;
use crate::change::Change;
use crate::ladder::{Expectation, Ladder, Rung};

/// How far ladders reach.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// A few rungs about the base: an answer within a minute.
    Quick,
    /// All rungs of every ladder.
    Whole,
}

/// Samples a sweep, all rungs.
const SAMPLES: [u32; 8] = [125, 250, 500, 1000, 2000, 4000, 8000, 16_000];
/// Share of the range at which the modified terrain generator switches, and share of the samples before: those of
/// `pra-nominal`.
const TWO_RATE: [f64; 2] = [0.01, 0.2];
/// A storage tube that displaces the shadow map by this share of its side (hardware section 3: 0.3 to 2 %).
const OFFSET: [f64; 2] = [0.003, 0.003];

/// The ladders that have a meaning for `subject`; `models` are those whose parts are compared.
pub fn ladders(subject: &Subject, models: &[HardwareModel], extent: Extent) -> Vec<Ladder> {
    let mut all = vec![
        samples(extent),
        sweeps(subject, extent),
        scalar(),
        parts(models),
        programme(subject),
        projection(),
    ];
    all.extend(subject.scenario.levels.is_some().then(levels));
    all.extend(subject.scenario.shadows.is_some().then(shadow));
    all.extend([quality(extent), normal_sweeps(subject)]);
    all.extend(subject.scenario.shadows.is_some().then(normal_shadows));
    all.extend([
        samples_and_scalar(extent),
        samples_and_programme(subject, extent),
        samples_and_parts(models, extent),
    ]);
    all
}

fn rung(label: impl Into<String>, step: Option<f64>, changes: Vec<Change>) -> Rung {
    Rung { label: label.into(), step, changes }
}

fn sample_counts(extent: Extent) -> &'static [u32] {
    match extent {
        Extent::Quick => &SAMPLES[..5],
        Extent::Whole => &SAMPLES,
    }
}

fn samples(extent: Extent) -> Ladder {
    let at = |&samples: &u32| {
        rung(samples.to_string(), Some(1.0 / f64::from(samples)), vec![Change::Samples(samples)])
    };
    let expected = vec![
        Expectation {
            error: "height between samples rms",
            order: 2.0,
            why: "a straight line between samples of a smooth profile",
        },
        Expectation { error: "ridge rms", order: 2.0, why: "a crest that lies between samples is round" },
    ];
    Ladder {
        name: "samples",
        what: "samples a sweep",
        expected,
        rungs: sample_counts(extent).iter().map(at).collect(),
    }
}

fn sweeps(subject: &Subject, extent: Extent) -> Ladder {
    let base = subject.stage.settings.raster.sweeps;
    let most = if extent == Extent::Quick { base } else { 2 * base };
    let counts = [base / 8, base / 4, base / 2, base, 2 * base];
    let fitting = counts.into_iter().filter(|sweeps| (1..=most.min(8192)).contains(sweeps));
    let at =
        |sweeps: u32| rung(sweeps.to_string(), Some(1.0 / f64::from(sweeps)), vec![Change::Sweeps(sweeps)]);
    let rungs = fitting.map(at).collect();
    Ladder {
        name: "sweeps",
        what: "sweeps a frame, shown on the columns of the base",
        expected: Vec::new(),
        rungs,
    }
}

fn scalar() -> Ladder {
    let of = |(label, scalar)| rung(label, None, vec![Change::Scalar(scalar)]);
    let rungs = [("f32", Scalar::F32), ("f64", Scalar::F64)].map(of).into();
    Ladder { name: "scalar", what: "scalar type of the signals", expected: Vec::new(), rungs }
}

fn parts(models: &[HardwareModel]) -> Ladder {
    let of = |model: &HardwareModel| rung(&model.name, None, vec![Change::Parts(Box::new(model.clone()))]);
    Ladder {
        name: "parts",
        what: "analog parts of each model, the digital side as in the base",
        expected: Vec::new(),
        rungs: models.iter().map(of).collect(),
    }
}

/// The four laws of the ground-range programme between the ends of `range`.
fn programmes(range: RangeProgramme) -> [(&'static str, RangeLaw); 4] {
    let [switch, fine_share] = TWO_RATE;
    let two_rate = match range.law {
        RangeLaw::TwoRate { .. } => range.law,
        _ => RangeLaw::TwoRate { switch: (switch * range.end).max(2.0 * range.start), fine_share },
    };
    [
        ("constant-rate", RangeLaw::ConstantRate),
        ("two-rate", two_rate),
        ("constant-elevation", RangeLaw::ConstantElevation),
        ("geometric", RangeLaw::Geometric),
    ]
}

fn programme(subject: &Subject) -> Ladder {
    let of = |(label, law)| rung(label, None, vec![Change::Programme(law)]);
    Ladder {
        name: "programme",
        what: "law of the ground-range programme",
        expected: Vec::new(),
        rungs: programmes(subject.stage.settings.range).map(of).into(),
    }
}

fn projection() -> Ladder {
    let laws = [
        ("as-reported", Projection::AsReported),
        ("corrected", Projection::Corrected),
        ("exact", Projection::Exact),
    ];
    let of = |(label, law)| rung(label, None, vec![Change::Projection(law)]);
    Ladder { name: "projection", what: "projection law", expected: Vec::new(), rungs: laws.map(of).into() }
}

fn levels() -> Ladder {
    let rungs =
        vec![rung("fine and coarse", None, vec![]), rung("fine alone", None, vec![Change::FineLevelAlone])];
    Ladder { name: "levels", what: "terrain levels", expected: Vec::new(), rungs }
}

fn shadow() -> Ladder {
    let few = ShadowParts::Digital { line_generators: Some(8) };
    let tube = ShadowParts::ScanConverter { offset: OFFSET, gain: 0.0 };
    let variants = [
        ("digital, any number of line generators", ShadowParts::Digital { line_generators: None }),
        ("digital, eight line generators", few),
        ("scan converter, aligned", ShadowParts::ScanConverter { offset: [0.0, 0.0], gain: 0.0 }),
        ("scan converter, off by 0.3 %", tube),
    ];
    let of = |(label, parts)| rung(label, None, vec![Change::Shadow(parts)]);
    Ladder { name: "shadow", what: "shadow controller", expected: Vec::new(), rungs: variants.map(of).into() }
}

/// A rung drawn with an economy.
fn economical(label: String, step: Option<f64>, economy: Economy, change: Option<Change>) -> Rung {
    rung(label, step, [Change::Economy(economy)].into_iter().chain(change).collect())
}

/// Instants a step, and what the rule of the default and the whole machine make of the scene.
fn quality(extent: Extent) -> Ladder {
    let most = if extent == Extent::Quick { 4 } else { 16 };
    let counts = [1, 2, 3, 4, 6, 8, 16].into_iter().filter(|count| *count <= most);
    let at = |count: u32| {
        economical(count.to_string(), Some(1.0 / f64::from(count)), Economy::Instants(count), None)
    };
    let named = [("normal", Economy::Normal), ("fine", Economy::Bounded)];
    let named = named.map(|(word, economy)| economical(word.into(), None, economy, None));
    Ladder {
        name: "quality",
        what: "instants a step, and the named qualities",
        expected: Vec::new(),
        rungs: counts.map(at).chain(named).collect(),
    }
}

fn normal_sweeps(subject: &Subject) -> Ladder {
    let base = subject.stage.settings.raster.sweeps;
    let counts = [base / 4, base / 2, base].into_iter().filter(|sweeps| *sweeps > 0);
    let at = |sweeps: u32| {
        let step = Some(1.0 / f64::from(sweeps));
        economical(sweeps.to_string(), step, Economy::Normal, Some(Change::Sweeps(sweeps)))
    };
    Ladder {
        name: "normal-sweeps",
        what: "sweeps a frame at normal quality, shown on the columns of the base",
        expected: Vec::new(),
        rungs: counts.map(at).collect(),
    }
}

fn normal_shadows() -> Ladder {
    let at = |times: f64| {
        economical(format!("{times}x"), Some(times), Economy::Normal, Some(Change::CoarserShadows(times)))
    };
    Ladder {
        name: "normal-shadows",
        what: "distance between profiles of shadow at normal quality, over that of the scenario",
        expected: Vec::new(),
        rungs: [8.0, 4.0, 2.0, 1.0].map(at).into(),
    }
}

fn samples_and_scalar(extent: Extent) -> Ladder {
    let scalars = [("f32", Scalar::F32), ("f64", Scalar::F64)];
    let rungs = pairs(&few(extent), &scalars, |scalar| Change::Scalar(*scalar));
    Ladder { name: "samples-scalar", what: "samples a sweep, by scalar type", expected: Vec::new(), rungs }
}

fn samples_and_programme(subject: &Subject, extent: Extent) -> Ladder {
    let laws = programmes(subject.stage.settings.range);
    // Each number of samples begins at another range: `exact` draws a picture for it, so there are two.
    let rungs = pairs(&[250, *few(extent).last().unwrap_or(&1000)], &laws, |law| Change::Programme(*law));
    Ladder { name: "samples-programme", what: "samples a sweep, by programme", expected: Vec::new(), rungs }
}

fn samples_and_parts(models: &[HardwareModel], extent: Extent) -> Ladder {
    let usable = models
        .iter()
        .filter(|model| matches!(model.name.as_str(), "ideal" | "pra-nominal" | "modern-analog"));
    let models: Vec<(&str, &HardwareModel)> = usable.map(|model| (model.name.as_str(), model)).collect();
    let rungs = pairs(&few(extent), &models, |model| Change::Parts(Box::new((*model).clone())));
    Ladder { name: "samples-parts", what: "samples a sweep, by analog parts", expected: Vec::new(), rungs }
}

/// Samples of a pair of factors: more would only repeat the single ladders.
fn few(extent: Extent) -> Vec<u32> {
    match extent {
        Extent::Quick => vec![250, 1000],
        Extent::Whole => vec![250, 1000, 4000],
    }
}

fn pairs<T>(samples: &[u32], others: &[(&str, T)], change: impl Fn(&T) -> Change) -> Vec<Rung> {
    let of = |&count: &u32| {
        let change = &change;
        others.iter().map(move |(label, other)| {
            rung(format!("{count}, {label}"), None, vec![Change::Samples(count), change(other)])
        })
    };
    samples.iter().flat_map(of).collect()
}
