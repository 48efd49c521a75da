// A folder of the program that outlives the visit, in the storage of the browser.

const KEY = "jointwise-files";

export function restoreFolder(FS, folder) {
  FS.mkdirTree(folder);
  let files = {};
  try {
    files = JSON.parse(localStorage.getItem(KEY) ?? "{}");
  } catch { return; }
  writeFiles(FS, files);
}

/** Writes files of the program: texts or bytes by their paths. */
export function writeFiles(FS, files) {
  for (const [path, content] of Object.entries(files)) {
    FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
    FS.writeFile(path, content);
  }
}

function filesBelow(FS, folder, found = {}) {
  for (const name of FS.readdir(folder)) {
    if (name === "." || name === "..") { continue; }
    const path = `${folder}/${name}`;
    if (FS.isDir(FS.stat(path).mode)) { filesBelow(FS, path, found); } else {
      found[path] = FS.readFile(path, { encoding: "utf8" });
    }
  }
  return found;
}

export function keepFolder(FS, folder) {
  const now = JSON.stringify(filesBelow(FS, folder));
  if (now === keepFolder.before) { return; }
  keepFolder.before = now;
  try {
    localStorage.setItem(KEY, now);
  } catch { /* storage is full or forbidden: the visit goes on without it */ }
}
