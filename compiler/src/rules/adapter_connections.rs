//! Connections of an adapter. 1734-UM013, Add the Adapter.

use twinrung_catalog::modules;
use twinrung_catalog::points::{ADAPTERS, CONNECTIONS_OF_ADAPTER};
use twinrung_grammar::tree::CompactString;

use crate::diagnostic::{Finding, Findings};
use crate::names::{Map, fold};
use crate::project::{Module, Project};

rule! {
    /// More connections than the adapter of the rack has.
    "S0412", Error, "the modules of a rack need more connections than their adapter has",
    "A 1734-AENT or 1734-AENTR makes 20 connections. A POINT Guard module takes one for its inputs or status and one for its outputs. Spread the modules over a second adapter, or choose OutputData := NONE where no test output is switched by logic.",
    "1734-UM013, Add and Configure the 1734 Ethernet Adapter",
    good: concat!("CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n",
        "  MODULE D1 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"),
    bad: concat!("CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)\n  MODULE <<Rack>> (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n",
        "  MODULE D1 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  MODULE D2 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  MODULE D3 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 3, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  MODULE D4 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 4, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  MODULE D5 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 5, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  MODULE D6 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 6, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  MODULE D7 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 7, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  MODULE D8 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 8, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  MODULE D9 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 9, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  MODULE D10 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 10, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  MODULE D11 (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 11, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n",
        "  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n")
}

/// Every adapter of a POINT rack.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let mut of_parent: Map<CompactString, u32> = Map::default();
    for module in &project.modules {
        *of_parent.entry(fold(&module.parent)).or_default() += connections(module);
    }
    for adapter in &project.modules {
        let number = modules::without_series(&adapter.catalog_number);
        if !ADAPTERS.iter().any(|one| one.eq_ignore_ascii_case(number)) {
            continue;
        }
        let needed = of_parent.get(&fold(&adapter.name)).copied().unwrap_or_default();
        if needed > CONNECTIONS_OF_ADAPTER {
            let message = format!(
                "the safety modules of `{}` need {needed} connections; it has {CONNECTIONS_OF_ADAPTER}",
                adapter.name
            );
            let finding = Finding::new(&CODE, adapter.span, message);
            findings.push(finding.help("attach some of them to a second adapter"));
        }
    }
}

/// Connections that a safety module takes.
fn connections(module: &Module) -> u32 {
    let shown = module.shown.connections.len() as u32;
    let Some(known) = modules::Module::by_catalog_number(&module.catalog_number).filter(|_| shown == 0) else { return shown };
    let word = |key: &str| module.shown.attributes.iter().find(|one| one.key.is(key)).and_then(|one| one.value.text());
    let output = match word("OutputData") {
        Some(word) => known.output_data.iter().find(|choice| choice.word.eq_ignore_ascii_case(word.as_str().trim())),
        None => known.output_data.first(),
    };
    1 + u32::from(output.is_some_and(|choice| !choice.members.is_empty()))
}
