//! Run parameters of the generator, as `[sampled]` and `--set sampled.KEY=VALUE` give them.

use diagnostics::Reader;

use crate::policy::Overload;

/// Run parameters that no other generator has, and those of sampling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters {
    /// How a scene is sampled.
    pub sampling: scene_sampler::Parameters,
    /// Half the side of the innermost square of ground (m).
    pub ground_half_side: f64,
    /// Most cells along half the side of every square of ground.
    pub ground_cells: u32,
    /// Error of the ground in the view of frame 0 (pixels) up to which it has fewer cells; 0 for never.
    pub ground_error: f64,
    /// Which features lose their places where a list is full.
    pub overload: Overload,
}

impl Default for Parameters {
    /// All figures are chosen. An error of the ground of half a pixel is as much as the points of the pattern `4` are apart.
    fn default() -> Self {
        Self {
            sampling: scene_sampler::Parameters::default(),
            ground_half_side: 32.0,
            ground_cells: 128,
            ground_error: 0.5,
            overload: Overload::DropSmallest,
        }
    }
}

impl Parameters {
    /// The parameters of a `[sampled]` table; the default where the table has no key.
    pub(crate) fn read(table: &Reader) -> Option<Self> {
        let usual = Self::default();
        let sampling = scene_sampler::Parameters::read(table);
        let ground_half_side =
            table.f64("ground_half_side_m").between(0.1, 1e5).unit("m").default(usual.ground_half_side);
        let rule = "a multiple of 4";
        let ground_cells = table
            .u32("ground_cells")
            .between(ground_mesh::FEWEST_CELLS, ground_mesh::MOST_CELLS)
            .must(rule, |cells| cells.is_multiple_of(4))
            .default(usual.ground_cells);
        let ground_error =
            table.f64("ground_error_px").between(0.0, 100.0).unit("pixels").default(usual.ground_error);
        let overload = table.one_of("overload", &Overload::WORDS).default(usual.overload);
        Some(Self {
            sampling: sampling?,
            ground_half_side: ground_half_side?,
            ground_cells: ground_cells?,
            ground_error: ground_error?,
            overload: overload?,
        })
    }
}
