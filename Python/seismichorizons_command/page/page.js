// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a report does without its meshes: it sorts its table, finds names in it, and opens what a link leads to.
(() => {
  "use strict";

  const table = document.getElementById("table");
  const rows = table ? Array.from(table.tBodies[0].rows) : [];

  function valueOf(row, column) {
    const text = row.cells[column].dataset.value;
    return column === 0 ? text : text === "" ? null : Number(text);
  }

  // Rows without a value come last both ways; equal ones stay in the order that they had at first.
  function sort(column, ascending) {
    const compare = column === 0
      ? (a, b) => a.localeCompare(b, undefined, { numeric: true })
      : (a, b) => a - b;
    const sorted = rows.map((row) => [valueOf(row, column), row]).sort(([a], [b]) => {
      if (a === null || b === null) {
        return (a === null) - (b === null);
      }
      return ascending ? compare(a, b) : compare(b, a);
    });
    table.tBodies[0].append(...sorted.map(([, row]) => row));
  }

  if (table) {
    const heads = Array.from(table.tHead.rows[0].cells);
    heads.forEach((head, column) => {
      head.querySelector("button").addEventListener("click", () => {
        // Numbers are of interest from the largest on, names from the first.
        const known = head.getAttribute("aria-sort");
        const ascending = known ? known === "descending" : column === 0;
        heads.forEach((other) => other.removeAttribute("aria-sort"));
        head.setAttribute("aria-sort", ascending ? "ascending" : "descending");
        sort(column, ascending);
      });
    });
  }

  const filter = document.getElementById("filter");
  if (filter) {
    filter.addEventListener("input", () => {
      const wanted = filter.value.toLowerCase();
      const shown = rows.filter((row) => {
        row.hidden = !row.cells[0].dataset.value.toLowerCase().includes(wanted);
        return !row.hidden;
      });
      document.getElementById("filtered").textContent = wanted ? `${shown.length} of ${rows.length}` : "";
    });
  }

  function openTarget() {
    const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (target && target.tagName === "DETAILS") {
      target.open = true;
      target.scrollIntoView();
    }
  }
  window.addEventListener("hashchange", openTarget);
  document.addEventListener("click", (event) => {
    // A second click on the same link changes nothing in the address.
    const link = event.target.closest('a[href^="#"]');
    if (link && link.hash === location.hash) {
      openTarget();
    }
  });
  openTarget();

  // On paper nothing can be opened: what was read and what has pictures is.
  let opened = [];
  window.addEventListener("beforeprint", () => {
    opened = Array.from(document.querySelectorAll("details:not([open])")).filter(
      (details) => details.className === "file" || details.querySelector("img"));
    opened.forEach((details) => { details.open = true; });
    document.querySelectorAll("img[loading]").forEach((image) => image.removeAttribute("loading"));
  });
  window.addEventListener("afterprint", () => opened.forEach((details) => { details.open = false; }));
})();
