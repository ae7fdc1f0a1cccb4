//! What the generator refuses.

use generator::Generator;
use panels::Parameters;

use crate::shots::{landscape, panels, photograph, run, stage};

fn error(parameters: Parameters, photographs: usize) -> String {
    let photos = vec![photograph(80, 500.0, |_, _| 0.5); photographs];
    let stage = stage(landscape(0.0), photos, 16, 0.5);
    match panels(parameters).prepare(stage) {
        Err(error) => error.to_string(),
        Ok(_) => panic!("it was drawn"),
    }
}

#[test]
fn each_fault_is_one_message() {
    let none = error(run(), 0);
    assert!(none.contains("without photographs") && none.contains("[[photograph]]"), "{none}");
    let posts = error(Parameters { spacing: Some(0.01), ..run() }, 1);
    assert!(posts.contains("posts 0.01 m apart") && posts.contains("panels.spacing_m"), "{posts}");
}
