//! Problems of a file: all of them, each with place, found, expected, what to do.
//!
//! Files that people write (scenarios, hardware models) are read through a [`Reader`] of one TOML table.
//! Each getter that meets a fault records a [`Problem`] in [`Problems`] and returns `None`, so that
//! reading goes on and one run lists every fault. Keys nobody asked for are faults as well:
//! [`Reader::finish`] on the root reports them, in all tables below it.
//!
//! ```
//! use diagnostics::{Problems, TomlFile};
//!
//! #[derive(Clone, Copy, Debug, PartialEq)]
//! enum Projection { Exact, AsReported }
//!
//! let text = r#"
//! format = 1
//! title = "Ridge"
//! projection = "exakt"
//!
//! [raster]
//! sweps = 1000
//! lines = 99999
//! field_of_view_deg = [40, 30.0]
//! "#;
//!
//! let problems = Problems::new();
//! let file = TomlFile::parse("scenarios/ridge.toml", text, &problems).expect("no fault of syntax");
//! let root = file.root(&problems);
//! root.format_version(1);
//! assert_eq!(root.string("title").required().as_deref(), Some("Ridge"));
//! let projection = root
//!     .one_of("projection", &[("exact", Projection::Exact), ("as-reported", Projection::AsReported)])
//!     .default(Projection::Exact);
//! assert_eq!(projection, None);
//! let raster = root.table_or_empty("raster");
//! assert_eq!(raster.usize("sweeps").between(1, 8192).default(500), Some(500));
//! assert_eq!(raster.usize("lines").between(1, 4096).required(), None);
//! assert_eq!(raster.f64_array::<2>("field_of_view_deg").above(0.0).below(180.0).optional(), Some([40.0, 30.0]));
//! root.finish();
//!
//! let faults = problems.into_result().expect_err("three faults");
//! assert_eq!(faults.len(), 3);
//! assert_eq!(faults.render(false), r#"error: `projection` must be one of "exact", "as-reported", not "exakt"
//!  --> scenarios/ridge.toml:4:14
//!   |
//! 4 | projection = "exakt"
//!   |              ^^^^^^^ expected one of "exact", "as-reported"
//!   |
//!   = help: did you mean "exact"?
//!
//! error: unknown key `raster.sweps`
//!  --> scenarios/ridge.toml:7:1
//!   |
//! 7 | sweps = 1000
//!   | ^^^^^ expected one of field_of_view_deg, lines, sweeps
//!   |
//!   = help: did you mean `sweeps`?
//!
//! error: `raster.lines` must be a whole number from 1 to 4096, not 99999
//!  --> scenarios/ridge.toml:8:9
//!   |
//! 8 | lines = 99999
//!   |         ^^^^^ expected a whole number from 1 to 4096
//! "#);
//! ```
//!
//! Rules that span several keys are checked afterwards: [`Field::placed`] keeps the place of a value,
//! [`Reader::place`] looks it up, and [`Problem::at`] makes a problem that points there.
//!
//! A file with a `base` is read through [`Layers`], where a later file wins key by key and every value
//! remembers the file and the line it came from.
//!
//! Of a long list of data [`LongList`] tells the first faults and counts the others.
//!
//! [`JunitSuite`] writes what was checked for continuous integration.

pub mod asked;
mod field;
mod junit;
mod layers;
mod long_list;
mod place;
mod problem;
mod reader;
mod render;
mod toml_file;
mod tree;

pub use field::{Bounded, Field};
pub use junit::{JunitCase, JunitSuite};
pub use layers::{Layers, Origin};
pub use long_list::LongList;
pub use place::{Place, Placed, Source};
pub use problem::{Problem, ProblemList, ProblemRecord, Problems};
pub use reader::{PartTable, Reader, nearest, similar_file};
pub use toml_file::TomlFile;
