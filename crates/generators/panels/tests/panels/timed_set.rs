//! The set that the thesis must have timed: rows and columns of posts, and the mean box of a panel, that come nearest to its seconds.

use generator::ReportedTime;
use panel_program::{FillPieces, MOST_PANELS, MOST_ROWS, SIDE, Work, WrittenFill};
use panels::{Hardware, REPORTED, tasks};

/// Pixels of the photograph in a panel, as the thesis has it.
const PIXELS_OF_PANEL: f64 = 345.0;
/// Seconds that measuring a routine takes: AFFIN does two divisions, and the thesis has this for it.
const MEASURING: f64 = 0.04;
/// Cells of the screen.
const SCREEN: f64 = (SIDE * SIDE) as f64;
/// Buckets and words that FRAMEFIL clears for a panel.
const BUCKETS: u64 = SIDE as u64 + 12;

/// A set of posts with what the gear makes of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Set {
    /// Rows and columns of posts.
    pub size: [usize; 2],
    /// Mean number of cells in the box of a panel with which FILL takes the time of the thesis; 0 or less where it takes that without.
    pub box_cells: f64,
    /// Predicted over reported time of the routines that nothing was fitted to, in the order of the listing.
    pub ratios: Vec<(&'static str, f64)>,
}

impl Set {
    /// The set of a size. Every pixel that is marked is written, and half of a box is marked.
    pub fn new(size: [usize; 2], hardware: &Hardware) -> Self {
        let second = |work: &Work, routine: &str| {
            let all = tasks(work, hardware);
            let ours = all.iter().filter(|task| task.task.split('.').next() == Some(routine));
            ours.map(|task| task.ticks as f64 / 1e9).sum::<f64>()
        };
        let without = work(size, 0);
        let of_fill = |boxed: u64| second(&work(size, boxed), "fill");
        let [empty, full] = [0, SCREEN as u64].map(of_fill);
        let is_free = |time: &&ReportedTime| !["ter-crop", "read-image", "fill"].contains(&time.routine);
        let ratio = |time: &ReportedTime| (time.routine, second(&without, time.routine) / time.seconds);
        let boxed = SCREEN * (reported("fill") - empty) / (full - empty);
        let set = Self { size, box_cells: 0.0, ratios: REPORTED.iter().filter(is_free).map(ratio).collect() };
        Self { box_cells: boxed / set.panels() as f64, ..set }
    }

    /// Number of panels, two a cell.
    pub fn panels(&self) -> usize {
        2 * (self.size[0] - 1) * (self.size[1] - 1)
    }

    /// By what factor the routines are off, in the root mean square of their logarithms. Those that took no longer than the measuring are left out.
    pub fn off_by(&self) -> f64 {
        let is_measured = |routine: &str| reported(routine) > MEASURING;
        let logarithms: Vec<f64> = self
            .ratios
            .iter()
            .filter(|(routine, _)| is_measured(routine))
            .map(|(_, ratio)| libm::log(*ratio))
            .collect();
        let squares: f64 = logarithms.iter().map(|logarithm| logarithm * logarithm).sum();
        libm::exp((squares / logarithms.len() as f64).sqrt())
    }

    /// How often the boxes of all panels would cover the screen.
    pub fn screens(&self) -> f64 {
        self.box_cells * self.panels() as f64 / SCREEN
    }
}

/// Seconds of a routine in the thesis.
fn reported(routine: &str) -> f64 {
    REPORTED.iter().find(|time| time.routine == routine).map_or(0.0, |time| time.seconds)
}

