//! The budget as lines that a person reads and a program takes apart.

use std::fmt;

use super::{Budget, CpuBudget, CrossingBudget, DrumBudget, GroundScale, LoaderBudget, SweepBudget};

/// One figure of a budget.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BudgetLine {
    /// Name with the unit, as `sweep_period_us`.
    pub key: &'static str,
    /// Meaning of the figure, in words.
    pub meaning: &'static str,
    /// Value of the figure, in `unit`.
    pub value: f64,
    /// Unit of the value.
    pub unit: &'static str,
    /// How it comes about, in the symbols of hardware section 4.
    pub formula: &'static str,
}

const fn line(
    key: &'static str,
    meaning: &'static str,
    value: f64,
    unit: &'static str,
    formula: &'static str,
) -> BudgetLine {
    BudgetLine { key, meaning, value, unit, formula }
}

impl Budget {
    /// All figures, in the order of hardware section 4.
    pub fn lines(&self) -> Vec<BudgetLine> {
        let drum = self.drum.iter().flat_map(drum_lines);
        ground_lines(&self.ground)
            .into_iter()
            .chain(sweep_lines(&self.sweep))
            .chain(crossing_lines(&self.crossings))
            .chain(loader_lines(&self.loader))
            .chain(cpu_lines(&self.cpu))
            .chain(drum)
            .collect()
    }
}

impl fmt::Display for Budget {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for BudgetLine { meaning, value, unit, formula, .. } in self.lines() {
            let line = format!("{meaning:<44} {:>10} {unit:<8} {formula}", four_digits(value));
            writeln!(f, "{}", line.trim_end())?;
        }
        Ok(())
    }
}

/// Four significant digits; more where they stand before the point.
pub(crate) fn four_digits(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let magnitude = libm::floor(libm::log10(value.abs())) as i32;
    format!("{value:.*}", (3 - magnitude).clamp(0, 12) as usize)
}

fn ground_lines(ground: &GroundScale) -> [BudgetLine; 2] {
    [
        line("region_size_m", "region size", ground.region_size, "m", "d"),
        line("range_m", "ground range of a sweep", ground.range, "m", "R"),
    ]
}

fn sweep_lines(sweep: &SweepBudget) -> [BudgetLine; 4] {
    [
        line("sweep_period_us", "sweep period", 1e6 * sweep.period, "µs", "T = 1/(n f)"),
        line("active_us", "drawn part", 1e6 * sweep.active, "µs", "Ta = T (1 - blanking)"),
        line("sample_ns", "sample", 1e9 * sweep.sample, "ns", "dt = Ta/N"),
        line(
            "video_bandwidth_mhz",
            "video bandwidth needed",
            1e-6 * sweep.video_bandwidth,
            "MHz",
            "N/(2 Ta)",
        ),
    ]
}

fn crossing_lines(crossings: &CrossingBudget) -> [BudgetLine; 9] {
    let CrossingBudget { rate, end_rate, mean, worst, axis, interval, ramp, words_used, words_loaded } =
        *crossings;
    [
        line("rate_m_us", "ground-range rate", 1e-6 * rate, "m/µs", "v = R/Ta"),
        line(
            "end_rate_m_us",
            "the same at the end of the model's range",
            1e-6 * end_rate,
            "m/µs",
            "own programme",
        ),
        line("crossings_mean", "crossings a sweep, mean over azimuth", mean, "", "4 R/(pi d)"),
        line("crossings_worst", "crossings a sweep, along a diagonal", worst, "", "sqrt(2) R/d"),
        line("axis_crossing_us", "stop to stop of one axis", 1e6 * axis, "µs", "d/v"),
        line("crossing_interval_us", "mean time between crossings", 1e6 * interval, "µs", "Ta/n"),
        line("ramp_v_us", "slope of a ramp", 1e-6 * ramp, "V/µs", "FS v/d"),
        line("words_used_us", "words used", 1e-6 * words_used, "1/µs", "18 n/Ta"),
        line("words_loaded_us", "words loaded", 1e-6 * words_loaded, "1/µs", "36 n/Ta"),
    ]
}

fn loader_lines(loader: &LoaderBudget) -> [BudgetLine; 5] {
    [
        line("urgent_ns", "fold to urgent set, at worst", 1e9 * loader.urgent, "ns", "t_u"),
        line("grace_ns", "lateness that does not show", 1e9 * loader.grace, "ns", "0.1 d/v"),
        line("late_sets", "late urgent sets a sweep", loader.late, "", "R v t_u 2/(pi d^2)"),
        line("height_step_pct", "step of the worst of them", 100.0 * loader.step, "%", "S0(v t_u/d)"),
        line("loader_load_pct", "use of loader and buffer", 100.0 * loader.load, "%", "4 sets a crossing"),
    ]
}

fn cpu_lines(cpu: &CpuBudget) -> [BudgetLine; 7] {
    let percent = |key, meaning, share: f64, formula| line(key, meaning, 100.0 * share, "%", formula);
    [
        percent("cpu_sweep_setup_pct", "processor: sweep set-up", cpu.sweep_setup, "of T"),
        percent("cpu_frame_tables_pct", "processor: frame tables", cpu.frame_tables, "of 1/f"),
        line(
            "cpu_crossing_us",
            "processor: one crossing by interrupt",
            1e6 * cpu.crossing,
            "µs",
            "t_int + instructions",
        ),
        percent(
            "cpu_interrupts_pct",
            "processor: crossing interrupts",
            cpu.interrupts,
            "of T, if it serves them",
        ),
        percent("cpu_loads_pct", "processor: words of crossings", cpu.loads, "of T, through its memory"),
        percent("cpu_total_pct", "processor: all of these", cpu.total, ""),
        percent("cpu_vertices_pct", "processor: 100 vertices, beside", cpu.hundred_vertices, "of 1/f"),
    ]
}

fn drum_lines(drum: &DrumBudget) -> [BudgetLine; 5] {
    [
        line(
            "sector_corners",
            "corners of the sector of 50 degrees",
            drum.corners,
            "",
            "area + 4 P/(pi d) + 4",
        ),
        line("sector_words", "their words", drum.words, "", "9 a corner"),
        line("sector_fill_ms", "transfer of all of them", 1e3 * drum.fill, "ms", "without latency"),
        line("corners_turning_s", "new corners at 10 degrees/s", drum.turning, "1/s", "R^2 omega/(2 d^2)"),
        line(
            "drum_load_pct",
            "use of the drums at 10 degrees/s",
            100.0 * drum.load,
            "%",
            "records, one by one",
        ),
    ]
}
