//! What a scenario does at the terminals of modules.

use twinrung_compiler::diagnostic::{Finding, SCENARIO_NAME, SCENARIO_TERMINAL, SCENARIO_VALUE};
use twinrung_grammar::tree::scenario::{self as tree, Literal, ModuleEvent, TerminalEvent};
use twinrung_grammar::tree::{Name, Span};
use twinrung_plant::{AuxiliaryContact, Fault, Refusal, SERIES_MAX, Series, Signal, Station, Stimulus, Terminal};

use super::{Expansion, finding};
use crate::scenario::Change;
use crate::site::Site;

/// The module of a scenario's words: its position, and the module as at power-up.
pub(in crate::scenario) fn module(sites: &[Site], name: &Name) -> Result<(usize, Station), Box<Finding>> {
    let position = sites.iter().position(|site| name.is(&site.name));
    let found = position.and_then(|position| Some((position, sites.get(position)?.station()?)));
    found.ok_or_else(|| {
        let known: Vec<&str> = sites.iter().map(|site| site.name.as_str()).collect();
        let known = match known.is_empty() {
            true => "the project has no 1734-IB8S, 1734-OB8S or 1734-IE4S".to_owned(),
            false => format!("modules with terminals here: {}", known.join(", ")),
        };
        Box::new(Finding::new(&SCENARIO_NAME, name.span, format!("`{name}` is no module with terminals")).help(known))
    })
}

/// A terminal of a module: a number is a point of it.
pub(in crate::scenario) fn terminal(station: &Station, text: &str, span: Span) -> Result<Terminal, Box<Finding>> {
    let number = text.parse().ok().map(|number| station.point(number));
    let terminal = number.or_else(|| Terminal::parse(text)).filter(|one| station.has(*one));
    terminal.ok_or_else(|| finding(&SCENARIO_TERMINAL, span, format!("the module has no terminal `{text}`")))
}

/// A terminal at which a check may look: whether 24 V stand there.
pub(in crate::scenario) fn looked_at(station: &Station, place: &tree::Terminal) -> Result<Terminal, Box<Finding>> {
    let own = terminal(station, &place.text, place.span)?;
    // What can be repaired is wired.
    station.accepts(&Stimulus::Repaired(own)).map_err(|refusal| refused(&refusal, place.span))?;
    if station.is_high(own).is_none() {
        let message = format!("{own} has a number, not on or off");
        return Err(Box::new(
            Finding::new(&SCENARIO_TERMINAL, place.span, message).help("look at the data in its tag"),
        ));
    }
    Ok(own)
}

fn refused(refusal: &Refusal, span: Span) -> Box<Finding> {
    let wrong = Finding::new(&SCENARIO_TERMINAL, span, refusal.to_string());
    Box::new(match refusal.help() {
        Some(help) => wrong.help(help),
        None => wrong,
    })
}

/// A value at a terminal: on, off, or a number with up to three decimals.
fn signal(literal: &Literal) -> Result<Signal, Box<Finding>> {
    match literal.text.as_str() {
        "on" => return Ok(Signal::Contact(true)),
        "off" => return Ok(Signal::Contact(false)),
        _ => {}
    }
    thousandths(&literal.text).map(Signal::Amount).ok_or_else(|| {
        let message = format!("`{}` is no value of a terminal", literal.text);
        Box::new(
            Finding::new(&SCENARIO_VALUE, literal.span, message)
                .help("on, off, or a number with three decimals at most"),
        )
    })
}

/// `12.5` as 12500.
fn thousandths(text: &str) -> Option<i64> {
    let (sign, digits) = text.strip_prefix('-').map_or((1, text), |rest| (-1, rest));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let whole: i64 = whole.parse().ok()?;
    let part: i64 = if fraction.is_empty() { 0 } else { format!("{fraction:0<3}").parse().ok()? };
    (fraction.len() <= 3).then(|| Some(sign * whole.checked_mul(1000)?.checked_add(part)?))?
}

/// What stands at the terminals of each module, and how the module is, after all that was said so far.
#[derive(Default)]
pub(super) struct Standing {
    /// By module: devices, faults of wires, and what befell the module itself.
    modules: Vec<Vec<Stimulus>>,
    /// Until when something is held at a terminal, in ms.
    held_until_ms: u64,
}

impl Standing {
    fn of(&self, module: usize) -> &[Stimulus] {
        self.modules.get(module).map_or(&[], Vec::as_slice)
    }

