/// Why a task did not succeed.
#[derive(Debug)]
pub struct Failure {
    /// The exit code: 1 if a check failed, 2 if something is missing or wrongly used, else the exit code of the program that failed.
    pub code: u8,
    /// The message: the failure, and advice if there is any.
    pub message: String,
}

impl Failure {
    /// A check said no.
    pub fn check(message: impl Into<String>) -> Self {
        Self { code: 1, message: message.into() }
    }

    /// The failure of a task for want of a tool or a file.
    pub fn setup(message: impl Into<String>) -> Self {
        Self { code: 2, message: message.into() }
    }
}
