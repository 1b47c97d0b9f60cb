//! What is downloaded, uploaded, signed, stored and loaded.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use jiff::{Timestamp, Unit};
use twinrung_bytecode::signature::{leaves, long_form, short_form};
use twinrung_commission::lifecycle::Project;
use twinrung_commission::{Application, Card, ControllerState, Downloaded, Identity, LoadMode};
use twinrung_controller::protection::Action;

use super::folder::Kept;
use super::{Ended, refuse, status};
use crate::input::{self, Complete, Input, Loaded};
use crate::{exit, failed, files, instructions};

/// Arguments of `controller FOLDER download`.
#[derive(Debug, Args)]
pub(super) struct Download {
    /// The project: .rll, .L5K, .L5X, a folder, or an image
    project: PathBuf,
    /// Hardware series that the project was made for; that of the controller where this is not given
    #[arg(long, value_name = "LETTER", value_parser = series)]
    series: Option<char>,
    #[command(flatten)]
    complete: Complete,
}

fn series(text: &str) -> Result<char, String> {
    match text.as_bytes() {
        [letter] if letter.is_ascii_alphabetic() => Ok(letter.to_ascii_uppercase().into()),
        _ => Err(format!("`{text}` is not a series: it is one letter")),
    }
}

/// The series of a controller that is made by a download which names none.
const FIRST_SERIES: char = 'A';

pub(super) fn download(out: &mut dyn Write, folder: &Path, arguments: &Download) -> Ended {
    let (trees, loaded, from_image) = match input::open(&arguments.project, &arguments.complete).map_err(failed)? {
        Input::Image(loaded) => (Vec::new(), *loaded, true),
        Input::Project(read) => match input::image_of(out, &arguments.project, &read, "; nothing was downloaded")? {
            Ok(loaded) => (read.trees, loaded, false),
            Err(code) => return Ok(code),
        },
    };
    if loaded.image.image().task.is_none() {
        return refuse(out, &"the project has no safety task; nothing was downloaded");
    }
    let identity = |series| {
        let made_for = &loaded.image.image().controller;
        Identity { catalog_number: made_for.processor.clone(), series, revision: made_for.revision }
    };
    let made = || ControllerState::new(identity(arguments.series.unwrap_or(FIRST_SERIES)));
    let mut kept = Kept::open_or_make(folder, made)?;
    let made_for = identity(arguments.series.unwrap_or(kept.state.identity.series));
    let id = *loaded.image.application_signature();
    let name = loaded.image.image().controller.name.clone();
    let instructions = instructions::listing(&trees, &loaded.image)?;
    let Loaded { bytes, .. } = loaded;
    let application = Application { name, image: bytes, instructions, from_image };
    let project = Project { made_for, id, application };
    let downloaded = match kept.state.download(project) {
        Ok(downloaded) => downloaded,
        Err(why) => return refuse(out, &why),
    };
    kept.keep()?;
    writeln!(out, "downloaded to {}: safety application {}", kept.state.identity, short_form(&id))?;
    match downloaded {
        Downloaded::SignatureKept(signature) => {
            writeln!(out, "it matches the safety task signature, which stays: {signature}")?;
            writeln!(out, "compare it with the one that was recorded")?;
        }
        Downloaded::SignatureDeleted(signature) => {
            writeln!(out, "the safety task signature is deleted: {signature}")?;
            writeln!(out, "the application is to be validated again")?;
        }
        Downloaded::Unsigned => writeln!(out, "there is no safety task signature: the application is to be tested")?,
    }
    for line in kept.state.application.iter().flat_map(status::instruction_lines) {
        writeln!(out, "{line}")?;
    }
    Ok(ExitCode::SUCCESS)
}

pub(super) fn upload(out: &mut dyn Write, kept: &Kept, image: &Path) -> Ended {
    if let Err(why) = kept.state.permit(Action::Upload) {
        return refuse(out, &why);
    }
    let Some((admitted, bytes)) = kept.admitted()? else { return Ok(ExitCode::from(exit::REFUSED)) };
    files::write_whole(image, bytes)?;
    writeln!(out, "wrote {}: safety application {}", image.display(), short_form(admitted.application_signature()))?;
    if let Some(signature) = &kept.state.signature {
        writeln!(out, "safety task signature  {signature}")?;
    }
    Ok(ExitCode::SUCCESS)
}

