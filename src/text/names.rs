//! Wrong names: the nearest right one and the list of all.

/// The fields of a scene.
pub const FIELDS: [&str; 15] = [
    "title", "shape", "bodies", "adhesion", "friction", "wear", "machine", "history", "accuracy", "springs", "solver",
    "steps", "plots", "sweep", "fit",
];

/// `did you mean …? Known: …`, for a name that is not among `known`.
pub fn advice(found: &str, known: &[&str]) -> String {
    let list = known.join(", ");
    match nearest(found, known) {
        Some(name) if known.len() > 1 => format!("did you mean `{name}`? Known: {list}"),
        Some(name) => format!("expected `{name}`"),
        None if known.is_empty() => "expected nothing here".to_owned(),
        None => format!("expected one of {list}"),
    }
}

/// The known name nearest to `found`, if it is near enough to be meant.
pub fn nearest<'n>(found: &str, known: &[&'n str]) -> Option<&'n str> {
    let lower = |text: &str| text.chars().take(64).flat_map(char::to_lowercase).collect::<Vec<char>>();
    let found = lower(found);
    let near = |name: &&&str| {
        let name = lower(name);
        (distance(&found, &name), name.len())
    };
    let best = known.iter().min_by_key(|name| near(name).0)?;
    let (far, length) = near(&best);
    (far <= 1 + length / 4).then_some(best)
}

/// Number of insertions, removals, replacements and exchanges of neighbours between two words
/// (optimal string alignment).
fn distance(one: &[char], two: &[char]) -> usize {
    let mut rows = vec![(0..=two.len()).collect::<Vec<usize>>()];
    for i in 1..=one.len() {
        let mut row = vec![i];
        for j in 1..=two.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(one[i - 1] != two[j - 1]);
            let exchanged = i > 1 && j > 1 && one[i - 1] == two[j - 2] && one[i - 2] == two[j - 1];
            let exchange = if exchanged { rows[i - 2][j - 2] + 1 } else { usize::MAX };
            row.push(replaced.min(exchange).min(rows[i - 1][j] + 1).min(row[j - 1] + 1));
        }
        rows.push(row);
    }
    rows[one.len()][two.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances() {
        let far = |a: &str, b: &str| distance(&a.chars().collect::<Vec<_>>(), &b.chars().collect::<Vec<_>>());
        assert_eq!(far("kitten", "sitting"), 3);
        assert_eq!(far("titel", "title"), 1);
        assert_eq!(far("", "abc"), 3);
    }

    #[test]
    fn a_near_name_is_suggested_and_a_far_one_is_not() {
        let known = ["Paraboloid", "Cone", "Power"];
        assert_eq!(advice("parabloid", &known), "did you mean `Paraboloid`? Known: Paraboloid, Cone, Power");
        assert_eq!(advice("Wheel", &known), "expected one of Paraboloid, Cone, Power");
        assert_eq!(advice("radus", &["radius"]), "expected `radius`");
    }
}
