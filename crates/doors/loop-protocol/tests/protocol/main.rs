//! The protocol: bytes of messages, answers of a session, and hostile input.

mod guests;
mod home;
mod hostile;
mod page;
mod parts;
mod searching;
mod session;
mod states;
mod wire;
