//! The evidence as one HTML page for a reviewer.

mod campaign;
mod defects;
mod head;
mod independence;
mod injection;
mod mutants;
mod origins;

use crate::html;
use crate::provenance::Provenance;

use super::Evidence;

/// Writes the page; `here` is the build that writes it.
pub fn page(evidence: &Evidence, here: &Provenance) -> String {
    let mut out = html::begin("Evidence: what was done to make the channels disagree");
    head::write(&mut out, evidence, here);
    campaign::write(&mut out, evidence);
    defects::write(&mut out, &evidence.defects);
    injection::write(&mut out, evidence.injection.as_ref());
    mutants::write(&mut out, &evidence.mutants);
    independence::write(&mut out, evidence.independence.as_ref());
    origins::write(&mut out, &evidence.origins, here);
    out.push_str(html::END);
    out
}

/// What was recorded, or that it was not.
fn recorded(text: Option<&str>) -> String {
    text.filter(|text| !text.is_empty()).unwrap_or("not recorded").to_owned()
}

/// A machine in few words.
fn machine(made: &Provenance) -> String {
    let cores = made.cores.map_or(String::new(), |cores| format!(", {cores} processors"));
    let system = made.system.as_ref().map_or(String::new(), |system| format!(", {system}"));
    format!("{}{cores}{system}", recorded(made.processor.as_deref()))
}

/// A build in few words.
fn build(made: &Provenance) -> String {
    format!(
        "{}, commit {}, {}",
        recorded(Some(&made.version)),
        recorded(made.commit.as_deref()),
        recorded(made.rustc.as_deref())
    )
}
