// Sorts the table by the column whose head is pressed; again, the other way round. A submission without points comes
// last. Without this script the rows are in alphabetical order.
document.documentElement.classList.add("scripted");
const table = document.querySelector(".class");
const collator = new Intl.Collator(undefined, { numeric: true });
let sorted = { column: 0, turn: 1 };
const value = (row, column) => {
  const cell = row.cells[column];
  if (!cell || (column > 1 && row.querySelector(".problem"))) return null;
  return cell.dataset.value ?? cell.textContent.trim();
};
const heads = [...table.tHead.rows[0].cells];
heads.forEach((head, column) => {
  head.querySelector("button").addEventListener("click", () => {
    sorted = { column, turn: sorted.column === column ? -sorted.turn : 1 };
    const body = table.tBodies[0];
    const rows = [...body.rows];
    rows.sort((a, b) => {
      const left = value(a, column), right = value(b, column);
      if (left === null || right === null) return (left === null) - (right === null);
      return sorted.turn * collator.compare(left, right);
    });
    body.append(...rows);
    heads.forEach((other) => other.removeAttribute("aria-sort"));
    head.setAttribute("aria-sort", sorted.turn > 0 ? "ascending" : "descending");
  });
});
