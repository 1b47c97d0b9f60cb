//! The table of protection against `protection.table`, which was written from the manual: every cell that can occur, and
//! that those which cannot are marked so.

use std::collections::BTreeSet;

use twinrung_controller::Mode;
use twinrung_controller::protection::{
    Action, Edits, Forces, Keyswitch, Offer, OfferedSignature, Place, RULES, SafetyTaskStatus, State, Verb, impossible,
    judge, refusals,
};

const TABLE: &str = include_str!("protection.table");

/// A line of the table.
struct Line {
    action: Option<&'static str>,
    verdict: &'static str,
    conditions: &'static str,
    number: usize,
}

fn lines() -> Vec<Line> {
    let mut action = None;
    let mut found = Vec::new();
    for (number, text) in TABLE.lines().enumerate() {
        if let Some(name) = text.strip_prefix("action ") {
            action = Some(name);
        } else if let Some((verdict, rest)) = text.split_once('|').filter(|_| !text.starts_with('#')) {
            let (conditions, source) = rest.rsplit_once('|').unwrap();
            assert!(!source.trim().is_empty(), "line {}: no source", number + 1);
            found.push(Line { action, verdict: verdict.trim(), conditions: conditions.trim(), number: number + 1 });
        }
    }
    found
}

fn offer(action: Action) -> Option<Offer> {
    match action {
        Action::Download(offer) | Action::LoadFromCard(offer) => Some(offer),
        _ => None,
    }
}

fn sealed(action: Action) -> bool {
    matches!(
        action,
        Action::EditAddOn { sealed: true }
            | Action::SealAddOn { sealed: true }
            | Action::UnsealAddOn { sealed: true }
            | Action::AddHistoryEntry { sealed: true, .. }
    )
}

/// Whether a word of the table holds; of the action nothing holds where only a state is meant.
fn holds(word: &str, state: State, action: Option<Action>) -> bool {
    let offered = |test: fn(Offer) -> bool| action.and_then(offer).is_some_and(test);
    if let Some(word) = word.strip_prefix('!') {
        return !holds(word, state, action);
    }
    match word {
        "online" => state.place == Place::Online,
        "offline" => state.place == Place::Offline,
        "run" => state.mode == Mode::Run,
        "program" => state.mode == Mode::Program,
        "key-run" => state.keyswitch == Keyswitch::Run,
        "key-remote" => state.keyswitch == Keyswitch::Remote,
        "key-program" => state.keyswitch == Keyswitch::Program,
        "locked" => state.locked,
        "unlocked" => !state.locked,
        "signed" => state.signed,
        "unsigned" => !state.signed,
        "forces" => state.forces != Forces::None,
        "enabled" => state.forces == Forces::Enabled,
        "disabled" => state.forces == Forces::Disabled,
        "edits" => state.edits != Edits::None,
        "pending" => state.edits == Edits::Pending,
        "accepted" => state.edits == Edits::Accepted,
        "tested" => state.edits == Edits::Tested,
        "empty" => state.status == SafetyTaskStatus::NoProject,
        "ok" => state.status == SafetyTaskStatus::Ok,
        "recoverable" => state.status == SafetyTaskStatus::RecoverableFault,
        "safety-fault" => state.status == SafetyTaskStatus::NonrecoverableSafetyFault,
        "controller-fault" => state.status == SafetyTaskStatus::NonrecoverableControllerFault,
        "application" => {
            !holds("empty", state, action) && state.status != SafetyTaskStatus::NonrecoverableControllerFault
        }
        "card" => state.takes_card,
        "same" => offered(|offer| offer.signature == OfferedSignature::Same),
        "other" => offered(|offer| offer.signature == OfferedSignature::Other),
        "without" => offered(|offer| offer.signature == OfferedSignature::Without),
        "same-type" => offered(|offer| offer.same_type),
        "same-revision" => offered(|offer| offer.same_revision),
        "same-series" => offered(|offer| offer.same_series),
        "sealed" => action.is_some_and(sealed),
        "full" => matches!(action, Some(Action::AddHistoryEntry { full: true, .. })),
        other => panic!("`{other}` is no word of the table"),
    }
}

fn matches(line: &Line, state: State, action: Option<Action>) -> bool {
    line.conditions.split_whitespace().all(|word| word.split('/').any(|one| holds(one, state, action)))
}

fn verdicts(of: &[&Line], state: State, action: Action) -> BTreeSet<&'static str> {
    of.iter().filter(|line| matches(line, state, Some(action))).map(|line| line.verdict).collect()
}

fn found(state: State, action: Action) -> &'static str {
    let refused = || judge(state, action).map_or("refused", |()| "permitted");
    impossible(state, action).map_or_else(refused, |_| "cannot")
}

