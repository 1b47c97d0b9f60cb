//! Random runs of one instruction, and what they leave behind.

use crate::vocabulary;
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::TestRunner;
use twinrung_catalog::operand::OperandKind;
use twinrung_catalog::{Element, MemberRole, Opcode, SafetyApplication};
use twinrung_safety_primary::State;

/// How many scans an event lasts at most.
const LONGEST_EVENT: u8 = 14;
/// Times and counts from which configuration literals are drawn, where their range holds them.
const LITERALS: &[i32] = &[0, 1, 2, 5, 20, 50, 100, 200];

/// At least as many as any instruction has operands.
const MOST_OPERANDS: usize = 20;

/// Members that are fixed in a run.
pub type Fixed = &'static [(&'static str, i32)];

/// One event: what changes, the rung condition, and for how many scans everything then stays.
#[derive(Clone, Debug)]
struct Event {
    which: Index,
    rung: bool,
    scans: u8,
}

/// A run to be played.
#[derive(Clone, Debug)]
pub struct Play {
    opcode: Opcode,
    fixed: Fixed,
    period_ms: i64,
    first_ms: i64,
    configuration: Vec<Index>,
    events: Vec<Event>,
}

/// Random runs of an instruction, with the given members fixed at the start.
pub fn plays(opcode: Opcode, fixed: Fixed) -> impl Strategy<Value = Play> {
    let event = (any::<Index>(), prop::bool::weighted(0.97), 1..=LONGEST_EVENT)
        .prop_map(|(which, rung, scans)| Event { which, rung, scans });
    (
        prop::sample::select(vec![1i64, 10, 10, 10, 25, 100]),
        -1_000_000i64..1_000_000,
        prop::collection::vec(any::<Index>(), MOST_OPERANDS),
        prop::collection::vec(event, 1..120),
    )
        .prop_map(move |(period_ms, first_ms, configuration, events)| Play {
            opcode,
            fixed,
            period_ms,
            first_ms,
            configuration,
            events,
        })
}

impl Play {
    /// The same run, later.
    pub fn shifted(&self, by_ms: i64) -> Play {
        Play { first_ms: self.first_ms + by_ms, ..self.clone() }
    }

    /// Plays the run: a row for the prescan, then one for each scan.
    pub fn run(&self) -> Vec<Row> {
        let mut stage = Stage::set(self);
        let mut rows = vec![stage.row(self.first_ms, false)];
        let mut now_ms = self.first_ms;
        for event in &self.events {
            for _ in 0..event.scans {
                stage.happen(event.which);
                rows.push(stage.execute(now_ms, event.rung));
                now_ms += self.period_ms;
            }
        }
        rows
    }

    /// As [`Play::run`], but only the first event happens, and the rung is always true.
    pub fn run_with_constant_inputs(&self) -> Vec<Row> {
        let mut stage = Stage::set(self);
        stage.happen(self.events[0].which);
        let scans = self.events.iter().map(|event| i64::from(event.scans)).sum::<i64>();
        (0..scans).map(|scan| stage.execute(self.first_ms + scan * self.period_ms, true)).collect()
    }

    /// The first scan in which a property does not hold, with the scan before it.
    pub fn first_violation(&self, holds: impl Fn(&Scans) -> bool) -> Option<(Row, Row)> {
        let rows = self.run();
        let mut pairs = rows.iter().zip(rows.iter().skip(1));
        pairs.find(|(before, now)| !holds(&Scans { before, now })).map(|(before, now)| (before.clone(), now.clone()))
    }
}

/// A value for an operand, counted from 0 after the backing tag.
type Setting = (usize, i32);

/// An instruction with its operands, played event by event.
struct Stage {
    application: &'static SafetyApplication,
    /// The events of the vocabulary that concern this instruction.
    events: Vec<Vec<Setting>>,
    /// Operands that follow an output member of the previous scan.
    wires: Vec<(usize, usize)>,
    /// For each operand the member that mirrors it.
    mirrored: Vec<usize>,
    state: State,
    operands: Vec<i32>,
    members: Vec<i32>,
}

