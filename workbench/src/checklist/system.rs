//! The list for the controller system. 1756-RM093 Appendix D, page 90.

use twinrung_catalog::modules;
use twinrung_compiler::diagnostic::{Code, NO_CONTROLLER, UNKNOWN_CONTROLLER};
use twinrung_compiler::project::TagClass;
use twinrung_compiler::rules;
use twinrung_grammar::tree::RungKind;

use super::{Answer, Checklist, Evidence, Line, person};

/// Fills in the list.
pub fn list(evidence: &Evidence<'_>) -> Checklist {
    let times = times(evidence);
    let lines = vec![
        components(evidence),
        person(2, "the safety response time of each chain was calculated", times.clone()),
        person(3, "that response time includes watchdog and period of the safety task", times),
        person(4, "the response time suits the process tolerance time", Vec::new()),
        person(5, "PFD and PFH were calculated for this configuration", Vec::new()),
        person(6, "all functional verification tests were done", Vec::new()),
        person(7, "it is determined how the system handles faults", faults(evidence)),
        numbered(
            evidence,
            8,
            "each network of the safety system has a safety network number of its own",
            &[&rules::shared_network::CODE],
        ),
        numbered(
            evidence,
            9,
            "each safety device has the right safety network number",
            &[&rules::network_number::CODE, &rules::unique_node::CODE],
        ),
        signature(evidence),
        person(11, "the safety task signature was read out and recorded", Vec::new()),
        person(12, "after a download the signature in the controller was compared with the recorded one", Vec::new()),
        person(13, "something else protects the safety integrity while the program is edited online", edits(evidence)),
        person(14, "the lists for safety inputs and outputs were gone through", Vec::new()),
    ];
    Checklist { title: "controller system", page: 90, subject: evidence.subject(), lines }
}

fn components(evidence: &Evidence<'_>) -> Line {
    let requirement = "only certified components are used, with the firmware release that belongs to them";
    let unknown = evidence.found(&[&UNKNOWN_CONTROLLER]);
    if !unknown.is_empty() {
        return Line { number: 1, requirement, answer: Answer::No, evidence: unknown };
    }
    let mut list = evidence.found(&[&NO_CONTROLLER]);
    if let Some(profile) = evidence.project.and_then(|project| project.profile.as_ref()) {
        list.push(format!("controller {}: a known safety controller", profile.display()));
    }
    for module in &evidence.file.modules {
        let Some(number) = module.catalog_number.as_ref().filter(|number| !number.as_str().is_empty()) else {
            continue;
        };
        let carries = |one: &&&str| number.as_str().split('/').next().is_some_and(|own| one.eq_ignore_ascii_case(own));
        let what = if modules::Module::by_catalog_number(number.as_str()).is_some() {
            "a known safety module"
        } else if modules::CARRIERS.iter().any(|one| carries(&one)) {
            "a known adapter or bridge"
        } else {
            "not in this tool's table: look it up"
        };
        list.push(format!("{} is {}: {what}", module.name, number.as_str()));
    }
    list.push("firmware releases are compared by a person".to_owned());
    person(1, requirement, list)
}

/// Period and watchdog of the safety task and the packet intervals, as far as they are declared.
fn times(evidence: &Evidence<'_>) -> Vec<String> {
    let Some(project) = evidence.project else { return Vec::new() };
    let ms = |us: u64| us as f64 / 1000.0;
    let mut list = Vec::new();
    for task in project.tasks.iter().filter(|task| task.class == TagClass::Safety) {
        let (Some((period, _)), Some((watchdog, _))) = (task.period_us, task.watchdog_us.or(task.period_us)) else {
            continue;
        };
        list.push(format!(
            "{}: period {} ms, watchdog {} ms, together {} ms",
            task.name,
            ms(period),
            ms(watchdog),
            ms(period + watchdog)
        ));
    }
    for module in &evidence.file.modules {
        let own = module.rpi_us.iter().map(|rpi| (String::new(), rpi.value));
        let of_connections =
            module.connections.iter().filter_map(|one| Some((format!(" {}", one.name), one.rpi_us?.value)));
        list.extend(
            own.chain(of_connections)
                .map(|(name, rpi)| format!("{}{name}: packet interval {} ms", module.name, ms(rpi))),
        );
    }
    list
}

fn faults(evidence: &Evidence<'_>) -> Vec<String> {
    let mut list = Vec::new();
    for program in evidence.project.iter().flat_map(|project| &project.programs) {
        list.push(match program.fault {
            Some(_) => format!("program {} has a fault routine", program.name),
            None => format!("program {} has no fault routine", program.name),
        });
    }
    list.extend(evidence.found(&[&rules::status_not_watched::CODE]));
    list
}

/// What these codes find is wrong for certain; what they do not find is not right for certain: the files do not show every
/// network, nor what the devices hold.
fn numbered(evidence: &Evidence<'_>, number: u32, requirement: &'static str, codes: &[&'static Code]) -> Line {
    let found = evidence.found(codes);
    if found.is_empty() {
        return person(number, requirement, networks(evidence));
    }
    Line { number, requirement, answer: Answer::No, evidence: found }
}

fn networks(evidence: &Evidence<'_>) -> Vec<String> {
    let mut list = Vec::new();
    if let Some(number) = evidence.file.controller.as_ref().and_then(|one| one.safety_network.as_ref()) {
        list.push(format!("controller: {}", number.as_str()));
    }
    let Some(project) = evidence.project else { return list };
    for module in &project.modules {
        match &module.safety_network {
            Some((number, _)) => list.push(format!("{} behind {}: {number}", module.name, module.parent)),
            None if module.safety => {
                list.push(format!("{} behind {}: no number is visible", module.name, module.parent))
            }
            None => {}
        }
    }
    list
}

/// Only an export made from a signed project shows a signature of the controller.
fn signature(evidence: &Evidence<'_>) -> Line {
    let requirement = "a safety task signature was generated";
    let shown =
        evidence.file.controller.as_ref().and_then(|one| one.safety.as_ref()).and_then(|one| one.signature.as_ref());
    if let Some(shown) = shown.filter(|text| !text.as_str().trim().is_empty()) {
        let evidence = vec![format!("the export holds the signature {}", shown.as_str())];
        return Line { number: 10, requirement, answer: Answer::Yes, evidence };
    }
    let mut list = vec!["the file holds no signature of the controller".to_owned()];
    list.extend(
        evidence
            .signature_text()
            .map(|text| format!("the safety application signature of this tool is {text}; it is not the controller's")),
    );
    person(10, requirement, list)
}

fn edits(evidence: &Evidence<'_>) -> Vec<String> {
    let locked = evidence.file.controller.as_ref().and_then(|one| one.safety.as_ref()).and_then(|one| one.locked);
    let routines = evidence.file.programs.iter().flat_map(|program| &program.routines);
    let pending =
        routines.flat_map(|routine| routine.rungs()).filter(|rung| rung.kind.value != RungKind::Normal).count();
    let mut list = vec![format!("rungs with pending edits: {pending}")];
    list.extend(
        locked.map(|locked| format!("safety-locked when it was exported: {}", if locked.value { "yes" } else { "no" })),
    );
    list
}
