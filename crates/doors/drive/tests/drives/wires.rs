//! Ways between blocks are those of the signal table.

use std::collections::BTreeSet;

use machine::{LINKS, signals};

#[test]
fn every_way_leads_from_a_block_to_a_block_by_its_own_signals() {
    let blocks: BTreeSet<&str> = signals().iter().map(|signal| signal.block()).collect();
    for link in &LINKS {
        assert!(blocks.contains(link.from) && blocks.contains(link.to), "{link:?}");
        for name in link.signals {
            let signal = signals().iter().find(|signal| signal.name == *name);
            assert_eq!(signal.map(|signal| signal.block()), Some(link.from), "{name} of {link:?}");
        }
    }
    let reached = |name: &str| LINKS.iter().any(|link| link.to == name || link.from == name);
    let alone: Vec<&str> = blocks.iter().copied().filter(|name| !reached(name)).collect();
    assert_eq!(alone, ["vehicle-shadow"], "the machine that augments pictures of a camera stands beside the others");
}
