//! How do texts come into the module and out of it? A C interface without glue.
//!
//! The page asks for room, writes a question there in UTF-8, and reads the answer where it is.

use std::panic;
use std::sync::{Mutex, PoisonError};

/// What the program said when it gave up.
static FAULT: Mutex<String> = Mutex::new(String::new());

/// Address in the low half, length in the high one.
fn handed_over(text: String) -> u64 {
    let bytes = text.into_bytes().into_boxed_slice();
    let length = bytes.len() as u64;
    (Box::into_raw(bytes).cast::<u8>() as u64) | (length << 32)
}

/// Before the first question: what a fault of the program says is kept for [`crankstar_fault`].
#[unsafe(no_mangle)]
pub extern "C" fn crankstar_start() {
    panic::set_hook(Box::new(|fault| {
        *FAULT.lock().unwrap_or_else(PoisonError::into_inner) = fault.to_string();
    }));
}

/// What the program said before it stopped, after a call that trapped.
#[unsafe(no_mangle)]
pub extern "C" fn crankstar_fault() -> u64 {
    handed_over(FAULT.lock().unwrap_or_else(PoisonError::into_inner).clone())
}

/// Room for a question of this many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn crankstar_room(length: usize) -> *mut u8 {
    Box::into_raw(vec![0_u8; length].into_boxed_slice()).cast()
}

/// Gives back the room of an answer.
///
/// # Safety
/// `at` and `length` are of one answer, and not given back yet.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn crankstar_give_back(at: *mut u8, length: usize) {
    drop(unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(at, length)) });
}

/// The answer to a question: its address in the low 32 bits, its length above. The room of the question is given back.
///
/// # Safety
/// `at` is of `crankstar_room(length)`, and not given back yet.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn crankstar_ask(at: *mut u8, length: usize) -> u64 {
    let question = unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(at, length)) };
    handed_over(super::answer(&String::from_utf8_lossy(&question)))
}
