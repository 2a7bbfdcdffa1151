{
  const body = document.querySelector("tbody");
  const form = document.querySelector(".filters");
  const heads = [...document.querySelectorAll("thead th")];
  const fields = ["search", "state", "task", "mistake"].map(id => document.getElementById(id));
  const shown = document.getElementById("shown");
  shown.append(document.getElementById("count-words").content);
  const count = shown.querySelector("b");

  const fold = text => text.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();
  const rows = [...body.rows].map(row => ({
    row,
    text: fold(row.cells[0].textContent + " " + row.cells[row.cells.length - 2].textContent),
    state: row.dataset.state.split(" "),
    lost: row.dataset.lost.split(" "),
    mistakes: [...row.cells[row.cells.length - 2].querySelectorAll("code")].map(code => code.textContent),
    keys: [...row.cells].map(cell => cell.textContent.trim()),
  }));

  const filter = () => {
    const [search, state, task, mistake] = fields.map(field => field.value);
    const words = fold(search).split(/\s+/).filter(word => word);
    let visible = 0;
    for (const entry of rows) {
      const fits = words.every(word => entry.text.includes(word)) && (!state || entry.state.includes(state)) &&
        (!task || entry.lost.includes(task)) && (!mistake || entry.mistakes.includes(mistake));
      if (entry.row.hidden === fits) entry.row.hidden = !fits;
      visible += fits;
    }
    count.textContent = visible;
  };

  const collator = new Intl.Collator("de", { numeric: true });
  const sort = column => {
    const head = heads[column];
    const is_number = !head.classList.contains("text") && column > 0;
    // Points begin with the most, words that are there go before none.
    const first = is_number || column > 0 ? "descending" : "ascending";
    const other = first === "descending" ? "ascending" : "descending";
    const order = head.getAttribute("aria-sort") === first ? other : first;
    const sign = order === "ascending" ? 1 : -1;
    const value = key => key === "" ? -1 : parseFloat(key);
    rows.sort((a, b) => sign * (is_number ? value(a.keys[column]) - value(b.keys[column])
                                          : collator.compare(a.keys[column], b.keys[column])));
    for (const each of heads) each.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", order);
    body.append(...rows.map(entry => entry.row));
  };

  for (const [column, head] of heads.entries()) {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...head.childNodes);
    button.addEventListener("click", () => sort(column));
    head.append(button);
  }
  form.hidden = false;
  form.addEventListener("submit", event => event.preventDefault());
  form.addEventListener("input", filter);
  form.addEventListener("reset", () => setTimeout(filter));
  filter();
}
