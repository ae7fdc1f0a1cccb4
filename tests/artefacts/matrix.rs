//! Every cause before every detector.

use std::sync::LazyLock;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::artefacts::causes::{CAUSES, faulty, model};
use crate::artefacts::detectors::DETECTORS;
use crate::artefacts::look::{Look, Run};
use crate::artefacts::scenes::Place;

/// What the detectors measure, in units of their thresholds: by cause, then by detector.
type Strengths = [[f64; 27]; 27];

/// Off the diagonal: cause, detector, and why.
const EXPLAINED: [(usize, usize, &str); 4] = [
    (1, 4, "one cause: what tears is late where two lines are crossed at once"),
    (4, 1, "one cause: what is late at a corner tears"),
    (13, 14, "one cause: a comparator that is late for an edge is late for a crest"),
    (14, 13, "one cause: a comparator that is late for a crest is late for an edge"),
];

static STRENGTHS: LazyLock<Strengths> = LazyLock::new(|| {
    let mut strengths = [[0.0; 27]; 27];
    for place in Place::ALL {
        for (row, found) in strengths.iter_mut().zip(at(place)) {
            found.into_iter().for_each(|(detector, strength)| row[detector - 1] = strength);
        }
    }
    strengths
});

/// What the detectors that look at a scene make of every cause: their numbers, and strengths.
fn at(place: Place) -> Vec<Vec<(usize, f64)>> {
    let scene = place.scene();
    let clean = Run::of(&scene, &model(None));
    let before_detectors = |number: usize| {
        let run = Run::of(&scene, &faulty(number));
        let look = Look { scene: &scene, clean: &clean, run: &run };
        let here = DETECTORS.iter().filter(|detector| detector.place == place);
        here.map(|detector| (detector.number, (detector.measure)(&look) / detector.threshold)).collect()
    };
    CAUSES.into_par_iter().map(|cause| before_detectors(cause.number)).collect()
}

/// The matrix, each cell `width` characters.
fn text(width: usize, cell: impl Fn(f64) -> String) -> String {
    let mut text = format!("{:14}", "");
    (1..=27).for_each(|number| text += &format!("{:>width$}", format!("A{number}")));
    for (cause, row) in CAUSES.iter().zip(STRENGTHS.iter()) {
        text += &format!("\n{:14}", format!("A{} {}", cause.number, cause.overlay));
        row.iter().for_each(|&strength| text += &format!("{:>width$}", cell(strength)));
    }
    text
}

/// The matrix of the page: `.` is below the threshold, 1 to 3 times it, 2 to 10 times, 3 beyond.
fn classes() -> String {
    text(4, |strength| {
        let class = [1.0, 3.0, 10.0].iter().filter(|&&bound| strength >= bound).count();
        if class == 0 { ".".into() } else { class.to_string() }
    })
}

fn is_explained(cause: usize, detector: usize) -> bool {
    EXPLAINED.iter().any(|&(a, b, _)| (a, b) == (cause, detector))
}

#[test]
fn every_cause_sets_off_its_own_detector_alone() {
    println!("{}", text(5, |s| if s < 1.0 { ".".into() } else { format!("{s:.1}") }));
    let mut wrong = Vec::new();
    for (cause, row) in CAUSES.iter().zip(STRENGTHS.iter()) {
        for (detector, strength) in DETECTORS.iter().zip(row) {
            let expected = cause.number == detector.number || is_explained(cause.number, detector.number);
            if !(strength.is_finite() && (*strength >= 1.0) == expected) {
                let (overlay, name, unit) = (cause.overlay, detector.name, detector.unit);
                let (found, threshold) = (strength * detector.threshold, detector.threshold);
                let number = detector.number;
                wrong.push(format!("{overlay}: A{number} {name}: {found:.3} {unit}, threshold {threshold}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn the_tables_are_in_order() {
    let numbers: Vec<usize> = (1..=27).collect();
    assert_eq!(CAUSES.map(|cause| cause.number).to_vec(), numbers);
    assert_eq!(DETECTORS.map(|detector| detector.number).to_vec(), numbers);
}

#[test]
fn the_page_has_this_matrix() {
    let matrix = classes();
    println!("{matrix}");
    let page = include_str!("../../docs/artefacts.md");
    assert!(page.contains(&matrix), "docs/artefacts.md has another matrix than this:\n{matrix}");
}
