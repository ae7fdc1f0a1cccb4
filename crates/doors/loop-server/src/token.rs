//! The secret word of a client.

use crate::ServerError;

/// Fewest characters of a token that a user chooses (chosen).
pub const SHORTEST_TOKEN: usize = 16;

/// Random bytes of a token that is made here; each is two characters.
const RANDOM_BYTES: usize = 16;

/// Most characters of a token; a first request has room for them (chosen).
const LONGEST: usize = 1024;

/// A secret word. Its debug text hides it.
#[derive(Clone, PartialEq, Eq)]
pub struct Token(String);

impl Token {
    /// 128 random bits of the system, as 32 characters.
    ///
    /// # Errors
    /// If the system has no random bytes.
    pub fn random() -> Result<Self, ServerError> {
        let mut bytes = [0; RANDOM_BYTES];
        getrandom::fill(&mut bytes).map_err(|error| ServerError::NoRandom(error.to_string()))?;
        Ok(Self(bytes.iter().map(|byte| format!("{byte:02x}")).collect()))
    }

    /// The word of a user.
    ///
    /// # Errors
    /// If it has fewer than [`SHORTEST_TOKEN`] or more than 1024 visible ASCII characters, or others.
    pub fn chosen(word: &str) -> Result<Self, ServerError> {
        let visible = word.bytes().take_while(u8::is_ascii_graphic).count();
        let is_good = visible == word.len() && (SHORTEST_TOKEN..=LONGEST).contains(&visible);
        if is_good { Ok(Self(word.to_owned())) } else { Err(ServerError::BadToken(visible)) }
    }

    /// Whether `word` is this token. The time that it takes tells the length alone.
    pub fn is(&self, word: &str) -> bool {
        let differs = |own: u8, other: u8| own ^ other;
        let same = self.0.bytes().zip(word.bytes()).fold(0, |sum, (own, other)| sum | differs(own, other));
        self.0.len() == word.len() && std::hint::black_box(same) == 0
    }

    /// The word itself, for whoever is to be told.
    pub fn word(&self) -> &str {
        &self.0
    }
}

impl std::fmt::Debug for Token {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Token")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_token_is_itself_alone() {
        let [first, second] = [Token::random().unwrap(), Token::random().unwrap()];
        assert!(first.is(first.word()) && !first.is(second.word()));
        assert_eq!(first.word().len(), 2 * RANDOM_BYTES);
        let mut last = first.word().to_owned();
        last.pop();
        assert!(!first.is(&last) && !first.is("") && !first.is(&format!("{}0", first.word())));
        last.push(if first.word().ends_with('0') { '1' } else { '0' });
        assert!(!first.is(&last), "the last character counts");
        assert_eq!(format!("{first:?}"), "Token");
    }

    #[test]
    fn a_short_word_is_refused() {
        assert!(Token::chosen("0123456789abcdef").is_ok() && Token::chosen(&"x".repeat(LONGEST)).is_ok());
        assert!(Token::chosen(&"x".repeat(LONGEST + 1)).is_err());
        for bad in ["", "0123456789abcde", "0123456789abcdef ", "0123456789abcde\n", "0123456789abcdeé"] {
            assert!(Token::chosen(bad).is_err(), "{bad:?}");
        }
    }
}
