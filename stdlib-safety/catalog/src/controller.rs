//! The safety controllers and what each admits.

/// A family of controllers that admit the same set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// 1756-L61S, -L62S, -L63S: no REAL.
    L6x,
    /// 1768-L43S, -L45S: no REAL.
    L4x,
    /// 1756-L71S, -L72S, -L73S(XT) and the later families that take what these take.
    L7x,
}

/// One controller.
#[derive(Debug, PartialEq, Eq)]
pub struct Controller {
    /// Catalogue number as `ProcessorType` writes it.
    pub catalog_number: &'static str,
    /// What it admits.
    pub family: Family,
    /// First major revision that it had; earlier ones are refused.
    pub first_revision: u16,
}

const fn controller(catalog_number: &'static str, family: Family, first_revision: u16) -> Controller {
    Controller { catalog_number, family, first_revision }
}

/// Every known safety controller. Sources: DESIGN 4; 1756-RM093 Tables 2 and 7; the revisions of later families are
/// those of the exports that name them (decided: 28 where none is at hand).
pub static ALL: &[Controller] = &[
    controller("1756-L61S", Family::L6x, 14),
    controller("1756-L62S", Family::L6x, 14),
    controller("1756-L63S", Family::L6x, 17),
    controller("1768-L43S", Family::L4x, 18),
    controller("1768-L45S", Family::L4x, 18),
    controller("1756-L71S", Family::L7x, 20),
    controller("1756-L72S", Family::L7x, 20),
    controller("1756-L73S", Family::L7x, 20),
    controller("1756-L73SXT", Family::L7x, 20),
    controller("1769-L30ERMS", Family::L7x, 28),
    controller("1769-L33ERMS", Family::L7x, 28),
    controller("1769-L36ERMS", Family::L7x, 28),
    controller("1769-L37ERMS", Family::L7x, 28),
    controller("1769-L38ERMS", Family::L7x, 28),
    controller("5069-L306ERS2", Family::L7x, 31),
    controller("5069-L306ERMS2", Family::L7x, 31),
    controller("5069-L306ERMS3", Family::L7x, 31),
    controller("5069-L310ERS2", Family::L7x, 31),
    controller("5069-L310ERMS2", Family::L7x, 31),
    controller("5069-L310ERMS3", Family::L7x, 31),
    controller("5069-L320ERS2", Family::L7x, 31),
    controller("5069-L320ERS2K", Family::L7x, 31),
    controller("5069-L320ERMS2", Family::L7x, 31),
    controller("5069-L320ERMS3", Family::L7x, 31),
    controller("5069-L330ERS2", Family::L7x, 31),
    controller("5069-L330ERMS2", Family::L7x, 31),
    controller("5069-L330ERMS3", Family::L7x, 31),
    controller("5069-L340ERS2", Family::L7x, 31),
    controller("5069-L340ERMS2", Family::L7x, 31),
    controller("5069-L340ERMS3", Family::L7x, 31),
    controller("5069-L350ERS2", Family::L7x, 31),
    controller("5069-L350ERMS2", Family::L7x, 31),
    controller("5069-L350ERMS3", Family::L7x, 31),
    controller("5069-L380ERS2", Family::L7x, 31),
    controller("5069-L380ERMS2", Family::L7x, 31),
    controller("5069-L380ERMS3", Family::L7x, 31),
    controller("5069-L3100ERS2", Family::L7x, 31),
    controller("5069-L3100ERMS2", Family::L7x, 31),
    controller("5069-L3100ERMS3", Family::L7x, 31),
    controller("1756-L81ES", Family::L7x, 31),
    controller("1756-L82ES", Family::L7x, 31),
    controller("1756-L83ES", Family::L7x, 31),
    controller("1756-L84ES", Family::L7x, 31),
    controller("1756-L85ES", Family::L7x, 31),
];

impl Controller {
    /// Finds a controller by catalogue number; upper and lower case are the same.
    pub fn by_catalog_number(catalog_number: &str) -> Option<&'static Controller> {
        ALL.iter().find(|known| known.catalog_number.eq_ignore_ascii_case(catalog_number))
    }

    /// Whether safety tags of this controller may hold REAL (1756-RM093 Table 7 and Table 12 footnote 1).
    pub const fn has_real(&self) -> bool {
        matches!(self.family, Family::L7x)
    }

    /// Whether a major revision of this controller exists and holds a safety task. Version 15 never did; the L6x and
    /// L4x ended with 20 (1756-RM093 Table 2).
    pub const fn knows_revision(&self, revision: u16) -> bool {
        revision >= self.first_revision
            && match self.family {
                Family::L6x | Family::L4x => revision != 15 && revision <= 20,
                Family::L7x => true,
            }
    }
}
