// A folder of the program that outlives the visit, in the storage of the browser: a key for each file, since other tabs
// of the same page keep theirs there, too.

const KEY = "jointwise-file:";
// all files in one text, as pages of before kept them
const OLD_KEY = "jointwise-files";
/** Texts as they stand in the storage, by their paths. */
const kept = new Map();

/** Settings and the like; undefined where the storage is forbidden, or holds something else. */
export function stored(key) {
  try {
    return JSON.parse(localStorage.getItem(key)) ?? undefined;
  } catch { return undefined; }
}
/** @return false if the storage is full or forbidden */
export function store(key, value) {
  try {
    localStorage.setItem(key, value);
    return true;
  } catch { return false; }
}

function storedFiles() {
  const files = {};
  try {
    for (let k = 0; k < localStorage.length; ++k) {
      const key = localStorage.key(k);
      if (key.startsWith(KEY)) { files[key.slice(KEY.length)] = localStorage.getItem(key); }
    }
  } catch { /* forbidden: nothing is kept */ }
  return files;
}

export function restoreFolder(FS, folder) {
  FS.mkdirTree(folder);
  const isText = ([path, text]) => path.startsWith(`${folder}/`) && !path.includes("/..") && typeof text === "string";
  writeFiles(FS, Object.fromEntries(Object.entries(stored(OLD_KEY) ?? {}).filter(isText)));
  const files = Object.entries(storedFiles()).filter(isText);
  writeFiles(FS, Object.fromEntries(files));
  for (const [path, text] of files) { kept.set(path, text); }
  // another tab has written
  window.addEventListener("storage", ({ key, newValue }) => {
    const path = key?.startsWith(KEY) ? key.slice(KEY.length) : "";
    if (!isText([path, newValue ?? ""])) { return; }
    if (newValue === null) {
      kept.delete(path);
      if (FS.analyzePath(path).exists) { FS.unlink(path); }
    } else {
      kept.set(path, newValue);
      writeFiles(FS, { [path]: newValue });
    }
  });
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

/** Writes what has changed since. @return false if the storage is full or forbidden */
export function keepFolder(FS, folder) {
  const now = filesBelow(FS, folder);
  let all = true;
  for (const [path, text] of Object.entries(now)) {
    if (kept.get(path) === text) { continue; }
    if (store(KEY + path, text)) { kept.set(path, text); } else { all = false; }
  }
  for (const path of kept.keys()) {
    if (path in now) { continue; }
    localStorage.removeItem(KEY + path);
    kept.delete(path);
  }
  if (all && stored(OLD_KEY)) { localStorage.removeItem(OLD_KEY); }
  return all;
}
