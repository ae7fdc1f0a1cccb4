//! The files of a page, in memory.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::reply::Reply;

/// Endings of names with their media types.
const KINDS: [(&str, &str); 6] = [
    (".html", "text/html; charset=utf-8"),
    (".js", "text/javascript; charset=utf-8"),
    (".css", "text/css; charset=utf-8"),
    (".json", "application/json"),
    (".svg", "image/svg+xml"),
    (".wasm", "application/wasm"),
];

/// Files by name, without folders.
#[derive(Debug, Clone, Default)]
pub struct PageFiles(BTreeMap<String, Cow<'static, [u8]>>);

impl PageFiles {
    /// Puts a file in, or in place of one with its name.
    pub fn put(&mut self, name: &str, bytes: impl Into<Cow<'static, [u8]>>) {
        self.0.insert(name.to_owned(), bytes.into());
    }

    /// The reply to whoever asks for `path`, which begins with a slash.
    pub(super) fn reply(&self, path: &str) -> Reply {
        let name = path.strip_prefix('/').unwrap_or(path);
        let Some(bytes) = self.0.get(name) else { return Reply::refusal(404, "the page has no such file") };
        let kind = KINDS.iter().find(|(ending, _)| name.ends_with(ending));
        Reply::file(kind.map_or("application/octet-stream", |(_, kind)| kind), bytes.clone())
    }
}
