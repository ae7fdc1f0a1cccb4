//! Values of a JSON file with their paths.

use diagnostics::{Problem, ProblemList};
use serde_json::Value;

/// A value and where it stands.
#[derive(Clone)]
pub(super) struct Json<'a> {
    name: &'a str,
    value: &'a Value,
    path: String,
}

impl<'a> Json<'a> {
    /// The root of the file of that name.
    pub fn root(name: &'a str, value: &'a Value) -> Self {
        Self { name, value, path: String::new() }
    }

    /// What is wrong with this value.
    pub fn problem(&self, title: impl AsRef<str>, expected: impl Into<String>) -> Problem {
        let title = match self.path.as_str() {
            "" => title.as_ref().to_owned(),
            path => format!("{path}: {}", title.as_ref()),
        };
        Problem::of_file(self.name, title).expected(expected)
    }

    /// The path from the root.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// The value of a key of an object.
    pub fn get(&self, key: &str) -> Option<Self> {
        let value = self.value.get(key)?;
        let path = if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) };
        Some(Self { value, path, ..*self })
    }

    /// The value of a key that must be there.
    ///
    /// # Errors
    /// If it is not.
    pub fn required(&self, key: &str) -> Result<Self, ProblemList> {
        self.get(key)
            .ok_or_else(|| self.problem(format!("`{key}` is missing"), format!("the key `{key}`")).into())
    }

    /// The values of an array.
    ///
    /// # Errors
    /// If it is none.
    pub fn items(&self) -> Result<Vec<Self>, ProblemList> {
        let Value::Array(values) = self.value else {
            return Err(self.problem("no array", "an array").into());
        };
        let item = |(number, value)| Self { value, path: format!("{}[{number}]", self.path), ..*self };
        Ok(values.iter().enumerate().map(item).collect())
    }

    /// The values of the array of a key; none where the key is missing.
    ///
    /// # Errors
    /// If it is no array.
    pub fn list(&self, key: &str) -> Result<Vec<Self>, ProblemList> {
        self.get(key).map_or_else(|| Ok(Vec::new()), |list| list.items())
    }

    /// Refuses keys that are neither used nor known to be harmless.
    ///
    /// # Errors
    /// At the first such key, or if it is no object.
    pub fn expect_known(&self, used: &[&str], harmless: &[&str]) -> Result<(), ProblemList> {
        // Extensions are held against a list of their own.
        const ANYWHERE: [&str; 3] = ["name", "extras", "extensions"];
        let is_known = |key: &str| [used, harmless, &ANYWHERE].iter().any(|keys| keys.contains(&key));
        match self.keys()?.into_iter().find(|key| !is_known(key)) {
            None => Ok(()),
            Some(key) => {
                let expected = format!("{}, or of no effect: {}", used.join(", "), harmless.join(", "));
                Err(self
                    .problem(format!("key `{key}` is not read"), expected)
                    .help("export the file without it")
                    .into())
            }
        }
    }

    /// The keys of an object.
    ///
    /// # Errors
    /// If it is none.
    pub fn keys(&self) -> Result<Vec<&'a str>, ProblemList> {
        match self.value {
            Value::Object(object) => Ok(object.keys().map(String::as_str).collect()),
            _ => Err(self.problem("no object", "an object").into()),
        }
    }

    /// A text.
    ///
    /// # Errors
    /// If it is none.
    pub fn text(&self) -> Result<&'a str, ProblemList> {
        self.value.as_str().ok_or_else(|| self.problem("no text", "a text").into())
    }

    /// A whole number from 0: an index, a count, a number of bytes or a code.
    ///
    /// # Errors
    /// If it is none.
    pub fn whole(&self) -> Result<usize, ProblemList> {
        let whole = self.value.as_u64().and_then(|whole| usize::try_from(whole).ok());
        whole.ok_or_else(|| self.problem("no whole number", "a whole number, 0 or more").into())
    }

    /// The whole number of a key; `usual` where the key is missing.
    ///
    /// # Errors
    /// If it is none.
    pub fn whole_or(&self, key: &str, usual: usize) -> Result<usize, ProblemList> {
        self.get(key).map_or(Ok(usual), |value| value.whole())
    }

    /// So many numbers.
    ///
    /// # Errors
    /// If it is anything else.
    pub fn numbers<const N: usize>(&self) -> Result<[f64; N], ProblemList> {
        let numbers: Option<Vec<f64>> =
            self.value.as_array().and_then(|all| all.iter().map(Value::as_f64).collect());
        let numbers = numbers.and_then(|numbers| <[f64; N]>::try_from(numbers).ok());
        numbers.ok_or_else(|| {
            self.problem(format!("not {N} numbers"), format!("an array of {N} numbers")).into()
        })
    }

    /// Whether any number of an array is not 0.
    pub fn has_weight(&self) -> bool {
        self.value.as_array().is_some_and(|all| all.iter().any(|weight| weight.as_f64() != Some(0.0)))
    }

    /// Whether it is the word `true`.
    pub fn is_true(&self) -> bool {
        self.value.as_bool() == Some(true)
    }
}
