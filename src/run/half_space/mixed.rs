//! Rounds that are guessed ahead, or gather way.

use super::memory::dot;
use ndarray::Array2;

/// Change of the attraction, as part of its stress, below which the rounds are mixed: before, they find their branch.
const MIXED: f64 = 0.05;
/// Most steps of the last round that one guess may go.
const FAR: f64 = 20.0;

/// Rounds that are not guessed after a guess that led astray.
const ALONE: usize = 4;

/// Rounds by which the next one is guessed.
const KEPT: usize = 4;

/// Part of the square of a change below which it is one of those known already.
const ALIKE: f64 = 1e-6;

/// A round: the attraction it led to, and by how much it changed it.
type Round = (Array2<f64>, Array2<f64>);

/// The last rounds, by which the next one is guessed: what changes by the same parts in each round is summed at once
/// (Anderson 1965).
#[derive(Default)]
pub(super) struct Mixed {
    rounds: Vec<Round>,
    /// The attraction that was not taken for the last guess, and the change that led to it.
    passed_over: Option<(Array2<f64>, f64)>,
    /// Rounds still to be gone without a guess, since the last one led astray, and how many after the next.
    alone: usize,
    patience: usize,
    momentum: Momentum,
}

impl Mixed {
    /// The attraction to go on from, after a round that led from `before` to `after`.
    pub(super) fn next(&mut self, before: &Array2<f64>, after: Array2<f64>, change: f64, most: f64) -> Array2<f64> {
        if self.passed_over.as_ref().is_some_and(|(_, before)| change >= *before)
            && let Some(safe) = self.back()
        {
            return safe;
        }
        self.passed_over = None;
        if change > MIXED {
            (self.rounds, self.momentum) = (Vec::new(), Momentum::default());
            return after;
        }
        if self.alone > 0 {
            self.alone -= 1;
            return self.momentum.next(before, after, most);
        }
        let step = &after - before;
        let guess = self.guess(&after, &step);
        if self.rounds.len() == KEPT {
            self.rounds.remove(0);
        }
        self.rounds.push((after.clone(), step));
        let Some(guess) = guess else { return after };
        self.passed_over = Some((after, change));
        guess.mapv_into(|pull| pull.clamp(0.0, most))
    }

    /// The attraction that was not taken for the last guess, if it was one, from which rounds go on without a guess for a while.
    pub(super) fn back(&mut self) -> Option<Array2<f64>> {
        let (safe, _) = self.passed_over.take()?;
        self.patience = (2 * self.patience).max(ALONE);
        self.alone = self.patience;
        (self.rounds, self.momentum) = (Vec::new(), Momentum::default());
        Some(safe)
    }

    /// Where the rounds end if their steps go on to change as they did, in the least squares; `None` of the first, and of
    /// rounds whose steps grow: they are on their way to another branch, and what they would end in lies behind them.
    ///
    /// Of each round kept the change of the step since, made orthogonal to those of later ones, with what it changed in the
    /// attraction.
    fn guess(&self, after: &Array2<f64>, step: &Array2<f64>) -> Option<Array2<f64>> {
        let mut known: Vec<Round> = Vec::new();
        let (mut left, mut away) = (step.clone(), Array2::zeros(step.dim()));
        for (then, then_step) in self.rounds.iter().rev() {
            let (mut moved, mut change) = (after - then, step - then_step);
            let whole = dot(&change, &change);
            for (other, orthogonal) in &known {
                let share = dot(orthogonal, &change) / dot(orthogonal, orthogonal);
                moved.scaled_add(-share, other);
                change.scaled_add(-share, orthogonal);
            }
            let square = dot(&change, &change);
            if square > ALIKE * whole {
                let share = dot(&change, &left) / square;
                away.scaled_add(-share, &moved);
                left.scaled_add(-share, &change);
                known.push((moved, change));
            }
        }
        let (length, most) = (dot(&away, &away), FAR * FAR * dot(step, step));
        let part = if length > most { (most / length).sqrt() } else { 1.0 };
        (dot(&away, step) > 0.0).then(|| after + &(away * part))
    }
}

/// Rounds that gather way: each begins beyond the last one's end by a part of what that moved, which grows from round to
/// round until a step points back (Nesterov 1983; O'Donoghue & Candès 2015). A round whose step shrinks by the part 1 − κ
/// comes to its end in some 1/√κ of them, and a contact that creeps to where it snaps off is there sooner.
#[derive(Default)]
struct Momentum {
    last: Option<Array2<f64>>,
    /// Nesterov's t, from round to round since the way was lost, less its first, which is 1.
    gathered: f64,
}

impl Momentum {
    /// The attraction, at most `most`, to go on from, after a round that led from `before` to `after`.
    fn next(&mut self, before: &Array2<f64>, after: Array2<f64>, most: f64) -> Array2<f64> {
        let last = self.last.replace(after.clone());
        let moved = last.map(|last| &after - &last);
        let Some(moved) = moved.filter(|moved| dot(&(&after - before), moved) > 0.0) else {
            self.gathered = 0.0;
            return after;
        };
        let t = 1.0 + self.gathered;
        let next = 0.5 * (1.0 + (1.0 + 4.0 * t * t).sqrt());
        self.gathered = next - 1.0;
        (after + moved * ((t - 1.0) / next)).mapv_into(|pull| pull.clamp(0.0, most))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::arr2;

    /// Rounds that lead away from where two branches part go on to the next one: steps that grow are not summed, and of
    /// those that shrink the sum is the end.
    #[test]
    fn only_steps_that_shrink_are_summed() {
        let round = |pull: f64, after: f64| (arr2(&[[pull]]), arr2(&[[after]]));
        for (factor, end) in [(3.0, None), (0.5, Some(2.0))] {
            let mut mixed = Mixed::default();
            let (first, second) = (round(0.0, 1.0), round(1.0, 1.0 + factor));
            let mut next = |(before, after): (Array2<f64>, Array2<f64>)| {
                let change = 0.01 * (after[[0, 0]] - before[[0, 0]]);
                mixed.next(&before, after, change, 100.0)[[0, 0]]
            };
            let found = [next(first), next(second)];
            let told = [1.0, end.unwrap_or(1.0 + factor)];
            assert!(found.iter().zip(told).all(|(found, told)| (found - told).abs() < 1e-15), "{found:?}");
        }
    }
}
