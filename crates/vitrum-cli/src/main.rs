//! The `vitrum` program: `vitrum_cli::run` with the words of the command line.

use std::ffi::OsString;
use std::process::ExitCode;

fn main() -> ExitCode {
    // First of all: no other thread is there yet.
    silence_device_select();
    let words: Vec<OsString> = std::env::args_os().collect();
    ExitCode::from(vitrum_cli::run(&words))
}

/// Silences Mesa's Vulkan layer that orders adapters: without a desktop session it complains on standard error at every run. It stays
/// on where the user names an order.
fn silence_device_select() {
    const SESSION_OR_WISH: [&str; 4] = ["XDG_RUNTIME_DIR", "NODEVICE_SELECT", "MESA_VK_DEVICE_SELECT", "DRI_PRIME"];
    if cfg!(target_os = "linux") && SESSION_OR_WISH.iter().all(|name| std::env::var_os(name).is_none()) {
        // SAFETY: the environment must not be read or changed by another thread meanwhile. This is the first thing that `main`
        // does, and nothing before it starts a thread.
        unsafe { std::env::set_var("NODEVICE_SELECT", "1") };
    }
}
