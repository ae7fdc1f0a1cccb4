// The tasks of the lessons: each is solved by its right answer, and wrong ones are refused with a reason.

/** For each page of lessons, in the order of its tasks: the right answer, found with `lunoid probe` and `lunoid trace`, and wrong ones. */
const ANSWERS = {
  "book/lessons/fold.html": [{ right: "5", wrong: ["4", "6", "many", ""] }, { right: "21", wrong: ["20", "22", "20.5"] }],
  "book/lessons/overload.html": [{ right: "90", wrong: ["85", "95", "92"] }, { right: "295", wrong: ["294", "296"] }],
  "book/lessons/occlusion.html": [{ right: "6", wrong: ["5"] }, { right: "-0,0017", wrong: ["0.0017", "-0.0023"] }, { right: "100", wrong: ["90", "110"] }],
};

/** Solves the tasks of `pages`. */
export async function tasks(browser, host, pages, expect, record) {
  record.tasks = 0;
  expect(pages.join() === Object.keys(ANSWERS).sort().join(), `the lessons are those that have answers here: ${pages}`);
  for (const page of pages) {
    await browser.go(host.address + page);
    const count = await browser.script(`return document.querySelectorAll(".task").length;`);
    expect(count === ANSWERS[page].length, `${page} has ${count} tasks`);
    for (const [at, { right, wrong }] of ANSWERS[page].entries()) {
      for (const answer of [...wrong, right]) {
        const { state, says } = await answered(browser, at, answer);
        expect(state === (answer === right ? "right" : "wrong") && says.length > 20, `${page}, task ${at + 1}, "${answer}": ${says}`);
      }
      record.tasks += 1;
    }
  }
}

function answered(browser, at, answer) {
  return browser.script(
    `const task = document.querySelectorAll(".task")[values[0]];
     task.querySelector("input").value = values[1];
     task.querySelector("form").requestSubmit();
     for (let turn = 0; turn < 3000 && !["right", "wrong"].includes(task.dataset.state); turn += 1) await new Promise((resolve) => setTimeout(resolve, 40));
     const told = { state: task.dataset.state, says: task.querySelector("[role=status]").textContent };
     delete task.dataset.state;
     return told;`,
    at,
    answer,
  );
}
