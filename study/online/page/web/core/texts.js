// The study's words.

/** Puts a value into each `{name}`; a place without a value stays as it is. */
export function fillIn(text, values = {}) {
  return text.replace(/\{(\w+)\}/g, (place, name) => (name in values ? String(values[name]) : place));
}

/**
 * The language to begin with, one of `languages` ({tag}, the study's own first): the one that was chosen before, the
 * link's, the browser's first that there is, or the study's own. "de-AT" is content with "de", and "de" with "de-CH".
 */
export function chooseLanguage(languages, wishes) {
  const main = (tag) => tag.toLowerCase().split("-")[0];
  for (const wish of wishes.filter(Boolean)) {
    const exact = languages.find(({ tag }) => tag.toLowerCase() === wish.toLowerCase());
    const near = exact ?? languages.find(({ tag }) => main(tag) === main(wish));
    if (near) return near;
  }
  return languages[0];
}

const RIGHT_TO_LEFT = ["ar", "arc", "ckb", "dv", "fa", "he", "iw", "ks", "nqo", "ps", "sd", "syr", "ug", "ur", "yi"];

/** "rtl" or "ltr" of a language tag such as "he" or "az-Arab". */
export function direction(language) {
  const parts = language.toLowerCase().split("-");
  if (parts.some((part) => part === "arab" || part === "hebr")) return "rtl";
  if (parts.some((part) => part === "latn" || part === "cyrl")) return "ltr";
  return RIGHT_TO_LEFT.includes(parts[0]) ? "rtl" : "ltr";
}
