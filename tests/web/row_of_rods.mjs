/**
 * A lesson of rods in a row, hinged one to the next: as large as a test wants it.
 * @param apart  [m] distance of every second rod from its place: the story takes four times as long
 */
export function rowOfRods(count, apart = 0) {
  const lines = ["format = 1", 'title = "A row of rods"', 'text = "As long as one likes."'];
  for (let k = 0; k < count; ++k) {
    lines.push("[[body]]", `name = "rod ${k}"`, `position = [${k}.5, 0, ${k % 2 * apart}]`);
  }
  for (let k = 0; k < count; ++k) {
    lines.push("[[joint]]", `name = "joint ${k}"`, 'type = "revolute"', `bodies = [${k === 0 ? '"ground"' : `"rod ${k - 1}"`}, "rod ${k}"]`);
    lines.push(`point_i = [${k === 0 ? 0 : 0.5}, 0, 0]`, "point_j = [-0.5, 0, 0]", "axis_i = [0, 1, 0]", "axis_j = [0, 1, 0]");
  }
  return lines.join("\n");
}