/// REQ-MODE-001. Every action in every state: what the manual says is what the table says, and the manual is not silent.
#[test]
fn cells_when_compared_with_the_manual_then_each_is_as_it_says_and_none_is_left_out() {
    let lines = lines();
    let everywhere: Vec<&Line> = lines.iter().filter(|line| line.action.is_none()).collect();
    let mut wrong = Vec::new();
    let mut total = [0_usize; 3];
    println!("{:42} {:>9} {:>9} {:>9}", "action", "permitted", "refused", "cannot");
    for verb in Verb::ALL {
        let own: Vec<&Line> = lines.iter().filter(|line| line.action == Some(verb.name())).collect();
        assert!(!own.is_empty(), "the manual's table says nothing of `{}`", verb.name());
        let mut counts = [0_usize; 3];
        for action in Action::all().filter(|action| action.verb() == verb) {
            for state in State::all() {
                let mut said = verdicts(&everywhere, state, action);
                said.extend(verdicts(&own, state, action).into_iter().filter(|verdict| *verdict == "cannot"));
                let said = Some(said).filter(|said| !said.is_empty()).unwrap_or_else(|| verdicts(&own, state, action));
                let found = found(state, action);
                counts[["permitted", "refused", "cannot"].iter().position(|name| *name == found).unwrap()] += 1;
                if said != BTreeSet::from([found]) && wrong.len() < 20 {
                    wrong.push(format!("{action:?} in {state:?}: the manual {said:?}, the table {found}"));
                }
            }
        }
        println!("{:42} {:>9} {:>9} {:>9}", verb.name(), counts[0], counts[1], counts[2]);
        total.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
    }
    println!("{:42} {:>9} {:>9} {:>9}", "all", total[0], total[1], total[2]);
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// REQ-MODE-001. A line that no cell needs would be a word about nothing.
#[test]
fn lines_of_the_manual_when_searched_for_then_each_speaks_of_a_cell() {
    let lines = lines();
    let idle: Vec<usize> = lines
        .iter()
        .filter(|line| {
            !Action::all().filter(|action| line.action.is_none_or(|name| name == action.verb().name())).any(|action| {
                State::all().any(|state| {
                    matches(line, state, Some(action))
                        && (line.verdict == "cannot" || impossible(state, action).is_none())
                })
            })
        })
        .map(|line| line.number)
        .collect();
    assert_eq!(idle, Vec::<usize>::new());
    let unknown: Vec<&str> = lines
        .iter()
        .filter_map(|line| line.action)
        .filter(|name| Verb::ALL.iter().all(|verb| verb.name() != *name))
        .collect();
    assert_eq!(unknown, Vec::<&str>::new());
}

/// REQ-MODE-002. A refusal that nobody can get, or whose text is missing, helps nobody.
#[test]
fn rules_when_each_is_looked_for_then_it_refuses_a_cell_for_each_of_its_actions_and_says_the_way_out() {
    let reachable: Vec<State> = State::all().filter(|state| state.impossible().is_none()).collect();
    let mut idle = Vec::new();
    for rule in RULES {
        assert!(!rule.reason.is_empty() && !rule.way_out.is_empty() && !rule.source.is_empty(), "{}", rule.code);
        for verb in rule.actions {
            let refuses = Action::all().filter(|action| action.verb() == *verb).any(|action| {
                reachable.iter().any(|state| {
                    impossible(*state, action).is_none() && refusals(*state, action).any(|one| one == rule)
                })
            });
            idle.extend((!refuses).then(|| format!("{} of {}", rule.code, verb.name())));
        }
    }
    let codes: BTreeSet<&str> = RULES.iter().map(|rule| rule.code).collect();
    assert_eq!(codes.len(), RULES.len(), "two rows have one code");
    assert_eq!(idle, Vec::<String>::new());
}

/// REQ-MODE-003. Table 8, row by row: new forces, online edits, writing safety memory, deleting the signature.
#[test]
fn table_8_when_read_row_by_row_then_forces_edits_memory_and_signature_are_as_it_says() {
    let asked = [Action::InstallForce, Action::BeginEdit, Action::WriteSafetyData, Action::DeleteSignature];
    let rows = [
        (State::online(Mode::Run, false, false), [true, true, true, false]),
        (State::online(Mode::Run, true, false), [false, false, false, false]),
        (State::online(Mode::Run, false, true), [false, false, false, true]),
        (State::online(Mode::Run, true, true), [false, false, false, false]),
    ];
    for (state, expected) in rows {
        assert_eq!(asked.map(|action| judge(state, action).is_ok()), expected, "{state:?}");
    }
}

/// REQ-MODE-002. Words by which somebody tells one from another.
#[test]
fn names_when_listed_then_each_action_and_each_condition_has_its_own() {
    let actions: BTreeSet<&str> = Verb::ALL.iter().map(|verb| verb.name()).collect();
    assert_eq!(actions.len(), Verb::ALL.len());
    let conditions: Vec<_> = RULES.iter().flat_map(|rule| rule.when).collect();
    let mut named: Vec<(&str, String)> = conditions.iter().map(|one| (one.words(), format!("{one:?}"))).collect();
    named.sort();
    named.dedup();
    let words: BTreeSet<&str> = named.iter().map(|(words, _)| *words).collect();
    assert_eq!(words.len(), named.len(), "{named:?}");
    assert!(words.iter().all(|words| words.len() > 3), "{words:?}");
}

/// REQ-MODE-003. The last column of Table 8.
#[test]
fn integrity_when_read_row_by_row_then_it_is_what_table_8_says() {
    let of = |mode, locked, signed| State::online(mode, locked, signed).integrity();
    let flags = [(false, false), (true, false), (false, true), (true, true)];
    let in_run = flags.map(|(locked, signed)| of(Mode::Run, locked, signed));
    let signed = "PLe/Cat. 4, control reliable, SIL 3";
    assert_eq!(in_run, ["development only", "PLd/Cat. 3, control reliable, SIL 2", signed, signed]);
    assert!(flags.iter().all(|(locked, signed)| of(Mode::Program, *locked, *signed).starts_with("nothing")));
}
