//! Reading files, in threads of their own.

use crate::document::{Document, next_number};
use crate::trouble::Trouble;
use crate::worker::{Data, Wake};
use std::path::Path;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread::Builder;
use vitrum::Assets;
use vitrum::scene::Scene;

/// What is to be read.
#[derive(Debug, Clone)]
pub enum Request {
    /// An input, with a picture of this size, or of the scene's own.
    Open(String, Option<[u32; 2]>),
    /// A scene that was saved by itself, with the name of its input.
    Restore {
        /// The name of the input.
        input: String,
        /// The scene's text.
        scene: String,
    },
    /// The data of a scene whose files have changed.
    Data(Box<Scene>),
}

/// What was read.
pub enum Loaded {
    /// A document.
    Document(Box<Document>),
    /// Data of the document that is open.
    Data(Data),
}

/// A reading that is under way.
pub struct Loading {
    /// What is read, for people.
    pub name: String,
    outcome: Receiver<Result<Loaded, Trouble>>,
}

impl Loading {
    /// Starts to read. `wake` is called at the end.
    ///
    /// # Errors
    /// Where the system starts no thread.
    pub fn start(request: Request, wake: Wake) -> Result<Self, Trouble> {
        let name = match &request {
            Request::Open(input, _) | Request::Restore { input, .. } => input.clone(),
            Request::Data(_) => "the scene's files".to_owned(),
        };
        let (sender, outcome) = channel();
        let work = move || {
            // Nobody waits for a reading that was given up.
            let _ = sender.send(load(request));
            wake();
        };
        let started = Builder::new().name("vitrum-loader".to_owned()).spawn(work);
        started.map_err(|error| Trouble::new(format!("no thread can be started: {error}"), "close other programs"))?;
        Ok(Self { name, outcome })
    }

    /// What was read, once it is there.
    pub fn poll(&self) -> Option<Result<Loaded, Trouble>> {
        match self.outcome.try_recv() {
            Ok(outcome) => Some(outcome),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => {
                let help = "try another file, and report this one";
                Some(Err(Trouble::new(format!("{}: the reader met a fault of its own", self.name), help)))
            }
        }
    }
}

fn load(request: Request) -> Result<Loaded, Trouble> {
    match request {
        Request::Open(input, size) => Ok(Loaded::Document(Box::new(Document::open(&input, size)?))),
        Request::Restore { input, scene } => Ok(Loaded::Document(Box::new(Document::restore(&input, &scene)?))),
        Request::Data(scene) => {
            let assets = Assets::load(&scene, Path::new(""))?;
            vitrum::check(&scene, &assets)?;
            Ok(Loaded::Data(Data { assets, number: next_number() }))
        }
    }
}
