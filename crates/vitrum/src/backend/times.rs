//! Times of kernels.

use serde::Serialize;

/// The time of all passes of a kernel together.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct KernelTime {
    /// The kernel's name.
    pub kernel: &'static str,
    /// Passes that ran.
    pub passes: u32,
    /// Time in milliseconds.
    pub ms: f64,
}

/// Adds what `passes` passes of a kernel took.
pub(super) fn add(times: &mut Vec<KernelTime>, kernel: &'static str, passes: u32, ms: f64) {
    match times.iter_mut().find(|time| time.kernel == kernel) {
        Some(time) => {
            time.passes += passes;
            time.ms += ms;
        }
        None => times.push(KernelTime { kernel, passes, ms }),
    }
}

/// Adds the times of several runs up, kernel by kernel.
pub(crate) fn merge(whole: &mut Vec<KernelTime>, added: &[KernelTime]) {
    for time in added {
        match whole.iter_mut().find(|other| other.kernel == time.kernel) {
            Some(other) => {
                other.passes += time.passes;
                other.ms += time.ms;
            }
            None => whole.push(*time),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_add_up_by_kernel() {
        let mut times = Vec::new();
        add(&mut times, "a", 1, 1.0);
        add(&mut times, "b", 1, 2.0);
        add(&mut times, "a", 1, 3.0);
        let expected = [KernelTime { kernel: "a", passes: 2, ms: 4.0 }, KernelTime { kernel: "b", passes: 1, ms: 2.0 }];
        assert_eq!(times, expected);
        merge(&mut times, &expected);
        assert_eq!((times[0].passes, times[0].ms, times[1].ms), (4, 8.0, 4.0));
    }
}
