//! What in a model cannot hold together, and what of it will show.

mod analog;
mod digital;
mod refusals;

use crate::budget::four_digits;
use crate::{Budget, GroundScale, HardwareModel};

/// What is wrong with a model, or will be seen.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// How bad it is.
    pub grade: Grade,
    /// The keys that are at odds.
    pub keys: Vec<&'static str>,
    /// Why, with the numbers.
    pub message: String,
}

/// How bad a finding is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grade {
    /// No machine can be built like this.
    Refuse,
    /// It can be built, and this artefact of hardware section 5 will show; none where it is merely of no use.
    Warn(Option<&'static str>),
}

impl HardwareModel {
    /// Findings over the [usual ground](Self::usual_ground).
    pub fn check(&self) -> Vec<Finding> {
        self.check_over(self.usual_ground())
    }

    /// The reasons for which no machine can be built like this.
    pub fn refusals(&self) -> impl Iterator<Item = Finding> {
        self.check().into_iter().filter(|finding| finding.grade == Grade::Refuse)
    }

    /// Findings over `ground`, those that refuse the model first. Thresholds are those of hardware section 4, and at a
    /// constant rate of ground range; where there is none there, the worst figure that section 3 has.
    pub fn check_over(&self, ground: GroundScale) -> Vec<Finding> {
        let mut check = Check { model: self, budget: self.budget(ground), found: Vec::new() };
        refusals::check(&mut check);
        digital::check(&mut check);
        analog::check(&mut check);
        check.found
    }
}

/// A check that is under way.
struct Check<'a> {
    model: &'a HardwareModel,
    budget: Budget,
    found: Vec<Finding>,
}

impl Check<'_> {
    fn refuse_if(&mut self, is_so: bool, keys: &[&'static str], message: impl FnOnce() -> String) {
        self.push_if(is_so, Grade::Refuse, keys, message);
    }

    fn warn_if(
        &mut self,
        is_so: bool,
        artefact: &'static str,
        keys: &[&'static str],
        message: impl FnOnce() -> String,
    ) {
        self.push_if(is_so, Grade::Warn(Some(artefact)), keys, message);
    }

    fn push_if(
        &mut self,
        is_so: bool,
        grade: Grade,
        keys: &[&'static str],
        message: impl FnOnce() -> String,
    ) {
        if is_so {
            self.found.push(Finding { grade, keys: keys.to_vec(), message: message() });
        }
    }
}

/// A number to four digits, without zeros behind the point.
fn short(value: f64) -> String {
    let text = four_digits(value);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
