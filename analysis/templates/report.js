"use strict";
/* Sorts and filters the tables of class "sortable", a tbody for each entry; opens what an address points to. */
(() => {
  const text = (cell) => cell.dataset.sort ?? cell.textContent.trim();

  function compare(a, b) {
    const x = parseFloat(a), y = parseFloat(b);
    if (!Number.isNaN(x) && !Number.isNaN(y)) return x - y;
    if (Number.isNaN(x) !== Number.isNaN(y)) return Number.isNaN(x) ? 1 : -1;
    return a.localeCompare(b);
  }

  function sort(table, head, column) {
    const down = head.getAttribute("aria-sort") !== "descending";
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    const entries = [...table.tBodies];
    const value = (entry) => text(entry.rows[0].cells[column]);
    entries.sort((a, b) => (down ? -1 : 1) * compare(value(a), value(b)));
    table.append(...entries);
  }

  function choice(table, column, label) {
    const select = document.createElement("select");
    select.setAttribute("aria-label", label);
    const names = new Set([...table.tBodies].map((entry) => text(entry.rows[0].cells[column])));
    select.append(new Option(`every ${label}`, ""), ...[...names].sort().map((name) => new Option(name, name)));
    return { select, column };
  }

  function filters(table) {
    const bar = document.createElement("div"), words = document.createElement("input"), count = document.createElement("span");
    bar.className = "filters";
    words.type = "search";
    words.placeholder = "filter";
    words.setAttribute("aria-label", "filter the rows by words");
    count.className = "soft";
    const heads = [...table.tHead.rows[0].cells];
    const choices = heads.flatMap((head, column) => head.dataset.choose ? [choice(table, column, head.dataset.choose)] : []);
    function apply() {
      const wanted = words.value.toLowerCase().split(/\s+/).filter(Boolean);
      let shown = 0;
      for (const entry of table.tBodies) {
        const row = entry.rows[0], all = row.textContent.toLowerCase();
        entry.hidden = !(wanted.every((word) => all.includes(word))
          && choices.every(({ select, column }) => !select.value || text(row.cells[column]) === select.value));
        shown += !entry.hidden;
      }
      count.textContent = `${shown} of ${table.tBodies.length}`;
    }
    bar.append(words, ...choices.map(({ select }) => select), count);
    bar.addEventListener("input", apply);
    (table.closest(".scroll") ?? table).before(bar);
    apply();
  }

  for (const table of document.querySelectorAll("table.sortable")) {
    [...table.tHead.rows[0].cells].forEach((head, column) => {
      const button = document.createElement("button");
      button.append(...head.childNodes);
      button.addEventListener("click", () => sort(table, head, column));
      head.append(button);
    });
    filters(table);
  }

  function openTarget() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    for (let each = target; each; each = each.parentElement) if (each.tagName === "DETAILS") each.open = true;
    target.querySelector(":scope > tr > td > details")?.setAttribute("open", "");
    target.scrollIntoView({ block: "nearest" });
  }
  addEventListener("hashchange", openTarget);
  openTarget();
})();
