use shard::{Shard, from_environment};

/// What an environment of these variables names: a shard, or why there is none.
fn of(variables: &[(&str, &str)]) -> Result<String, String> {
    let get =
        |name: &str| variables.iter().find(|(known, _)| *known == name).map(|(_, value)| (*value).to_owned());
    from_environment(get).map(|shard: Shard| shard.to_string()).map_err(|error| error.to_string())
}

/// A task of a Slurm array.
fn slurm(task: &str, [least, most, count]: [&str; 3], shards: &str) -> Result<String, String> {
    of(&[
        ("SLURM_ARRAY_TASK_ID", task),
        ("SLURM_ARRAY_TASK_MIN", least),
        ("SLURM_ARRAY_TASK_MAX", most),
        ("SLURM_ARRAY_TASK_COUNT", count),
        ("LUNOID_SHARDS", shards),
    ])
}

#[test]
fn tasks_of_a_whole_array_are_the_shards() {
    let named = |first: u32, last: u32| -> Vec<_> {
        let [least, most, count] = [first, last, last - first + 1].map(|number| number.to_string());
        (first..=last).map(|task| slurm(&task.to_string(), [&least, &most, &count], "").unwrap()).collect()
    };
    assert_eq!(named(1, 4), ["1/4", "2/4", "3/4", "4/4"]);
    assert_eq!(named(0, 2), ["1/3", "2/3", "3/3"]);
}

#[test]
fn parts_of_an_array_need_the_number_of_shards() {
    for (task, [least, most, count]) in
        [("3", ["3", "3", "1"]), ("5", ["3", "5", "2"]), ("4", ["0", "6", "4"]), ("1", ["1", "7", "3"])]
    {
        let said = slurm(task, [least, most, count], "").unwrap_err();
        assert!(said.contains(&format!("not {count} tasks from {least} to {most}")), "{said}");
        assert!(said.contains("LUNOID_SHARDS=7"), "{said}");
        assert_eq!(slurm(task, [least, most, count], "7"), Ok(format!("{task}/7")));
    }
    let said = slurm("0", ["0", "6", "7"], "7").unwrap_err();
    assert!(
        said.starts_with("SLURM_ARRAY_TASK_ID=0: expected 1 to 7, because LUNOID_SHARDS is 7;"),
        "{said}"
    );
    let said = slurm("8", ["1", "8", "8"], "7").unwrap_err();
    assert!(said.starts_with("SLURM_ARRAY_TASK_ID=8: expected 1 to 7"), "{said}");
    let said = slurm("9", ["1", "4", "4"], "").unwrap_err();
    assert!(said.starts_with("SLURM_ARRAY_TASK_ID=9: "), "{said}");
}

#[test]
fn indices_of_a_job_begin_at_zero() {
    let pod = |index, shards| of(&[("JOB_COMPLETION_INDEX", index), ("LUNOID_SHARDS", shards)]);
    assert_eq!((pod("0", "4"), pod("3", "4")), (Ok("1/4".into()), Ok("4/4".into())));
    let said = pod("4", "4").unwrap_err();
    assert!(
        said.starts_with("JOB_COMPLETION_INDEX=4: expected 0 to 3, because LUNOID_SHARDS is 4;"),
        "{said}"
    );
    assert!(pod("0", "").unwrap_err().starts_with("found no LUNOID_SHARDS in the environment; set it to "));
    assert!(pod("0", "0").unwrap_err().starts_with("LUNOID_SHARDS=0: expected a whole number from 1 on"));
    for wrong in ["x", "-1", "1.5", "99999999999"] {
        let said = pod(wrong, "4").unwrap_err();
        assert!(said.starts_with(&format!("JOB_COMPLETION_INDEX={wrong}: expected ")), "{said}");
    }
}

#[test]
fn an_environment_of_no_job_or_of_two_names_no_shard() {
    let said = of(&[("LUNOID_SHARDS", "4")]).unwrap_err();
    assert!(said.starts_with("found neither SLURM_ARRAY_TASK_ID nor JOB_COMPLETION_INDEX"), "{said}");
    let said = of(&[("SLURM_ARRAY_TASK_ID", "1"), ("JOB_COMPLETION_INDEX", "0")]).unwrap_err();
    assert!(said.starts_with("found both SLURM_ARRAY_TASK_ID and JOB_COMPLETION_INDEX"), "{said}");
    let said = of(&[("SLURM_ARRAY_TASK_ID", "1")]).unwrap_err();
    assert!(said.starts_with("found no SLURM_ARRAY_TASK_MIN in the environment"), "{said}");
}
