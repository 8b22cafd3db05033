//! SI units of what comes out of a run.
//!
//! # Examples
//! ```
//! use springbed::run::unit::Unit;
//!
//! assert_eq!((Unit::PASCAL.symbol, Unit::PASCAL.ending), ("Pa", "_pa"));
//! assert_eq!(Unit::of_name("final_speed_m_per_s"), ("final_speed", Unit::METRE_PER_SECOND));
//! ```

/// An SI unit: how it is written, and how names in files end with it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unit {
    /// As a person writes it, such as `N/m`; empty for a pure number.
    pub symbol: &'static str,
    /// Ending of names in files, such as `_n_per_m`.
    pub ending: &'static str,
    /// Whether it goes with a prefix such as kilo.
    pub prefixed: bool,
}

impl Unit {
    /// A pure number.
    pub const ONE: Self = Self { symbol: "", ending: "", prefixed: false };
    /// A length.
    pub const METRE: Self = Self { symbol: "m", ending: "_m", prefixed: true };
    /// A volume.
    pub const CUBIC_METRE: Self = Self { symbol: "m³", ending: "_m3", prefixed: false };
    /// A flow per difference of pressure.
    pub const CUBIC_METRE_PER_PASCAL_SECOND: Self =
        Self { symbol: "m³/(Pa s)", ending: "_m3_per_pa_s", prefixed: false };
    /// A curvature.
    pub const PER_METRE: Self = Self { symbol: "1/m", ending: "_per_m", prefixed: false };
    /// An area.
    pub const SQUARE_METRE: Self = Self { symbol: "m²", ending: "_m2", prefixed: false };
    /// A density over pressures.
    pub const PER_PASCAL: Self = Self { symbol: "1/Pa", ending: "_per_pa", prefixed: false };
    /// A time.
    pub const SECOND: Self = Self { symbol: "s", ending: "_s", prefixed: true };
    /// A frequency.
    pub const HERTZ: Self = Self { symbol: "Hz", ending: "_hz", prefixed: true };
    /// A speed.
    pub const METRE_PER_SECOND: Self = Self { symbol: "m/s", ending: "_m_per_s", prefixed: true };
    /// An angle.
    pub const RADIAN: Self = Self { symbol: "rad", ending: "_rad", prefixed: false };
    /// A spin.
    pub const RADIAN_PER_SECOND: Self = Self { symbol: "rad/s", ending: "_rad_per_s", prefixed: false };
    /// A force.
    pub const NEWTON: Self = Self { symbol: "N", ending: "_n", prefixed: true };
    /// A stiffness, or a force per length.
    pub const NEWTON_PER_METRE: Self = Self { symbol: "N/m", ending: "_n_per_m", prefixed: true };
    /// A pressure, a stress, a modulus.
    pub const PASCAL: Self = Self { symbol: "Pa", ending: "_pa", prefixed: true };
    /// A stress intensity.
    pub const PASCAL_ROOT_METRE: Self = Self { symbol: "Pa √m", ending: "_pa_sqrt_m", prefixed: true };
    /// An energy.
    pub const JOULE: Self = Self { symbol: "J", ending: "_j", prefixed: true };
    /// An energy per length.
    pub const JOULE_PER_METRE: Self = Self { symbol: "J/m", ending: "_j_per_m", prefixed: true };
    /// An energy per area.
    pub const JOULE_PER_SQUARE_METRE: Self = Self { symbol: "J/m²", ending: "_j_per_m2", prefixed: true };

    /// A power.
    pub const WATT: Self = Self { symbol: "W", ending: "_w", prefixed: true };
    /// A flow of heat.
    pub const WATT_PER_SQUARE_METRE: Self = Self { symbol: "W/m²", ending: "_w_per_m2", prefixed: true };

    /// All units that names end with.
    const NAMED: [Self; 21] = [
        Self::WATT,
        Self::WATT_PER_SQUARE_METRE,
        Self::METRE,
        Self::CUBIC_METRE,
        Self::CUBIC_METRE_PER_PASCAL_SECOND,
        Self::SQUARE_METRE,
        Self::PER_PASCAL,
        Self::PER_METRE,
        Self::SECOND,
        Self::HERTZ,
        Self::METRE_PER_SECOND,
        Self::RADIAN,
        Self::RADIAN_PER_SECOND,
        Self::NEWTON,
        Self::NEWTON_PER_METRE,
        Self::PASCAL,
        Self::PASCAL_ROOT_METRE,
        Self::JOULE,
        Self::JOULE_PER_METRE,
        Self::JOULE_PER_SQUARE_METRE,
        Self::ONE,
    ];

    /// The quantity and the unit of a name in a file, such as `largest_force_n`.
    #[must_use]
    pub fn of_name(name: &str) -> (&str, Self) {
        let ends = |unit: &&Self| name.ends_with(unit.ending);
        let unit = Self::NAMED.iter().filter(ends).max_by_key(|unit| unit.ending.len()).copied().unwrap_or(Self::ONE);
        (name.strip_suffix(unit.ending).unwrap_or(name), unit)
    }
}
