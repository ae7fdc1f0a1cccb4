use shard::Shard;

#[test]
fn shards_are_numbered_from_one() {
    let shard: Shard = "3/7".parse().expect("a shard");
    assert_eq!((shard.number(), shard.of(), shard.to_string()), (3, 7, "3/7".into()));
    assert_eq!(Shard::new(1, 1).map(|shard| shard.to_string()), Some("1/1".into()));
    for wrong in [
        "5/4",
        "0/4",
        "1/0",
        "0/0",
        "",
        "/",
        "3",
        "3/",
        "/7",
        "-1/4",
        "+1/4",
        "1/4/2",
        "1.0/4",
        " 1/4",
        "auto",
        "1/4294967296",
    ] {
        let said = wrong.parse::<Shard>().expect_err(wrong).to_string();
        assert_eq!(said, format!("expected K/N with 1 <= K <= N, as 3/7, or auto, not `{wrong}`"));
    }
}
