//! The requests that wait: of views the newest alone.

use super::request::{AnimationExport, Export, Sketch, View};
use std::collections::VecDeque;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// What the thread is to do next.
pub(super) enum Task {
    View(Box<View>),
    Export(Box<Export>),
    Animation(Box<AnimationExport>),
    Sketch(Sketch),
}

#[derive(Default)]
struct Waiting {
    view: Option<Box<View>>,
    export: Option<Task>,
    sketches: VecDeque<Sketch>,
    gives_export_up: bool,
    closed: bool,
}

/// The requests that wait for the thread.
#[derive(Default)]
pub(super) struct Mailbox {
    waiting: Mutex<Waiting>,
    arrived: Condvar,
}

/// What a view that waits means for the picture that is being made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Newer {
    /// Nothing waits.
    None,
    /// A view that is about to change again.
    Moving,
    /// A view at rest, or of other data.
    AtRest,
}

impl Mailbox {
    fn waiting(&self) -> MutexGuard<'_, Waiting> {
        // A state of plain values is whole after a panic elsewhere.
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut Waiting)) {
        change(&mut self.waiting());
        self.arrived.notify_one();
    }

    pub fn put_view(&self, view: View) {
        self.change(|waiting| waiting.view = Some(Box::new(view)));
    }

    pub fn put_sketch(&self, sketch: Sketch) {
        self.change(|waiting| waiting.sketches.push_back(sketch));
    }

    /// The sketch again, before the others: something came in between.
    pub fn put_back(&self, sketch: Sketch) {
        self.change(|waiting| waiting.sketches.push_front(sketch));
    }

    pub fn forget_sketches(&self) {
        self.change(|waiting| waiting.sketches.clear());
    }

    pub fn put_export(&self, export: Export) {
        self.change(|waiting| {
            waiting.export = Some(Task::Export(Box::new(export)));
            waiting.gives_export_up = false;
        });
    }

    pub fn put_animation(&self, animation: AnimationExport) {
        self.change(|waiting| {
            waiting.export = Some(Task::Animation(Box::new(animation)));
            waiting.gives_export_up = false;
        });
    }

    pub fn cancel_export(&self) {
        // One that still waits is begun and given up, so that there is a reply.
        self.change(|waiting| waiting.gives_export_up = true);
    }

    pub fn close(&self) {
        self.change(|waiting| waiting.closed = true);
    }

    /// The next task, once there is one; `None` at the end.
    pub fn take(&self) -> Option<Task> {
        let mut waiting = self.waiting();
        loop {
            if waiting.closed {
                return None;
            }
            if let Some(export) = waiting.export.take() {
                return Some(export);
            }
            if let Some(view) = waiting.view.take() {
                return Some(Task::View(view));
            }
            if let Some(sketch) = waiting.sketches.pop_front() {
                return Some(Task::Sketch(sketch));
            }
            waiting = self.arrived.wait(waiting).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// The view or export that waits, seen from the making of a view of data `number`.
    pub fn newer(&self, number: u64) -> Newer {
        let waiting = self.waiting();
        match &waiting.view {
            _ if waiting.closed || waiting.export.is_some() => Newer::AtRest,
            None => Newer::None,
            Some(view) if view.moving && view.data.number == number => Newer::Moving,
            Some(_) => Newer::AtRest,
        }
    }

    /// Whether something waits that comes before sketches.
    pub fn is_busy(&self) -> bool {
        let waiting = self.waiting();
        waiting.closed || waiting.view.is_some() || waiting.export.is_some()
    }

    /// Whether the export that is under way is to end.
    pub fn gives_export_up(&self) -> bool {
        let waiting = self.waiting();
        waiting.closed || waiting.gives_export_up
    }
}
