// A picture of a page grows on a click, and is small again on the next one or on Escape.
document.addEventListener("click", (event) => {
  const large = document.querySelector("article img.large");
  if (large) large.classList.remove("large");
  else if (event.target.matches("article img")) {
    const { naturalWidth, naturalHeight } = event.target;
    event.target.classList.toggle("wide", naturalWidth > 1.2 * naturalHeight);
    event.target.classList.add("large");
  }
});
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") document.querySelector("article img.large")?.classList.remove("large");
});

// Debian's Furo has no style sheet for its theme "auto" in the dark: the page says which one it is.
const dark = matchMedia("(prefers-color-scheme: dark)");
function settleTheme() {
  if (document.body.dataset.theme === "auto" && dark.matches) document.body.dataset.theme = "dark";
}
addEventListener("DOMContentLoaded", () => {
  new MutationObserver(settleTheme).observe(document.body, { attributeFilter: ["data-theme"] });
  settleTheme();
});
