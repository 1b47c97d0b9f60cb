//! A stack whose room is allocated by loading.

use alloc::vec::Vec;
use core::ops::{Deref, DerefMut};

/// A vector that is never longer than the room it was made with: who pushes looks first. A clone has the same room, so
/// that it allocates nothing in a scan either.
#[derive(Debug)]
pub(crate) struct Stack<T>(Vec<T>);

impl<T> Stack<T> {
    pub(crate) fn with_room(room: usize) -> Stack<T> {
        Stack(Vec::with_capacity(room))
    }
}

impl<T: Clone> Clone for Stack<T> {
    fn clone(&self) -> Self {
        let mut entries = Vec::with_capacity(self.0.capacity());
        entries.extend_from_slice(&self.0);
        Stack(entries)
    }
}

impl<T> Deref for Stack<T> {
    type Target = Vec<T>;

    fn deref(&self) -> &Vec<T> {
        &self.0
    }
}

impl<T> DerefMut for Stack<T> {
    fn deref_mut(&mut self) -> &mut Vec<T> {
        &mut self.0
    }
}
