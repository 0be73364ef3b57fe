// against_dolos.mjs FOLDER: compares our likeness with that of Dolos (https://dolos.ugent.be) on the pairs in FOLDER. To make them, and to have Dolos
// (its parsers are compiled, which takes minutes):
//   FIRSTLIGHT_COPIES=/tmp/copies build/check/tests/test_report --gtest_filter=Sketch.tells*
//   npm install @dodona/dolos-lib    # in the folder from which this is run
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const { Dolos } = await import(pathToFileURL(createRequire(process.cwd() + "/").resolve("@dodona/dolos-lib")));

// The share of the file that has fewer prints, without the stub's, as ours; and the similarity that Dolos shows.
async function alike(folder) {
  const dolos = new Dolos({ language: "cpp" });
  const report = await dolos.analyzePaths([folder + "/a.cpp", folder + "/b.cpp"], folder + "/stub.cpp");
  const [pair] = report.allPairs();
  return pair === undefined ? 0 : pair.similarity;
}

const values = { ours: {}, Dolos: {} };
for (const line of readFileSync(process.argv[2] + "/pairs.txt", "utf8").trim().split("\n")) {
  const [kind, folder, share] = line.split("\t");
  (values.ours[kind] ??= []).push(Number(share));
  (values.Dolos[kind] ??= []).push(await alike(folder));
}
for (const [tool, kinds] of Object.entries(values)) {
  const independent = kinds.independent;
  const most = Math.max(...independent);
  console.log(`${tool}: ${independent.length} independent pairs, at most ${most.toFixed(2)} alike`);
  for (const [kind, copies] of Object.entries(kinds)) {
    if (kind === "independent") continue;
    let won = 0;
    for (const copy of copies) for (const other of independent) won += copy > other ? 1 : copy === other ? 0.5 : 0;
    const area = won / (copies.length * independent.length);
    const found = copies.filter((copy) => copy > most).length;
    console.log(`  ${kind.padEnd(32)} area ${area.toFixed(4)}, ${found} of ${copies.length} above every independent pair`);
  }
}
