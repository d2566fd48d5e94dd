// What tests of laws share: laws that a page or a server keeps: each is tried, whatever became of the others.

/** Runs them in turn, says which hold, then `end`, and ends the program: with status 1 where one failed. */
export async function tryLaws(laws, end = async () => {}) {
  let failed = 0;
  for (const [law, run] of Object.entries(laws)) {
    try {
      await run();
      console.log("ok      %s", law);
    } catch (error) {
      ++failed;
      console.log("FAILED  %s\n%s", law, error.stack);
    }
  }
  await end();
  console.log("%d failed", failed);
  process.exit(failed === 0 ? 0 : 1);
}
