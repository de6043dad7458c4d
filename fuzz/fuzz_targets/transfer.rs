#![no_main]
vitrum_fuzz::target!("transfer");
