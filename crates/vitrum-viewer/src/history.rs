//! Undo and redo by whole states.

/// The most states that are kept.
const MOST: usize = 256;

/// The states of something that is edited: those before the present one, and those that were taken back.
///
/// States that are recorded with the same gesture, such as all of one drag, make one step.
#[derive(Debug, Clone)]
pub struct History<T> {
    past: Vec<T>,
    present: T,
    future: Vec<T>,
    gesture: Option<&'static str>,
}

impl<T: Clone + PartialEq> History<T> {
    /// A history that begins now.
    pub fn new(present: T) -> Self {
        Self { past: Vec::new(), present, future: Vec::new(), gesture: None }
    }

    /// The present state.
    pub fn present(&self) -> &T {
        &self.present
    }

    /// Records a new state. With the name of the gesture that the last state was recorded with, it takes that state's place.
    pub fn record(&mut self, state: T, gesture: Option<&'static str>) {
        if state == self.present {
            return;
        }
        self.future.clear();
        let before = std::mem::replace(&mut self.present, state);
        if gesture.is_none() || gesture != self.gesture {
            self.past.push(before);
            if self.past.len() > MOST {
                self.past.remove(0);
            }
        }
        self.gesture = gesture;
    }

    /// Ends the gesture: what comes next is a step of its own.
    pub fn end_gesture(&mut self) {
        self.gesture = None;
    }

    /// Whether there is a step to take back.
    pub fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is a step to do again.
    pub fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// Takes the last step back; the state from before.
    pub fn undo(&mut self) -> Option<&T> {
        let before = self.past.pop()?;
        self.future.push(std::mem::replace(&mut self.present, before));
        self.end_gesture();
        Some(&self.present)
    }

    /// Does the step again that was taken back last; the state from behind.
    pub fn redo(&mut self) -> Option<&T> {
        let after = self.future.pop()?;
        self.past.push(std::mem::replace(&mut self.present, after));
        self.end_gesture();
        Some(&self.present)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_taken_back_and_done_again() {
        let mut history = History::new(0);
        history.record(1, None);
        history.record(1, None);
        history.record(2, None);
        assert_eq!(
            [history.undo().copied(), history.undo().copied(), history.undo().copied()],
            [Some(1), Some(0), None]
        );
        assert_eq!(history.redo().copied(), Some(1));
        history.record(5, None);
        assert!(!history.can_redo(), "a new step forgets what was taken back");
        assert_eq!(history.undo().copied(), Some(1));
    }

    #[test]
    fn a_gesture_is_one_step() {
        let mut history = History::new(0);
        (1..9).for_each(|state| history.record(state, Some("drag")));
        history.end_gesture();
        (9..12).for_each(|state| history.record(state, Some("drag")));
        history.record(20, Some("other"));
        assert_eq!(history.undo().copied(), Some(11));
        assert_eq!(history.undo().copied(), Some(8));
        assert_eq!(history.undo().copied(), Some(0));
    }

    #[test]
    fn the_oldest_states_are_forgotten() {
        let mut history = History::new(0);
        (1..=2 * MOST).for_each(|state| history.record(state, None));
        while history.undo().is_some() {}
        assert_eq!(*history.present(), MOST);
    }
}