    fn happened(&mut self, module: usize, stimulus: Stimulus) {
        if self.modules.len() <= module {
            self.modules.resize(module + 1, Vec::new());
        }
        let Some(own) = self.modules.get_mut(module) else { return };
        own.retain(|other| !replaces(stimulus, *other));
        if !matches!(stimulus, Stimulus::Repaired(_) | Stimulus::FaultGone(..)) {
            own.push(stimulus);
        }
    }

    /// What brings back what stood before; nothing where that is what is held. At first nothing is closed, no sensor gives
    /// anything, and modules are there, run and have power.
    fn before(&self, module: usize, stimulus: Stimulus, station: &Station) -> Option<Stimulus> {
        let last = self.of(module).iter().find(|other| replaces(stimulus, **other)).copied();
        match stimulus {
            Stimulus::Fault(..) if last.is_some() => None,
            Stimulus::Fault(terminal, fault) => Some(Stimulus::FaultGone(terminal, fault)),
            _ if last.is_some() => last,
            Stimulus::Signal(terminal, _) => {
                Some(Stimulus::Signal(terminal, contact(station, terminal, Signal::Contact(false))))
            }
            Stimulus::FieldPower(_) => Some(Stimulus::FieldPower(true)),
            Stimulus::Present(_) => Some(Stimulus::Present(true)),
            Stimulus::Running(_) => Some(Stimulus::Running(true)),
            Stimulus::Repaired(_) | Stimulus::FaultGone(..) => None,
        }
    }
}

/// Whether a later event takes the place of another one of the same module.
fn replaces(later: Stimulus, other: Stimulus) -> bool {
    let short = |terminal: Terminal, fault: Fault| match fault {
        Fault::To(other) => Some((other, Fault::To(terminal))),
        _ => None,
    };
    match (later, other) {
        (Stimulus::Signal(own, _), Stimulus::Signal(other, _)) => own == other,
        (
            Stimulus::Fault(at, fault) | Stimulus::FaultGone(at, fault),
            Stimulus::Fault(own, other) | Stimulus::FaultGone(own, other),
        ) => (at, fault) == (own, other) || short(at, fault) == Some((own, other)),
        (Stimulus::Repaired(at), Stimulus::Fault(own, fault) | Stimulus::FaultGone(own, fault)) => {
            at == own || fault == Fault::To(at)
        }
        (Stimulus::FieldPower(_), Stimulus::FieldPower(_))
        | (Stimulus::Present(_), Stimulus::Present(_))
        | (Stimulus::Running(_), Stimulus::Running(_)) => true,
        _ => false,
    }
}

