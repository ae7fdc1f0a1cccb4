//! The overall figure of the report, with the blocks that the scene left out.

use maud::{Markup, html};

use run_record::OmissionRecord;

/// A block of the figure.
struct Block {
    /// Its crate, as omissions name it.
    name: &'static str,
    lines: &'static [&'static str],
    /// What joins it to the others: left out with the block. None for blocks that are always there.
    joint: Option<&'static str>,
    /// Left, top, width, height.
    place: [u32; 4],
}

const fn block(
    name: &'static str,
    lines: &'static [&'static str],
    joint: Option<&'static str>,
    place: [u32; 4],
) -> Block {
    Block { name, lines, joint, place }
}

const BLOCKS: [Block; 11] = [
    block("dpu", &["digital", "processing unit"], None, [10, 20, 140, 60]),
    block("sweep-generator", &["sweep", "generator"], None, [10, 150, 140, 60]),
    block("terrain-generator", &["terrain generator"], None, [210, 20, 180, 44]),
    block("feature-generator", &["feature generator"], Some("VS1"), [210, 84, 180, 44]),
    block("shadow-controller", &["shadow controller"], Some("VS2"), [210, 148, 180, 44]),
    block("texture-generator", &["texture generator"], Some("adder"), [210, 212, 180, 44]),
    block("polyhedron-generator", &["polyhedron generator"], Some("VS3"), [210, 276, 180, 44]),
    block("mixing-unit", &["mixing unit"], None, [450, 20, 110, 236]),
    block("display-projection-processor", &["display", "projection", "processor"], None, [610, 96, 120, 84]),
    block("sweep-memory", &["sweep", "memory"], None, [780, 96, 110, 84]),
    block("picture-tube", &["display"], None, [780, 20, 110, 44]),
];

/// Wires between blocks: the block on whose presence the wire depends, and its path.
const WIRES: [(&str, &str); 15] = [
    ("dpu", "M80 80V150"),
    ("dpu", "M150 42H210"),
    ("sweep-generator", "M150 180H180V48H210"),
    ("feature-generator", "M180 106H210"),
    ("shadow-controller", "M180 170H210"),
    ("texture-generator", "M180 180V234H210"),
    ("polyhedron-generator", "M150 60H166V298H210"),
    ("terrain-generator", "M390 42H450"),
    ("feature-generator", "M390 106H450"),
    ("shadow-controller", "M390 170H450"),
    ("texture-generator", "M390 234H450"),
    ("mixing-unit", "M560 138H610"),
    ("display-projection-processor", "M730 138H780"),
    ("polyhedron-generator", "M390 298H835V180"),
    ("sweep-memory", "M835 96V64"),
];

/// Whether what joins a block to the others is left out, and the block with it.
fn is_absent(block: &Block, omissions: &[OmissionRecord]) -> bool {
    let Some(joint) = block.joint else { return false };
    omissions.iter().any(|omission| omission.block == block.name && names(&omission.what, joint))
}

fn names(what: &str, joint: &str) -> bool {
    what.split(|c: char| !c.is_ascii_alphanumeric()).any(|word| word == joint)
}

/// The figure; blocks that are left out are drawn in broken lines.
pub(crate) fn diagram(omissions: &[OmissionRecord]) -> Markup {
    let absent = |name: &str| BLOCKS.iter().any(|block| block.name == name && is_absent(block, omissions));
    html! {
        svg.diagram viewBox="0 0 900 340" role="img" aria-labelledby="diagram-title" {
            title #diagram-title { (in_words(omissions)) }
            defs { marker #tip viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto" {
                path d="M0 1L7 4L0 7z" {}
            } }
            @for (from, path) in WIRES { path.wire.absent[absent(from)] d=(path) marker-end="url(#tip)" {} }
            @for block in &BLOCKS { (drawn(block, omissions)) }
        }
    }
}

fn drawn(block: &Block, omissions: &[OmissionRecord]) -> Markup {
    let [x, y, width, height] = block.place;
    let parts = omissions.iter().filter(|omission| omission.block == block.name).count();
    let absent = is_absent(block, omissions);
    let first = f64::from(y) + 0.5 * f64::from(height) - 8.5 * (block.lines.len() as f64 - 1.0) + 5.0;
    html! {
        g.block.absent[absent].partly[!absent && parts > 0] {
            rect x=(x) y=(y) width=(width) height=(height) rx="2" {}
            @for (index, line) in block.lines.iter().enumerate() {
                text x=(x + width / 2) y=(format!("{:.1}", first + 17.0 * index as f64)) { (line) }
            }
            @if !absent && parts > 0 { circle cx=(x + width) cy=(y) r="5" {} }
        }
    }
}

fn in_words(omissions: &[OmissionRecord]) -> String {
    let absent: Vec<String> = BLOCKS
        .iter()
        .filter(|block| is_absent(block, omissions))
        .map(|block| block.lines.join(" "))
        .collect();
    match absent.as_slice() {
        [] => "Blocks of the machine: all are there".into(),
        some => format!("Blocks of the machine; left out: {}", some.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::{BLOCKS, diagram, in_words};
    use run_record::{OmissionRecord, WeightRecord};

    fn omission(block: &str, what: &str) -> OmissionRecord {
        let (why, weight) = (String::new(), WeightRecord::Lossless);
        OmissionRecord { block: block.into(), what: what.into(), why, weight }
    }

    #[test]
    fn a_block_goes_with_what_joins_it() {
        let absent = |block, what| in_words(&[omission(block, what)]).contains("left out");
        assert!(absent("feature-generator", "sub-generators and VS1"));
        assert!(absent("shadow-controller", "line generators and VS2"));
        assert!(absent("texture-generator", "texture and its adder"));
        assert!(absent("polyhedron-generator", "polyhedra and VS3"));
        assert!(!absent("texture-generator", "texture beyond 80 m"));
        assert!(!absent("polyhedron-generator", "rocks and culture smaller than a resolution cell"));
        assert!(!absent("terrain-generator", "second level and its switch"));
        let drawn = diagram(&[omission("texture-generator", "texture beyond 80 m")]).into_string();
        assert_eq!((drawn.matches("<circle").count(), drawn.matches("absent").count()), (1, 0));
    }

    #[test]
    fn blocks_do_not_lie_on_one_another() {
        for (index, a) in BLOCKS.iter().enumerate() {
            for b in &BLOCKS[index + 1..] {
                let apart = |side: usize| {
                    let (a, b) = (a.place, b.place);
                    a[side] + a[side + 2] <= b[side] || b[side] + b[side + 2] <= a[side]
                };
                assert!(apart(0) || apart(1), "{} {}", a.name, b.name);
            }
        }
    }
}
