// Whether a picture's pixel is a pixel of the screen: the size of the page in pixels of the screen, the box of the
// picture that is shown, and what the browser's zoom makes of both.

/** Pixels of the screen that an element's content covers, as ResizeObserver says; null where it cannot say. */
const deviceBox = (entry) => {
  const box = entry.devicePixelContentBoxSize?.[0];
  return box ? { width: box.inlineSize, height: box.blockSize } : null;
};

/** Whether the browser can tell the box of an element in pixels of the screen. */
export const canBeExact = () =>
  "ResizeObserver" in globalThis && "devicePixelContentBoxSize" in (globalThis.ResizeObserverEntry?.prototype ?? {});

/** A picture at whole pixels of the screen, as large as its file says. */
export function isExact(image, box, ratio) {
  const { left, top } = image.getBoundingClientRect();
  const whole = (css) => Math.abs(css * ratio - Math.round(css * ratio)) < 0.1;
  return box.width === image.naturalWidth && box.height === image.naturalHeight && whole(left) && whole(top);
}

/** Frames a second, from the median of some forty gaps between frames; 0 while it is not known. */
function measureRefresh() {
  let refresh = 0;
  const gaps = [];
  let last = null;
  const frame = (now) => {
    if (last !== null) gaps.push(now - last);
    last = now;
    if (gaps.length < 40) return requestAnimationFrame(frame);
    gaps.sort((a, b) => a - b);
    refresh = Math.round(100000 / gaps[20]) / 100;
  };
  requestAnimationFrame(frame);
  return () => refresh;
}

/** Watches the page's size and zoom; `note(kind, detail)` hears of changes. */
export function watchScreen(probe, note) {
  const listeners = new Set();
  let size = { width: Math.round(innerWidth * devicePixelRatio), height: Math.round(innerHeight * devicePixelRatio) };
  let ratio = devicePixelRatio;
  let picture = null;
  let exact = true;
  const tell = () => listeners.forEach((listener) => listener());

  const changed = () => {
    if (devicePixelRatio !== ratio) {
      ratio = devicePixelRatio;
      note("zoom", String(ratio));
    }
    tell();
  };
  const page = new ResizeObserver(([entry]) => {
    const box = deviceBox(entry);
    if (box && (box.width !== size.width || box.height !== size.height)) {
      const first = !page.seen;
      size = box;
      if (!first) note("resize", box.width + "x" + box.height);
    }
    page.seen = true;
    changed();
  });
  const shown = new ResizeObserver(([entry]) => {
    const box = deviceBox(entry);
    const now = entry.target !== picture || box === null || isExact(picture, box, devicePixelRatio);
    if (now === exact) return;
    exact = now;
    tell();
  });
  if (canBeExact()) page.observe(probe, { box: "device-pixel-content-box" });
  globalThis.visualViewport?.addEventListener("resize", changed);
  const again = () => {
    matchMedia("(resolution: " + devicePixelRatio + "dppx)").addEventListener("change", () => (changed(), again()), {
      once: true,
    });
  };
  again();

  return {
    size: () => size,
    refreshHz: measureRefresh(),
    /** No pinch, and the picture that is shown, if any, covers exactly its own pixels. */
    exact: () => exact && Math.abs((globalThis.visualViewport?.scale ?? 1) - 1) < 1e-3,
    watchPicture(image) {
      shown.disconnect();
      picture = image;
      exact = true;
      if (image) shown.observe(image, { box: "device-pixel-content-box" });
    },
    onChange(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
