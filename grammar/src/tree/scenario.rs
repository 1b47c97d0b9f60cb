//! What a scenario file says: how a project is tested, as an engineer wrote it.

use super::{Name, SourceId, Span, Text};

/// A scenario file.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct ScenarioFile {
    /// The file.
    pub source: SourceId,
    /// What stands in it, in order.
    pub items: Vec<ScenarioItem>,
}

/// What stands at the top of a scenario file.
#[derive(Clone, PartialEq, Debug)]
pub enum ScenarioItem {
    /// `project "FILE"`: what is tested; a path from the scenario file on.
    Project(Text),
    /// `minimum coverage 100 %`
    Minimum(Literal),
    /// `never CONDITION and CONDITION`: in every scan of every scenario.
    Never(Never),
    /// `exclude "ITEM" because "REASON"`: what need not be covered.
    Exclude {
        /// The item as the report names it.
        item: Text,
        /// Why.
        reason: Text,
    },
    /// A scenario, or what several scenarios begin with.
    Block(Block),
}

/// What a block is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BlockKind {
    /// Runs by itself.
    Scenario,
    /// Runs where a scenario begins `with` it.
    Setup,
}

/// `scenario "NAME" ... end` or `setup "NAME" ... end`.
#[derive(Clone, PartialEq, Debug)]
pub struct Block {
    /// Which of the two.
    pub kind: BlockKind,
    /// Its name.
    pub name: Text,
    /// Its lines in order.
    pub lines: Vec<Line>,
}

/// One statement of a block.
#[derive(Clone, PartialEq, Debug)]
pub struct Line {
    /// What it says.
    pub kind: LineKind,
    /// All of it.
    pub span: Span,
}

/// What a statement says.
#[derive(Clone, PartialEq, Debug)]
pub enum LineKind {
    /// `with "SETUP"`
    With(Text),
    /// `power up in run`, `power up in program`
    PowerUp(Mode),
    /// `given NAME is VALUE, ...`: before the first scan of the block.
    Given(Vec<Setting>),
    /// `at TIME`: counted from the beginning of the block.
    At(Time),
    /// `after TIME`: counted from the moment before.
    After(Time),
    /// `when NAME is VALUE, ...`
    When(Vec<Setting>),
    /// `hold NAME is VALUE, ... for TIME`: then what it was before.
    Hold(Vec<Setting>, Time),
    /// `toggle NAME every TIME for TIME`
    Toggle {
        /// What changes.
        name: Name,
        /// From one change to the next.
        every: Time,
        /// From the first change to the end.
        lasts: Time,
    },
    /// `mode run`, `mode program`: the mode switch is turned.
    Mode(Mode),
    /// `then NAME is VALUE, ... not before TIME within TIME`
    Then {
        /// Each of these by itself.
        checks: Vec<Condition>,
        /// Not sooner than this.
        not_before: Option<Time>,
        /// Not later than this; in the very scan where it is not given.
        within: Option<Time>,
    },
    /// `then NAME stays VALUE, ... for TIME`
    Stays(Vec<Condition>, Time),
    /// `then fault TYPE/CODE within TIME`: the controller stops, as it should.
    Fault {
        /// The fault type.
        fault_type: Literal,
        /// The fault code.
        code: Literal,
        /// Not later than this.
        within: Option<Time>,
    },
    /// `never CONDITION and CONDITION`: from the beginning of the block on.
    Never(Never),
}

/// `never CONDITION and CONDITION`: these are not true together at the end of any scan.
#[derive(Clone, PartialEq, Debug)]
pub struct Never {
    /// The conditions.
    pub conditions: Vec<Condition>,
    /// All of it.
    pub span: Span,
}

/// Where the mode switch stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    /// Logic executes.
    Run,
    /// Logic does not execute.
    Program,
}

/// Something that is done.
#[derive(Clone, PartialEq, Debug)]
pub enum Setting {
    /// `NAME is VALUE`: drive this.
    Value {
        /// What is driven.
        name: Name,
        /// With what.
        value: Literal,
    },
    /// `MODULE terminal 0 is on`, `MODULE terminal 0 shorted to 24 V`: something happens at a terminal.
    Terminal {
        /// Where.
        terminal: Terminal,
        /// What.
        event: TerminalEvent,
        /// All of it.
        span: Span,
    },
    /// `MODULE power lost`: something happens to a module as a whole.
    Module {
        /// To which.
        module: Name,
        /// What.
        event: ModuleEvent,
        /// All of it.
        span: Span,
    },
}

/// `MODULE terminal 0`, `MODULE terminal T1`: a terminal of a module of the I/O tree.
#[derive(Clone, PartialEq, Debug)]
pub struct Terminal {
    /// The module's name.
    pub module: Name,
    /// A point's number, or letter and number, as written.
    pub text: String,
    /// All of it.
    pub span: Span,
}

/// What happens at a terminal.
#[derive(Clone, PartialEq, Debug)]
pub enum TerminalEvent {
    /// `is VALUE`: the device at it is on, off, or gives so much.
    Is(Literal),
    /// `shorted to 24 V`, `shorted to 0 V`: the number, and what it counts.
    ShortedToVolts(Literal, Name),
    /// `shorted to terminal 1`: of the same module.
    ShortedToTerminal(Literal),
    /// `open`: the wire is broken, or the lamp burnt out.
    Open,
    /// `repaired`: every fault of the wire is gone.
    Repaired,
    /// `fails`: the module's own circuit at it.
    Fails,
    /// `follows MODULE terminal 0 in TIME and not ...`: contacts in series move with outputs.
    Follows(Vec<Follow>),
}

/// `MODULE terminal 0 in TIME`, `not MODULE terminal 0`: what a contact follows.
#[derive(Clone, PartialEq, Debug)]
pub struct Follow {
    /// Whether the contact is closed while the output is off.
    pub inverted: bool,
    /// The output.
    pub output: Terminal,
    /// How long the contact takes to move.
    pub delay: Option<Time>,
}

/// What happens to a module.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ModuleEvent {
    /// `power lost`, `power restored`: its field power.
    Power(bool),
    /// `lost`, `restored`: the module itself.
    Present(bool),
    /// `idle`, `running`
    Running(bool),
}

/// `NAME is VALUE`, `NAME < VALUE`: look at this.
#[derive(Clone, PartialEq, Debug)]
pub struct Condition {
    /// What is looked at; of a terminal its words.
    pub name: Name,
    /// The terminal that is looked at, where it is one.
    pub terminal: Option<Terminal>,
    /// How it is compared.
    pub relation: Relation,
    /// With what.
    pub value: Literal,
    /// `+- VALUE`
    pub tolerance: Option<Literal>,
    /// All of it.
    pub span: Span,
}

/// How a value is compared.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Relation {
    /// `is`, `stays`
    Is,
    /// `is not`
    IsNot,
    /// `<`
    Below,
    /// `<=`
    AtMost,
    /// `>`
    Above,
    /// `>=`
    AtLeast,
}

/// A value as written: `on`, `off`, `-5`, `16#5007`, `1.5`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Literal {
    /// As written.
    pub text: String,
    /// Where.
    pub span: Span,
}

/// A time as written: `200 ms`, `1.5 s`, `2 scans`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Time {
    /// The number as written.
    pub number: String,
    /// What it counts.
    pub unit: TimeUnit,
    /// Number and unit.
    pub span: Span,
}

/// What a time counts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TimeUnit {
    /// `ms`
    Milliseconds,
    /// `s`
    Seconds,
    /// `min`
    Minutes,
    /// `scan`, `scans`: periods of the safety task.
    Scans,
}
