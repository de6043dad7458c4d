//! The course of the thread: task by task.

use super::device::DeviceOptions;
use super::ladder::{Rung, ladder};
use super::mailbox::{Mailbox, Newer, Task};
use super::pace::{Pace, TARGET};
use super::picture::{Shown, shown};
use super::request::{Data, Export, Reply, Sketch, SketchSubject, View, Wake};
use crate::document::with_preset;
use crate::trouble::Trouble;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;
use vitrum::backend::Choice;
use vitrum::composition::{Composed, Composition, Quality};
use vitrum::io::{WriteOptions, stage_picture_with};
use vitrum::scene::Scene;
use vitrum::{Frame, Layers, OutputRequest, Progress, Renderer};
use vitrum_annotations::{Overlay, file_picture, layers_of};

/// A picture that follows the hand is given up for a newer one only after so many times as long as it may take: else a slow machine would show none.
const PATIENCE: f64 = 4.0;

/// The renderer, and what it was opened for.
struct Open {
    renderer: Renderer,
    choice: Choice,
    data: u64,
}

/// The thread's state.
pub(super) struct Course {
    pub(super) mailbox: Arc<Mailbox>,
    progress: Arc<Mutex<Option<Progress>>>,
    replies: Sender<Reply>,
    wake: Wake,
    options: DeviceOptions,
    open: Option<Open>,
    pace: Pace,
    /// About how many seconds a pixel takes at rest, of the data that is shown.
    seconds_per_pixel: f64,
}

/// Why a picture is not there: given up, or failed.
pub(super) enum End {
    GivenUp,
    Failed(Trouble),
}

impl<E: Into<Trouble>> From<E> for End {
    fn from(error: E) -> Self {
        let trouble = error.into();
        if trouble.is_cancelled { Self::GivenUp } else { Self::Failed(trouble) }
    }
}

impl Course {
    pub fn new(
        mailbox: Arc<Mailbox>,
        progress: Arc<Mutex<Option<Progress>>>,
        replies: Sender<Reply>,
        wake: Wake,
        options: DeviceOptions,
    ) -> Self {
        let pace = Pace::default();
        Self { mailbox, progress, replies, wake, options, open: None, pace, seconds_per_pixel: 2e-6 }
    }

    pub fn run(mut self) {
        while let Some(task) = self.mailbox.take() {
            let number = match &task {
                Task::View(view) => Some(view.number),
                Task::Export(_) | Task::Animation(_) | Task::Sketch(_) => None,
            };
            // A fault of the program costs one picture, and not what the user has done.
            let done = catch_unwind(AssertUnwindSafe(|| self.work(task)));
            if done.is_err() {
                self.open = None;
                let trouble = Trouble::new(
                    "the renderer met a fault of its own",
                    "change the scene back, or try another backend",
                );
                match number {
                    Some(number) => self.reply(Reply::Failed { number, trouble }),
                    None => self.reply(Reply::NotExported { trouble: Some(trouble) }),
                }
            }
            self.tell(None);
        }
    }

    pub(super) fn reply(&self, reply: Reply) {
        // Without a window there is nobody to tell.
        let _ = self.replies.send(reply);
        (self.wake)();
    }

