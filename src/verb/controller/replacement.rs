//! Replacement of a safety module.

use std::io::Write;
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use twinrung_bytecode::signature::{LeafKind, leaves, long_form, short_form};
use twinrung_commission::replacement::{Found, Number, Owner, Policy, judge};

use super::folder::Kept;
use super::{Ended, refuse};
use crate::{exit, failed};

/// Arguments of `controller FOLDER replace`.
#[derive(Debug, Args)]
#[command(
    after_help = "Says whether the controller configures what stands in the place of a module (1734-UM013 Chapter 8), and what a person does\n\
first where it does not. Whether it configures always is a setting of the project.\n\
Exit code: 0 it is configured, 1 it is not."
)]
pub(super) struct Replace {
    /// The module
    module: String,
    /// The safety network number that the replacement holds
    #[arg(long, value_enum, default_value_t = NumberName::OutOfBox)]
    number: NumberName,
    /// Who owns its configuration
    #[arg(long, value_enum, default_value_t = OwnerName::Nobody)]
    owner: OwnerName,
    /// It is another kind of module
    #[arg(long)]
    other_key: bool,
    /// It has another node or IP address
    #[arg(long)]
    other_address: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum NumberName {
    /// None.
    OutOfBox,
    /// The one of the project.
    Same,
    /// Another one.
    Other,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum OwnerName {
    /// Nobody.
    Nobody,
    /// This controller.
    Local,
    /// Another controller.
    Remote,
}

pub(super) fn replace(out: &mut dyn Write, kept: &Kept, arguments: &Replace) -> Ended {
    let Some((image, _)) = kept.admitted()? else {
        return refuse(out, &"the controller holds no application: download the project");
    };
    let leaves = leaves(image.image()).map_err(failed)?;
    let own =
        leaves.iter().find(|leaf| leaf.kind == LeafKind::Module && leaf.name.eq_ignore_ascii_case(&arguments.module));
    let Some(own) = own else { return refuse(out, &format!("there is no safety module `{}`", arguments.module)) };
    let found = Found {
        number: match arguments.number {
            NumberName::OutOfBox => Number::OutOfBox,
            NumberName::Same => Number::Same,
            NumberName::Other => Number::Other,
        },
        key_fits: !arguments.other_key,
        address_fits: !arguments.other_address,
        owner: match arguments.owner {
            OwnerName::Nobody => Owner::Nobody,
            OwnerName::Local => Owner::Local,
            OwnerName::Remote => Owner::Remote,
        },
    };
    if !found.is_possible() {
        return refuse(out, &"a module that is out-of-box has no owner");
    }
    let always = image.image().controller.configures_always();
    let policy = if always { Policy::Always } else { Policy::WithoutSignature };
    let words = if always { "Configure Always" } else { "Configure Only When No Safety Signature Exists" };
    writeln!(out, "{}: {words}", own.name)?;
    match judge(policy, kept.state.signature.is_some(), found) {
        Ok(()) => {
            writeln!(
                out,
                "the controller configures it and connects to it; test it and the system before they are relied on"
            )?;
            writeln!(out, "configuration signature  {}  {}", short_form(&own.hash), long_form(&own.hash))?;
            Ok(ExitCode::SUCCESS)
        }
        Err(row) => {
            writeln!(out, "not configured: {}", row.reason)?;
            for (number, step) in row.steps.iter().enumerate() {
                writeln!(out, "  {}. {step}", number + 1)?;
            }
            writeln!(out, "  {}: {}", row.code, row.source)?;
            Ok(ExitCode::from(exit::REFUSED))
        }
    }
}
