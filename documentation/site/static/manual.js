// A picture of a page grows on a click, and is small again on the next one or on Escape.
document.addEventListener("click", (event) => {
  const large = document.querySelector("article img.large");
  if (large) large.classList.remove("large");
  else if (event.target.matches("article img")) event.target.classList.add("large");
});
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") document.querySelector("article img.large")?.classList.remove("large");
});
