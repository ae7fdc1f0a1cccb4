//! Ways between blocks are those of the signal table.

use std::collections::BTreeSet;

use machine::{LINE_SIGNALS, LINKS, signals};

use crate::scene::Scene;

#[test]
fn every_way_leads_from_a_block_to_a_block_by_its_own_signals() {
    let blocks: BTreeSet<&str> = signals().iter().chain(LINE_SIGNALS).map(|signal| signal.block()).collect();
    for link in &LINKS {
        assert!(blocks.contains(link.from) && blocks.contains(link.to), "{link:?}");
        for name in link.signals {
            let signal = signals().iter().find(|signal| signal.name == *name);
            assert_eq!(signal.map(|signal| signal.block()), Some(link.from), "{name} of {link:?}");
        }
    }
    let reached = |name: &str| LINKS.iter().any(|link| link.to == name || link.from == name);
    assert_eq!(blocks.iter().find(|name| !reached(name)), None, "a block without a way");
}

#[test]
fn a_drive_tells_every_block_of_the_diagram() {
    let blocks = Scene::new("", &[]).drive().blocks();
    for link in &LINKS {
        assert!(
            blocks.iter().any(|block| block.name == link.from && block.links.contains(&link)),
            "{link:?}"
        );
        assert!(blocks.iter().any(|block| block.name == link.to), "{link:?}");
    }
    let guest = Scene::new("", &[]).by("exact").drive().blocks();
    assert!(
        guest.iter().all(|block| block.links.is_empty() && block.parts.is_empty() && block.tables.is_empty())
    );
}