    fn tell(&self, progress: Option<Progress>) {
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner) = progress;
    }

    fn work(&mut self, task: Task) {
        match task {
            Task::View(view) => {
                let number = view.number;
                let outcome = if view.moving { self.follow(&view) } else { self.refine(&view) };
                if let Err(End::Failed(trouble)) = outcome {
                    self.reply(Reply::Failed { number, trouble });
                }
            }
            Task::Export(export) => {
                let outcome = self.export(&export);
                self.tell_exported(outcome, export.file);
            }
            Task::Animation(animation) => {
                let outcome = self.animate(&animation);
                self.tell_exported(outcome, animation.export.file);
            }
            Task::Sketch(sketch) => match self.sketch(&sketch) {
                Ok(shown) => self.reply(Reply::Sketched { name: sketch.name, shown: Some(shown) }),
                Err(End::GivenUp) => self.mailbox.put_back(sketch),
                Err(End::Failed(_)) => self.reply(Reply::Sketched { name: sketch.name, shown: None }),
            },
        }
    }

    fn tell_exported(&self, outcome: Result<(), End>, file: PathBuf) {
        self.reply(match outcome {
            Ok(()) => Reply::Exported { file },
            Err(End::GivenUp) => Reply::NotExported { trouble: None },
            Err(End::Failed(trouble)) => Reply::NotExported { trouble: Some(trouble) },
        });
    }

    /// One picture, as large as can be made in time.
    fn follow(&mut self, view: &View) -> Result<(), End> {
        self.open(view.backend, &view.data)?;
        let film = &view.scene.film;
        let whole = [film.width, film.height];
        let rung = self.pace.rung(whole);
        let start = Instant::now();
        let mailbox = Arc::clone(&self.mailbox);
        let number = view.data.number;
        let goes_on = move || match mailbox.newer(number) {
            Newer::None => true,
            Newer::Moving => start.elapsed().as_secs_f64() < PATIENCE * TARGET,
            Newer::AtRest => false,
        };
        let outcome = self.picture(view, rung, false, goes_on);
        let is_cut_short = matches!(&outcome, Err(End::GivenUp));
        let seconds = start.elapsed().as_secs_f64();
        if !is_cut_short || seconds > TARGET {
            self.pace.took(seconds, whole);
        }
        outcome
    }

    /// The pictures up to the whole one.
    fn refine(&mut self, view: &View) -> Result<(), End> {
        self.open(view.backend, &view.data)?;
        let pixels = f64::from(view.scene.film.width) * f64::from(view.scene.film.height);
        let rungs = ladder(&view.scene, self.seconds_per_pixel * pixels);
        let last = rungs.len() - 1;
        for (index, rung) in rungs.into_iter().enumerate() {
            let mailbox = Arc::clone(&self.mailbox);
            let start = Instant::now();
            self.picture(view, rung, index == last, move || !mailbox.is_busy())?;
            let seconds = start.elapsed().as_secs_f64();
            self.seconds_per_pixel = seconds / rung.size.map(f64::from).iter().product::<f64>();
        }
        Ok(())
    }

    fn picture(
        &mut self,
        view: &View,
        rung: Rung,
        complete: bool,
        goes_on: impl Fn() -> bool + Send + Sync,
    ) -> Result<(), End> {
        let start = Instant::now();
        let scene = rung.of(&view.scene);
        let frame = self.frame(&scene, Layers::color(), goes_on)?;
        let statistics = Box::new(frame.statistics.clone());
        let shown = shown(frame, &scene, &view.data.assets)?;
        let seconds = start.elapsed().as_secs_f64();
        self.reply(Reply::Picture { number: view.number, shown, statistics, seconds, complete });
        Ok(())
    }

    /// A frame of the open data.
    pub(super) fn frame(
        &mut self,
        scene: &Scene,
        layers: Layers,
        goes_on: impl Fn() -> bool + Send + Sync,
    ) -> Result<Frame, End> {
        let told = Arc::clone(&self.progress);
        let Some(open) = &mut self.open else {
            return Err(End::Failed(Trouble::new("no device is open", "choose a backend")));
        };
        let request = OutputRequest { light: false, layers, ..OutputRequest::default() };
        let mut progress = |progress| {
            *told.lock().unwrap_or_else(PoisonError::into_inner) = Some(progress);
            goes_on()
        };
        Ok(open.renderer.render(scene, request, &mut progress)?)
    }

    /// Has the renderer show the data on the backend that is asked for.
    pub(super) fn open(&mut self, choice: Choice, data: &Data) -> Result<(), End> {
        match &mut self.open {
            Some(open) if open.choice == choice => {
                if open.data != data.number {
                    open.renderer.show(data.assets.clone());
                    open.data = data.number;
                    self.pace = Pace::default();
                }
            }
            _ => {
                self.open = None;
                let notes = (self.replies.clone(), Arc::clone(&self.wake));
                let renderer = self.options.renderer(choice, &data.assets, notes)?;
                self.open = Some(Open { renderer, choice, data: data.number });
                self.pace = Pace::default();
            }
        }
        Ok(())
    }

    fn export(&mut self, export: &Export) -> Result<(), End> {
        self.open(export.backend, &export.data)?;
        let mailbox = Arc::clone(&self.mailbox);
        let frame = self.frame(&export.scene, layers_of(&export.file), move || !mailbox.gives_export_up())?;
        let metadata = frame.metadata(&export.scene)?;
        let overlay = Overlay::framed::<End>(&export.scene, &export.data.assets)?;
        let picture = file_picture(frame, overlay.as_ref(), &export.file)?;
        stage_picture_with(&export.file, &picture, &metadata, &WriteOptions::default())?.put()?;
        Ok(())
    }

    fn sketch(&mut self, sketch: &Sketch) -> Result<Shown, End> {
        let mailbox = Arc::clone(&self.mailbox);
        let goes_on = move || !mailbox.is_busy();
        let (scene, data) = match &sketch.subject {
            SketchSubject::Preset(name, scene, data) => (with_preset(name, scene, &data.assets)?.0, data.clone()),
            SketchSubject::BuiltIn(name) => {
                let input = format!("builtin:{name}");
                // Coarse volumes are made in no time, and nothing gives their making up.
                let made = vitrum::composition::open(&input)?.scene.volume.builtin.is_some();
                let settings = if made { vec!["volume.resolution=64".to_owned()] } else { Vec::new() };
                let composition =
                    Composition { input, settings, quality: Some(Quality::Draft), ..Composition::default() };
                let Composed { scene, assets, .. } = composition.compose()?;
                // Numbers of documents count upwards from 0.
                (scene, Data { assets, number: u64::MAX })
            }
        };
        let choice = self.open.as_ref().map_or(Choice::Auto, |open| open.choice);
        if let Some(open) = &mut self.open
            && data.number == u64::MAX
        {
            // One built-in scene's number is as another's.
            open.data = 0;
        }
        self.open(choice, &data)?;
        let scene = Rung { size: sketch.size, single_rays: true, distance: 1.5, light_cells: Some(96) }.of(&scene);
        let frame = self.frame(&scene, Layers::color(), goes_on)?;
        Ok(shown(frame, &scene, &data.assets)?)
    }
}
