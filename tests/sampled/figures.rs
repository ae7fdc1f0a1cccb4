//! Each scenario with its subject, and without it.

use compare::compare;
use generator::Generator;
use lunoid_tests::Shipped;
use lunoid_tests::shipped::Shown;
use scenario::Scenario;
use signal::Probe;

/// A frame of a shipped scenario after a change of it, with run parameters (`key = value`) over those of its file.
fn drawn(name: &str, frame: u64, parameters: &str, change: impl FnOnce(&mut Scenario)) -> Shown {
    let shipped = Shipped::changed(name, None, change);
    let text = std::fs::read_to_string(lunoid_tests::shipped::folder().join(format!("{name}.toml"))).unwrap();
    let problems = diagnostics::Problems::new();
    let file = |title: &str, text: &str| diagnostics::TomlFile::parse(title, text, &problems).unwrap();
    let layers = [file(name, &text), file("test", &format!("[sampled]\n{parameters}"))];
    let generator = registry::configure(&sampled::ROW, layers).unwrap();
    let session = generator.prepare(shipped.stage().stage()).unwrap();
    shipped.draw(&*session, frame, &mut Probe::off())
}

fn as_it_stands(_: &mut Scenario) {}

fn rmse(a: &Shown, b: &Shown) -> f64 {
    compare(&a.picture, &b.picture, None, &[]).unwrap().rmse
}
