//! Every deliberate break of the list still applies.

use std::collections::BTreeSet;

use lunoid_tests::breaks::{breaks, root};

#[test]
fn every_break_applies_to_the_code_as_it_is() {
    let breaks = breaks(&root()).unwrap_or_else(|error| panic!("{error}"));
    assert!(breaks.len() >= 30, "{} breaks: expected at least thirty", breaks.len());
    let names: BTreeSet<&str> = breaks.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(names.len(), breaks.len(), "two breaks have one name");
    for one in &breaks {
        let [before, after] = one.texts(&root()).unwrap_or_else(|error| panic!("{error}"));
        assert_ne!(before, after, "break {} changes nothing", one.name);
        assert!(!one.tests.is_empty(), "break {}: no test is asked", one.name);
        for line in &one.tests {
            assert!(!line.contains("golden"), "break {}: a golden picture is no answer: {line}", one.name);
        }
    }
}
