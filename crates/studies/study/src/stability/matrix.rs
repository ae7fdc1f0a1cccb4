//! The matrix: every case by every method.

use hardware_model::HardwareModel;
use quantities::hash_words;
use scenario::Scalar;

use super::cell::{Cell, Theory};
use super::extremes::{Extreme, extremes};
use super::frames::{Drawer, Judge, draw, share_allowed};
use super::scene::StabilityScene;
use super::{linear, refusals, second_order, switching};
use crate::ladder::Extent;

/// A dimension of the matrix that needs no scene.
type PartRow = (&'static str, fn(Extent) -> Vec<Cell>);

/// Dimensions of the parts.
const PART_ROWS: [PartRow; 7] = [
    ("time constant", linear::time_constants),
    ("chain", linear::chains),
    ("second order", second_order::second_orders),
    ("limits", switching::slew),
    ("comparator", switching::comparators),
    ("hold", switching::holds),
    ("drift", linear::drift),
];
/// The row of what readers refuse.
const INPUT: &str = "input";

/// Choice of the rows and cases that are run.
#[derive(Debug, Clone)]
pub struct Choice {
    /// How long runs are.
    pub extent: Extent,
    /// These rows alone; all of them if empty.
    pub rows: Vec<String>,
    /// Whether every pair of extremes of different rows is run.
    pub pairs: bool,
    /// Number of random mixtures of extremes.
    pub mixtures: u32,
    /// Seed of the mixtures.
    pub seed: u64,
}

impl Choice {
    fn has(&self, row: &str) -> bool {
        self.rows.is_empty() || self.rows.iter().any(|wanted| wanted == row)
    }
}

/// Names of all rows.
pub fn rows() -> Vec<&'static str> {
    let mut names: Vec<&str> = PART_ROWS.iter().map(|(name, _)| *name).collect();
    for extreme in extremes() {
        if names.last() != Some(&extreme.row) {
            names.push(extreme.row);
        }
    }
    names.push(INPUT);
    names
}

/// Runs what is chosen over `scene`; `ideal` and `real` are the models that draw. `hear` is told of each row.
pub fn matrix(
    scene: &StabilityScene,
    [ideal, real]: [&HardwareModel; 2],
    choice: &Choice,
    hear: &mut dyn FnMut(&str),
) -> Vec<Cell> {
    let parts = with_parts(ideal, real);
    let drawer = |name, model, scalar, judge| Drawer { name, model, scalar, judge };
    let drawers = [
        drawer("ideal, f64", ideal, Scalar::F64, Judge::Rounding),
        drawer("ideal, f32", ideal, Scalar::F32, Judge::Rounding),
        drawer("parts, f32", &parts, Scalar::F32, Judge::Share),
        drawer("machine, f32", real, Scalar::F32, Judge::Bounds),
    ];
    let mut cells = Vec::new();
    for (name, run) in PART_ROWS.iter().filter(|(name, _)| choice.has(name)) {
        hear(name);
        cells.extend(run(choice.extent));
    }
    let mut all = extremes();
    all.retain(|extreme| choice.extent == Extent::Whole || !extreme.long);
    for extreme in all.iter().filter(|extreme| choice.has(extreme.row)) {
        hear(&format!("{}: {}", extreme.row, extreme.name));
        let able = drawers
            .iter()
            .filter(|drawer| drawer.judge == Judge::Rounding || !extreme.long)
            .copied()
            .collect::<Vec<_>>();
        cells.extend(frame_cells(scene, &able, extreme.row, &[extreme]));
    }
    if choice.has(INPUT) {
        hear(INPUT);
        cells.extend(refusals::refusals());
    }
    all.retain(|extreme| !extreme.long);
    if choice.pairs {
        let pairs = all.iter().enumerate().flat_map(|(k, a)| all[k + 1..].iter().map(move |b| [a, b]));
        for pair in pairs.filter(|[a, b]| a.row != b.row && (choice.has(a.row) || choice.has(b.row))) {
            cells.extend(frame_cells(scene, &drawers, "pair", &pair));
        }
    }
    for number in 0..choice.mixtures {
        hear(&format!("mixture {number} of seed {}", choice.seed));
        cells.extend(frame_cells(scene, &drawers, "mixture", &mixture(&all, choice.seed, number)));
    }
    cells
}

/// Analog parts, storage tubes and yoke of `real` behind the digital side of `ideal`, whose words are never late.
fn with_parts(ideal: &HardwareModel, real: &HardwareModel) -> HardwareModel {
    let HardwareModel { analog, sweep_memory, mixing_unit, yoke, .. } = real.clone();
    HardwareModel { analog, sweep_memory, mixing_unit, yoke, ..ideal.clone() }
}

/// Two to five extremes of different rows.
fn mixture(all: &[Extreme], seed: u64, number: u32) -> Vec<&Extreme> {
    let draw = |what: u64| hash_words(seed, &[u64::from(number), what]);
    let count = 2 + (draw(0) % 4) as usize;
    let mut chosen: Vec<&Extreme> = Vec::new();
    for k in 1..64 {
        let extreme = &all[(draw(k) % all.len() as u64) as usize];
        if chosen.len() < count && chosen.iter().all(|other| other.row != extreme.row) {
            chosen.push(extreme);
        }
    }
    // Ground before eye: the order of the table.
    let place = |extreme: &Extreme| all.iter().position(|other| std::ptr::eq(other, extreme));
    chosen.sort_by_key(|extreme| place(extreme));
    chosen
}

/// One extreme, or several together, by every machine.
fn frame_cells(
    scene: &StabilityScene,
    drawers: &[Drawer<'_>],
    row: &'static str,
    pushed: &[&Extreme],
) -> Vec<Cell> {
    let mut scene = scene.clone();
    pushed.iter().for_each(|extreme| extreme.apply.apply(&mut scene));
    let names: Vec<&str> = pushed.iter().map(|extreme| extreme.name.as_str()).collect();
    let case = names.join(" + ");
    let roundings = pushed.iter().map(|extreme| extreme.roundings).fold(0.0, f64::max);
    let shares = pushed.iter().map(|extreme| extreme.shares).fold(1.0, f64::max);
    let is_refused = pushed.iter().any(|extreme| extreme.refused) || scene.nears_the_zenith();
    let cell = |drawer: &Drawer<'_>| {
        let found = draw(&scene, drawer);
        let theory = if is_refused {
            Theory::Refuses
        } else {
            match (drawer.judge, drawer.scalar) {
                (Judge::Rounding, Scalar::F64) => Theory::Answers(roundings * f64::EPSILON),
                (Judge::Rounding, Scalar::F32) => Theory::Answers(roundings * f64::from(f32::EPSILON)),
                (Judge::Share, _) => Theory::Answers(shares * share_allowed(&scene, drawer)),
                (Judge::Bounds, _) => Theory::Bounded,
            }
        };
        Cell::own(row, &case, drawer.name, theory, found)
    };
    drawers.iter().map(cell).collect()
}
