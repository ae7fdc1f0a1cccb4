//! Posts that a scenario lists itself: rows and columns of seconds of arc.

use diagnostics::Reader;
use glam::DVec3;
use panel_program::{Lie, Posts};
use photo_camera::{Axis, Ellipsoid, parse_angle};
use serde_json::{Value, json};

/// Most rows and columns. Chosen: a quarter of a million posts are more than a table should list.
const MOST: u32 = 512;

/// A second of arc (rad).
const SECOND: f64 = std::f64::consts::PI / 648_000.0;

/// Posts a second of arc apart, flat but for blocks.
#[derive(Debug, Clone, PartialEq)]
pub struct PostTable {
    /// Latitude and longitude (rad) of the post in row 0 and column 0.
    pub reference: [f64; 2],
    /// Place of that post in the scenario: north, east (m).
    pub at: [f64; 2],
    /// First and last row, northward.
    pub rows: [u32; 2],
    /// First and last column, eastward.
    pub columns: [u32; 2],
    /// Height (m) of posts in no block.
    pub height: f64,
    /// Blocks; the later stands over the earlier.
    pub blocks: Vec<Block>,
}

/// Posts of a height.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// First and last row.
    pub rows: [u32; 2],
    /// First and last column.
    pub columns: [u32; 2],
    /// Height (m); none where the posts are void.
    pub height: Option<f64>,
}

impl PostTable {
    pub(super) fn read(table: &Reader) -> Option<Self> {
        let latitude = angle(table, "latitude", Axis::Latitude);
        let longitude = angle(table, "longitude", Axis::Longitude);
        let at = table.f64_array::<2>("at_m").default([0.0; 2]);
        let (rows, columns) = (range(table, "rows"), range(table, "columns"));
        let height = height(table);
        let blocks: Option<Vec<Block>> = table.tables("block").iter().map(Block::read).collect();
        Some(Self {
            reference: [latitude?, longitude?],
            at: at?,
            rows: rows?,
            columns: columns?,
            height: height??,
            blocks: blocks?,
        })
    }

    pub(super) fn record(&self) -> Value {
        let block =
            |block: &Block| json!({ "rows": block.rows, "columns": block.columns, "height_m": block.height });
        json!({
            "latitude_rad": self.reference[0],
            "longitude_rad": self.reference[1],
            "at_m": self.at,
            "rows": self.rows,
            "columns": self.columns,
            "height_m": self.height,
            "block": self.blocks.iter().map(block).collect::<Vec<_>>(),
        })
    }

    /// How the posts lie on a body.
    pub fn lie(&self, body: Ellipsoid) -> Lie {
        Lie::Degrees { body, reference: self.reference, at: self.at }
    }

    /// The posts on a body.
    pub fn posts(&self, body: Ellipsoid) -> Posts {
        let lie = self.lie(body);
        let all = (self.rows[0]..=self.rows[1])
            .flat_map(|row| (self.columns[0]..=self.columns[1]).map(move |column| [row, column]));
        let post = |[row, column]: [u32; 2]| {
            let [latitude, longitude] = self.reference;
            let place = lie.place(latitude + f64::from(row) * SECOND, longitude + f64::from(column) * SECOND);
            let [north, east] = place.unwrap_or(self.at);
            DVec3::new(north, east, self.height_of([row, column]))
        };
        let size = [self.rows, self.columns].map(|[first, last]| (last - first) as usize + 1);
        Posts { size, places: all.map(post).collect() }
    }

    /// Height (m) of a post; NaN where it is void.
    fn height_of(&self, [row, column]: [u32; 2]) -> f64 {
        let holds = |block: &&Block| {
            (block.rows[0]..=block.rows[1]).contains(&row)
                && (block.columns[0]..=block.columns[1]).contains(&column)
        };
        let block = self.blocks.iter().rfind(holds);
        block.map_or(self.height, |block| block.height.unwrap_or(f64::NAN))
    }
}

impl Block {
    fn read(table: &Reader) -> Option<Self> {
        let (rows, columns) = (range(table, "rows"), range(table, "columns"));
        let height = height(table);
        Some(Self { rows: rows?, columns: columns?, height: height? })
    }
}

/// A height (m), or the word `void`; none where it is neither.
fn height(table: &Reader) -> Option<Option<f64>> {
    table.f64("height_m").between(-32_766.0, 9_000.0).unit("m").or_word("void").required()
}

/// First and last of rows or columns, in order.
fn range(table: &Reader, key: &str) -> Option<[u32; 2]> {
    let rule = "a first and a last whole number from 0 to 100000, at most 512 apart";
    let is_range = |ends: &[f64; 2]| {
        let [first, last] = *ends;
        (0.0..=100_000.0).contains(&first)
            && first.fract() == 0.0
            && last.fract() == 0.0
            && (0.0..f64::from(MOST)).contains(&(last - first))
    };
    let ends = table.f64_array::<2>(key).must(rule, is_range).required()?;
    Some(ends.map(|end| end as u32))
}

/// An angle (rad): `37:22:47 N`, or signed degrees in quotes.
fn angle(table: &Reader, key: &str, axis: Axis) -> Option<f64> {
    let text = table.string(key).required()?;
    match parse_angle(&text, axis) {
        Ok(angle) => Some(angle),
        Err(error) => {
            table.report(table.problem(key, error.to_string()).found(text));
            None
        }
    }
}
