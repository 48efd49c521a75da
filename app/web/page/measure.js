// A copy of the program that measures what a digit costs, in a thread of the browser: the picture goes on meanwhile.
import createJointwise from "./jointwise.js";

self.addEventListener("message", async ({ data: { number, lesson, treatment } }) => {
  const tell = (news) => self.postMessage({ number, news });
  try {
    const module = await createJointwise({ page: { tellMeasured: tell } });
    module.ccall("jw_measure", null, ["string", "string"], [lesson, treatment]);
  } catch (error) {
    tell(JSON.stringify({ runs: [], origin: "", failure: String(error?.message ?? error), done: true }));
  }
});
