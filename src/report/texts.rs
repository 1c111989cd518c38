//! The texts of `templates/pages`: of each, its page with places for what is computed, and its sentences.

// A sentence has as many values as places.
#![allow(clippy::too_many_arguments)]
// Without a room its sentences have no caller.
#![cfg_attr(not(feature = "optimise"), allow(dead_code))]

use crate::page::{Blocks, Choice, Document, Items, Skeleton, Text};

include!(concat!(env!("OUT_DIR"), "/pages.rs"));
