//! A device that the caller opened, and reading without waiting.

use std::pin::pin;
use std::task::{Context, Poll, Waker};

use pollster::block_on;
use vitrum::backend::wgpu::{self, Adapter, DeviceDescriptor, PollType};
use vitrum::backend::{Backend, Contents, CpuBackend, GpuBackend};
use vitrum_conformance::case::Case;
use vitrum_conformance::run::Run;
use vitrum_conformance::{Failure, adapter, evidence, frames};

/// The adapter that tests use, found by the caller itself.
fn found(adapter: &str) -> Adapter {
    let descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    let all = block_on(wgpu::Instance::new(descriptor).enumerate_adapters(wgpu::Backends::all()));
    let is_wanted = |found: &Adapter| adapter.starts_with(&found.get_info().name);
    all.into_iter().find(is_wanted).expect("the adapter is there still")
}

#[test]
fn a_device_of_the_caller_renders_the_same() -> Result<(), Failure> {
    let Some(own) = adapter::for_test() else { return Ok(()) };
    let adapter = found(&own.adapter());
    let (mut cpu, mut run) = (CpuBackend::new(None)?, Run::new(evidence::folder()));
    // A device that checks numbers of workgroups in buffers does so for rays through a mesh.
    let cases = [Case::builtin("ball", 24, Some(16), &[])?, Case::builtin("vase", 24, Some(16), &[])?];
    // All that helps, and nothing of it.
    for descriptor in [GpuBackend::required(&adapter), DeviceDescriptor::default()] {
        let (device, queue) = block_on(adapter.request_device(&descriptor)).expect("the device opens");
        let mut gpu = GpuBackend::with_device(device, queue, &adapter.get_info());
        for case in &cases {
            frames::compare(case, &mut cpu, &mut gpu, &mut run)?;
        }
    }
    run.assert_passed();
    Ok(())
}

#[test]
fn a_buffer_is_read_without_waiting() -> Result<(), Failure> {
    let Some(own) = adapter::for_test() else { return Ok(()) };
    let adapter = found(&own.adapter());
    let opened = block_on(adapter.request_device(&GpuBackend::required(&adapter)));
    let (device, queue) = opened.expect("the device opens");
    let mut gpu = GpuBackend::with_device(device.clone(), queue, &adapter.get_info());
    let buffer = gpu.create("numbers", Contents::Bytes(bytemuck::cast_slice(&[1u32, 2, 3, 4])))?;
    {
        let mut read = pin!(gpu.read_async(&buffer, 4..12));
        let mut context = Context::from_waker(Waker::noop());
        assert!(read.as_mut().poll(&mut context).is_pending(), "nobody has polled the device");
        device.poll(PollType::wait_indefinitely()).expect("the device works");
        let Poll::Ready(bytes) = read.as_mut().poll(&mut context) else { panic!("the device was polled") };
        assert_eq!(bytes?, bytemuck::cast_slice::<u32, u8>(&[2, 3]));
    }
    assert!(block_on(gpu.read_async(&buffer, 8..24)).is_err(), "the part ends behind the buffer");
    Ok(())
}
