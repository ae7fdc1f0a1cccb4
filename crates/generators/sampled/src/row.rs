//! The row of the registry.

use std::sync::Arc;

use diagnostics::Reader;
use generator::{Gear, Generator, LampWay, Role, Row};

use crate::faults::FAULTS;
use crate::hardware::SHIPPED;
use crate::ladders::LADDERS;
use crate::rows::SIGNALS;
use crate::{Hardware, Parameters, Sampled};

/// Name of the generator.
pub(crate) const NAME: &str = "sampled";

/// The sampled generator in the registry.
pub static ROW: Row = Row {
    name: NAME,
    about: "triangles by sampling points, with translucency and light points (EP-0611021)",
    role: Role::Guest,
    signals: &SIGNALS,
    timed: true,
    parameters: Some(NAME),
    gear: Some(Gear {
        tables: &["sampler", "memory", "beam"],
        file: "built-in programs/sampled.toml",
        text: SHIPPED,
        faults: &FAULTS,
    }),
    ladders: &LADDERS,
    details: &[],
    lamps: &LAMPS,
    configure,
};

const LAMPS: [LampWay; 3] = [
    LampWay { name: "raster", is_calligraphic: false, sets: &[("sampled.normalise", "true")] },
    LampWay { name: "undivided", is_calligraphic: false, sets: &[("sampled.normalise", "false")] },
    LampWay { name: "beam", is_calligraphic: true, sets: &[] },
];

fn configure(root: &Reader) -> Option<Arc<dyn Generator>> {
    let parameters = Parameters::read(&root.table_or_empty(NAME));
    let hardware = Hardware::read(root);
    Some(Arc::new(Sampled { parameters: parameters?, hardware: hardware? }))
}
