//! The modules of an image that have a model, with the cells of their tags: what joins a simulated plant to a controller.

mod declaration;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::image::{ModuleRecord, TagKind};
use twinrung_bytecode::index::TagIndex;
use twinrung_plant::{Command, ModuleSettings, Plant, Reading, Station, Terminal};

use crate::drive::cells;
use crate::names;
use crate::signal::Signal;
use declaration::Declaration;

/// A module that is simulated.
#[derive(Debug, Clone)]
pub struct Site {
    /// Its name.
    pub name: String,
    settings: ModuleSettings,
    readings: Vec<Reading>,
    commands: Vec<Command>,
    /// Members of the input tag with their full names, in the order of the readings.
    pub inputs: Vec<(String, Signal)>,
    /// Members of the output tag as they are published, in the order of the commands.
    pub outputs: Vec<Signal>,
}

impl Site {
    /// The module at power-up.
    pub fn station(&self) -> Option<Station> {
        Station::new(&self.settings, self.readings.clone(), self.commands.clone())
    }

    /// Where the data of an input terminal is shown.
    pub fn data_of(&self, terminal: Terminal) -> Option<&(String, Signal)> {
        let wanted = (terminal.letter != 'T').then_some(Reading::Data(terminal.number))?;
        let position = self.readings.iter().position(|reading| *reading == wanted)?;
        self.inputs.get(position)
    }

    /// Whether a value is a member of the input tag, which follows the model, or a bit of one.
    pub fn drives(&self, signal: Signal) -> bool {
        let cell = cells(signal);
        cell.is_some() && self.inputs.iter().any(|(_, own)| cells(*own) == cell)
    }
}

/// The modules of an image that have a model, in the order of the image.
pub fn sites(image: &AdmittedImage) -> Vec<Site> {
    let period_us = image.image().task.as_ref().map_or(1000, |task| u64::from(task.period_us));
    image.image().modules.iter().filter_map(|record| site(image, record, period_us)).collect()
}

/// The modules at power-up.
pub fn plant(sites: &[Site]) -> Plant {
    Plant::new(sites.iter().filter_map(Site::station).collect())
}

fn site(image: &AdmittedImage, record: &ModuleRecord, period_us: u64) -> Option<Site> {
    let declaration = Declaration::read(&record.text);
    let mut site = Site {
        name: record.name.clone(),
        settings: declaration.settings(period_us)?,
        readings: Vec::new(),
        commands: Vec::new(),
        inputs: Vec::new(),
        outputs: Vec::new(),
    };
    for (position, tag) in image.image().tags.iter().enumerate() {
        if !declaration.owns(&record.name, &tag.name) {
            continue;
        }
        for (name, signal) in names::values_of(image, TagIndex(position as u32)) {
            let member = name.rsplit('.').next().unwrap_or_default();
            match tag.kind {
                TagKind::ModuleInput => {
                    if let Some(reading) = Reading::of(member) {
                        site.readings.push(reading);
                        site.inputs.push((name, signal));
                    }
                }
                TagKind::ModuleOutput => {
                    if let Some(command) = Command::of(member) {
                        site.commands.push(command);
                        site.outputs.push(signal.published());
                    }
                }
                _ => {}
            }
        }
    }
    // A module without a model has no station, and its tags are driven as they always were.
    site.station().map(|_| site)
}
