//! What a scenario does at the terminals of modules.

use twinrung_compiler::diagnostic::{Finding, SCENARIO_NAME, SCENARIO_TERMINAL, SCENARIO_VALUE};
use twinrung_grammar::tree::scenario::{self as tree, Literal, ModuleEvent, TerminalEvent};
use twinrung_grammar::tree::{Name, Span};
use twinrung_plant::{Fault, Refusal, Signal, Station, Stimulus, Terminal};

use super::{Expansion, finding};
use crate::scenario::Change;
use crate::site::Site;

/// What was done to a terminal or a module, and what ends that.
pub(super) struct Done {
    pub module: usize,
    pub ends: Stimulus,
}

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
    let terminal = number.or_else(|| Terminal::parse(text)).filter(|one| station.is_high(*one).is_some());
    terminal.ok_or_else(|| finding(&SCENARIO_TERMINAL, span, format!("the module has no terminal `{text}`")))
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
    (fraction.len() <= 3).then(|| Some(sign * (whole.checked_mul(1000)? + part)))?
}

impl Expansion<'_> {
    /// Something happens at a terminal.
    pub(super) fn at_terminal(
        &mut self,
        place: &tree::Terminal,
        event: &TerminalEvent,
        span: Span,
        at_ms: u64,
    ) -> Result<Done, Box<Finding>> {
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
        };
        station.accepts(&stimulus).map_err(|refusal| refused(&refusal, span))?;
        let ends = match stimulus {
            Stimulus::Signal(own, _) => Stimulus::Signal(own, self.terminal_before(position, own, &station)),
            _ => Stimulus::Repaired(own),
        };
        self.happen(position, stimulus, at_ms, span)?;
        Ok(Done { module: position, ends })
    }

    /// Something happens to a module.
    pub(super) fn at_module(
        &mut self,
        name: &Name,
        event: ModuleEvent,
        span: Span,
        at_ms: u64,
    ) -> Result<Done, Box<Finding>> {
        let (position, _) = module(self.sites, name)?;
        let (stimulus, ends) = match event {
            ModuleEvent::Power(on) => (Stimulus::FieldPower(on), Stimulus::FieldPower(!on)),
            ModuleEvent::Present(present) => (Stimulus::Present(present), Stimulus::Present(!present)),
            ModuleEvent::Running(running) => (Stimulus::Running(running), Stimulus::Running(!running)),
        };
        self.happen(position, stimulus, at_ms, span)?;
        Ok(Done { module: position, ends })
    }

    /// What stood at a terminal last; at first nothing is closed, and sensors give nothing.
    fn terminal_before(&self, position: usize, terminal: Terminal, station: &Station) -> Signal {
        let of_it = |change: &Change| match change {
            Change::Plant { module, stimulus: Stimulus::Signal(own, signal), .. }
                if (*module, *own) == (position, terminal) =>
            {
                Some(*signal)
            }
            _ => None,
        };
        let last = self.actions.iter().rev().find_map(|action| of_it(&action.change));
        last.unwrap_or_else(|| contact(station, terminal, Signal::Contact(false)))
    }

    /// Something happens to a module at a time.
    pub(super) fn happen(
        &mut self,
        module: usize,
        stimulus: Stimulus,
        at_ms: u64,
        span: Span,
    ) -> Result<(), Box<Finding>> {
        self.at_terminals = true;
        // A later one at the same terminal ends what is held there.
        if let Stimulus::Signal(terminal, _) = stimulus {
            self.actions.retain(|action| action.at_ms <= at_ms || !of_terminal(&action.change, module, terminal));
        }
        self.act(at_ms, Change::Plant { module, stimulus }, span)
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

fn of_terminal(change: &Change, position: usize, terminal: Terminal) -> bool {
    matches!(change, Change::Plant { module, stimulus: Stimulus::Signal(own, _) }
        if (*module, *own) == (position, terminal))
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
    }
}
