//! Values as L5K writes them.

use crate::tree::{Data, DataForm, Value};

/// The text of a value; nothing for one by member name or as bytes, which L5K cannot say.
pub(super) fn print_value(value: &Value) -> Option<String> {
    let mut out = String::new();
    push(value, &mut out).then_some(out)
}

/// Recurses as deep as values nest, which has a limit.
fn push(value: &Value, out: &mut String) -> bool {
    match value {
        Value::Number(text) => out.push_str(&text.text),
        Value::String(text) => {
            out.push('\'');
            out.push_str(&text.text);
            out.push('\'');
        }
        Value::List { items, .. } => {
            out.push('[');
            for (index, item) in items.iter().enumerate() {
                if index > 0 {
                    out.push(',');
                }
                if !push(item, out) {
                    return false;
                }
            }
            out.push(']');
        }
        Value::Structure { .. } | Value::Array { .. } | Value::Bytes { .. } => return false,
    }
    true
}

/// The data of a tag as text: its L5K form, or a decorated form that is a single number.
pub(super) fn print_data(data: &[Data]) -> Option<String> {
    let l5k = data.iter().find(|data| data.form == DataForm::L5k);
    let single = data.iter().find(|data| matches!(data.value, Value::Number(_)));
    l5k.or(single).and_then(|data| print_value(&data.value))
}
