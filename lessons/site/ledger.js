// A line that filters the rows of the ledger.
{
  /** @type {{heading: ?Element, parts: Element[], text: string}[]} */
  const rows = [];
  /** @type {?Element} */
  let heading = null;
  for (const part of document.querySelector("main")?.children ?? []) {
    if (part.matches("h2")) heading = part;
    else if (part.matches(".ledger")) rows.push({ heading, parts: [part], text: "" });
    else if (heading && rows.length > 0) rows[rows.length - 1].parts.push(part);
  }
  for (const row of rows) row.text = row.parts.map((part) => part.textContent).join(" ").toLowerCase();
  const box = document.createElement("p");
  box.className = "filter";
  box.innerHTML = '<label>Show rows with <input type="search" placeholder="17b, refuted, theta …"></label> ' +
    '<span role="status"></span>';
  document.querySelector("h2")?.before(box);
  const line = /** @type {HTMLInputElement} */ (box.querySelector("input"));
  const filter = () => {
    const words = line.value.toLowerCase().split(/\s+/);
    const shown = rows.filter(({ text }) => words.every((word) => text.includes(word)));
    const headings = new Set(shown.map((row) => row.heading));
    for (const row of rows) {
      const isHidden = !shown.includes(row);
      for (const part of row.parts) part.toggleAttribute("hidden", isHidden);
      row.heading?.toggleAttribute("hidden", !headings.has(row.heading));
    }
    /** @type {HTMLElement} */ (box.querySelector("[role=status]")).textContent = `${shown.length} of ${rows.length} rows`;
  };
  line.addEventListener("input", filter);
  filter();
}
