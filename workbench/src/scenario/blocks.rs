//! Blocks put in front of each other, and their lines on one scale of time.

pub(super) mod terminals;

use twinrung_bytecode::AdmittedImage;
use twinrung_compiler::diagnostic::{Finding, SCENARIO_BLOCK, SCENARIO_NAME, SCENARIO_TIME, SCENARIO_VALUE};
use twinrung_grammar::tree::scenario::{
    Block, BlockKind, Condition, Line, LineKind, Literal, Mode, ScenarioFile, ScenarioItem, Setting, Time,
};
use twinrung_grammar::tree::{Name, Span};

use super::plan::{nevers, no_scan};
use super::value::{self, Check};
use super::words::{self, condition_text, never_text, time_text, within_text};
use super::{Action, Change, Expectation, Expected};
use crate::names;
use crate::signal::{Signal, Value};
use crate::site::Site;
use terminals::Standing;

/// Setups in setups.
const DEPTH_MAX: usize = 16;
/// Scans of one scenario: more than ten hours of a task that runs each 10 ms.
const SCANS_MAX: u64 = 4_000_000;
/// Actions of one scenario: a `toggle` is one for each change.
const ACTIONS_MAX: usize = 1_000_000;
/// Lines of one scenario with those of its setups, which may begin with setups in turn. Each of what is joined with commas counts.
const LINES_MAX: usize = 10_000;

/// The blocks of a file by name.
pub struct Blocks<'a> {
    in_order: Vec<&'a Block>,
}

impl<'a> Blocks<'a> {
    /// Gathers the blocks; two of one kind and name are a finding.
    pub fn new(file: &'a ScenarioFile, findings: &mut Vec<Finding>) -> Blocks<'a> {
        let mut in_order: Vec<&Block> = Vec::new();
        for item in &file.items {
            let ScenarioItem::Block(block) = item else { continue };
            let same = |other: &&&Block| other.kind == block.kind && other.name.text == block.name.text;
            if let Some(other) = in_order.iter().find(same) {
                let message = format!("`{}` stands in the file twice", block.name.as_str());
                let finding = Finding::new(&SCENARIO_BLOCK, block.name.span, message);
                findings.push(finding.label(other.name.span, "the first one"));
            }
            in_order.push(block);
        }
        Blocks { in_order }
    }

    /// All blocks in order.
    pub fn all(&self) -> impl Iterator<Item = &'a Block> + '_ {
        self.in_order.iter().copied()
    }

    fn setup(&self, name: &str) -> Option<&'a Block> {
        self.all().find(|block| block.kind == BlockKind::Setup && block.name.as_str() == name)
    }
}

/// A scenario as it comes into being.
pub struct Expansion<'a> {
    image: &'a AdmittedImage,
    sites: &'a [Site],
    blocks: &'a Blocks<'a>,
    findings: &'a mut Vec<Finding>,
    period_ms: u64,
    /// Whether anything happens at terminals, or is looked at there.
    pub at_terminals: bool,
    /// What was driven by its name, and where.
    driven_at: Vec<(Name, Signal)>,
    /// Where the mode switch stands at power-up.
    pub power_up: Mode,
    /// What is done, in the order of the text.
    pub actions: Vec<Action>,
    /// What is expected.
    pub expectations: Vec<Expectation>,
    /// Time of the last moment and the last check in ms: what comes next begins after it.
    pub end_ms: u64,
    /// Time of the last action in ms: what is held or toggled runs on.
    pub acts_until_ms: u64,
    /// What was driven last, by where it is.
    driven: Vec<(Signal, i32)>,
    /// What stands at the terminals.
    standing: Standing,
    /// Lines so far, those of setups included.
    lines: usize,
    open: Vec<&'a str>,
}

/// Where in a block a line stands.
struct Moment {
    /// When the block begins, in ms.
    begin_ms: u64,
    /// The moment of the lines that follow, in ms.
    now_ms: u64,
    /// Whether a line stood before that is neither `with` nor `power up`.
    begun: bool,
}

