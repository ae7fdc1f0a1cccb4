//! Tables that people write: one reader for every list, path and pose file.
//!
//! A [`Form`] names the columns of a table. A [`Table`] reads a text of that form row by row. Every fault goes to its list
//! with line and cell; [`Table::finish`] hands the list on.
//!
//! What programs do to tables is decided here, for all tables alike:
//!
//! | found | what becomes of it |
//! |---|---|
//! | byte order mark, Windows and old Mac line ends | read |
//! | UTF-16, UTF-32, other encodings | refused by name |
//! | commas, semicolons or tabs between cells | read; two kinds in one header are refused |
//! | decimal comma between semicolons or tabs | read; a decimal point in the same table is refused |
//! | quotes, doubled quotes, empty cells in quotes | read; a quote must end in its line |
//! | capitals in names of columns | read |
//! | unknown columns | refused by name, except those that the form lists as harmless |
//! | times since 1970 and dates | counted from the first row, with a note; leap seconds between dates count |
//! | angles (`_rad`, `_deg`) beyond one turn | read, with a note |
//!
//! ```
//! use diagnostics::Problems;
//! use tables::{Column, Form, Table, decode};
//!
//! const PLACES: Form = Form {
//!     what: "list of places",
//!     columns: &[Column::needed("x_m"), Column::optional("y_m")],
//!     harmless: &["colour"],
//! };
//! let problems = Problems::new();
//! let source = decode("places.csv", b"X_m;colour;y_m\r\n1,5;red;\"\"\r\n".to_vec(), &problems).expect("text");
//! let mut table = Table::with_header(source, &PLACES);
//! let mut row = table.next_row().expect("a row");
//! assert_eq!(row.number(0, -10.0..=10.0), Some(1.5));
//! assert_eq!(row.optional_number(1, -10.0..=10.0), Ok(None));
//! assert!(table.next_row().is_none());
//! assert_eq!(table.finish("all", &problems), Some("all"));
//! ```

mod clock;
mod decode;
mod form;
mod header;
mod line;
mod number;
mod row;
mod table;
mod turn;

pub use clock::{Clock, Time};
pub use decode::{decode, read_text};
pub use form::{Column, Form};
pub use row::{Faulty, Row};
pub use table::Table;
