/// Why a task did not succeed.
#[derive(Debug)]
pub struct Failure {
    /// The exit code: 1 if a check said no, 2 if something is missing or wrongly used, else that of
    /// the program that failed.
    pub code: u8,
    /// What went wrong, and what to do about it where that is known.
    pub message: String,
}

impl Failure {
    /// A check said no.
    pub fn check(message: impl Into<String>) -> Self {
        Self { code: 1, message: message.into() }
    }

    /// Something that the task needs is missing.
    pub fn setup(message: impl Into<String>) -> Self {
        Self { code: 2, message: message.into() }
    }
}
