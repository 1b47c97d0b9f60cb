//! What GSV could read: values of system attributes, drawn at random.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::image::SystemValueRecord;
use twinrung_catalog::instructions::system::{ATTRIBUTES, Attribute};

use crate::generate::{Random, any_value};
use crate::signal::Value;

/// The values of one attribute that a program reads.
#[derive(Debug, Clone)]
pub struct SystemSample {
    /// The attribute.
    pub attribute: &'static Attribute,
    /// Which object, and where the values stand among the inputs of a scan.
    pub record: SystemValueRecord,
    /// The values.
    pub values: Vec<i32>,
}

/// Draws a sample of every attribute that a program reads and that no program writes.
pub fn system_samples(image: &AdmittedImage, random: &mut Random) -> Vec<SystemSample> {
    let mut samples = Vec::new();
    for record in &image.image().system_values {
        let known = ATTRIBUTES.iter().find(|attribute| attribute.number == record.attribute);
        let Some(attribute) = known.filter(|attribute| !attribute.writable) else { continue };
        let value = |random: &mut Random| match any_value(random, attribute.element) {
            Value::Integer(value) => value,
            _ => 0,
        };
        let values = (0..attribute.length).map(|_| value(random)).collect();
        samples.push(SystemSample { attribute, record: record.clone(), values });
    }
    samples
}
