//! Which column holds what, and in which unit.

use super::grid::Grid;
use super::quantity::{Quantity, Size};
use crate::scene::fit::Drive;
use crate::text::advice;

/// What is asked of a data file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wanted {
    named: Vec<Named>,
    /// Stiffness of the cantilever [N/m].
    pub spring: Option<f64>,
    /// What drives; `None` of moduli.
    pub led: Option<Drive>,
}

/// A column named by the user.
#[derive(Debug, Clone, PartialEq)]
struct Named {
    quantity: Quantity,
    /// Name or number, from 1 on.
    column: String,
    unit: Option<String>,
    sign: f64,
}

impl Wanted {
    /// The columns of `text`, such as `depth=z [nm], force=-F [nN], time=3 [s]`: names or numbers, and a sign.
    ///
    /// # Errors
    /// What is wrong with it, and what would be right.
    pub fn read(text: &str, spring: Option<f64>) -> Result<Self, String> {
        let named = text.split(',').map(str::trim).filter(|part| !part.is_empty()).map(Named::read);
        Ok(Self { named: named.collect::<Result<Vec<_>, _>>()?, spring, led: None })
    }

    /// The same of data of what `led` drives.
    #[must_use]
    pub fn led_by(self, led: Drive) -> Self {
        Self { led: Some(led), ..self }
    }
}

impl Named {
    fn read(text: &str) -> Result<Self, String> {
        let right = "expected depth=NAME [UNIT], such as \"depth=z [nm], force=F [nN]\"";
        let (quantity, column) = text.split_once('=').ok_or_else(|| format!("\"{text}\" names no column: {right}"))?;
        let known: Vec<&str> = Quantity::ALL.into_iter().map(Quantity::name).collect();
        let quantity = quantity.trim();
        let found = Quantity::ALL.into_iter().find(|known| known.name() == quantity.to_lowercase());
        let found = found.ok_or_else(|| format!("there is no quantity `{quantity}`: {}", advice(quantity, &known)))?;
        let (name, unit) = match column.trim().strip_suffix(']').and_then(|column| column.rsplit_once('[')) {
            Some((name, unit)) => (name.trim(), Some(unit.trim().to_owned())),
            None => (column.trim(), None),
        };
        if let Some(unit) = unit.as_deref().filter(|unit| found.size(unit).is_none()) {
            return Err(format!("{quantity} has no unit \"{unit}\": expected one such as {}", found.example()));
        }
        let (sign, name) = name.strip_prefix('-').map_or((1.0, name), |name| (-1.0, name.trim()));
        if name.is_empty() {
            return Err(format!("\"{text}\" names no column: {right}"));
        }
        Ok(Self { quantity: found, column: name.to_owned(), unit, sign })
    }
}

/// A column that was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// What it holds.
    pub quantity: Quantity,
    /// Where, from 0 on.
    pub at: usize,
    /// Size of its unit, with its sign.
    pub size: Size,
    /// What is added to it in SI units.
    pub zero: f64,
    /// Its name in messages.
    pub name: String,
}

/// A column as its heads describe it.
pub struct Headed {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: Option<String>,
}

/// The columns of a table that are wanted, and what was taken for granted of them.
///
/// # Errors
/// A column that was named is not there; two may hold the same quantity.
pub fn found(grid: &Grid, wanted: &Wanted) -> Result<(Vec<Found>, Vec<String>), String> {
    let headed: Vec<Headed> = (0..grid.width).map(|at| headed(grid, at)).collect();
    let mut all = Vec::new();
    let mut notes = Vec::new();
    for named in &wanted.named {
        let at = place(&headed, &named.column)?;
        let unit = named.unit.clone().or_else(|| headed[at].unit.clone());
        all.push(sized(named.quantity, at, unit.as_deref(), &mut notes, (&headed[at], named.sign))?);
    }
    for &quantity in Quantity::wanted(wanted.led) {
        let taken = |at: &usize| all.iter().any(|found: &Found| found.at == *at);
        if all.iter().any(|found| found.quantity == quantity) {
            continue;
        }
        let fits: Vec<usize> =
            (0..grid.width).filter(|at| !taken(at)).filter(|&at| holds(quantity, &headed[at])).collect();
        match fits[..] {
            [] => {}
            [at] => all.push(sized(quantity, at, headed[at].unit.as_deref(), &mut notes, (&headed[at], 1.0))?),
            [one, two, ..] => {
                let (one, two, name) = (&headed[one].name, &headed[two].name, quantity.name());
                return Err(format!(
                    "the {name} may be in \"{one}\" or in \"{two}\": name it, as in --columns \"{name}={one}\""
                ));
            }
        }
    }
    Ok((all, notes))
}

fn sized(
    quantity: Quantity,
    at: usize,
    unit: Option<&str>,
    notes: &mut Vec<String>,
    (head, sign): (&Headed, f64),
) -> Result<Found, String> {
    let name = if head.name.is_empty() { format!("column {}", at + 1) } else { head.name.clone() };
    let size = match unit {
        Some(unit) => quantity.size(unit).ok_or_else(|| {
            format!("{name}: {} has no unit \"{unit}\": expected one such as {}", quantity.name(), quantity.example())
        })?,
        None if quantity == Quantity::Restitution => (1.0, 1.0),
        None => {
            notes.push(format!(
                "{name} has no unit: taken as SI; else say --columns \"{}={name} [{}]\"",
                quantity.name(),
                quantity.example()
            ));
            (1.0, 1.0)
        }
    };
    Ok(Found { quantity, at, size: (sign * size.0, size.1), zero: quantity.zero(unit), name })
}

