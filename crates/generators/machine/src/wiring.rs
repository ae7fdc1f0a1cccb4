//! Who is wired to whom, as the report's overall figure has it (figs. 14, 15).

/// The way from one block to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Link {
    /// Name of the block that drives the way.
    pub from: &'static str,
    /// Name of the block at its other end.
    pub to: &'static str,
    /// What goes there, in words.
    pub carries: &'static str,
    /// The signals of the way; none where it carries only words that have no signal.
    pub signals: &'static [&'static str],
}

/// All ways between blocks, in the order of the data.
pub const LINKS: [Link; 22] = [
    link("data-bank", "dpu", "records", &["buffer.fine.lacks"]),
    link("dpu", "sweep-generator", "azimuth, start registers", &["cpu.drawn"]),
    link(
        "dpu",
        "terrain-generator",
        "coefficient words",
        &["loader.yellow.waiting", "loader.green.waiting", "loader.black.waiting", "loader.red.waiting"],
    ),
    link("dpu", "feature-generator", "feature parameters", &[]),
    link("dpu", "shadow-controller", "shadow boundaries", &[]),
    link("dpu", "polyhedron-generator", "vertices and reflectivities", &[]),
    link("dpu", "sweep-memory", "roll", &[]),
    link("sweep-generator", "dpu", "stops", &["sweep.fold.x", "sweep.fold.y"]),
    link(
        "sweep-generator",
        "terrain-generator",
        "folded ramps",
        &["sweep.x", "sweep.y", "sweep.polarity.x", "sweep.polarity.y"],
    ),
    link("sweep-generator", "feature-generator", "range", &["sweep.range"]),
    link("sweep-generator", "shadow-controller", "range", &["sweep.range"]),
    link("sweep-generator", "texture-generator", "folded ramps", &["sweep.x", "sweep.y"]),
    link("sweep-generator", "display-projection-processor", "range", &["sweep.range"]),
    link("terrain-generator", "mixing-unit", "height, reflectivity", &["tg.height", "tg.reflectivity"]),
    link(
        "feature-generator",
        "mixing-unit",
        "height, reflectivity, presence",
        &["fg.height", "fg.reflectivity", "fg.present"],
    ),
    link("feature-generator", "texture-generator", "grain", &["fg.grain"]),
    link("shadow-controller", "mixing-unit", "shadow gate", &["sc.gate"]),
    link("texture-generator", "mixing-unit", "texture", &["txg.texture"]),
    link("mixing-unit", "display-projection-processor", "one profile", &["mu.height", "mu.reflectivity"]),
    link("display-projection-processor", "sweep-memory", "deflection, blanking", &["dpp.y", "dpp.blank"]),
    link(
        "polyhedron-generator",
        "sweep-memory",
        "bodies, by the third video switch",
        &["pg.present", "pg.reflectivity"],
    ),
    link("sweep-memory", "picture-tube", "video", &["sm.video", "sm.write"]),
];

const fn link(
    from: &'static str,
    to: &'static str,
    carries: &'static str,
    signals: &'static [&'static str],
) -> Link {
    Link { from, to, carries, signals }
}
