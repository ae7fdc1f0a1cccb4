//! What the module exports: plain functions over addresses of its memory.

// A name that is not mangled is all that is unsafe here; no address is followed.
#![allow(unsafe_code)]

use std::cell::RefCell;
use std::panic;
use std::ptr;
use std::sync::{Mutex, Once, PoisonError};

use crate::Host;

thread_local! {
    static HOST: RefCell<Host> = RefCell::default();
}

/// The message of the panic that ended the module; empty before.
static PANIC: Mutex<String> = Mutex::new(String::new());

fn keep_message_of_panic() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        panic::set_hook(Box::new(|info| {
            *PANIC.lock().unwrap_or_else(PoisonError::into_inner) = info.to_string();
        }));
    });
}

/// Address of `length` bytes for the next request; 0 where there is no memory for them.
#[unsafe(no_mangle)]
pub extern "C" fn reserve(length: usize) -> *mut u8 {
    keep_message_of_panic();
    HOST.with_borrow_mut(|host| host.reserve(length).map_or(ptr::null_mut(), |room| room.as_mut_ptr()))
}

/// Answers the request that was written to [`reserve`]'s address. The reply is at [`reply`].
#[unsafe(no_mangle)]
pub extern "C" fn answer() {
    HOST.with_borrow_mut(Host::answer);
}

/// Address of the last reply.
#[unsafe(no_mangle)]
pub extern "C" fn reply() -> *const u8 {
    HOST.with_borrow(|host| host.reply().as_ptr())
}

/// Bytes of the last reply.
#[unsafe(no_mangle)]
pub extern "C" fn reply_length() -> usize {
    HOST.with_borrow(|host| host.reply().len())
}

/// Lets the last reply go.
#[unsafe(no_mangle)]
pub extern "C" fn release() {
    HOST.with_borrow_mut(Host::release);
}

/// Address of the message of a panic, in UTF-8. It can be read after the module has ended.
#[unsafe(no_mangle)]
pub extern "C" fn panic_message() -> *const u8 {
    PANIC.lock().unwrap_or_else(PoisonError::into_inner).as_ptr()
}

/// Bytes of the message of a panic; 0 where there was none.
#[unsafe(no_mangle)]
pub extern "C" fn panic_message_length() -> usize {
    PANIC.lock().unwrap_or_else(PoisonError::into_inner).len()
}

/// Panics, so that a page can be tested for what it does then.
///
/// # Panics
/// Always.
#[unsafe(no_mangle)]
pub extern "C" fn fail() {
    panic!("this panic was asked for");
}
