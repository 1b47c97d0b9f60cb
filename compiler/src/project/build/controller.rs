//! The controller and what it admits.

use twinrung_bytecode::image::CONFIGURE_ALWAYS;
use twinrung_catalog::Controller;
use twinrung_grammar::tree::{self, Span};

use super::Inputs;
use crate::diagnostic::{Finding, Findings, NO_CONTROLLER, UNKNOWN_CONTROLLER};
use crate::names::closest;
use crate::project::Profile;

/// The profile of the controller that the command line or the file names.
pub(super) fn profile(inputs: &Inputs<'_>, span: Span, findings: &mut Findings) -> Option<Profile> {
    let shown = inputs.file.controller.as_deref();
    let (processor, place) = match (&inputs.completion.controller, shown.and_then(|one| one.processor_type.as_ref())) {
        (Some(processor), _) => (processor.as_str(), span),
        (None, Some(text)) => (text.as_str(), text.span),
        (None, None) => {
            let finding = Finding::new(&NO_CONTROLLER, span, "the file does not say for which controller it is")
                .help("complete it with --controller CATALOG/REVISION, for instance 1756-L73S/20");
            findings.push(finding);
            return None;
        }
    };
    let Some(controller) = Controller::by_catalog_number(processor) else {
        let message = format!("`{processor}` is no known safety controller");
        let finding = Finding::new(&UNKNOWN_CONTROLLER, place, message);
        let known = twinrung_catalog::controller::ALL.iter().map(|one| one.catalog_number);
        findings.push(match closest(processor, known) {
            Some(like) => finding.help(format!("did you mean `{like}`?")),
            None => finding.help("safety logic runs on GuardLogix controllers only, for instance 1756-L73S"),
        });
        return None;
    };
    let revision = match (inputs.completion.revision, shown.and_then(|one| one.major)) {
        (Some(revision), _) => u32::from(revision),
        (None, Some(major)) => major.value,
        (None, None) => {
            let finding = Finding::new(&NO_CONTROLLER, span, "the file does not say which revision the controller has")
                .help("complete it with --controller CATALOG/REVISION, for instance 1756-L73S/20");
            findings.push(finding);
            return None;
        }
    };
    let revision = u16::try_from(revision).unwrap_or(u16::MAX);
    if !controller.knows_revision(revision) {
        let place = shown.and_then(|one| one.major).filter(|_| inputs.completion.revision.is_none());
        let message = format!("there is no safety task in revision {revision} of the {}", controller.catalog_number);
        let finding = Finding::new(&UNKNOWN_CONTROLLER, place.map_or(span, |major| major.span), message)
            .help(format!("its first revision is {}", controller.first_revision));
        findings.push(finding);
        return None;
    }
    Some(Profile { controller, revision, span: place })
}

/// Settings of the controller that belong to the signed declaration.
pub(super) fn attributes(file: &tree::File) -> Vec<(String, String)> {
    let mut list = Vec::new();
    let Some(controller) = file.controller.as_deref() else { return list };
    let local = || file.modules.iter().find(|module| module.name.is("Local"));
    let network = controller.safety_network.as_ref().or_else(|| local()?.network_number());
    if let Some(network) = network {
        list.push(("SafetyNetwork".to_owned(), network.as_str().to_ascii_lowercase()));
    }
    if let Some(level) = controller.safety.as_ref().and_then(|safety| safety.level.as_ref()) {
        list.push(("SafetyLevel".to_owned(), level.as_str().to_owned()));
    }
    let always = controller.safety.as_ref().and_then(|safety| safety.configure_io_always);
    if always.is_some_and(|always| always.value) {
        list.push((CONFIGURE_ALWAYS.0.to_owned(), CONFIGURE_ALWAYS.1.to_owned()));
    }
    list.sort();
    list
}
