//! The slide's position. `v14-and-metal-form.md` 6.1.

/// Member `SlideZone` while the slide is in Top. 6.1, decided.
const TOP: i32 = 1;
/// Member `SlideZone` while the slide goes down. 6.1, decided.
const DOWN: i32 = 2;
/// Member `SlideZone` while the slide goes up. 6.1, decided.
const UP: i32 = 4;

/// The zones, one-hot in `SlideZone`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Zone {
    Top,
    Down,
    Up,
}

crate::bits!(
    enum Zone {
        Top,
        Down,
        Up,
    }
);

impl Zone {
    /// The zone of a `SlideZone`; every value but the three is invalid.
    pub(crate) fn from_number(number: i32) -> Option<Zone> {
        match number {
            TOP => Some(Zone::Top),
            DOWN => Some(Zone::Down),
            UP => Some(Zone::Up),
            _ => None,
        }
    }

    /// The value of `SlideZone`.
    pub(crate) fn number(self) -> i32 {
        match self {
            Zone::Top => TOP,
            Zone::Down => DOWN,
            Zone::Up => UP,
        }
    }

    /// The zone that follows in forward motion.
    pub(crate) fn next(self) -> Zone {
        match self {
            Zone::Top => Zone::Down,
            Zone::Down => Zone::Up,
            Zone::Up => Zone::Top,
        }
    }
}
