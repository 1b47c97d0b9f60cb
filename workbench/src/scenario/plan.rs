//! From a scenario file to scenarios that can be played: blocks put in front of each other, names, values and times looked up.

use std::sync::Arc;

use twinrung_bytecode::AdmittedImage;
use twinrung_compiler::diagnostic::{Finding, SCENARIO_BLOCK, SCENARIO_TERMINAL, SCENARIO_TIME, SCENARIO_VALUE};
use twinrung_grammar::tree::scenario::{Block, BlockKind, Literal, Never, ScenarioFile, ScenarioItem};
use twinrung_grammar::tree::{Span, Text};

use super::blocks::{Blocks, Expansion};
use super::value::Check;
use super::words::never_text;
use super::{Expectation, Expected, Scenario};
use crate::site::{Site, sites};

/// Looks at terminals of a scenario: one in each ms of each module, a thousand where a module counts pulses. Ten modules for a day.
const LOOKS_MAX: u64 = 10 * 24 * 3_600_000;

/// What a scenario file asks for.
#[derive(Debug, Default)]
pub struct Plan {
    /// The scenarios in order.
    pub scenarios: Vec<Scenario>,
    /// Coverage in percent that is the least accepted.
    pub minimum: Option<u8>,
    /// What need not be covered.
    pub exclusions: Vec<Exclusion>,
}

/// What need not be covered, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exclusion {
    /// The item as the report names it.
    pub item: String,
    /// Why.
    pub reason: String,
    /// Where the item is named.
    pub span: Span,
}

/// Looks a scenario file up in the image that it tests. What is wrong is among the findings, and left out of the plan.
pub fn plan(image: &AdmittedImage, file: &ScenarioFile) -> (Plan, Vec<Finding>) {
    let mut findings = Vec::new();
    let mut plan = Plan::default();
    let blocks = Blocks::new(file, &mut findings);
    let sites: Arc<[Site]> = sites(image).into();
    let mut everywhere: Vec<Everywhere<'_>> = Vec::new();
    for item in &file.items {
        match item {
            ScenarioItem::Minimum(literal) => minimum(&mut plan, literal, &mut findings),
            ScenarioItem::Never(never) => match nevers(image, &sites, never) {
                Ok(kind) => everywhere.push(Everywhere { never, kind: Some(kind) }),
                Err(finding) => {
                    everywhere.push(Everywhere { never, kind: None });
                    findings.push(*finding);
                }
            },
            ScenarioItem::Exclude { item, reason } => exclude(&mut plan, item, reason, &mut findings),
            ScenarioItem::Project(_) | ScenarioItem::Block(_) => {}
        }
    }
    let mut at_terminals = false;
    for block in blocks.all().filter(|block| block.kind == BlockKind::Scenario) {
        let (acts_there, scenario) = scenario((image, &sites), &blocks, block, &everywhere, &mut findings);
        at_terminals |= acts_there;
        plan.scenarios.extend(scenario);
    }
    for one in everywhere.iter().filter(|one| !at_terminals && one.kind.is_some() && one.is_at_terminals()) {
        let message = "no scenario of the file is played at terminals, so that this is never looked at";
        let help = "act at a terminal in a scenario of the file, or look at the tag";
        findings.push(Finding::new(&SCENARIO_TERMINAL, one.never.span, message).help(help));
    }
    findings.sort_by_key(|finding| (finding.span.start, finding.span.end));
    findings.dedup();
    (plan, findings)
}

/// A `never` at the top of a file, with names and values looked up; nothing where they are wrong.
struct Everywhere<'a> {
    never: &'a Never,
    kind: Option<Expected>,
}

impl Everywhere<'_> {
    /// Whether it looks at a terminal, which only a scenario that is played at terminals has.
    fn is_at_terminals(&self) -> bool {
        self.never.conditions.iter().any(|condition| condition.terminal.is_some())
    }
}

fn minimum(plan: &mut Plan, literal: &Literal, findings: &mut Vec<Finding>) {
    match literal.text.parse().ok().filter(|percent: &u8| *percent <= 100) {
        Some(_) if plan.minimum.is_some() => {
            findings.push(Finding::new(&SCENARIO_BLOCK, literal.span, "the minimum of the coverage is given twice"));
        }
        Some(percent) => plan.minimum = Some(percent),
        None => findings.push(
            Finding::new(&SCENARIO_VALUE, literal.span, format!("`{}` is no percentage", literal.text))
                .help("write a whole number from 0 to 100"),
        ),
    }
}

