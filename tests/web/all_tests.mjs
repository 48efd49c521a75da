// Tests of the page and of the site: node all_tests.mjs ROOT [NAME]; ./dev web test. They end with "N passed, N failed".
import "./page_test.mjs";
import "./editor_test.mjs";
import "./phone_test.mjs";
import "./kept_test.mjs";
import "./long_test.mjs";
import "./site_test.mjs";
import "./scripts_test.mjs";
import "./firefox_test.mjs";
import { runAll } from "./suite.mjs";

await runAll(process.argv[3] ?? "");
