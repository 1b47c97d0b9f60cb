//! Replacement of a safety module, cell by cell. 1734-UM013 Chapter 8.

use std::collections::BTreeSet;

use twinrung_commission::replacement::{Found, Number, Owner, Ownership, Policy, ROWS, Refusal, judge};

const POLICIES: [Policy; 2] = [Policy::WithoutSignature, Policy::Always];

/// A module that fits, with this number, which nobody owns.
fn module(number: Number) -> Found {
    Found { number, key_fits: true, address_fits: true, owner: Owner::Nobody }
}

fn code(policy: Policy, signed: bool, found: Found) -> Option<&'static str> {
    judge(policy, signed, found).err().map(|row| row.code)
}

/// REQ-REPLACE-001. Table 11, and Replacement with Configure Always Enabled, row by row.
#[test]
fn module_when_it_fits_then_it_is_configured_as_table_11_says() {
    use Number::{Other, OutOfBox, Same};
    use Policy::{Always, WithoutSignature};
    let table = [
        (WithoutSignature, false, OutOfBox, None),
        (WithoutSignature, false, Same, None),
        (WithoutSignature, true, Same, None),
        (WithoutSignature, true, OutOfBox, Some("R04")),
        (WithoutSignature, true, Other, Some("R05")),
        (WithoutSignature, false, Other, Some("R06")),
        (Always, false, OutOfBox, None),
        (Always, true, OutOfBox, None),
        (Always, false, Same, None),
        (Always, true, Same, None),
        (Always, false, Other, Some("R07")),
        (Always, true, Other, Some("R07")),
    ];
    for (policy, signed, number, expected) in table {
        assert_eq!(code(policy, signed, module(number)), expected, "{policy:?} {signed} {number:?}");
    }
}

/// REQ-REPLACE-001. 1756-RM093: address, electronic keying; 1734-UM013: ownership. Whatever else holds.
#[test]
fn module_when_address_key_or_owner_do_not_fit_then_it_is_never_configured() {
    for policy in POLICIES {
        for signed in [false, true] {
            let unfit = |found: &Found| !found.address_fits || !found.key_fits || found.owner == Owner::Remote;
            for found in Found::all().filter(|found| found.is_possible()).filter(unfit) {
                let expected = match (found.address_fits, found.key_fits) {
                    (false, _) => "R01",
                    (true, false) => "R02",
                    (true, true) => "R03",
                };
                assert_eq!(code(policy, signed, found), Some(expected), "{found:?}");
            }
        }
    }
}

/// REQ-REPLACE-001. No row is one that nothing can get.
#[test]
fn rows_when_every_cell_is_asked_for_then_each_is_the_reason_of_one() {
    let cells = POLICIES.into_iter().flat_map(|policy| {
        [false, true].into_iter().flat_map(move |signed| {
            Found::all().filter(|found| found.is_possible()).filter_map(move |found| code(policy, signed, found))
        })
    });
    let found: BTreeSet<&str> = cells.collect();
    let all: BTreeSet<&str> = ROWS.iter().map(|row| row.code).collect();
    assert_eq!(found, all);
    assert!(ROWS.iter().all(|row| !row.steps.is_empty() && !row.source.is_empty()));
}

/// REQ-REPLACE-002. The three scenarios, step by step.
#[test]
fn scenarios_when_their_steps_are_taken_then_the_module_is_configured() {
    let without = Policy::WithoutSignature;
    let first = module(Number::OutOfBox).set_number().unwrap();
    assert_eq!(code(without, true, first), None);
    let second = module(Number::Other).reset_ownership(false).unwrap();
    assert_eq!(code(without, true, second), Some("R04"));
    assert_eq!(code(without, true, second.set_number().unwrap()), None);
    let third = module(Number::Other).reset_ownership(false).unwrap();
    assert_eq!(code(without, false, third), None);
    assert_eq!(code(Policy::Always, true, third), None);
}

/// REQ-REPLACE-002. 1734-UM013 Resetting a Module; Manually Setting the Safety Network Number.
#[test]
fn module_when_it_is_owned_or_has_a_number_then_it_is_not_changed_before_its_time() {
    let owned = Found { owner: Owner::Local, ..module(Number::Same) };
    assert_eq!(owned.reset_ownership(false), Err(Refusal::Connected));
    assert_eq!(owned.reset_ownership(true), Ok(module(Number::OutOfBox)));
    assert_eq!(module(Number::Same).set_number(), Err(Refusal::HasNumber));
    assert_eq!(module(Number::Other).set_number(), Err(Refusal::HasNumber));
}

/// REQ-REPLACE-003. 1734-UM013 Configuration Ownership: any difference loses the connection.
#[test]
fn ownership_when_any_of_its_parts_differs_then_that_part_is_named() {
    let own = Ownership {
        module_number: "1".to_owned(),
        module_network: 1,
        controller_slot: 0,
        controller_network: 2,
        path: "Rack".to_owned(),
        configuration: [7; 32],
    };
    assert!(own.differences(&own).is_empty());
    let others = [
        (Ownership { module_number: "2".to_owned(), ..own.clone() }, "the module number"),
        (Ownership { module_network: 3, ..own.clone() }, "the safety network number of the module"),
        (Ownership { controller_slot: 1, ..own.clone() }, "the slot of the controller"),
        (Ownership { controller_network: 3, ..own.clone() }, "the safety network number of the controller"),
        (Ownership { path: "Other".to_owned(), ..own.clone() }, "the path from the controller to the module"),
        (Ownership { configuration: [8; 32], ..own.clone() }, "the configuration signature"),
    ];
    for (other, part) in others {
        assert_eq!(own.differences(&other), [part]);
    }
}
