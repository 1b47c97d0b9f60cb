//! A stack that gets its room once.

use alloc::vec::Vec;

/// A stack that never grows beyond the room that it was made with; a clone has the same room.
#[derive(Debug)]
pub(crate) struct Stack<T> {
    entries: Vec<T>,
}

impl<T: Copy> Stack<T> {
    /// An empty stack for at least so many entries.
    pub(crate) fn new(room: usize) -> Stack<T> {
        Stack { entries: Vec::with_capacity(room) }
    }

    /// Entries on it.
    pub(crate) fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether it takes no more.
    pub(crate) fn is_full(&self) -> bool {
        self.entries.len() >= self.entries.capacity()
    }

    /// Puts an entry on top; whether there was room.
    #[must_use]
    pub(crate) fn push(&mut self, entry: T) -> bool {
        let fits = !self.is_full();
        if fits {
            self.entries.push(entry);
        }
        fits
    }

    /// Takes the topmost entry.
    pub(crate) fn pop(&mut self) -> Option<T> {
        self.entries.pop()
    }

    /// The entry at a position, counted from the bottom.
    pub(crate) fn get(&self, position: usize) -> Option<T> {
        self.entries.get(position).copied()
    }

    /// Keeps so many entries at the bottom.
    pub(crate) fn truncate(&mut self, length: usize) {
        self.entries.truncate(length);
    }

    /// Empties it.
    pub(crate) fn clear(&mut self) {
        self.entries.clear();
    }
}

impl<T: Copy> Clone for Stack<T> {
    fn clone(&self) -> Stack<T> {
        let mut stack = Stack::new(self.entries.capacity());
        stack.entries.extend_from_slice(&self.entries);
        stack
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stack_when_cloned_then_it_has_the_entries_and_the_room_of_the_first() {
        let mut first = Stack::new(3);
        assert!(first.push(1) && first.push(2));
        let mut second = first.clone();
        let room = second.entries.capacity();
        assert!(second.push(3) && second.is_full());
        assert!(!second.push(4));
        assert_eq!((second.get(2), second.len(), second.entries.capacity()), (Some(3), 3, room));
        assert_eq!((second.pop(), first.len()), (Some(3), 2));
    }
}
