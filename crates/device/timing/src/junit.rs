//! A comparison as JUnit XML, the report that continuous integration reads.

use diagnostics::{JunitCase, JunitSuite};

use crate::comparison::Comparison;
use crate::diff::diff;
use crate::difference::Difference;

impl Comparison {
    /// One test case for the head, one for the tasks before the mission and one a frame; a failure holds the first `limit` differences of its frame.
    pub fn junit(&self, limit: usize) -> String {
        let case = |name: &str, differences: &[Difference], message: String| JunitCase {
            name: name.to_owned(),
            failure: (!differences.is_empty()).then(|| [message, diff(differences, limit)]),
        };
        let tasks = &self.before_mission;
        let mut cases =
            vec![case("head", &self.head, self.cause()), case("before the mission", tasks, differing(tasks))];
        cases.extend(self.frames.iter().map(|frame| {
            let message = match self.totals_line() {
                totals if totals.is_empty() => differing(&frame.differences),
                totals => format!("{}; in all frames {totals}", differing(&frame.differences)),
            };
            case(&format!("frame {}", frame.frame), &frame.differences, message)
        }));
        JunitSuite { name: format!("timing {} {}", self.scenario, self.machine), kind: "timing", cases }.xml()
    }
}

fn differing(differences: &[Difference]) -> String {
    format!("differences: {}", differences.len())
}
