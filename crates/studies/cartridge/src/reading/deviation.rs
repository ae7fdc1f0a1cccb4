//! How far a found value is from an expected one.

/// The value that is farthest off.
#[derive(Debug, Clone, PartialEq)]
pub struct Deviation {
    /// What it is, and where.
    pub what: String,
    /// Value that was found.
    pub found: f64,
    /// Value that was expected.
    pub expected: f64,
    /// How far off, in the unit of the tolerance; infinite where there is nothing to compare.
    pub off: f64,
}

impl Deviation {
    /// One value, in units of `unit`.
    pub fn of(what: impl Into<String>, found: f64, expected: f64, unit: f64) -> Self {
        let off = (found - expected).abs() / unit;
        Self { what: what.into(), found, expected, off: if off.is_nan() { f64::INFINITY } else { off } }
    }

    /// Two lists, value by value; lists of different lengths are infinitely far off.
    pub fn between(what: &str, found: &[f64], expected: &[f64], unit: f64) -> Self {
        if found.len() != expected.len() {
            let what = format!("{what}: their number");
            return Self {
                off: f64::INFINITY,
                ..Self::of(what, found.len() as f64, expected.len() as f64, 1.0)
            };
        }
        let one = |(index, (&found, &expected)): (usize, (&f64, &f64))| {
            Self::of("", found, expected, unit).at(index)
        };
        let pairs = found.iter().zip(expected).enumerate();
        let worst = pairs.map(one).reduce(Self::worse);
        match worst {
            Some(worst) => Self { what: format!("{what}{}", worst.what), ..worst },
            None => Self::of(what, 0.0, 0.0, 1.0),
        }
    }

    fn at(self, index: usize) -> Self {
        // Most are dropped at once; a text for each would cost more than the run.
        Self { what: if self.off > 0.0 { format!(" [{index}]") } else { String::new() }, ..self }
    }

    /// The one that is farther off.
    pub fn worse(self, other: Self) -> Self {
        if other.off > self.off { other } else { self }
    }
}
