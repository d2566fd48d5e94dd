// The form: a function for each kind of question. Faults are said beside the question until they are put right.
import { faultOf, valuesOf } from "../core/form.js";
import { card, element, radioGroup, uniqueId } from "./dom.js";
import { codeWords } from "./pages.js";

function faultText(app, field, fault) {
  if (fault === "out_of_range") return app.phrase("form_out_of_range", { least: field.least, most: field.most });
  return app.phrase("form_" + fault);
}

function numberField(app, field, changed) {
  const id = uniqueId("field");
  const note = field.required ? null : element("span", { class: "note" }, " (" + app.phrase("form_optional") + ")");
  const input = element("input", {
    id,
    type: "text",
    inputmode: field.whole && field.least >= 0 ? "numeric" : "decimal",
    autocomplete: "off",
    maxlength: "12",
    class: "number",
    oninput: () => changed(input.value.trim()),
  });
  return { node: element("div", { class: "field" }, element("label", { for: id }, field.label, note), input), input };
}

function choiceField(app, field, changed) {
  const node = radioGroup({
    legend: field.label,
    note: field.required ? null : app.phrase("form_optional"),
    options: field.options,
    chosen: -1,
    change: (index) => changed(valuesOf(field)[index]),
  });
  return { node, input: node.querySelector("input") };
}

/** By the word of the kind in the study file. */
const DRAWN = { number: numberField, choice: choiceField };

export function drawForm(app, display) {
  const values = new Map();
  const rows = app.study.form.map((field) => {
    const problem = element("p", { class: "problem", id: uniqueId("problem"), hidden: true });
    const changed = (value) => {
      values.set(field.name, value);
      if (!problem.hidden) show(field, problem, input);
    };
    const { node, input } = DRAWN[field.kind](app, field, changed);
    node.append(problem);
    return { field, problem, input, node };
  });

  function show(field, problem, input) {
    const fault = faultOf(field, values.get(field.name) ?? "");
    problem.hidden = fault === null;
    problem.textContent = fault === null ? "" : faultText(app, field, fault);
    if (input.type === "text") input.setAttribute("aria-invalid", String(fault !== null));
    if (fault === null) input.removeAttribute("aria-describedby");
    else input.setAttribute("aria-describedby", problem.id);
  }

  const submit = (event) => {
    event.preventDefault();
    const answers = app.study.form.map(({ name }) => ({ field: name, value: values.get(name) ?? "" }));
    app.step({ type: "form_submitted", answers: answers.filter((answer) => answer.value !== "") });
  };
  const buttons = element(
    "div",
    { class: "buttons" },
    element("button", { type: "submit", id: "submit", class: "leading" }, app.phrase("form_submit"))
  );
  const form = element("form", { novalidate: true, onsubmit: submit }, ...rows.map((row) => row.node), buttons);
  display.append(card(app.phrase("form_title"), "middle", form, ...codeWords(app)));
  if (rows.length > 0) app.focus(rows[0].input);

  return {
    update() {
      const problems = app.visit.screen.problems ?? [];
      for (const row of rows)
        if (problems.some((problem) => problem.field === row.field.name)) show(row.field, row.problem, row.input);
      const first = rows.find((row) => !row.problem.hidden);
      if (first && problems.length > 0) {
        app.focus(first.input);
        app.say(first.field.label + " " + first.problem.textContent);
      }
    },
  };
}
