// Chooses how the real world hides virtual things, and lets the person at the page change it.
(() => {
  "use strict";
  const by = (id) => document.getElementById(id);
  const set = (name, value) => {
    for (const field of document.querySelectorAll(`field[name="${name}"]`)) field.setAttribute("value", String(value));
  };
  const hasWebGl2 = !!document.createElement("canvas").getContext("webgl2");
  const ghosts = !hasWebGl2 || location.search === "?ghosts";
  if (ghosts) {
    // Photograph and invisible geometry must be drawn first, so they come first in the document.
    const scene = by("scene");
    scene.insertBefore(by("ghost_template").content, scene.firstChild);
    by("depth_background").remove();
    for (const part of document.querySelectorAll(".by-shader")) part.remove();
    for (const control of document.querySelectorAll(".needs-depth")) control.hidden = true;
  }
  by("status").textContent = !ghosts
    ? "Who is in front is decided by the depth image, written fragment by fragment (WebGL 2)."
    : (hasWebGl2 ? "As asked for" : "There is no WebGL 2 here") +
      ": who is in front is decided by invisible geometry, drawn before the object. Shadows and the user's mask are not shown.";
  by("other_way").hidden = !hasWebGl2;
  by("other_way").href = ghosts ? "?" : "?ghosts";
  by("other_way").textContent = ghosts ? "Use the depth image" : "Use invisible geometry";

  const moved = [0, 0, 0];
  const step_m = Number(document.body.dataset.stepM);
  function move(axis, by_m) {
    moved[axis] += by_m;
    by("object").setAttribute("translation", moved.join(" "));
    set("moved_m", moved.join(" "));
  }
  for (const button of document.querySelectorAll("button[data-axis]"))
    button.addEventListener("click", () => move(Number(button.dataset.axis), Number(button.dataset.sign) * step_m));

  // Without the object there is no shadow of it.
  const shade = () => set("shades", by("shadow")?.checked && by("shown").checked ? 1 : 0);
  by("shown").addEventListener("change", (event) => {
    by("object").setAttribute("render", String(event.target.checked));
    shade();
  });
  by("occlusion").addEventListener("change", (event) => {
    const on = event.target.checked;
    set("occludes", on ? 1 : 0);
    for (const shape of document.querySelectorAll(".ghost")) shape.setAttribute("render", String(on));
  });
  by("shadow")?.addEventListener("change", shade);
  by("user_only")?.addEventListener("change", (event) => {
    set("shows_user_only", event.target.checked ? 1 : 0);
    by("virtual_scene").setAttribute("whichChoice", event.target.checked ? "0" : "-1");
  });
  by("marked").addEventListener("change", (event) => {
    set("marked", event.target.checked ? 1 : 0);
    if (!ghosts) return;
    for (const material of document.querySelectorAll("material.object")) {
      material.setAttribute("emissiveColor", event.target.checked ? "1 0 1" : "0 0 0");
      material.setAttribute("ambientIntensity", event.target.checked ? "0" : "1");
    }
    for (const light of document.querySelectorAll(".light")) {
      light.dataset.intensity ??= light.getAttribute("intensity");
      light.setAttribute("intensity", event.target.checked ? "0" : light.dataset.intensity);
    }
  });

  // The recorded values of the sensors, shortened.
  const rows = by("values");
  for (const instance of document.querySelectorAll("ProtoInstance"))
    for (const field of instance.querySelectorAll("fieldValue")) {
      const row = rows.insertRow();
      row.insertCell().textContent = instance.getAttribute("name");
      row.insertCell().textContent = field.getAttribute("name");
      const value = row.insertCell();
      value.className = "value";
      const text = field.getAttribute("value");
      value.textContent = text.length > 240 ? text.slice(0, 200) + " ... (" + text.length + " letters)" : text;
    }
})();
