//! Meshes: boundaries, checks, welding, orienting, stitching, assembling, filling.

#[path = "../common/mod.rs"]
mod common;

mod adversarial;
mod align;
mod answers;
mod arrange;
mod assemble;
mod assemble_gaps;
mod attributes;
mod blend;
mod boundary;
mod certify;
mod check;
mod concatenate;
mod continuity;
mod creases;
mod develop;
mod develop_cuts;
mod develop_steps;
mod elbows;
mod errata;
mod facing;
mod facing_sheets;
mod fill;
mod islands;
mod join_report;
mod nesting;
mod orient;
mod outwards;
mod partial_rims;
mod patches;
mod pieces;
mod regions;
mod piece_order;
mod rows;
mod seams;
mod solid;
mod solid_again;
mod stitch;
mod together;
mod triangulate;
mod trim;
mod weld;
mod weld_poles;
mod winged;
