//! Outcomes as JUnit XML.

use diagnostics::{JunitCase, JunitSuite};

use crate::outcome::Outcome;

/// One test case a cartridge; a failure has a line for every answer that is wrong and every overlay that nobody noticed.
pub fn junit(outcomes: &[Outcome]) -> String {
    let case = |outcome: &Outcome| {
        let faults = outcome.faults();
        let failure = (!faults.is_empty()).then(|| [format!("faults: {}", faults.len()), faults.join("\n")]);
        JunitCase { name: outcome.name.clone(), failure }
    };
    JunitSuite { name: "cartridges".into(), kind: "cartridge", cases: outcomes.iter().map(case).collect() }
        .xml()
}
