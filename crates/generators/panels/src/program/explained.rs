//! What a pixel of the program's picture shows, in words.

use generator::Fact;
use panel_program::{Look, Panel, Program};

/// The panel that was written last, its posts and photograph, its depth, how often the pixel was written; then what lost to it, in the order of drawing.
pub(super) fn explained(program: &Program, looks: &[Look]) -> Vec<Fact> {
    let shown = looks.iter().rposition(|look| look.is_written);
    let Some((shown, look)) = shown.and_then(|at| Some((at, looks.get(at)?))) else {
        return vec![Fact::new("panel", "none")];
    };
    let Panel { posts, grey, touches_void } = program.panels()[look.panel as usize];
    let [i, j] = grey.source;
    let writes = looks.iter().filter(|look| look.is_written).count();
    let mut facts = vec![
        Fact::new("panel", format!("{}; posts {posts:?}", look.panel)),
        Fact::new(
            "light of the panel",
            format!("{:.4}, mean of {} pixels of the photograph", grey.light, grey.pixels),
        ),
        Fact::new("photograph", format!("middle of the panel at pixel I {i:.2}, J {j:.2}")),
        Fact::new("void", if touches_void { "a post of it was void" } else { "none" }),
        Fact::new("depth buffer", format!("{:.3} m", look.distance)),
        Fact::new("written", format!("{writes} times")),
    ];
    let lost = looks.iter().enumerate().filter(|(at, _)| *at != shown);
    facts.extend(lost.map(|(_, look)| {
        let how = if look.is_written {
            "written before, and covered"
        } else {
            "not written, since it is no nearer"
        };
        Fact::new("lost", format!("panel {} at {:.3} m: {how}", look.panel, look.distance))
    }));
    facts
}
