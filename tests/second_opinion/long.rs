//! Every shipped scenario in lockstep under every shipped model, only where it is asked for by name: docs/lockstep.md.

#[allow(dead_code, reason = "its tests run with the others")]
mod shipped;

#[test]
fn long_under_every_model() {
    let mut different = Vec::new();
    for name in shipped::NAMED {
        let found = shipped::check(name, &shipped::MODELS);
        println!("{name}: {} reports, {} differ", 2 * shipped::MODELS.len(), found.len());
        different.extend(found);
    }
    assert!(different.is_empty(), "{}", different.join("\n"));
}
