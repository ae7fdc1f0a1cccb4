//! Why a server does not begin.

use std::io;

use crate::SHORTEST_TOKEN;

/// A server that cannot listen, or whose token is none.
#[derive(Debug, thiserror::Error)]
pub enum ServerError {
    /// The system does not let it listen.
    #[error("{place}: cannot listen there: {source}; {help}")]
    Listen {
        /// Address or path that was asked for.
        place: String,
        /// What the system says.
        source: io::Error,
        /// What to do instead.
        help: &'static str,
    },
    /// A token with so many visible ASCII characters from its first one on.
    #[error(
        "a token that begins with {0} visible ASCII characters, expected {SHORTEST_TOKEN} to 1024 and no others"
    )]
    BadToken(usize),
    /// The system has no random bytes for a token.
    #[error("the system has no random bytes for a token: {0}")]
    NoRandom(String),
}
