//! Motions that are taken back, and a state to be gone back to.

use super::{Instant, Lazy, Now, Numbers};

/// A state to be gone back to, and what springs have changed since.
#[derive(Debug, Clone)]
pub(super) struct Mark {
    now: Now,
    changed: Vec<Undo>,
}

/// A spring before it changed.
#[derive(Debug, Clone)]
pub(super) struct Undo {
    spring: usize,
    since: Instant,
    rest: f64,
    constants: Numbers,
}

impl Lazy {
    /// Takes note of the spring `j` before it changes.
    pub(super) fn note(&mut self, j: usize) {
        let row = self.row(j);
        let mark = self.marked.as_mut().map(|mark| &mut mark.changed);
        // What is tried is taken back, and nothing of it is to be taken back later.
        if let Some(journal) = self.journal.as_mut().or(mark) {
            let constants = Numbers::from_slice(&self.constants[row]);
            journal.push(Undo { spring: j, since: self.since[j], rest: self.rest[j], constants });
        }
    }

    /// What `look` sees at the end of a motion that is then taken back.
    pub fn tried<T>(&mut self, speed: f64, duration: f64, look: impl FnOnce(&Self) -> T) -> T {
        self.taken_back(|bed| bed.advance(speed, duration), look)
    }

    /// What `look` sees of the force and the edge at the end of a motion that is then taken back: of the springs let go in
    /// it only those beside the edge are followed.
    pub fn glanced<T>(&mut self, speed: f64, duration: f64, look: impl FnOnce(&Self) -> T) -> T {
        self.taken_back(|bed| bed.end_at(speed, duration), look)
    }

    fn taken_back<T>(&mut self, motion: impl FnOnce(&mut Self), look: impl FnOnce(&Self) -> T) -> T {
        let before = self.now.clone();
        self.journal = Some(Vec::new());
        motion(self);
        let seen = look(self);
        let changed = self.journal.take().unwrap_or_default();
        self.take_back(changed, before);
        seen
    }

    /// Undoes what has changed since the state `before`.
    fn take_back(&mut self, changed: Vec<Undo>, before: Now) {
        for undo in changed.into_iter().rev() {
            let row = self.row(undo.spring);
            self.constants[row].copy_from_slice(&undo.constants);
            (self.since[undo.spring], self.rest[undo.spring]) = (undo.since, undo.rest);
        }
        self.now = before;
    }

    /// Marks the present state: until it is marked again, [`at_mark`](Self::at_mark) gives it back, at the cost of the
    /// springs touched or released since.
    pub fn mark(&mut self) {
        self.marked = Some(Mark { now: self.now.clone(), changed: Vec::new() });
    }

    /// Forgets the mark.
    pub fn unmark(&mut self) {
        self.marked = None;
    }

    /// A bed as this one was when it was marked; `None` if it was not.
    #[must_use]
    pub fn at_mark(&self) -> Option<Self> {
        let mut bed = self.clone();
        let Mark { now, changed } = bed.marked.take()?;
        bed.take_back(changed, now);
        Some(bed)
    }
}
