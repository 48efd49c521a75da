// The lessons and exercises that come with the program, as page.js reads them: node bundle_lessons.mjs LESSONS
import { readdirSync, readFileSync } from "node:fs";
import { join, relative } from "node:path";

const COURSE = "/course";
const [, , folder] = process.argv;

function filesBelow(path) {
  return readdirSync(path, { withFileTypes: true }).sort((a, b) => (a.name < b.name ? -1 : 1)).flatMap((entry) => {
    const below = join(path, entry.name);
    if (entry.isDirectory()) { return filesBelow(below); }
    return entry.name.endsWith(".toml") ? [below] : [];
  });
}

const files = {};
for (const part of ["catalogue", "exercises"]) {
  for (const file of filesBelow(join(folder, part))) {
    files[`${COURSE}/${relative(folder, file)}`] = readFileSync(file, "utf8");
  }
}
process.stdout.write(JSON.stringify({ lessons: `${COURSE}/catalogue`, files }));
