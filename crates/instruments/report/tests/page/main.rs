//! The page of a run: its text, and how it behaves in a browser.

mod browser;
mod descent;
mod run_folder;
mod text;
mod webdriver;
