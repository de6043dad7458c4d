#![no_main]
vitrum_fuzz::target!("pvd");
