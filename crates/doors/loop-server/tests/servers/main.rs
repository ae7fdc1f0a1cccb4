//! Clients at the doors: admitted, refused, full of rubbish, gone.

mod home;
mod page;
#[cfg(unix)]
mod socket;
mod tcp;