impl<'a> Expansion<'a> {
    /// Nothing yet.
    pub fn new(
        image: &'a AdmittedImage,
        sites: &'a [Site],
        blocks: &'a Blocks<'a>,
        findings: &'a mut Vec<Finding>,
    ) -> Expansion<'a> {
        let period_us = image.image().task.as_ref().map_or(1000, |task| task.period_us);
        Expansion {
            image,
            sites,
            blocks,
            findings,
            at_terminals: false,
            driven_at: Vec::new(),
            period_ms: u64::from(period_us / 1000).max(1),
            power_up: Mode::Run,
            actions: Vec::new(),
            expectations: Vec::new(),
            end_ms: 0,
            acts_until_ms: 0,
            driven: Vec::new(),
            standing: Standing::default(),
            lines: 0,
            open: Vec::new(),
        }
    }

    /// Adds a block: its setups first, then its own lines, which begin with the scan after all that came before.
    pub fn block(&mut self, block: &'a Block) {
        let first = self.actions.is_empty() && self.expectations.is_empty();
        let mut moment = Moment { begin_ms: 0, now_ms: 0, begun: false };
        if !first {
            moment.begin_ms = self.next_begin();
            moment.now_ms = moment.begin_ms;
            self.end_ms = moment.begin_ms;
        }
        for line in &block.lines {
            if self.lines > LINES_MAX {
                return;
            }
            if let Err(finding) = self.counted(line).and_then(|()| self.line(line, &mut moment)) {
                self.findings.push(*finding);
            }
        }
    }

    /// Setups of setups multiply: what is too long is refused before it is laid out.
    fn counted(&mut self, line: &Line) -> Result<(), Box<Finding>> {
        self.lines += match &line.kind {
            LineKind::Given(settings) | LineKind::When(settings) | LineKind::Hold(settings, _) => settings.len(),
            LineKind::Then { checks, .. } | LineKind::Stays(checks, _) => checks.len(),
            LineKind::Never(never) => never.conditions.len(),
            _ => 1,
        };
        match self.lines > LINES_MAX {
            false => Ok(()),
            true => {
                let message = format!("a scenario has at most {LINES_MAX} lines, those of its setups included");
                Err(finding(&SCENARIO_BLOCK, line.span, message))
            }
        }
    }

    fn next_begin(&self) -> u64 {
        (self.end_ms / self.period_ms + 1) * self.period_ms
    }

    fn line(&mut self, line: &'a Line, moment: &mut Moment) -> Result<(), Box<Finding>> {
        match &line.kind {
            LineKind::With(name) => return self.with(name.as_str(), name.span, moment),
            LineKind::PowerUp(mode) => {
                if moment.begun || moment.begin_ms > 0 {
                    return Err(finding(
                        &SCENARIO_BLOCK,
                        line.span,
                        "power-up stands at the beginning of what runs first",
                    ));
                }
                self.power_up = *mode;
                return Ok(());
            }
            LineKind::Given(_) if moment.now_ms != moment.begin_ms => {
                return Err(Box::new(
                    Finding::new(&SCENARIO_BLOCK, line.span, "`given` stands before the first moment of its block")
                        .help("later on it is `when`"),
                ));
            }
            LineKind::At(time) => {
                let at_ms = moment.begin_ms.saturating_add(self.time(time)?);
                if at_ms < moment.now_ms {
                    let message = format!(
                        "{} ms is before the moment above, which is {} ms",
                        at_ms - moment.begin_ms,
                        moment.now_ms - moment.begin_ms
                    );
                    return Err(finding(&SCENARIO_TIME, time.span, message));
                }
                moment.now_ms = self.moment(at_ms, line.span)?;
            }
            LineKind::After(time) => {
                moment.now_ms = self.moment(moment.now_ms.saturating_add(self.time(time)?), line.span)?;
            }
            LineKind::Given(settings) | LineKind::When(settings) => self.settings(settings, moment.now_ms)?,
            LineKind::Hold(settings, time) => self.hold(settings, time, moment.now_ms)?,
            LineKind::Toggle { name, every, lasts } => self.toggle(name, every, lasts, moment.now_ms)?,
            LineKind::Mode(mode) => self.act(moment.now_ms, Change::Mode(*mode), line.span)?,
            LineKind::Then { checks, not_before, within } => {
                self.then(checks, not_before.as_ref(), within.as_ref(), moment.now_ms)?;
            }
            LineKind::Stays(checks, time) => self.stays(checks, time, moment.now_ms)?,
            LineKind::Fault { fault_type, code, within } => {
                let kind = Expected::Fault(number(fault_type)?, number(code)?);
                let text = format!("then fault {}/{}{}", fault_type.text, code.text, within_text(within.as_ref()));
                let until_ms = self.until(within.as_ref(), moment.now_ms)?;
                self.expect(text, line.span, (moment.now_ms, until_ms), kind)?;
            }
            LineKind::Never(never) => {
                self.at_terminals |= never.conditions.iter().any(|condition| condition.terminal.is_some());
                let kind = nevers(self.image, self.sites, never)?;
                self.expectations.push(Expectation {
                    text: never_text(never),
                    span: never.span,
                    from_ms: moment.begin_ms,
                    until_ms: u64::MAX,
                    kind,
                });
            }
        }
        moment.begun = true;
        self.lasts_until(moment.now_ms, line.span)
    }

    fn with(&mut self, name: &'a str, span: Span, moment: &mut Moment) -> Result<(), Box<Finding>> {
        if moment.begun {
            return Err(finding(&SCENARIO_BLOCK, span, "`with` stands at the beginning of its block"));
        }
        let Some(setup) = self.blocks.setup(name) else {
            let known: Vec<&str> = self
                .blocks
                .all()
                .filter(|block| block.kind == BlockKind::Setup)
                .map(|block| block.name.as_str())
                .collect();
            let known = if known.is_empty() {
                "the file has no setup".to_owned()
            } else {
                format!("the file has: {}", known.join(", "))
            };
            return Err(Box::new(
                Finding::new(&SCENARIO_BLOCK, span, format!("there is no setup `{name}`")).help(known),
            ));
        };
        if self.open.contains(&name) || self.open.len() >= DEPTH_MAX {
            return Err(finding(&SCENARIO_BLOCK, span, format!("the setup `{name}` begins with itself")));
        }
        self.moment(self.next_begin(), span)?;
        self.open.push(name);
        self.block(setup);
        self.open.pop();
        if !(self.actions.is_empty() && self.expectations.is_empty()) {
            moment.begin_ms = self.moment(self.next_begin(), span)?;
            moment.now_ms = moment.begin_ms;
        }
        Ok(())
    }

    fn settings(&mut self, settings: &[Setting], at_ms: u64) -> Result<(), Box<Finding>> {
        settings.iter().try_for_each(|setting| self.setting(setting, at_ms, None))
    }

    /// Does something; where it is held, what it was before comes back at that time in ms.
    fn setting(&mut self, setting: &Setting, at_ms: u64, until_ms: Option<u64>) -> Result<(), Box<Finding>> {
        let (module, stimulus, span) = match setting {
            Setting::Value { name, value } => {
                let (signal, before) = self.set(name, value, at_ms)?;
                return until_ms.map_or(Ok(()), |until_ms| self.drive(name, signal, before, until_ms));
            }
            Setting::Terminal { terminal, event, span } => {
                self.at_terminals = true;
                let (module, stimulus) = self.at_terminal(terminal, event, *span)?;
                (module, stimulus, *span)
            }
            Setting::Module { module, event, span } => {
                self.at_terminals = true;
                let (module, stimulus) = self.at_module(module, *event)?;
                (module, stimulus, *span)
            }
        };
        match until_ms {
            None => self.happen(module, stimulus, at_ms, span),
            Some(until_ms) => self.held(module, stimulus, (at_ms, until_ms), span),
        }
    }

    /// Sets an input; what it was before.
    fn set(&mut self, name: &Name, literal: &Literal, at_ms: u64) -> Result<(Signal, i32), Box<Finding>> {
        let signal = self.driven(name)?;
        let content = value::content(value::value(name.as_str(), literal, value::element(signal))?);
        let before = self.before(signal);
        // A later setting ends a hold or a toggle of the same input.
        if self.acts_until_ms > at_ms {
            let of_it = |change: &Change| matches!(change, Change::Drive { signal: other, .. } if *other == signal);
            self.actions.retain(|action| action.at_ms <= at_ms || !of_it(&action.change));
        }
        self.drive(name, signal, content, at_ms)?;
        Ok((signal, before))
    }

    fn driven(&self, name: &Name) -> Result<Signal, Box<Finding>> {
        names::driven(self.image, name.as_str()).map_err(|error| finding(&SCENARIO_NAME, name.span, error.to_string()))
    }

    fn drive(&mut self, name: &Name, signal: Signal, content: i32, at_ms: u64) -> Result<(), Box<Finding>> {
        if self.driven_at.iter().all(|(other, _)| other != name) {
            self.driven_at.push((name.clone(), signal));
        }
        match self.driven.iter_mut().find(|(other, _)| *other == signal) {
            Some((_, held)) => *held = content,
            None => self.driven.push((signal, content)),
        }
        self.act(at_ms, Change::Drive { name: name.as_str().to_owned(), signal, content }, name.span)
    }

    /// What an input was driven to last, or begins with.
    fn before(&self, signal: Signal) -> i32 {
        let driven = self.driven.iter().find(|(other, _)| *other == signal).map(|(_, content)| *content);
        driven.unwrap_or_else(|| {
            let records = self.image.image();
            let word = |cell: usize| records.initial_words.get(cell).copied().unwrap_or_default();
            match signal {
                Signal::Bit(cell) => records.initial_bits.get(cell.position()).map_or(0, |bit| i32::from(*bit)),
                Signal::Word(cell, _) => word(cell.position()),
                Signal::WordBit(cell, bit) => (word(cell.position()) >> bit.min(31)) & 1,
                _ => 0,
            }
        })
    }

    fn hold(&mut self, settings: &[Setting], time: &Time, at_ms: u64) -> Result<(), Box<Finding>> {
        let until_ms = at_ms.saturating_add(self.positive(time)?);
        settings.iter().try_for_each(|setting| self.setting(setting, at_ms, Some(until_ms)))
    }

    fn toggle(&mut self, name: &Name, every: &Time, lasts: &Time, at_ms: u64) -> Result<(), Box<Finding>> {
        let signal = self.driven(name)?;
        if !matches!(signal, Signal::Bit(_) | Signal::WordBit(..)) {
            return Err(finding(&SCENARIO_VALUE, name.span, format!("`{name}` is no BOOL, and cannot be toggled")));
        }
        let (step, length) = (self.positive(every)?, self.positive(lasts)?);
        let mut content = self.before(signal);
        let mut elapsed = 0;
        while elapsed < length {
            content ^= 1;
            self.drive(name, signal, content, at_ms.saturating_add(elapsed))?;
            elapsed = elapsed.saturating_add(step);
        }
        Ok(())
    }

    fn then(
        &mut self,
        checks: &[Condition],
        not_before: Option<&Time>,
        within: Option<&Time>,
        at_ms: u64,
    ) -> Result<(), Box<Finding>> {
        let sooner_ms = match not_before {
            Some(time) => self.moment(at_ms.saturating_add(self.time(time)?), time.span)?,
            None => at_ms,
        };
        for condition in checks {
            let check = self.check(condition)?;
            let until_ms = match (within, not_before) {
                (None, Some(time)) => {
                    return Err(Box::new(
                        Finding::new(
                            &SCENARIO_TIME,
                            time.span,
                            "`not before` needs the time by which it must be there",
                        )
                        .help("write `not before 280 ms within 300 ms`"),
                    ));
                }
                _ => self.until(within, at_ms)?,
            };
            let not_before_text = not_before.map_or(String::new(), |time| format!(" not before {}", time_text(time)));
            let text = format!("then {}{not_before_text}{}", condition_text(condition), within_text(within));
            if self.first_scan(sooner_ms) > until_ms {
                return Err(Box::new(no_scan(condition.span, sooner_ms, until_ms, self.period_ms)));
            }
            self.expect(text, condition.span, (at_ms, until_ms), Expected::Reached(check, sooner_ms))?;
        }
        Ok(())
    }

    /// Up to, and without, the end of the time: what is done at that very moment may change it.
    fn stays(&mut self, checks: &[Condition], time: &Time, at_ms: u64) -> Result<(), Box<Finding>> {
        let until_ms = at_ms.saturating_add(self.positive(time)?) - 1;
        if until_ms < self.first_scan(at_ms) {
            return Err(Box::new(no_scan(time.span, at_ms, until_ms, self.period_ms)));
        }
        for condition in checks {
            let check = self.check(condition)?;
            let text =
                format!("then {} for {}", condition_text(condition).replacen(" is ", " stays ", 1), time_text(time));
            self.expect(text, condition.span, (at_ms, until_ms), Expected::Stays(check))?;
        }
        Ok(())
    }

    fn check(&mut self, condition: &Condition) -> Result<Check, Box<Finding>> {
        self.at_terminals |= condition.terminal.is_some();
        Check::new(self.image, self.sites, condition)
    }

    /// The end of a span of time that begins at a moment: without a length it is the first scan at or after it.
    fn until(&self, within: Option<&Time>, at_ms: u64) -> Result<u64, Box<Finding>> {
        let first = self.first_scan(at_ms);
        let Some(time) = within else { return Ok(first) };
        let until_ms = at_ms.saturating_add(self.time(time)?);
        if until_ms < first {
            return Err(Box::new(no_scan(time.span, at_ms, until_ms, self.period_ms)));
        }
        Ok(until_ms)
    }

    /// Time of the first scan at a moment or after it.
    fn first_scan(&self, at_ms: u64) -> u64 {
        at_ms.div_ceil(self.period_ms).saturating_mul(self.period_ms)
    }

    fn expect(
        &mut self,
        text: String,
        span: Span,
        (from_ms, until_ms): (u64, u64),
        kind: Expected,
    ) -> Result<(), Box<Finding>> {
        self.moment(until_ms, span)?;
        self.expectations.push(Expectation { text, span, from_ms, until_ms, kind });
        self.end_ms = self.end_ms.max(until_ms);
        Ok(())
    }

    fn act(&mut self, at_ms: u64, change: Change, span: Span) -> Result<(), Box<Finding>> {
        if self.actions.len() >= ACTIONS_MAX {
            let message = format!("a scenario has at most {ACTIONS_MAX} changes of inputs");
            return Err(finding(&SCENARIO_TIME, span, message));
        }
        self.actions.push(Action { at_ms, change });
        self.acts_until_ms = self.acts_until_ms.max(self.scan_of(at_ms, span)?);
        Ok(())
    }

    fn lasts_until(&mut self, at_ms: u64, span: Span) -> Result<(), Box<Finding>> {
        self.end_ms = self.end_ms.max(self.scan_of(at_ms, span)?);
        Ok(())
    }

    /// A moment that a scenario can have.
    fn moment(&self, at_ms: u64, span: Span) -> Result<u64, Box<Finding>> {
        self.scan_of(at_ms, span).map(|_| at_ms)
    }

    /// Time of the scan that sees what is done at a moment: what is done between two scans is seen by the next one.
    fn scan_of(&self, at_ms: u64, span: Span) -> Result<u64, Box<Finding>> {
        let last = SCANS_MAX.saturating_mul(self.period_ms);
        if at_ms > last {
            let message = format!("a scenario lasts at most {SCANS_MAX} scans, here {last} ms");
            return Err(finding(&SCENARIO_TIME, span, message));
        }
        Ok(self.first_scan(at_ms))
    }

    fn positive(&self, time: &Time) -> Result<u64, Box<Finding>> {
        match self.time(time)? {
            0 => Err(finding(&SCENARIO_TIME, time.span, "this time must be longer than 0")),
            other => Ok(other),
        }
    }

    /// A time in ms.
    fn time(&self, time: &Time) -> Result<u64, Box<Finding>> {
        words::milliseconds(time, self.period_ms).ok_or_else(|| {
            let message = format!("`{}` is no time in whole milliseconds", time_text(time));
            Box::new(Finding::new(&SCENARIO_TIME, time.span, message).help("write 200 ms, 1.5 s, 2 min or 3 scans"))
        })
    }
}

fn finding(code: &'static twinrung_compiler::Code, span: Span, message: impl Into<String>) -> Box<Finding> {
    Box::new(Finding::new(code, span, message))
}

fn number(literal: &Literal) -> Result<u16, Box<Finding>> {
    let wrong = || finding(&SCENARIO_VALUE, literal.span, format!("`{}` is no fault type or code", literal.text));
    match value::value("the fault", literal, twinrung_catalog::Element::Dint)? {
        Value::Integer(value) => u16::try_from(value).map_err(|_| wrong()),
        _ => Err(wrong()),
    }
}
