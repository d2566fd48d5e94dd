// The study's words.

/** Puts a value into each `{name}`; a place without a value stays as it is. */
export function fillIn(text, values = {}) {
  return text.replace(/\{(\w+)\}/g, (place, name) => (name in values ? String(values[name]) : place));
}

const RIGHT_TO_LEFT = ["ar", "arc", "ckb", "dv", "fa", "he", "iw", "ks", "nqo", "ps", "sd", "syr", "ug", "ur", "yi"];

/** "rtl" or "ltr" of a language tag such as "he" or "az-Arab". */
export function direction(language) {
  const parts = language.toLowerCase().split("-");
  if (parts.some((part) => part === "arab" || part === "hebr")) return "rtl";
  if (parts.some((part) => part === "latn" || part === "cyrl")) return "ltr";
  return RIGHT_TO_LEFT.includes(parts[0]) ? "rtl" : "ltr";
}
