//! Ctrl-C: work that keeps files stops at its next step, any other at once.

use corput::{Error, Result};
use std::sync::atomic::{AtomicBool, Ordering};

static INTERRUPTED: AtomicBool = AtomicBool::new(false);
static CLEANS_UP: AtomicBool = AtomicBool::new(false);

/// Exit code of work that was cut off.
const CUT_OFF: i32 = 4;

/// Listens for Ctrl-C, termination and hang-up.
pub fn install() {
    let handler = || {
        let again = INTERRUPTED.swap(true, Ordering::SeqCst);
        if !CLEANS_UP.load(Ordering::SeqCst) {
            eprintln!("corput: interrupted; run again");
            exit();
        }
        if again {
            eprintln!("corput: interrupted; run again, a file of points with --resume");
            exit();
        }
    };
    if let Err(error) = ctrlc::set_handler(handler) {
        eprintln!("corput: Ctrl-C will not be handled: {error}");
    }
}

/// Ends the process without a word to its libraries: drivers whose threads still compile crash
/// when what they use is taken down around them.
fn exit() -> ! {
    #[cfg(unix)]
    signal_hook::low_level::exit(CUT_OFF);
    #[cfg(not(unix))]
    std::process::exit(CUT_OFF);
}

/// From now on the work calls [`stop`] itself, and leaves nothing half-written.
pub fn clean_up() {
    CLEANS_UP.store(true, Ordering::SeqCst);
}

/// Stops work that has come so far if the user wants it to.
pub fn stop(done: u64, total: u64) -> Result<()> {
    if INTERRUPTED.load(Ordering::SeqCst) {
        return Err(Error::Interrupted { done, total });
    }
    Ok(())
}