fn exclude(plan: &mut Plan, item: &Text, reason: &Text, findings: &mut Vec<Finding>) {
    if reason.as_str().trim().is_empty() {
        let message = "an exclusion needs a reason that a reviewer can judge";
        findings.push(Finding::new(&twinrung_compiler::diagnostic::SCENARIO_EXCLUSION, reason.span, message));
    }
    let exclusion = Exclusion { item: item.as_str().to_owned(), reason: reason.as_str().to_owned(), span: item.span };
    plan.exclusions.push(exclusion);
}

/// Whether a scenario is played at terminals, and the scenario, where nothing is wrong with it.
fn scenario(
    (image, sites): (&AdmittedImage, &Arc<[Site]>),
    blocks: &Blocks<'_>,
    block: &Block,
    everywhere: &[Everywhere<'_>],
    findings: &mut Vec<Finding>,
) -> (bool, Option<Scenario>) {
    let before = findings.len();
    let mut expansion = Expansion::new(image, sites, blocks, findings);
    expansion.block(block);
    // What holds in every scenario is no reason to play one at its terminals.
    let at_terminals = expansion.at_terminals;
    let both = expansion.tags_and_terminals();
    let Expansion { power_up, mut actions, mut expectations, end_ms, acts_until_ms, .. } = expansion;
    findings.extend(both);
    let end_ms = end_ms.max(acts_until_ms);
    let looks_each_ms: u64 = sites.iter().filter_map(Site::station).map(|station| station.looks_each_ms()).sum();
    let end_ms_max = LOOKS_MAX / looks_each_ms.max(1);
    if at_terminals && end_ms > end_ms_max {
        let message = format!(
            "a scenario at these terminals lasts at most {end_ms_max} ms, since each ms of each module is simulated"
        );
        findings.push(Finding::new(&SCENARIO_TIME, block.name.span, message));
    }
    for one in everywhere.iter().filter(|one| at_terminals || !one.is_at_terminals()) {
        expectations.extend(one.kind.clone().map(|kind| Expectation {
            text: never_text(one.never),
            span: one.never.span,
            from_ms: 0,
            until_ms: u64::MAX,
            kind,
        }));
    }
    let all_known = everywhere.iter().all(|one| one.kind.is_some());
    if expectations.is_empty() && all_known && findings.len() == before {
        let message = format!("the scenario `{}` expects nothing", block.name.as_str());
        findings.push(
            Finding::new(&SCENARIO_BLOCK, block.name.span, message).help("say what must happen with `then` or `never`"),
        );
    }
    if findings.len() > before {
        return (at_terminals, None);
    }
    // What is written later wins where two act at once: the order within a moment stays.
    actions.sort_by_key(|action| action.at_ms);
    for expectation in &mut expectations {
        expectation.until_ms = expectation.until_ms.min(end_ms);
    }
    let scenario = Scenario {
        name: block.name.as_str().to_owned(),
        span: block.name.span,
        power_up,
        actions,
        expectations,
        sites: if at_terminals { Arc::clone(sites) } else { Arc::default() },
        end_ms,
    };
    (at_terminals, Some(scenario))
}

/// `never` with names and values looked up.
pub(super) fn nevers(image: &AdmittedImage, sites: &[Site], never: &Never) -> Result<Expected, Box<Finding>> {
    never
        .conditions
        .iter()
        .map(|condition| Check::new(image, sites, condition))
        .collect::<Result<_, _>>()
        .map(Expected::Never)
}

/// A time that no scan has.
pub(super) fn no_scan(span: Span, from_ms: u64, until_ms: u64, period_ms: u64) -> Finding {
    let next = from_ms.div_ceil(period_ms).saturating_mul(period_ms);
    let message = format!("no scan begins from {from_ms} to {until_ms} ms: the next one begins at {next} ms");
    Finding::new(&SCENARIO_TIME, span, message)
        .help(format!("give it at least {} ms; one scan begins every {period_ms} ms", next - from_ms))
}
