//! The texts of `templates/pages`: of each, its page with places for what is computed, and its sentences.

// Without a room its sentences have no caller.
#![cfg_attr(not(feature = "optimise"), allow(dead_code))]

use crate::page::{Blocks, Choice, Document, Items, Skeleton, Text};

include!(concat!(env!("OUT_DIR"), "/pages.rs"));
