// Small pieces of page. Nothing here sets HTML from text, or a style attribute: the page's policy forbids both.

/** element("p", {class: "note", onclick: f}, "text", otherElement) */
export function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else if (value === true) node.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) node.setAttribute(name, value);
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

/** Paragraphs are separated by an empty line; single line ends stay line ends. */
export const paragraphs = (text) =>
  text
    .split(/\n\s*\n/)
    .filter((part) => part.trim() !== "")
    .map((part) => element("p", {}, part.trim()));

/** A card in the middle of the page. `width` is "narrow", "middle" or "wide". */
export function card(title, width, ...children) {
  const heading = element("h1", { id: "title" }, title);
  return element("section", { class: "card " + width, "aria-labelledby": "title" }, heading, ...children);
}

/** [{text, leading, action}]: in the reading order, the one that leads on last. */
export function buttonRow(buttons) {
  const made = buttons.map(({ text, leading, action, id }) =>
    element("button", { type: "button", id, class: leading ? "leading" : null, onclick: action }, text)
  );
  return element("div", { class: "buttons" }, ...made);
}

let names = 0;
/** A name for an element that others point at. */
export const uniqueId = (word) => word + "-" + ++names;

/** A group of radio buttons: {legend, options: [text], chosen: index or -1, change(index)}. */
export function radioGroup({ legend, note, options, chosen, change, id }) {
  const group = uniqueId("group");
  const rows = options.map((text, index) => {
    const input = element("input", {
      type: "radio",
      name: group,
      id: index === 0 ? id : null,
      value: String(index),
      onchange: () => change(index),
    });
    input.checked = index === chosen;
    return element("label", { class: "option" }, input, element("span", {}, text));
  });
  const words = element("legend", {}, legend, note ? element("span", { class: "note" }, " (" + note + ")") : null);
  return element("fieldset", {}, words, element("div", { class: "options" }, ...rows));
}

/** A drawing that is measured in pixels of the screen. */
export function svg(tag, attributes = {}, ...children) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}
