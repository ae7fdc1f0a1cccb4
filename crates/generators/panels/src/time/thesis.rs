//! Table 1 of the thesis: seconds that its routines took.

use generator::ReportedTime;

const fn time(routine: &'static str, seconds: f64) -> ReportedTime {
    ReportedTime { routine, seconds }
}

/// Seconds of processor time on the artificial data set, in the order in which the program calls its routines. What asks its user was not measured.
pub const REPORTED: [ReportedTime; 11] = [
    time("ter-crop", 14.11),
    time("read-image", 3.23),
    time("ter-intrp", 0.04),
    time("real-el", 0.07),
    time("ter-dms", 0.69),
    time("im-refij", 0.39),
    time("im-refavg", 1.10),
    time("affin", 0.04),
    time("new-ij", 0.80),
    time("node-depth", 0.63),
    time("fill", 134.80),
];
