//! The files of a page: who has them, and how they are sent.

use std::collections::BTreeMap;
use std::sync::Arc;

use tungstenite::Bytes;

use super::reply::Reply;

/// Endings of names with their media types.
const KINDS: [(&str, &str); 8] = [
    (".html", "text/html; charset=utf-8"),
    (".js", "text/javascript; charset=utf-8"),
    (".css", "text/css; charset=utf-8"),
    (".json", "application/json"),
    (".csv", "text/csv; charset=utf-8"),
    (".png", "image/png"),
    (".svg", "image/svg+xml"),
    (".wasm", "application/wasm"),
];

/// Whoever has the files of a page.
pub trait Shelf {
    /// The file `name`, as a browser asks for it: without a slash in front, and not looked at before. `None` if there is none.
    fn file(&self, name: &str) -> Option<Bytes>;
}

/// Files in memory by name, without folders.
#[derive(Debug, Clone, Default)]
pub struct PageFiles(BTreeMap<String, Bytes>);

impl PageFiles {
    /// Puts a file in, or in place of one with its name.
    pub fn put(&mut self, name: &str, bytes: impl Into<Bytes>) {
        self.0.insert(name.to_owned(), bytes.into());
    }
}

impl Shelf for PageFiles {
    fn file(&self, name: &str) -> Option<Bytes> {
        self.0.get(name).cloned()
    }
}

impl<S: Shelf + ?Sized> Shelf for Arc<S> {
    fn file(&self, name: &str) -> Option<Bytes> {
        S::file(self, name)
    }
}

/// The reply to whoever asks for `path`, which begins with a slash.
pub fn reply(shelf: &impl Shelf, path: &str) -> Reply {
    let name = path.strip_prefix('/').unwrap_or(path);
    let Some(bytes) = shelf.file(name) else { return Reply::refusal(404, "the page has no such file") };
    let kind = KINDS.iter().find(|(ending, _)| name.ends_with(ending));
    Reply::file(kind.map_or("application/octet-stream", |(_, kind)| kind), bytes)
}
