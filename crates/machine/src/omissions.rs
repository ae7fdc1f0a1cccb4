//! What the elaborated machine leaves out, and what that does to the picture.

use generator::{Omission, Weight};

/// What a machine for terrain alone leaves out.
pub(crate) fn omissions(levels: usize) -> Vec<Omission> {
    let no_customer =
        |block, what| Omission::lossless(block, what, "the scenario has nothing for it to draw");
    let mut list = vec![
        no_customer("mixing-unit", "video switches VS1, VS2, VS3 and the texture adder"),
        Omission::lossless("terrain-generator", "dynamics of parts", "all parts of the model are ideal"),
        Omission::lossless("sweep-memory", "spot, exposure, residue", "all parts of the model are ideal"),
    ];
    if levels > 1 {
        let what = format!("{} coarser terrain levels", levels - 1);
        let why = "the machine has one terrain generator; the finest level alone is drawn".into();
        list.push(Omission { block: "terrain-generator", what, why, weight: Weight::NotModelled });
    }
    list
}
