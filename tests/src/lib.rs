#![no_std]
//! wip
