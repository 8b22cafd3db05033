//! The resistance of a rough line over the last chord of its way.

/// Duration [s] and ∫ F_x dt [N s] of the last whole chord that the springs have passed, and of the one they are on.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Window {
    whole: Option<(f64, f64)>,
    begun: (f64, f64),
}

impl Window {
    /// Takes up a piece of the way between two parts of a chord; who stands has no way behind.
    pub fn note(&mut self, parts: [f64; 2], (duration, impulse): (f64, f64)) {
        if parts[0].total_cmp(&parts[1]).is_eq() {
            *self = Self::default();
            return;
        }
        self.begun = (self.begun.0 + duration, self.begun.1 + impulse);
        if parts[1] <= 0.0 || parts[1] >= 1.0 {
            self.whole = Some(std::mem::take(&mut self.begun));
        }
    }

    /// The mean resistance [N]; `None` of who stands.
    pub fn mean(&self) -> Option<f64> {
        let (duration, impulse) = self.whole.unwrap_or(self.begun);
        (duration > 0.0).then(|| impulse / duration)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of the last whole chord, as soon as there is one, however it is cut; nothing of who stands.
    #[test]
    fn the_mean_is_that_of_the_last_chord() {
        let mut window = Window::default();
        assert_eq!(window.mean(), None);
        window.note([1.0, 0.5], (1.0, 3.0));
        assert_eq!(window.mean(), Some(3.0));
        window.note([0.5, 0.0], (1.0, 1.0));
        assert_eq!(window.mean(), Some(2.0));
        window.note([1.0, 0.25], (3.0, 90.0));
        assert_eq!(window.mean(), Some(2.0));
        window.note([0.25, 0.25], (1.0, 0.0));
        assert_eq!(window.mean(), None);
    }
}
