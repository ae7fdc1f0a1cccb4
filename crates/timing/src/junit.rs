//! A comparison as JUnit XML, the report that continuous integration reads.

use std::fmt::{self, Write};

use crate::comparison::Comparison;
use crate::diff::{OTHER_INPUTS, diff};
use crate::difference::Difference;

impl Comparison {
    /// One test case for the head, one for the tasks before the mission and one a frame; a failure holds the first `limit` differences of its frame.
    pub fn junit(&self, limit: usize) -> String {
        let mut out = String::new();
        // A string takes whatever is written to it.
        let _ = self.write_junit(&mut out, limit);
        out
    }

    fn write_junit(&self, out: &mut String, limit: usize) -> fmt::Result {
        let tests = self.frames.len() + 2;
        let failures = self.frames_that_differ()
            + usize::from(!self.head.is_empty())
            + usize::from(!self.before_mission.is_empty());
        let suite = escaped(&format!("timing {} {}", self.scenario, self.machine));
        let counts = format!("tests=\"{tests}\" failures=\"{failures}\"");
        writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {counts}>")?;
        writeln!(out, "  <testsuite name=\"{suite}\" {counts} errors=\"0\" skipped=\"0\">")?;
        write_case(out, &suite, "head", &self.head, OTHER_INPUTS, limit)?;
        let tasks = &self.before_mission;
        write_case(out, &suite, "before the mission", tasks, &differing(tasks), limit)?;
        for frame in &self.frames {
            let name = format!("frame {}", frame.frame);
            write_case(out, &suite, &name, &frame.differences, &differing(&frame.differences), limit)?;
        }
        out.write_str("  </testsuite>\n</testsuites>\n")
    }
}

fn differing(differences: &[Difference]) -> String {
    format!("differences: {}", differences.len())
}

fn write_case(
    out: &mut String,
    suite: &str,
    name: &str,
    differences: &[Difference],
    message: &str,
    limit: usize,
) -> fmt::Result {
    write!(out, "    <testcase classname=\"{suite}\" name=\"{name}\"")?;
    if differences.is_empty() {
        return writeln!(out, "/>");
    }
    let message = escaped(message);
    write!(out, ">\n      <failure type=\"timing\" message=\"{message}\">")?;
    out.push_str(&escaped(&diff(differences, limit)));
    writeln!(out, "</failure>\n    </testcase>")
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