impl Expansion<'_> {
    /// What happens at a terminal, looked up.
    pub(super) fn at_terminal(
        &self,
        place: &tree::Terminal,
        event: &TerminalEvent,
        span: Span,
    ) -> Result<(usize, Stimulus), Box<Finding>> {
        let (position, station) = module(self.sites, &place.module)?;
        let own = terminal(&station, &place.text, place.span)?;
        let stimulus = match event {
            TerminalEvent::Is(literal) => Stimulus::Signal(own, contact(&station, own, signal(literal)?)),
            TerminalEvent::ShortedToVolts(volts, unit) => match (volts.text.as_str(), unit.is("V")) {
                ("24", true) => Stimulus::Fault(own, Fault::ToSupply),
                ("0", true) => Stimulus::Fault(own, Fault::ToCommon),
                _ => {
                    let message = format!("a wire is not shorted to {} {unit}", volts.text);
                    let help = "write `shorted to 24 V`, `shorted to 0 V` or `shorted to terminal 1`";
                    return Err(Box::new(Finding::new(&SCENARIO_TERMINAL, volts.span, message).help(help)));
                }
            },
            TerminalEvent::ShortedToTerminal(other) => {
                Stimulus::Fault(own, Fault::To(terminal(&station, &other.text, other.span)?))
            }
            TerminalEvent::Open => Stimulus::Fault(own, Fault::Open),
            TerminalEvent::Repaired => Stimulus::Repaired(own),
            TerminalEvent::Fails => Stimulus::Fault(own, Fault::Inside),
            TerminalEvent::Follows(contacts) => Stimulus::Signal(own, Signal::Follows(self.series(contacts, span)?)),
        };
        station.accepts(&stimulus).map_err(|refusal| refused(&refusal, span))?;
        Ok((position, stimulus))
    }

    /// Contacts in series that follow outputs, of whichever modules.
    fn series(&self, contacts: &[tree::Follow], span: Span) -> Result<Series, Box<Finding>> {
        let mut list = Vec::with_capacity(contacts.len());
        for contact in contacts {
            let place = &contact.output;
            let (position, station) = module(self.sites, &place.module)?;
            let output = looked_at(&station, place)?;
            if !matches!(output.letter, 'O' | 'T') {
                let wrong = Finding::new(&SCENARIO_TERMINAL, place.span, format!("{output} is no output"));
                return Err(Box::new(wrong.help("a contact follows a safety output or a test output")));
            }
            let delay_ms = contact.delay.as_ref().map_or(Ok(0), |time| self.time(time))?;
            list.push(AuxiliaryContact { module: position, output, inverted: contact.inverted, delay_ms });
        }
        Series::new(&list).ok_or_else(|| {
            let message = format!("{} contacts are in series, and {SERIES_MAX} are the most", list.len());
            finding(&SCENARIO_TERMINAL, span, message)
        })
    }

    /// What happens to a module, looked up.
    pub(super) fn at_module(&self, name: &Name, event: ModuleEvent) -> Result<(usize, Stimulus), Box<Finding>> {
        let (position, _) = module(self.sites, name)?;
        let stimulus = match event {
            ModuleEvent::Power(on) => Stimulus::FieldPower(on),
            ModuleEvent::Present(present) => Stimulus::Present(present),
            ModuleEvent::Running(running) => Stimulus::Running(running),
        };
        Ok((position, stimulus))
    }

    /// Something happens to a module at a time; what is held of the same kind from before ends with it.
    pub(super) fn happen(
        &mut self,
        module: usize,
        stimulus: Stimulus,
        at_ms: u64,
        span: Span,
    ) -> Result<(), Box<Finding>> {
        if self.standing.held_until_ms > at_ms {
            let ends = |change: &Change| matches!(change, Change::Plant { module: own, stimulus: other } if *own == module && replaces(stimulus, *other));
            self.actions.retain(|action| action.at_ms <= at_ms || !ends(&action.change));
        }
        self.standing.happened(module, stimulus);
        self.act(at_ms, Change::Plant { module, stimulus }, span)
    }

    /// Something happens to a module for a time, after which it is as it was before.
    pub(super) fn held(
        &mut self,
        module: usize,
        stimulus: Stimulus,
        (at_ms, until_ms): (u64, u64),
        span: Span,
    ) -> Result<(), Box<Finding>> {
        let mends = match stimulus {
            Stimulus::Repaired(_) => Some("repaired"),
            Stimulus::FieldPower(true) | Stimulus::Present(true) => Some("restored"),
            Stimulus::Running(true) => Some("running"),
            _ => None,
        };
        if let Some(word) = mends {
            let message = format!("`{word}` is not held: it ends what went wrong before");
            return Err(Box::new(
                Finding::new(&SCENARIO_TERMINAL, span, message).help(format!("write `when ... {word}`")),
            ));
        }
        let station = self.sites.get(module).and_then(Site::station);
        let before = station.and_then(|station| self.standing.before(module, stimulus, &station));
        self.happen(module, stimulus, at_ms, span)?;
        match before {
            Some(before) => {
                self.happen(module, before, until_ms, span)?;
                self.standing.held_until_ms = self.standing.held_until_ms.max(until_ms);
                Ok(())
            }
            None => Ok(()),
        }
    }

    /// The tags of simulated modules follow their terminals: a scenario that acts at terminals drives none of them.
    pub fn tags_and_terminals(&self) -> Vec<Finding> {
        if !self.at_terminals {
            return Vec::new();
        }
        let both = self.driven_at.iter().filter_map(|(name, signal)| {
            let site = self.sites.iter().find(|site| site.drives(*signal))?;
            let message = format!("`{name}` follows the terminals of {}, which this scenario acts on", site.name);
            let help = format!("say what happens at the terminal: `when {} terminal 0 is on`", site.name);
            Some(Finding::new(&SCENARIO_TERMINAL, name.span, message).help(help))
        });
        both.collect()
    }
}

/// `1` and `0` mean on and off where the terminal takes a contact, and `off` means 0 where it takes a number.
fn contact(station: &Station, terminal: Terminal, signal: Signal) -> Signal {
    let other = match signal {
        Signal::Amount(0) => Signal::Contact(false),
        Signal::Amount(1000) => Signal::Contact(true),
        Signal::Contact(false) => Signal::Amount(0),
        other => other,
    };
    let takes = |signal: Signal| station.accepts(&Stimulus::Signal(terminal, signal)).is_ok();
    if !takes(signal) && takes(other) { other } else { signal }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_when_they_have_three_decimals_at_most_then_they_are_thousandths() {
        assert_eq!(thousandths("12.5"), Some(12_500));
        assert_eq!(thousandths("-0.25"), Some(-250));
        assert_eq!(thousandths("7"), Some(7_000));
        assert_eq!(thousandths("1.2345"), None);
        assert_eq!(thousandths("9223372036854775.999"), None);
    }
}
