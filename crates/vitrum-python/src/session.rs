//! Sessions: data on a device, of which picture after picture is made.

use crate::compose::{Composed, Data};
use crate::errors::Failure;
use crate::frame::Frame;
use crate::process::choice;
use crate::scene::Scene;
use crate::work;
use pyo3::prelude::*;
use std::sync::{Mutex, PoisonError};
use vitrum::backend::{self, Backend, BackendError, Choice, GpuOptions};
use vitrum::{Layers, OutputRequest, Renderer, framed_all_round, method, scene};
use vitrum_annotations::Overlay;

/// Data on a device.
#[pyclass(frozen, module = "vitrum_render._native")]
pub struct Session {
    /// The process that opened the device: one that was forked from it has neither its threads nor its device.
    process: u32,
    /// `None` once closed.
    state: Mutex<Option<State>>,
}

struct State {
    renderer: Renderer,
    data: Data,
}

/// The outputs of these names, which the scene's method must have; all of them without names.
fn outputs(names: Option<&[String]>, scene: &scene::Scene) -> Result<OutputRequest, Failure> {
    let Some(names) = names else { return Ok(OutputRequest::default()) };
    let mut request = OutputRequest { light: false, layers: Layers::color(), ..OutputRequest::default() };
    for name in names {
        let known: Vec<_> = method::of(scene.method).outputs().iter().map(|output| output.name).collect();
        if !known.contains(&name.as_str()) {
            let advice = match vitrum::suggest::nearest(name, known.iter().copied()) {
                Some(near) => format!("did you mean {near:?}?"),
                None => format!("it has {}", known.join(", ")),
            };
            let message = format!("the method `{}` has no output {name:?}", scene.method.as_str());
            return Err(Failure::value(message, advice));
        }
        request.layers = request.layers.with(name);
        request.light |= name == "light";
    }
    Ok(request)
}

impl Session {
    /// Runs `work` with the session's state, after other threads' work with it.
    fn with<T>(&self, work: impl FnOnce(&mut State) -> Result<T, Failure>) -> Result<T, Failure> {
        if self.process != std::process::id() {
            let message = "this session was opened by another process, from which this one was forked";
            return Err(Failure::value(message, "open a session in each process, or start processes by \"spawn\""));
        }
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        match &mut *state {
            Some(state) => work(state),
            None => Err(Failure::value("this session is closed", "open another one")),
        }
    }
}

#[pymethods]
impl Session {
    /// Opens a device for the data of a composed scene.
    #[new]
    #[pyo3(signature = (composed, backend = "auto", adapter = None, threads = None, memory_limit = None))]
    fn new(
        py: Python<'_>,
        composed: &Composed,
        backend: &str,
        adapter: Option<String>,
        threads: Option<usize>,
        memory_limit: Option<u64>,
    ) -> PyResult<Self> {
        if threads.is_some_and(|threads| !(1..=1024).contains(&threads)) {
            return Err(Failure::value(format!("threads={}", threads.unwrap_or(0)), "give 1 to 1024").into());
        }
        let choice = choice(backend)?;
        let by_itself = choice == Choice::Auto && adapter.is_none();
        let data = composed.data.clone();
        let state = work::run(py, None, |_| {
            let open_cpu = move || -> Result<Box<dyn Backend>, BackendError> {
                let mut cpu = backend::open(Choice::Cpu, &GpuOptions::default(), Some(threads.unwrap_or(0)))?;
                cpu.set_volume_limit(memory_limit);
                Ok(cpu)
            };
            let options = GpuOptions { adapter, ..GpuOptions::default() };
            // Threads of the session's own: 0 is one for each processor.
            let mut device = match backend::open(choice, &options, Some(threads.unwrap_or(0))) {
                Err(failure) if by_itself && failure.is_device_error() => open_cpu()?,
                opened => opened?,
            };
            device.set_volume_limit(memory_limit);
            let falls_back = by_itself && device.name() != "cpu";
            let renderer = Renderer::new(device, data.assets.clone());
            let renderer = if falls_back { renderer.with_fallback(Box::new(move |_| open_cpu())) } else { renderer };
            Ok(State { renderer, data })
        })?;
        Ok(Self { process: std::process::id(), state: Mutex::new(Some(state)) })
    }

    /// Renders a scene, with the outputs of these names, or all. `progress` is called with the stage, the units done and all units.
    #[pyo3(signature = (scene, outputs = None, progress = None))]
    fn render(
        &self,
        py: Python<'_>,
        scene: &Scene,
        outputs: Option<Vec<String>>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Frame> {
        let scene = scene.0.clone();
        let request = self::outputs(outputs.as_deref(), &scene)?;
        work::run(py, progress, |progress| {
            self.with(|State { renderer, data }| {
                if data.follow(&scene)? {
                    renderer.show(data.assets.clone());
                }
                let frame = renderer.render(&scene, request, progress)?;
                let overlay = Overlay::framed::<Failure>(&scene, &data.assets)?;
                Ok(Frame { frame, scene, overlay })
            })
        })
    }

    /// The scene with a camera that keeps its distance all the way round.
    fn framed_all_round(&self, py: Python<'_>, scene: &Scene) -> PyResult<Scene> {
        let scene = scene.0.clone();
        let framed = work::run(py, None, |_| {
            self.with(|State { data, .. }| {
                data.follow(&scene)?;
                Ok(framed_all_round(&scene, &data.assets)?)
            })
        })?;
        Ok(Scene(framed))
    }

    /// `cpu` or `gpu`, and the device's name.
    fn device(&self, py: Python<'_>) -> PyResult<(&'static str, String)> {
        let device = py.detach(|| {
            self.with(|State { renderer, .. }| Ok((renderer.backend().name(), renderer.backend().adapter())))
        })?;
        Ok(device)
    }

    /// Gives device and data back, after work that is under way.
    fn close(&self, py: Python<'_>) {
        if self.process == std::process::id() {
            py.detach(|| drop(self.state.lock().unwrap_or_else(PoisonError::into_inner).take()));
        }
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        // A forked process must not end threads and devices that are its parent's.
        if self.process != std::process::id() {
            std::mem::forget(self.state.get_mut().unwrap_or_else(PoisonError::into_inner).take());
        }
    }
}
