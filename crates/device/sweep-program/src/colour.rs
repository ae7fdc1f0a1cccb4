//! The four interlaced coefficient arrays (fig. 20, 21; section 6.3).

/// Colour of a corner, fixed to the lattice (absolute parity, our choice): it says at which corner of the
/// hardware square the coefficients act.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Colour {
    /// Corner (X, Y) = (0, 0): both indices even.
    Yellow,
    /// Corner (1, 0): north index odd.
    Green,
    /// Corner (0, 1): east index odd.
    Black,
    /// Corner (1, 1): both odd.
    Red,
}

impl Colour {
    /// All four; the index of a colour in register arrays is its place here: 1 at X = 1 plus 2 at Y = 1.
    pub const ALL: [Self; 4] = [Self::Yellow, Self::Green, Self::Black, Self::Red];

    /// Word in files and tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Yellow => "yellow",
            Self::Green => "green",
            Self::Black => "black",
            Self::Red => "red",
        }
    }

    /// Colour of lattice corner (m, n).
    pub fn of_corner(m: i64, n: i64) -> Self {
        Self::ALL[((m & 1) + 2 * (n & 1)) as usize]
    }

    /// Whether it acts at X = 1.
    pub fn at_far_x(self) -> bool {
        self as usize & 1 == 1
    }

    /// Whether it acts at Y = 1.
    pub fn at_far_y(self) -> bool {
        self as usize & 2 == 2
    }
}

/// The two registers of a multiplying D/A that wait in front of its hold register (fig. 22).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PreloadRegister {
    /// Next word if an X stop is met first.
    XFirst,
    /// Next word if a Y stop is met first.
    YFirst,
}

#[cfg(test)]
mod tests {
    use super::Colour;

    #[test]
    fn rows_alternate_as_in_the_figures() {
        assert_eq!(Colour::of_corner(0, 0), Colour::Yellow);
        assert_eq!(Colour::of_corner(3, -2), Colour::Green);
        assert_eq!(Colour::of_corner(-4, 5), Colour::Black);
        assert_eq!(Colour::of_corner(-1, -1), Colour::Red);
        for colour in Colour::ALL {
            let (m, n) = (i64::from(colour.at_far_x()), i64::from(colour.at_far_y()));
            assert_eq!(Colour::of_corner(m, n), colour);
        }
    }
}