pub(super) fn compare(out: &mut dyn Write, kept: &Kept, project: &Path, complete: &Complete) -> Ended {
    if let Err(why) = kept.state.permit(Action::Upload) {
        return refuse(out, &why);
    }
    let loaded = match input::image(out, project, complete, "; nothing was compared")? {
        Ok(loaded) => loaded,
        Err(code) => return Ok(code),
    };
    let Some((own, _)) = kept.admitted()? else { return Ok(ExitCode::from(exit::REFUSED)) };
    let (own_leaves, other_leaves) =
        (leaves(own.image()).map_err(failed)?, leaves(loaded.image.image()).map_err(failed)?);
    let lists = [(&own_leaves, &other_leaves, "in the controller"), (&other_leaves, &own_leaves, "in the project")];
    for (these, others, where_) in lists {
        for leaf in these.iter().filter(|leaf| !others.contains(leaf)) {
            writeln!(out, "{where_:17}  {} {}", leaf.kind.name(), leaf.name)?;
        }
    }
    let (own, other) = (own.application_signature(), loaded.image.application_signature());
    writeln!(out, "controller  {}\nproject     {}", long_form(own), long_form(other))?;
    writeln!(out, "{}", if own == other { "they are the same application" } else { "they differ" })?;
    Ok(if own == other { ExitCode::SUCCESS } else { ExitCode::from(exit::REFUSED) })
}

pub(super) fn generate(out: &mut dyn Write, kept: &mut Kept, clock: Option<Timestamp>) -> Ended {
    if let Err(why) = kept.state.permit(Action::GenerateSignature) {
        return refuse(out, &why);
    }
    let Some((admitted, _)) = kept.admitted()? else { return Ok(ExitCode::from(exit::REFUSED)) };
    let id = *admitted.application_signature();
    let now = clock.unwrap_or_else(Timestamp::now).round(Unit::Second).map_err(failed)?;
    let signature = match kept.state.generate_signature(id, now) {
        Ok(signature) => signature,
        Err(why) => return refuse(out, &why),
    };
    kept.keep()?;
    writeln!(out, "safety task signature  {signature}\nID                     {}", long_form(&id))?;
    writeln!(out, "record it: it is compared after every download")?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn delete(out: &mut dyn Write, kept: &mut Kept) -> Ended {
    if let Err(why) = kept.state.delete_signature() {
        return refuse(out, &why);
    }
    kept.keep()?;
    writeln!(out, "the safety task signature is deleted: the application is to be validated again")?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn store(out: &mut dyn Write, kept: &Kept, path: &Path, load_mode: LoadMode) -> Ended {
    let card = match kept.state.store_to_card(load_mode) {
        Ok(card) => card,
        Err(why) => return refuse(out, &why),
    };
    files::write_whole(path, &card.encode().map_err(failed)?)?;
    writeln!(out, "stored on {}: {} for {}", path.display(), card.application.name, card.made_for)?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn load(out: &mut dyn Write, folder: &Path, path: &Path) -> Ended {
    let in_file = |error: &dyn std::fmt::Display| io::Error::other(format!("{}: {error}", path.display()));
    let bytes = fs::read(path).map_err(|error| in_file(&error))?;
    let card = Card::decode(&bytes).map_err(|error| in_file(&error))?;
    let image = twinrung_bytecode::admit(&card.application.image).map_err(|error| in_file(&error))?;
    let id = *image.application_signature();
    if card.signature.is_some_and(|signature| signature.id != id) {
        return Err(in_file(&"its safety task signature is not that of its application"));
    }
    let made = || ControllerState::new(card.made_for.clone());
    let mut kept = Kept::open_or_make(folder, made)?;
    if let Err(why) = kept.state.load_from_card(card) {
        return refuse(out, &why);
    }
    kept.keep()?;
    writeln!(out, "loaded from {}: safety application {}", path.display(), short_form(&id))?;
    match &kept.state.signature {
        Some(signature) => writeln!(out, "safety task signature  {signature}")?,
        None => writeln!(out, "there is no safety task signature: the application is to be tested")?,
    }
    Ok(ExitCode::SUCCESS)
}