impl Stage {
    /// Sets the operands of the first scan and executes the prescan.
    fn set(play: &Play) -> Stage {
        let instruction = play.opcode.instruction();
        let application = instruction.safety.unwrap();
        let vocabulary = vocabulary::of(instruction.mnemonic);
        let member = |name: &str| application.backing.member(name).unwrap().0;
        let operands = instruction.operands[1..].iter().zip(&play.configuration);
        let mut stage = Stage {
            application,
            events: vocabulary
                .events
                .iter()
                .map(|event| settings(application, event))
                .filter(|event| !event.is_empty())
                .collect(),
            wires: vocabulary
                .wires
                .iter()
                .filter_map(|(output, input)| Some((place(application, input)?, member(output))))
                .collect(),
            mirrored: application.mirrored.iter().map(|name| member(name)).collect(),
            state: State::new(play.opcode).unwrap(),
            operands: operands.map(|(operand, index)| configuration(operand.kind, *index)).collect(),
            members: vec![0; application.backing.members.len()],
        };
        assert_eq!(stage.operands.len(), stage.mirrored.len());
        let fixed = play.fixed.iter().map(|(name, value)| (place(application, name).unwrap(), *value));
        let start = settings(application, vocabulary.start).into_iter().chain(fixed).collect::<Vec<Setting>>();
        stage.assign(&start);
        stage.mirror();
        stage.state.prescan(&stage.operands, &mut stage.members);
        stage
    }

    fn happen(&mut self, which: Index) {
        for (operand, output) in &self.wires {
            self.operands[*operand] = self.members[*output];
        }
        let event = which.get(&self.events).clone();
        self.assign(&event);
    }

    fn execute(&mut self, now_ms: i64, rung: bool) -> Row {
        self.mirror();
        let before = self.row(now_ms, rung);
        self.state.scan(rung, now_ms, &self.operands, &mut self.members);
        let row = self.row(now_ms, rung);
        assert_eq!(before.others(), row.others(), "only output members are written");
        row
    }

    fn row(&self, now_ms: i64, rung: bool) -> Row {
        Row { now_ms, rung, application: self.application, members: self.members.clone(), state: self.state.clone() }
    }

    fn assign(&mut self, event: &[Setting]) {
        for (operand, value) in event {
            self.operands[*operand] = *value;
        }
    }

    fn mirror(&mut self) {
        for (member, value) in self.mirrored.iter().zip(&self.operands) {
            self.members[*member] = *value;
        }
    }
}

/// Reads `name=value ...`; names that the instruction does not have are left out.
fn settings(application: &SafetyApplication, text: &str) -> Vec<Setting> {
    let setting = |text: &str| {
        let (name, value) = text.split_once('=')?;
        let operand = place(application, name)?;
        let (_, member) = application.backing.member(name)?;
        let real = || value.parse::<f32>().unwrap().to_bits().cast_signed();
        Some((operand, if member.element == Element::Real { real() } else { value.parse().unwrap() }))
    };
    text.split(' ').filter_map(setting).collect()
}

fn place(application: &SafetyApplication, name: &str) -> Option<usize> {
    application.mirrored.iter().position(|mirrored| *mirrored == name)
}

/// A value of a configuration operand; every other operand begins with 0.
fn configuration(kind: OperandKind, index: Index) -> i32 {
    match kind {
        OperandKind::Choice(list) => index.get(list.words).1,
        OperandKind::Literal { or_zero, least, greatest, .. } => {
            let admitted = |value: &&i32| (or_zero && **value == 0) || (least..=greatest).contains(*value);
            **index.get(&LITERALS.iter().filter(admitted).collect::<Vec<&i32>>())
        }
        _ => 0,
    }
}

/// One executed scan: the members and the private memory after it.
#[derive(Clone, PartialEq)]
pub struct Row {
    /// The scan's time.
    pub now_ms: i64,
    /// The rung condition.
    pub rung: bool,
    /// The private memory.
    pub state: State,
    application: &'static SafetyApplication,
    members: Vec<i32>,
}

