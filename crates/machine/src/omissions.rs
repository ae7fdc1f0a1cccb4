//! What the elaborated machine leaves out, and why that cannot touch the picture.

use generator::Omission;

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
        list.push(Omission::lossless("terrain-generator", what, "the machine has one terrain generator"));
    }
    list
}
