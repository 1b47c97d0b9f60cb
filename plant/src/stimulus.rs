//! What acts on a module from outside: devices and wires at its terminals, its power, its connection.

use std::fmt;

/// A terminal: `I0`, `O3`, `C1`, a test output `T1`, the sensor supply `S2` of an analog channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Terminal {
    /// What it is, in upper case.
    pub letter: char,
    /// Which one.
    pub number: u8,
}

impl Terminal {
    /// A terminal by letter and number.
    pub const fn new(letter: char, number: u8) -> Terminal {
        Terminal { letter: letter.to_ascii_uppercase(), number }
    }

    /// `I00`, `T1` as a terminal.
    pub fn parse(text: &str) -> Option<Terminal> {
        let letter = text.chars().next().filter(char::is_ascii_alphabetic)?;
        let digits = text.get(1..).filter(|rest| rest.bytes().all(|byte| byte.is_ascii_digit()))?;
        Some(Terminal::new(letter, digits.parse().ok()?))
    }
}

impl fmt::Display for Terminal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.letter, self.number)
    }
}

/// Auxiliary contacts in series at one terminal, at most.
pub const SERIES_MAX: usize = 4;

/// An auxiliary contact of a contactor or relay: it moves with the output that switches it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AuxiliaryContact {
    /// The module of the output, by its position in the plant.
    pub module: usize,
    /// The output.
    pub output: Terminal,
    /// Whether it is closed while the output is off: a mirror contact.
    pub inverted: bool,
    /// How long it takes to move, either way, ms.
    pub delay_ms: u64,
}

impl AuxiliaryContact {
    /// Whether it is to be closed while its output is on, or off.
    pub(crate) fn wants(&self, high: bool) -> bool {
        high != self.inverted
    }
}

/// Auxiliary contacts in series: closed while each of them is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Series {
    contacts: [Option<AuxiliaryContact>; SERIES_MAX],
}

impl Series {
    /// Nothing for more than [`SERIES_MAX`] contacts.
    pub fn new(list: &[AuxiliaryContact]) -> Option<Series> {
        let mut contacts = [None; SERIES_MAX];
        for (position, contact) in list.iter().enumerate() {
            *contacts.get_mut(position)? = Some(*contact);
        }
        Some(Series { contacts })
    }

    /// The contacts.
    pub fn contacts(&self) -> impl Iterator<Item = &AuxiliaryContact> {
        self.contacts.iter().flatten()
    }
}

/// What a device does at its terminal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Signal {
    /// A contact is closed, or a sensor is on; or not.
    Contact(bool),
    /// A voltage in mV, a current in µA or a frequency in mHz, as the range of the channel says.
    Amount(i64),
    /// Contacts move with outputs from now on. Another signal at the terminal ends that: the contact is welded, or stuck.
    Follows(Series),
}

/// What is wrong with the wire at a terminal, or behind it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// It touches 24 V.
    ToSupply,
    /// It touches 0 V.
    ToCommon,
    /// It touches the wire at another terminal.
    To(Terminal),
    /// It is broken, or the lamp or sensor at its end is burnt out.
    Open,
    /// The module finds an error of its own circuit at this terminal.
    Inside,
}

/// Something that happens to a module.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stimulus {
    /// A device changes.
    Signal(Terminal, Signal),
    /// A wire gets a fault; it keeps those that it has.
    Fault(Terminal, Fault),
    /// One fault of a wire is gone, at whichever end it was named.
    FaultGone(Terminal, Fault),
    /// Every fault of a wire is gone.
    Repaired(Terminal),
    /// Field power is there, or not.
    FieldPower(bool),
    /// The module is there; or it is pulled, without power or off the network. It begins as at power-up when it is back.
    Present(bool),
    /// The module runs, or is idle.
    Running(bool),
}

/// Why something cannot happen to a module.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Refusal {
    /// The module has no such terminal.
    NoTerminal(Terminal),
    /// The project does not use the terminal.
    NotUsed(Terminal),
    /// The terminal takes no device: outputs are switched by the module.
    NoDevice(Terminal),
    /// The device at this terminal is on or off.
    NotAnAmount(Terminal),
    /// The terminal takes a number.
    NotAContact(Terminal),
    /// More than the terminal stands, or less.
    Beyond(Terminal),
    /// A wire cannot touch itself.
    Itself(Terminal),
    /// The sensors at two channels give different quantities: what both give together is not modelled.
    OtherQuantity(Terminal),
    /// No source tells what an error inside the module does there.
    NotInside(Terminal),
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::NoTerminal(terminal) => write!(f, "the module has no terminal {terminal}"),
            Refusal::NotUsed(terminal) => write!(f, "the project does not use the terminal {terminal}"),
            Refusal::NoDevice(terminal) => write!(f, "the module switches {terminal}, no device does"),
            Refusal::NotAnAmount(terminal) => write!(f, "the device at {terminal} is on or off"),
            Refusal::NotAContact(terminal) => write!(f, "{terminal} takes a number"),
            Refusal::Beyond(terminal) => write!(f, "{terminal} cannot have so much, or so little"),
            Refusal::Itself(terminal) => write!(f, "the wire at {terminal} cannot touch itself"),
            Refusal::NotInside(terminal) => {
                write!(f, "no source tells what the module shows when its own circuit at {terminal} fails")
            }
            Refusal::OtherQuantity(terminal) => {
                write!(f, "{terminal} measures another quantity: what two such sensors give together is not simulated")
            }
        }
    }
}

impl Refusal {
    /// What to do about it.
    pub fn help(&self) -> Option<String> {
        match self {
            Refusal::NotUsed(terminal) if terminal.letter == 'T' => {
                Some(format!("set its mode in the module: `TEST {terminal} (Mode := PULSE_TEST);`"))
            }
            Refusal::NotUsed(terminal) => {
                let (letter, number) = (terminal.letter, terminal.number);
                let width = if letter == 'C' { 1 } else { 2 };
                Some(format!("set its mode in the module: `POINT {letter}{number:0width$} (Mode := SAFETY);`"))
            }
            Refusal::Beyond(_) => Some("at most 30 V either way, 30 mA, or 10000 Hz".to_owned()),
            Refusal::NotAnAmount(_) => Some("write `is on` or `is off`".to_owned()),
            Refusal::NotInside(_) => Some("an input of a 1734-IB8S and a channel of a 1734-IE4S can fail".to_owned()),
            Refusal::OtherQuantity(_) => Some("short each wire to 24 V and to 0 V instead".to_owned()),
            Refusal::NotAContact(_) => Some("write volts, milliamperes or hertz, as its range is".to_owned()),
            _ => None,
        }
    }
}

impl std::error::Error for Refusal {}
