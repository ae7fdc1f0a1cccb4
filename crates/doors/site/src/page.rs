//! The files of the page.

/// Name and bytes of a file of a folder of this crate.
macro_rules! file {
    ($folder:literal, $name:literal) => {
        ($name, include_bytes!(concat!("../", $folder, "/", $name)).as_slice())
    };
}

macro_rules! page {
    ($name:literal) => {
        file!("page", $name)
    };
}

/// A file by its name.
pub type File = (&'static str, &'static [u8]);

/// The page's own files, whose machine is in a worker of its own.
const OWN: [File; 55] = [
    page!("block-card.js"),
    page!("compare.js"),
    page!("diagram-panel.js"),
    page!("diagram-plan.js"),
    page!("diagram.js"),
    page!("drive-pad.js"),
    page!("drives.js"),
    page!("driving.js"),
    page!("effects-panel.js"),
    page!("events-table.js"),
    page!("fault-board.js"),
    page!("fields.js"),
    page!("figure-kinds.js"),
    page!("figure-scenes.js"),
    page!("figures.css"),
    page!("figures.js"),
    page!("first.js"),
    page!("gallery.css"),
    page!("gallery.html"),
    page!("gallery.js"),
    page!("gamepad.js"),
    page!("here.js"),
    page!("home.js"),
    page!("icon.svg"),
    page!("in-words.js"),
    page!("index.html"),
    page!("instrument.css"),
    page!("instrument.html"),
    page!("instrument.js"),
    page!("journal.js"),
    page!("known.js"),
    page!("late-frames.js"),
    page!("link.js"),
    page!("loop-keeper.js"),
    page!("lunoid.d.ts"),
    page!("lunoid.js"),
    page!("message.js"),
    page!("module.js"),
    page!("opening.js"),
    page!("panels.js"),
    page!("picture.js"),
    page!("shipped.js"),
    page!("slow-motion.js"),
    page!("socket-home.js"),
    page!("style.css"),
    page!("tasks.js"),
    page!("time-bar.js"),
    page!("time-panel.js"),
    page!("trigger-panel.js"),
    page!("trigger.js"),
    page!("tube.js"),
    page!("turns.js"),
    page!("view-model.js"),
    page!("worker-home.js"),
    page!("worker.js"),
];

/// All files of the page: its own, and those of its scope.
pub fn page() -> impl Iterator<Item = File> {
    OWN.into_iter().chain(scope::LIVE.map(|(name, text)| (name, text.as_bytes())))
}

/// The files that a program serves in place of those of [`page`], so that the page reaches the program.
pub const OF_A_PROGRAM: [File; 1] = [file!("drive", "here.js")];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_of_the_folders_is_in_the_lists() {
        let listed = |files: &[File]| files.iter().map(|(name, _)| (*name).to_owned()).collect::<Vec<_>>();
        for (folder, files) in [("page", &OWN[..]), ("drive", &OF_A_PROGRAM)] {
            let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
            assert_eq!(files::names_in(&path), listed(files), "{folder}");
        }
        assert!(listed(&OWN).contains(&"here.js".to_owned()), "the program's file replaces one of the page");
    }
}
