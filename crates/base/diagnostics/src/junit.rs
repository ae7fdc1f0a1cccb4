//! Results as JUnit XML, the report that continuous integration reads.

use std::fmt::{self, Write};

/// One suite of test cases.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JunitSuite {
    /// Name of the suite, and class of its cases.
    pub name: String,
    /// Type of its failures, one word.
    pub kind: &'static str,
    /// Test cases of the suite, in their order.
    pub cases: Vec<JunitCase>,
}

/// One test case, passed or failed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JunitCase {
    /// Name of the test case.
    pub name: String,
    /// What is wrong in a line, and in full; nothing if it passed.
    pub failure: Option<[String; 2]>,
}

impl JunitSuite {
    /// Returns the JUnit document as XML text.
    pub fn xml(&self) -> String {
        let mut out = String::new();
        // A string takes whatever is written to it.
        let _ = self.write(&mut out);
        out
    }

    fn write(&self, out: &mut String) -> fmt::Result {
        let failures = self.cases.iter().filter(|case| case.failure.is_some()).count();
        let suite = escaped(&self.name);
        let counts = format!("tests=\"{}\" failures=\"{failures}\"", self.cases.len());
        writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {counts}>")?;
        writeln!(out, "  <testsuite name=\"{suite}\" {counts} errors=\"0\" skipped=\"0\">")?;
        for JunitCase { name, failure } in &self.cases {
            write!(out, "    <testcase classname=\"{suite}\" name=\"{}\"", escaped(name))?;
            let Some([message, text]) = failure else {
                writeln!(out, "/>")?;
                continue;
            };
            let message = escaped(message);
            write!(out, ">\n      <failure type=\"{}\" message=\"{message}\">{}", self.kind, escaped(text))?;
            writeln!(out, "</failure>\n    </testcase>")?;
        }
        out.write_str("  </testsuite>\n</testsuites>\n")
    }
}

/// Text as content or in an attribute. Characters that XML 1.0 does not have become U+FFFD.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' | '\t' => out.push(character),
            '\0'..' ' | '\u{FFFE}' | '\u{FFFF}' => out.push(char::REPLACEMENT_CHARACTER),
            _ => out.push(character),
        }
    }
    out
}
