use std::fs;

use serde_json::Value;

use crate::scene::Scene;

fn looked(scene: &Scene, code: i32, more: &[&str]) -> Value {
    let (out, _) = scene.expect(code, &[&["farm", "status", "runs", "--json"], more].concat());
    serde_json::from_str(&out).unwrap()
}

#[test]
fn a_folder_says_how_far_its_shards_are() {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml", "--no-page", "--truth", "range", "--shard", "2/3"]);
    let (out, _) = scene.expect(0, &["farm", "status", "runs"]);
    assert!(out.starts_with("tiny: 3 shards: 1 done, 2 waiting\n1 of 4 frames\n"), "{out}");
    let document = looked(&scene, 0, &[]);
    assert_eq!(document["schema"], "lunoid.farm-status/1");
    let run = &document["runs"][0];
    assert_eq!(
        (&run["run"], &run["frames"], &run["done"]),
        (&"tiny".into(), &serde_json::json!([0, 4]), &1.into())
    );
    let shard = &run["shards"][1];
    assert_eq!((&shard["shard"], &shard["state"]), (&"2/3".into(), &"done".into()));
    assert_eq!((&shard["range"], &shard["done"]), (&serde_json::json!([1, 2]), &1.into()));
    // Without the truth that its command asks for the shard is not done.
    fs::remove_file(scene.join("runs/tiny-shard-2-of-3/truth/truth.json")).unwrap();
    assert_eq!(looked(&scene, 0, &[])["runs"][0]["shards"][1]["state"], "stale");
    // A shard that was set aside is an answer of no, and the watch ends by itself.
    for number in [1, 2, 3] {
        let note = serde_json::json!({ "schema": "lunoid.farm.failed/1", "tries": 3, "why": "no room", "command": "c" });
        scene.write(&format!("runs/tiny-shard-{number}-of-3.failed.json"), note.to_string());
    }
    let document = looked(&scene, 1, &["--watch"]);
    assert_eq!(document["runs"][0]["shards"][0]["why"], "no room");
    let (_, said) = scene.expect(3, &["farm", "status", "gone"]);
    assert!(said.contains("gone: cannot list the folder"), "{said}");
}

#[test]
fn a_journal_says_what_its_shard_is_to_draw() {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml", "--no-page", "--shard", "1/2"]);
    // What a worker leaves that is killed before the record is written.
    let folder = scene.join("runs/tiny-shard-1-of-2");
    let run: Value = serde_json::from_slice(&fs::read(folder.join("run.json")).unwrap()).unwrap();
    let heading = serde_json::json!({
        "schema": "lunoid.journal/1", "fingerprint": run["fingerprint"], "of": {},
        "span": { "range": run["range"], "shard": run["shard"] },
    });
    fs::write(folder.join("frames.journal"), format!("{heading}\n")).unwrap();
    fs::remove_file(folder.join("run.json")).unwrap();
    let document = looked(&scene, 0, &[]);
    let run = &document["runs"][0];
    assert_eq!((&run["frames"], &run["done"]), (&serde_json::json!([0, 4]), &0.into()));
    assert_eq!(
        (&run["shards"][0]["state"], &run["shards"][0]["range"]),
        (&"stale".into(), &serde_json::json!([0, 2]))
    );
}

#[test]
fn a_variable_names_the_shadow_cache_and_no_word_of_the_run_does() {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml", "--out", "plain"]);
    let mut command = crate::scene::lunoid();
    command.current_dir(scene.path()).env("LUNOID_SHADOW_CACHE", "shadows");
    command.args(["replay", "tiny.toml", "--out", "cached"]).assert().success();
    assert!(scene.join("shadows").is_dir());
    for name in ["run.json", "page.json", "index.html"] {
        let [plain, cached] =
            ["plain", "cached"].map(|folder| fs::read(scene.join(folder).join(name)).unwrap());
        assert!(plain == cached, "{name} differs");
    }
}
