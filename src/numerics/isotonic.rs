//! Rising values nearest to given ones.

/// The values that never fall and are nearest to `values`, Σ w(v̂ − v)² with the weights `weights` above zero.
///
/// Neighbours that fall are pooled to their mean until none does (pool adjacent violators: Ayer et al. 1955, Ann. Math.
/// Stat. 26, 641; exact, in a time that grows with their number). Values that rise stay as they are.
/// Check: 1, 3, 2, 4 of equal weights become 1, 2.5, 2.5, 4.
#[must_use]
pub fn isotonic(values: &[f64], weights: &[f64]) -> Vec<f64> {
    let mut pools: Vec<(f64, f64, usize)> = Vec::with_capacity(values.len());
    for (&value, &weight) in values.iter().zip(weights) {
        let mut last = (value, weight, 1);
        while let Some(&(before, weight, count)) = pools.last().filter(|pool| pool.0 > last.0) {
            pools.pop();
            let whole = weight + last.1;
            last = (before + (last.0 - before) * (last.1 / whole), whole, count + last.2);
        }
        pools.push(last);
    }
    pools.into_iter().flat_map(|(value, _, count)| std::iter::repeat_n(value, count)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn what_falls_is_pooled() {
        assert_eq!(isotonic(&[1.0, 3.0, 2.0, 4.0], &[1.0; 4]), [1.0, 2.5, 2.5, 4.0]);
        assert_eq!(isotonic(&[3.0, 0.0], &[1.0, 2.0]), [1.0, 1.0]);
        assert!(isotonic(&[], &[]).is_empty());
    }

    proptest! {
        /// The conditions of a least sum of squares (Kuhn & Tucker): it rises; the weighted means are kept; no tail of the
        /// residual can be lowered.
        #[test]
        fn no_rising_values_are_nearer(draws in prop::collection::vec((-100i32..100, 1u32..9), 1..60)) {
            let values: Vec<f64> = draws.iter().map(|draw| f64::from(draw.0)).collect();
            let weights: Vec<f64> = draws.iter().map(|draw| f64::from(draw.1)).collect();
            let found = isotonic(&values, &weights);
            prop_assert!(found.windows(2).all(|pair| pair[0] <= pair[1]));
            let rest: Vec<f64> = (0..values.len()).map(|at| weights[at] * (values[at] - found[at])).collect();
            let tails: Vec<f64> = (0..rest.len()).map(|at| rest[at..].iter().sum()).collect();
            prop_assert!(tails.iter().all(|tail| *tail <= 1e-9) && tails[0].abs() < 1e-9, "{tails:?}");
            let along: f64 = rest.iter().zip(&found).map(|(rest, found)| rest * found).sum();
            prop_assert!(along.abs() < 1e-7, "{along}");
        }
    }
}