/// Whether a column is called like a quantity and has a unit of it, or none.
fn holds(quantity: Quantity, head: &Headed) -> bool {
    quantity.names().contains(&plain(&head.name).as_str())
        && head.unit.as_deref().is_none_or(|unit| quantity.size(unit).is_some())
}

/// The column of a name, or of a number from 1 on.
fn place(headed: &[Headed], name: &str) -> Result<usize, String> {
    if let Some(at) = headed.iter().position(|head| plain(&head.name) == plain(name)) {
        return Ok(at);
    }
    if let Some(at) = name.parse::<usize>().ok().filter(|at| (1..=headed.len()).contains(at)) {
        return Ok(at - 1);
    }
    let known: Vec<&str> = headed.iter().map(|head| head.name.as_str()).filter(|name| !name.is_empty()).collect();
    if known.is_empty() {
        return Err(format!(
            "there is no column \"{name}\" and the columns have no names: expected a number from 1 to {}",
            headed.len()
        ));
    }
    Err(format!("there is no column \"{name}\": {}", advice(name, &known)))
}

/// A name in small letters, without blanks and dashes.
pub fn plain(name: &str) -> String {
    name.chars().filter(|c| !c.is_whitespace() && !matches!(c, '_' | '-')).flat_map(char::to_lowercase).collect()
}

/// Name and unit of a column: from the line above the table, or from the two above it, names and units.
pub fn headed(grid: &Grid, at: usize) -> Headed {
    let cell = |line: &Vec<String>| line[at].trim_start_matches('#').trim().trim_matches('"').to_owned();
    let near: Vec<String> = grid.heads.iter().rev().take(2).map(cell).collect();
    match &near[..] {
        [] => Headed { name: String::new(), unit: None },
        [units, names] if is_unit(units) && !names.is_empty() => {
            let unit = units.trim_matches(['[', ']', '(', ')']).to_owned();
            Headed { name: split(names).name, unit: Some(unit) }
        }
        [head, ..] => split(head),
    }
}

/// Whether a head is nothing but a unit, as in a second line of them; letters that may be names count in brackets only.
fn is_unit(text: &str) -> bool {
    let bare = text.trim_matches(['[', ']', '(', ')']);
    let known = Quantity::ALL.into_iter().any(|quantity| quantity.size(bare).is_some());
    known && !bare.is_empty() && !(["d", "h", "t", "C", "K"].contains(&bare) && bare == text)
}

/// `z [nm]`, `z (nm)`, `z/nm`, `z, nm` or `z_nm` as name and unit.
fn split(head: &str) -> Headed {
    let bracketed = [('[', ']'), ('(', ')')].into_iter().find_map(|(open, close)| {
        let inside = head.trim().strip_suffix(close)?;
        inside.rsplit_once(open)
    });
    let marked =
        || ['/', ','].into_iter().find_map(|mark| head.rsplit_once(mark)).filter(|(_, unit)| is_unit(unit.trim()));
    let tailed = || {
        let small = head.trim().to_lowercase();
        let speed =
            SPEEDS.iter().find_map(|(tail, unit)| Some((head.trim().get(..small.strip_suffix(tail)?.len())?, *unit)));
        speed.or_else(|| head.rsplit_once('_').and_then(|(name, tail)| Some((name, spelt(tail)?))))
    };
    match bracketed.or_else(marked).or_else(tailed) {
        Some((name, unit)) => Headed { name: name.trim().to_owned(), unit: Some(unit.trim().to_owned()) },
        None => Headed { name: head.trim().to_owned(), unit: None },
    }
}

/// Units of speeds as they end names of columns, in small letters.
const SPEEDS: [(&str, &str); 4] =
    [("_mm_per_s", "mm/s"), ("_um_per_s", "um/s"), ("_cm_per_s", "cm/s"), ("_m_per_s", "m/s")];

/// Units as they end names of columns, in small letters.
fn spelt(tail: &str) -> Option<&'static str> {
    const ENDINGS: [(&str, &str); 19] = [
        ("s", "s"),
        ("ms", "ms"),
        ("m", "m"),
        ("mm", "mm"),
        ("um", "um"),
        ("nm", "nm"),
        ("n", "N"),
        ("mn", "mN"),
        ("un", "uN"),
        ("nn", "nN"),
        ("pn", "pN"),
        ("hz", "Hz"),
        ("pa", "Pa"),
        ("kpa", "kPa"),
        ("mpa", "MPa"),
        ("gpa", "GPa"),
        ("min", "min"),
        ("k", "K"),
        ("degc", "degC"),
    ];
    let tail = tail.trim().to_lowercase();
    ENDINGS.iter().find(|(ending, _)| *ending == tail).map(|(_, unit)| *unit)
}
