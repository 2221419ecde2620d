//! A check as JUnit XML: failures, refusals, and what XML cannot hold.

use corput::check::{Further, Row, Verdict, junit};

#[test]
fn every_end_of_a_row_is_told() {
    let mut passed = Row::exact("passed", "evaluate");
    passed.count(true, String::new);
    let mut failed = Row::exact("failed <\"&>", "evaluate");
    failed.count(false, || "0: 1, not \"2\" <\u{1}".to_owned());
    let mut refused = Row::exact("refused", "evaluate_frame");
    refused.verdict = Verdict::Refused("no & promise".into());
    let mut defect = Row::native(
        "native_exp",
        "function_native",
        1.0,
        "of what Vulkan allows",
    );
    defect.count(true, String::new);
    defect.worst = Some(1.5);
    defect.witness = "x = 2".into();
    let defect = defect.judged_of_driver();
    assert_eq!(defect.verdict, Verdict::Defect);
    let rows = [passed.judged(), failed.judged(), refused, defect];
    let why = Some("1 < 2".to_owned());
    let further =
        [(None, None), (why.clone(), None), (None, why)].map(|(failure, skipped)| Further {
            class: "statistics",
            name: "slope".into(),
            failure,
            skipped,
        });
    let xml = junit(&rows, &["later".to_owned()], &further, "a \"device\"");
    for part in [
        "tests=\"8\" failures=\"2\" errors=\"0\" skipped=\"4\"",
        "a &quot;device&quot;",
        "<testcase classname=\"exact.evaluate\" name=\"passed\" time=\"0.000\"></testcase>",
        "name=\"failed &lt;&quot;&amp;&gt;\"",
        "<failure message=\"1 of 1 differ; worst error -, bound -\">0: 1, not &quot;2&quot; &lt; </failure>",
        "<skipped message=\"no &amp; promise\"/>",
        "<skipped message=\"the driver's defect: 1.5e0 of what Vulkan allows at x = 2\"/>",
        "<testcase classname=\"statistics\" name=\"slope\"></testcase>",
        "name=\"slope\"><failure message=\"1 &lt; 2\"/></testcase>",
        "name=\"slope\"><skipped message=\"1 &lt; 2\"/></testcase>",
        "<testcase classname=\"left out\" name=\"later\"><skipped message=\"no time was left\"/></testcase>",
    ] {
        assert!(xml.contains(part), "{part} is not in\n{xml}");
    }
}
