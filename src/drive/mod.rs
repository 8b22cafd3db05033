//! Ways to move a contact.

pub mod impact;