impl core::fmt::Debug for Row {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(formatter, "{} ms, rung {}:", self.now_ms, self.rung)?;
        let mut declared = self.application.backing.members.iter().zip(&self.members);
        declared.try_for_each(|(member, value)| write!(formatter, " {}={value:#x}", member.name))
    }
}

impl Row {
    /// A member's value.
    pub fn get(&self, member: &str) -> i32 {
        let (position, _) = self.application.backing.member(member).unwrap();
        self.members[position]
    }

    /// Whether a BOOL member is 1.
    pub fn on(&self, member: &str) -> bool {
        self.get(member) != 0
    }

    /// Whether the instruction has such a member and it is 1.
    pub fn shows(&self, member: &str) -> bool {
        self.application.backing.member(member).is_some_and(|(position, _)| self.members[position] != 0)
    }

    /// A member's value, 0 where the instruction has no such member.
    pub fn value(&self, member: &str) -> i32 {
        self.application.backing.member(member).map_or(0, |(position, _)| self.members[position])
    }

    /// A REAL member's value.
    pub fn real(&self, member: &str) -> f64 {
        f64::from(f32::from_bits(self.get(member).cast_unsigned()))
    }

    /// The output members, `EnableOut` and the constant `Revision` apart.
    pub fn outputs(&self) -> Vec<i32> {
        self.members_where(|role, name| role == MemberRole::Output && !matches!(name, "EnableOut" | "Revision"))
    }

    /// The members that the instruction must leave alone.
    pub fn others(&self) -> Vec<i32> {
        self.members_where(|role, name| role != MemberRole::Output || name == "EnableOut")
    }

    fn members_where(&self, wanted: impl Fn(MemberRole, &str) -> bool) -> Vec<i32> {
        let declared = self.application.backing.members.iter().zip(&self.members);
        declared.filter(|(member, _)| wanted(member.role, member.name)).map(|(_, value)| *value).collect()
    }
}

/// Two scans in a row; before the first scan stands the prescan, with a false rung.
pub struct Scans<'run> {
    /// The earlier one.
    pub before: &'run Row,
    /// The later one.
    pub now: &'run Row,
}

impl Scans<'_> {
    /// Whether an input has an edge: it was 0 in the previous scan, whose rung was true.
    pub fn edge(&self, input: &str) -> bool {
        self.now.rung && self.before.rung && !self.before.on(input) && self.now.on(input)
    }

    /// Whether a member went from 0 to 1.
    pub fn rises(&self, member: &str) -> bool {
        !self.before.on(member) && self.now.on(member)
    }

    /// Whether a member went from 1 to 0.
    pub fn falls(&self, member: &str) -> bool {
        self.before.on(member) && !self.now.on(member)
    }
}

/// Whether a condition implies another.
pub fn implies(condition: bool, conclusion: bool) -> bool {
    !condition || conclusion
}

/// Plays random runs of one instruction and demands that `holds` is true in every scan. One function for all tests, so
/// that the machinery is compiled once; `PROPTEST_CASES` says how many runs.
pub fn demand(opcode: Opcode, fixed: Fixed, holds: &dyn Fn(&Scans) -> bool) {
    let outcome = TestRunner::default().run(&plays(opcode, fixed), |play| {
        let violation = play.first_violation(holds);
        prop_assert!(violation.is_none(), "{violation:#?}");
        Ok(())
    });
    outcome.unwrap();
}

/// Declares tests that [`demand`] something of every scan of one instruction.
macro_rules! always {
    ($($(#[$doc:meta])* $name:ident, $opcode:ident $fixed:tt: |$scans:ident| $holds:expr;)*) => {
        $(
            $(#[$doc])*
            #[test]
            fn $name() {
                $crate::play::demand(twinrung_catalog::Opcode::$opcode, &$fixed, &|$scans| $holds);
            }
        )*
    };
}

pub(crate) use always;
