//! Was standard output open when the program was called? Before `main` Rust opens the null device in the place of what is closed, and
//! an answer would be lost without a word: so it is asked before that.

use std::sync::atomic::{AtomicBool, Ordering};

static CLOSED: AtomicBool = AtomicBool::new(false);

/// Whether nobody can be told anything on standard output.
pub fn is_closed() -> bool {
    CLOSED.load(Ordering::Relaxed)
}

#[cfg(unix)]
mod before_main {
    use std::ffi::c_int;
    use std::sync::atomic::Ordering;

    unsafe extern "C" {
        fn fcntl(file: c_int, command: c_int, ...) -> c_int;
    }

    const STANDARD_OUTPUT: c_int = 1;
    /// `F_GETFD`, which fails where no file is open.
    const FLAGS: c_int = 1;

    extern "C" fn ask() {
        // It asks for a number and changes nothing.
        let flags = unsafe { fcntl(STANDARD_OUTPUT, FLAGS) };
        super::CLOSED.store(flags == -1, Ordering::Relaxed);
    }

    /// What is called when the program is loaded.
    #[used]
    #[cfg_attr(target_vendor = "apple", unsafe(link_section = "__DATA,__mod_init_func"))]
    #[cfg_attr(not(target_vendor = "apple"), unsafe(link_section = ".init_array"))]
    static ASK: extern "C" fn() = ask;
}
