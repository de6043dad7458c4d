//! The thread that renders: it owns the renderer, takes the newest request only, and never keeps the window waiting.

mod animate;
mod course;
mod device;
mod ladder;
mod mailbox;
mod pace;
mod picture;
mod request;
mod target;

pub use device::DeviceOptions;
pub use ladder::{Rung, ladder};
pub use pace::{LEAST_EDGE, Pace, TARGET};
pub use picture::{Shown, shown};
pub use request::{AnimationExport, Data, Export, Reply, Sketch, SketchSubject, View, Wake};

use course::Course;
use mailbox::Mailbox;
use std::io;
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};
use vitrum::Progress;

/// Time in which the thread ends what cannot be given up, such as the making of a built-in volume; a window that is closed waits no longer for it.
const LAST_WORK: Duration = Duration::from_secs(2);

/// The handle of the rendering thread. The thread ends with it.
pub struct Worker {
    mailbox: Arc<Mailbox>,
    replies: Receiver<Reply>,
    progress: Arc<Mutex<Option<Progress>>>,
    thread: Option<JoinHandle<()>>,
}

impl Worker {
    /// Starts the thread, which opens its device with the first request. `wake` is called behind each reply.
    ///
    /// # Errors
    /// Where the system starts no thread.
    pub fn start(options: DeviceOptions, wake: Wake) -> io::Result<Self> {
        let mailbox = Arc::new(Mailbox::default());
        let progress = Arc::new(Mutex::new(None));
        let (sender, replies) = channel();
        let course = Course::new(Arc::clone(&mailbox), Arc::clone(&progress), sender, wake, options);
        let thread = Builder::new().name("vitrum-renderer".to_owned()).spawn(move || course.run())?;
        Ok(Self { mailbox, replies, progress, thread: Some(thread) })
    }

    /// Asks for a picture of a view; one that was asked for before, and is not there yet, is given up.
    pub fn show(&self, view: View) {
        self.mailbox.put_view(view);
    }

    /// Asks for a small picture, made when nothing else is to do.
    pub fn sketch(&self, sketch: Sketch) {
        self.mailbox.put_sketch(sketch);
    }

    /// Forgets the small pictures that were asked for and are not there yet.
    pub fn forget_sketches(&self) {
        self.mailbox.forget_sketches();
    }

    /// Asks for a picture in a file, before anything else.
    pub fn export(&self, export: Export) {
        self.mailbox.put_export(export);
    }

    /// Asks for an animation in files, before anything else.
    pub fn animate(&self, animation: AnimationExport) {
        self.mailbox.put_animation(animation);
    }

    /// Gives the picture or animation for a file up.
    pub fn cancel_export(&self) {
        self.mailbox.cancel_export();
    }

    /// The next reply, if there is one.
    #[must_use]
    pub fn poll(&self) -> Option<Reply> {
        self.replies.try_recv().ok()
    }

    /// The progress of the picture that is being made; `None` if none is.
    #[must_use]
    pub fn progress(&self) -> Option<Progress> {
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Whether a view waits that the thread has not begun.
    #[must_use]
    pub fn is_waiting(&self) -> bool {
        self.mailbox.is_busy()
    }

    /// Waits for a reply; for tests, which have no window to wake.
    #[must_use]
    pub fn wait(&self) -> Option<Reply> {
        self.replies.recv().ok()
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.mailbox.close();
        let Some(thread) = self.thread.take() else { return };
        let end = Instant::now() + LAST_WORK;
        while !thread.is_finished() && Instant::now() < end {
            std::thread::sleep(Duration::from_millis(5));
        }
        if thread.is_finished() {
            // A thread that failed has said so in its last reply.
            let _ = thread.join();
        }
    }
}
