//! A row of a table of measured figures: what is compared, what must hold, what was found.

use crate::guests::Sense;

/// What is compared, figures of the issue, the measured one with its words, both sides, remark.
pub struct Row {
    /// Issue that set the figures.
    pub issue: u32,
    /// What is compared, in words.
    pub quantity: String,
    /// What must be reached, and what is aimed at.
    pub figures: [f64; 2],
    /// The figure that was measured.
    pub measured: f64,
    /// Words that stand behind it.
    pub words: &'static str,
    /// Whether it is what must be.
    pub is_met: bool,
    /// Both sides, with their units.
    pub sides: [String; 2],
    /// What else belongs to the row.
    pub remark: String,
}

impl Row {
    /// Head of a table of rows, in Markdown.
    pub const HEAD: &str = "| issue | quantity | must | aim | measured | | ours | other | |\n|---|---|---|---|---|---|---|---|---|\n";

    /// A row of two times (s), ours and the other's.
    pub fn of_times(
        issue: u32,
        quantity: String,
        (sense, figures): (Sense, [f64; 2]),
        times: [f64; 2],
        remark: String,
    ) -> Self {
        let (measured, is_met) = sense.figure(times, figures[0]);
        let (words, sides) = (sense.words(), times.map(|seconds| format!("{:.2} ms", seconds * 1e3)));
        Self { issue, quantity, figures, measured, words, is_met, sides, remark }
    }

    /// The row as a line of a table in Markdown.
    pub fn line(&self) -> String {
        let Self {
            issue,
            quantity,
            figures: [must, aim],
            measured,
            words,
            is_met,
            sides: [ours, other],
            remark,
        } = self;
        let met = if *is_met { "met" } else { "**not met**" };
        format!(
            "| {issue} | {quantity} | {must} | {aim} | {measured:.2} {words} | {met} | {ours} | {other} | {remark} |\n"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::Row;
    use crate::guests::Sense;

    #[test]
    fn rows_of_times_count_both_ways() {
        let row =
            |sense, figures, times| Row::of_times(1, "q".into(), (sense, figures), times, String::new());
        let fast = row(Sense::AsFast, [3.0, 9.0], [0.002, 0.006]);
        assert_eq!((fast.measured, fast.is_met), (3.0, true));
        let slow = row(Sense::TimesTheTime, [3.0, 1.0], [0.008, 0.002]);
        assert_eq!((slow.measured, slow.is_met), (4.0, false));
        assert_eq!(
            slow.line(),
            "| 1 | q | 3 | 1 | 4.00 times its time | **not met** | 8.00 ms | 2.00 ms |  |\n"
        );
    }
}
