//! The diagonal: what each detector measures of its own cause, beside the formula of the hardware report.

mod array;
mod beam;
mod late;

use std::sync::LazyLock;

use crate::artefacts::causes::{faulty, model};
use crate::artefacts::detectors::{DETECTORS, Detector};
use crate::artefacts::look::{Look, Run};

/// One figure of an artefact, measured and predicted.
#[derive(Debug, Clone)]
pub struct Figure {
    pub number: usize,
    pub what: &'static str,
    pub measured: f64,
    pub predicted: f64,
    /// By how much the two may differ.
    pub within: f64,
    pub unit: &'static str,
    pub formula: &'static str,
}

impl Figure {
    fn holds(&self) -> bool {
        (self.measured - self.predicted).abs() <= self.within
    }

    /// As the page has it.
    fn row(&self) -> String {
        let Self { number, what, measured, predicted, unit, formula, .. } = self;
        let Detector { name, threshold, unit: detected, .. } = DETECTORS[number - 1];
        let space = if unit.is_empty() || *unit == "%" { "" } else { " " };
        format!(
            "| A{number} {name} | {what} | {measured:.2}{space}{unit} | {predicted:.2}{space}{unit} | {formula} | \
             {threshold} {detected} |"
        )
    }
}

/// Looks at artefact `number` where its detector does.
fn looked<T>(number: usize, at: impl FnOnce(&Look<'_>) -> T) -> T {
    let scene = DETECTORS[number - 1].place.scene();
    let [clean, run] = [model(None), faulty(number)].map(|model| Run::of(&scene, &model));
    at(&Look { scene: &scene, clean: &clean, run: &run })
}

fn figure(
    number: usize,
    what: &'static str,
    [measured, predicted, within]: [f64; 3],
    unit: &'static str,
    formula: &'static str,
) -> Figure {
    Figure { number, what, measured, predicted, within, unit, formula }
}

/// All figures, A1 first.
static FIGURES: LazyLock<Vec<Figure>> = LazyLock::new(|| {
    let all: [fn() -> Figure; 27] = [
        late::a1,
        late::a2,
        late::a3,
        late::a4,
        late::a5,
        array::a6,
        array::a7,
        array::a8,
        array::a9,
        array::a10,
        array::a11,
        array::a12,
        beam::a13,
        beam::a14,
        beam::a15,
        beam::a16,
        beam::a17,
        beam::a18,
        beam::a19,
        beam::a20,
        beam::a21,
        beam::a22,
        beam::a23,
        beam::a24,
        array::a25,
        late::a26,
        array::a27,
    ];
    all.iter().map(|figure| figure()).collect()
});

#[test]
fn every_artefact_measures_what_its_formula_says() {
    let off = FIGURES.iter().filter(|figure| !figure.holds()).map(Figure::row).collect::<Vec<_>>();
    assert_eq!(FIGURES.iter().map(|figure| figure.number).collect::<Vec<_>>(), (1..=27).collect::<Vec<_>>());
    assert!(off.is_empty(), "{off:#?}");
}

#[test]
fn the_page_has_these_figures() {
    let page = include_str!("../../../docs/artefacts.md");
    let rows: Vec<String> = FIGURES.iter().map(Figure::row).collect();
    println!("{}", rows.join("\n"));
    let missing: Vec<&String> = rows.iter().filter(|row| !page.contains(row.as_str())).collect();
    assert!(missing.is_empty(), "docs/artefacts.md lacks {missing:#?}");
}
