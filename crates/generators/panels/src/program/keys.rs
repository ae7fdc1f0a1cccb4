//! Keys of `[panels]` that turn findings of the listing on.

use diagnostics::Reader;
use panel_program::{Fill, Restrictions};
use serde_json::Value;

use super::PostTable;

/// What becomes of panels that touch a void: they have the grey of their filled posts, or the light outside.
const VOIDS: [(&str, bool); 2] = [("fill", false), ("mark", true)];

/// What the program of the thesis is asked for.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ProgramKeys {
    /// Findings that are turned on.
    pub restrictions: Restrictions,
    /// How panels are filled; the listing's way where none is asked for.
    pub fill: Option<Fill>,
    /// Posts of the program in place of those of the landscape.
    pub posts: Option<PostTable>,
    /// Whether panels that touch a void have the light outside.
    pub marks_voids: bool,
    /// Whether pixels on both sides of a border of panels have their mean.
    pub blends_borders: bool,
}

impl ProgramKeys {
    /// Whether the program draws, in place of the scene sampler.
    pub fn draws(&self) -> bool {
        self.restrictions.any()
            || self.fill.is_some()
            || self.posts.is_some()
            || self.marks_voids
            || self.blends_borders
    }

    /// Reads the keys. `restrictions` turns all findings on; the key of a finding stands over it.
    pub(crate) fn read(table: &Reader) -> Option<Self> {
        let all = table.bool("restrictions").default(false);
        let mut restrictions = Restrictions::default();
        let mut is_read = true;
        for (key, switch) in Restrictions::SWITCHES {
            match table.bool(key).default(all.unwrap_or(false)) {
                Some(value) => *switch(&mut restrictions) = value,
                None => is_read = false,
            }
        }
        let fill = table.one_of("fill", &Fill::ALL).optional();
        let marks_voids = table.one_of("voids", &VOIDS).default(false);
        let blends_borders = table.bool("boundary_blend").default(false);
        let posts = match table.optional_table("posts") {
            Some(posts) => PostTable::read(&posts).map(Some),
            None => (!table.has("posts")).then_some(None),
        };
        Some(Self {
            restrictions: (all.is_some() && is_read).then_some(restrictions)?,
            fill: (fill.is_some() || !table.has("fill")).then_some(fill)?,
            posts: posts?,
            marks_voids: marks_voids?,
            blends_borders: blends_borders?,
        })
    }

    /// Adds the keys to the record of a run, if the program draws.
    pub(crate) fn record(&self, record: &mut Value) {
        if !self.draws() {
            return;
        }
        let mut restrictions = self.restrictions;
        for (key, switch) in Restrictions::SWITCHES {
            record[key] = (*switch(&mut restrictions)).into();
        }
        let word = Fill::ALL.iter().find(|(_, fill)| *fill == self.way()).map(|(word, _)| *word);
        record["fill"] = word.into();
        if self.marks_voids {
            record["voids"] = VOIDS[1].0.into();
        }
        if self.blends_borders {
            record["boundary_blend"] = true.into();
        }
        if let Some(posts) = &self.posts {
            record["posts"] = posts.record();
        }
    }

    /// The way in which panels are filled.
    pub(crate) fn way(&self) -> Fill {
        self.fill.unwrap_or(Fill::EdgeBuffer)
    }
}
