//! The life of an online edit: begin, accept, test, untest, assemble, cancel. Each step asks the table of protection first.

use twinrung_controller::protection::Action;

use crate::edit::{OnlineEdit, Stage};
use crate::lifecycle::Refused;
use crate::state::ControllerState;

impl ControllerState {
    /// Begins an online edit: `image` is the application with the changed rungs of `routines`, `both` the one with both versions.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn begin_edit(&mut self, routines: Vec<String>, image: Vec<u8>, both: Vec<u8>) -> Result<(), Refused> {
        self.permit(Action::BeginEdit)?;
        self.edit = Some(OnlineEdit { stage: Stage::Pending, routines, image, both });
        Ok(())
    }

    /// Accepts it into the controller; the original rungs execute.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn accept_edits(&mut self) -> Result<(), Refused> {
        self.step(Action::AcceptEdits, Stage::Accepted)
    }

    /// Lets the changed rungs execute.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn test_edits(&mut self) -> Result<(), Refused> {
        self.step(Action::TestEdits, Stage::Tested)
    }

    /// Lets the original rungs execute again.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn untest_edits(&mut self) -> Result<(), Refused> {
        self.step(Action::UntestEdits, Stage::Accepted)
    }

    fn step(&mut self, action: Action, to: Stage) -> Result<(), Refused> {
        self.permit(action)?;
        if let Some(edit) = &mut self.edit {
            edit.stage = to;
        }
        Ok(())
    }

    /// Makes the changed rungs the application.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn assemble_edits(&mut self) -> Result<(), Refused> {
        self.permit(Action::AssembleEdits)?;
        if let (Some(edit), Some(application)) = (self.edit.take(), &mut self.application) {
            application.image = edit.image;
        }
        Ok(())
    }

    /// Drops the changed rungs.
    ///
    /// # Errors
    ///
    /// As the table says.
    pub fn cancel_edits(&mut self) -> Result<(), Refused> {
        self.permit(Action::CancelEdits)?;
        self.edit = None;
        Ok(())
    }

    /// The image with both versions, and whether the changed one executes, once an edit is accepted.
    pub fn both_versions(&self) -> Option<(&[u8], bool)> {
        let edit = self.edit.as_ref().filter(|edit| edit.stage != Stage::Pending)?;
        Some((&edit.both, edit.stage == Stage::Tested))
    }

    /// The application with the changed rungs, while they execute.
    pub fn tested(&self) -> Option<&[u8]> {
        self.edit.as_ref().filter(|edit| edit.stage == Stage::Tested).map(|edit| edit.image.as_slice())
    }
}
