//! A comparison as JUnit XML, the report that continuous integration reads.

use diagnostics::{JunitCase, JunitSuite};

use crate::allowance::Allowed;
use crate::comparison::Comparison;
use crate::diff::diff;
use crate::difference::Difference;

impl Comparison {
    /// One test case for the head, one for the tasks before the mission and one a frame; a failure holds the first `limit` differences of its frame.
    /// With bounds one test case a bound instead.
    pub fn junit(&self, limit: usize) -> String {
        let cases = if self.allowed.is_empty() { self.case_by_case(limit) } else { self.bound_by_bound() };
        JunitSuite { name: format!("timing {} {}", self.scenario, self.machine), kind: "timing", cases }.xml()
    }

    fn case_by_case(&self, limit: usize) -> Vec<JunitCase> {
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
        cases
    }

    fn bound_by_bound(&self) -> Vec<JunitCase> {
        let case = |allowed: &Allowed| JunitCase {
            name: allowed.bound.clone(),
            failure: (!allowed.is_met).then(|| [allowed.told(), self.totals_line()]),
        };
        self.allowed.iter().map(case).collect()
    }
}

fn differing(differences: &[Difference]) -> String {
    format!("differences: {}", differences.len())
}
