//! What is answered of the main bearings: tables, a short answer, a page?

use super::super::journal::{complete_bearings_answer, complete_bearings_page, without_gas};
use super::super::question::question;
use super::{BearingsStudy, bearings_answer, bearings_page, data};
use crate::page::Document;

question!(BearingsStudy, "bearings", |study| Some(study.engine.title()), data::table, answer, page, {});

fn answer(study: &BearingsStudy) -> Document {
    let answer = || bearings_answer(&study.engine, &study.continuous, &study.determinate);
    match &study.complete {
        None => answer(),
        Some(Err(lack)) => without_gas(answer(), lack),
        Some(Ok(loads)) => complete_bearings_answer(&study.engine, loads),
    }
}

fn page(study: &BearingsStudy) -> Document {
    let page = || bearings_page(&study.engine, &study.continuous, &study.determinate);
    match &study.complete {
        None => page(),
        Some(Err(lack)) => without_gas(page(), lack),
        Some(Ok(loads)) => complete_bearings_page(&study.engine, loads, &study.continuous),
    }
}