/// Work on a set whose panels have so many cells in their boxes together.
fn work(size: [usize; 2], boxed: u64) -> Work {
    let [rows, columns] = size.map(|side| side as u64);
    let (posts, panels) = (rows * columns, 2 * (rows - 1) * (columns - 1));
    let written = WrittenFill { buckets: panels * BUCKETS, boxed, marked: boxed / 2 };
    let (cells, records) = (2 * SCREEN as u64, SIDE as u64);
    Work {
        numbers: 49_980,
        bytes: SCREEN as u64,
        visits: 2 * posts,
        rows,
        placed: posts,
        referenced: posts,
        averaged: (PIXELS_OF_PANEL * panels as f64) as u64,
        panels,
        affine: 1,
        projected: posts,
        measured: posts,
        fill: FillPieces { cells, panels, written, pixels: boxed / 2, records },
    }
}

/// All sets that the listing has room for, the best first; of equals the smaller.
pub fn sets(hardware: &Hardware) -> Vec<Set> {
    let sides = || 2..=MOST_ROWS;
    let sizes = sides().flat_map(|rows| sides().map(move |columns| [rows, columns]));
    let all = sizes.map(|size| Set::new(size, hardware));
    let mut sets: Vec<Set> = all.filter(|set| set.panels() <= MOST_PANELS).collect();
    sets.sort_by(|a, b| a.off_by().total_cmp(&b.off_by()));
    sets
}

/// Rows of a table: the best set, the real one, the largest square, each with its residuals.
pub fn table(hardware: &Hardware) -> Vec<String> {
    let best = sets(hardware).swap_remove(0);
    let shown =
        [("best", best), ("real", Set::new([9, 12], hardware)), ("largest", Set::new([17, 17], hardware))];
    let row = |(name, set): &(&str, Set)| {
        let [rows, columns] = set.size;
        let ratios: Vec<String> = set
            .ratios
            .iter()
            .map(|(_, ratio)| if *ratio < 0.01 { "0".to_owned() } else { format!("{ratio:.2}") })
            .collect();
        format!(
            "| {name} | {rows} x {columns} | {} | {} | {:.1} | {:.0} | {:.0} |",
            set.panels(),
            ratios.join(" | "),
            set.off_by(),
            set.box_cells,
            set.screens()
        )
    };
    shown.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The data sheet, which has the table.
    const SHEET: &str = include_str!("../../../../../docs/blocks/panels.md");

    #[test]
    fn the_sheet_has_the_table_of_the_search() {
        for row in table(&Hardware::shipped().unwrap()) {
            assert!(SHEET.lines().any(|line| line == row), "not in the sheet: {row}");
        }
    }

    #[test]
    fn the_box_that_is_found_takes_the_time_of_the_thesis() {
        let hardware = Hardware::shipped().unwrap();
        let set = Set::new([9, 12], &hardware);
        let boxed = (set.box_cells * 176.0).round() as u64;
        let fill = tasks(&work(set.size, boxed), &hardware);
        let seconds: f64 = fill
            .iter()
            .filter(|task| task.task.starts_with("fill"))
            .map(|task| task.ticks as f64 / 1e9)
            .sum();
        assert!((seconds - 134.80).abs() < 1e-3, "{seconds}");
        assert_eq!((set.panels(), set.ratios.len()), (176, 8));
    }

    /// A search finds again what it is given: with a gear that reads numbers faster, more posts are needed.
    #[test]
    fn slower_numbers_mean_fewer_posts() {
        let shipped = Hardware::shipped().unwrap();
        let posts = |formatted_number: u64| {
            let best = sets(&Hardware { formatted_number, ..shipped }).swap_remove(0);
            best.size[0] * best.size[1]
        };
        let [slow, fast] = [4 * shipped.formatted_number, shipped.formatted_number / 4].map(posts);
        assert!(slow < fast, "{slow} {fast}");
    }

    /// No set that the listing has room for explains the fill: boxes of all panels would cover the screen many times.
    #[test]
    fn no_set_explains_the_fill() {
        let all = sets(&Hardware::shipped().unwrap());
        let least = all.iter().map(Set::screens).fold(f64::INFINITY, f64::min);
        assert!(least > 10.0, "{least}");
    }
}
