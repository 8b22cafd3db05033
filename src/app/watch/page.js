"use strict";
const at = id => document.getElementById(id);
const narrow = matchMedia("(max-width: 40rem)");
let view = null, figures = null, opened = false, version = 0, revision = 0, reported = 0, moved = new Map(), sending = false, again = false, rows = new Map();

const post = (name, body) => fetch(name, {
  method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body),
});

/* Sliders: one turn to ten times and to a tenth of what the file has; around zero as far as a number of its kind. */
const STEPS = 400;
const rounded = value => Number(value.toPrecision(3));
const last = path => path.replace(/\[\d+\]|\.\d+$/g, "").split(".").pop();

function reach(slider) {
  const alike = view.sliders.filter(other => last(other.path) === last(slider.path) && other.unit === slider.unit);
  return Math.max(...alike.map(other => Math.abs(other.value))) || 1;
}

function scale(slider) {
  if (slider.value === 0) {
    const ends = reach(slider);
    return { place: value => STEPS * value / ends, value: place => rounded(ends * place / STEPS) };
  }
  const ratio = value => STEPS * Math.log10(value / slider.value);
  return {
    place: value => value / slider.value > 0 ? Math.max(-STEPS, Math.min(STEPS, ratio(value))) : -STEPS,
    value: place => place === 0 ? slider.value : rounded(slider.value * 10 ** (place / STEPS)),
  };
}

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

function row(slider, index) {
  const how = scale(slider), id = "slider" + index;
  const range = element("input", { type: "range", id, min: -STEPS, max: STEPS, step: 1, value: how.place(slider.value) });
  const field = element("input", { type: "text", inputMode: "decimal", value: slider.value });
  field.setAttribute("aria-label", slider.path + (slider.unit ? " in " + slider.unit : ""));
  const line = element("div", { className: "slider" },
    element("label", { htmlFor: id, textContent: slider.path }), range, field, element("span", { textContent: slider.unit }));
  const set = value => {
    if (value === slider.value) moved.delete(slider.path); else moved.set(slider.path, value);
    line.classList.toggle("moved", moved.has(slider.path));
    range.setAttribute("aria-valuetext", value + " " + slider.unit);
    send();
  };
  range.addEventListener("input", () => {
    const value = how.value(Number(range.value));
    field.value = value;
    field.removeAttribute("aria-invalid");
    set(value);
  });
  field.addEventListener("input", () => {
    const value = Number(field.value.trim().replace(",", "."));
    const right = field.value.trim() !== "" && Number.isFinite(value);
    field.setAttribute("aria-invalid", String(!right));
    if (right) { range.value = how.place(value); set(value); }
  });
  const show = value => { field.value = value; range.value = how.place(value); line.classList.toggle("moved", moved.has(slider.path)); };
  show(moved.get(slider.path) ?? slider.value);
  rows.set(slider.path, () => show(slider.value));
  return line;
}

/* One request at a time; the newest numbers go when it is back. */
async function send() {
  if (sending) { again = true; return; }
  sending = true;
  do {
    again = false;
    await post("set", { revision, values: [...moved] }).catch(() => {});
  } while (again);
  sending = false;
}

function shown() {
  const { drawn } = view;
  const failed = drawn.faults.length > 0;
  if (!failed) at("title").textContent = drawn.title || view.file;
  document.title = (failed ? "✗ " : "") + view.file;
  at("faults").replaceChildren(...drawn.faults.flatMap(fault => {
    const place = fault.line ? `${fault.file}:${fault.line}:${fault.column}: ` : fault.file ? fault.file + ": " : "";
    const words = element("p", { textContent: place + fault.message });
    if (!fault.line) return [words];
    const caret = " ".repeat(fault.column - 1) + "^";
    return [words, element("pre", { textContent: fault.source.replaceAll("\t", " ") + "\n" + caret })];
  }));
  at("seen").querySelectorAll("figure, #results, #warnings").forEach(part => part.classList.toggle("old", failed));
  if (!failed) {
    figure();
    at("warnings").replaceChildren(...drawn.warnings.map(text => element("p", { textContent: "Warning: " + text })));
    at("results").tBodies[0].replaceChildren(...drawn.results.map(([name, value]) =>
      element("tr", {}, element("th", { scope: "row", textContent: name }), element("td", { textContent: value }))));
  }
  at("text").textContent = view.text;
  at("write").disabled = at("back").disabled = view.set.length === 0;
  at("write").textContent = `Write into ${view.file} …`;
}

/* The last that could be drawn stays while the text is wrong. */
function figure() {
  figures = view?.drawn.figures ?? figures;
  if (figures) at("figure").innerHTML = figures[narrow.matches ? 1 : 0];
}
narrow.addEventListener("change", figure);

function state(words) { at("state").textContent = words; }

/* What follows a frame follows its drawing. */
function told(fresh) {
  const now = version;
  requestAnimationFrame(() => setTimeout(() => {
    if (view.busy) return state("computing …");
    const after = opened ? Date.now() - view.saved : null, width = at("figure").firstElementChild?.getBoundingClientRect().width ?? 0;
    state(view.drawn.faults.length ? "not computed" : fresh && opened ? `drawn ${after.toFixed(0)} ms after the save` : "drawn");
    opened = true;
    if (fresh) post("seen", { version: now, milliseconds: after, width }).catch(() => {});
  }));
}

function show(next) {
  const renewed = view === null || next.revision !== view.revision;
  view = next;
  version = next.version;
  if (renewed) {
    revision = next.revision;
    moved = new Map(next.set);
    rows = new Map();
    at("sliders").replaceChildren(...next.sliders.map(row));
    at("none").hidden = next.sliders.length > 0;
  }
  shown();
  const fresh = !next.busy && next.revision !== reported;
  if (fresh) reported = next.revision;
  told(fresh);
}

async function follow() {
  for (;;) {
    try {
      const answer = await fetch("state?after=" + version);
      if (answer.status === 200) show(await answer.json());
      else if (answer.status !== 204) throw new Error(String(answer.status));
    } catch {
      state("springbed has ended: start it again and open its new address");
      await new Promise(done => setTimeout(done, 1000));
    }
  }
}

at("back").addEventListener("click", () => {
  moved.clear();
  for (const back of rows.values()) back();
  send();
});
at("copy").addEventListener("click", async () => {
  await navigator.clipboard.writeText(view.text);
  state("copied");
});
at("keep").addEventListener("click", () => {
  const link = element("a", { href: URL.createObjectURL(new Blob([view.text])), download: view.file.replace(/(\.\w+)?$/, ".changed$1") });
  link.click();
  URL.revokeObjectURL(link.href);
});
at("write").addEventListener("click", async () => {
  if (!confirm(`Write these numbers into ${view.file}? What it holds is lost.`)) return;
  const answer = await post("save", { revision, over: view.file });
  state(answer.ok ? "written" : await answer.text());
});
follow();
