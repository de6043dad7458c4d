// The widget's part in the browser: it shows what the kernel's process renders, and says what is turned.

const DEGREES_A_PIXEL = 0.4;
const DEGREES_A_KEY = 5;
const NEARER = 1.1;
// A wheel that is at rest for so many milliseconds, and a key, have ended a movement.
const REST = 200;

const STYLE = `
.vitrum { display: inline-block; max-width: 100%; font: 13px sans-serif; }
.vitrum-picture { position: relative; outline-offset: 2px; max-width: 100%; touch-action: none; cursor: grab;
  background: repeating-conic-gradient(#8883 0 25%, transparent 0 50%) 0 0 / 20px 20px; }
.vitrum-picture:active { cursor: grabbing; }
.vitrum-picture img { display: block; width: 100%; height: 100%; user-select: none; -webkit-user-drag: none; }
.vitrum-controls { display: flex; flex-wrap: wrap; gap: 4px 16px; padding: 6px 0; align-items: center; }
.vitrum-controls label { display: flex; gap: 6px; align-items: center; }
.vitrum-controls input { width: 110px; }
.vitrum-message { color: #c22; }
`;

function element(kind, properties, ...children) {
  const made = Object.assign(document.createElement(kind), properties);
  made.append(...children);
  return made;
}

function between(low, value, high) {
  return Math.min(Math.max(value, low), high);
}

function render({ model, el }) {
  const ended = new AbortController();
  const listen = (target, kind, act, options = {}) => target.addEventListener(kind, act, { signal: ended.signal, ...options });
  const [width, height] = model.get("_size");
  const image = element("img", { alt: "picture by Vitrum", draggable: false });
  const picture = element("div", { className: "vitrum-picture", tabIndex: 0 }, image);
  Object.assign(picture.style, { width: `${width}px`, aspectRatio: `${width} / ${height}` });
  picture.title = "Drag to turn, with Shift to move the light; wheel to come nearer; 0 to go back";
  const controls = element("div", { className: "vitrum-controls" });
  const message = element("div", { className: "vitrum-message" });
  const root = element("div", { className: "vitrum" }, element("style", { textContent: STYLE }), picture, controls, message);
  // JupyterLab, whose keys these would be, too, leaves them to the widget.
  root.dataset.lmSuppressShortcuts = "true";
  el.append(root);

  // Changes of one frame of the screen travel together.
  let scheduled = 0;
  const change = (values) => {
    for (const [name, value] of Object.entries(values)) model.set(name, value);
    scheduled ||= requestAnimationFrame(() => {
      scheduled = 0;
      model.save_changes();
    });
  };
  const start = Object.fromEntries(["azimuth", "elevation", "zoom", "light_azimuth", "light_elevation"].map((name) => [name, model.get(name)]));

  let url = "";
  const show = () => {
    const bytes = model.get("_image");
    if (!bytes || !bytes.byteLength) return;
    const kind = model.get("_image_kind");
    const next = URL.createObjectURL(new Blob([bytes], { type: kind === "png" ? "image/png" : "image/jpeg" }));
    const before = url;
    image.src = url = next;
    if (before) setTimeout(() => URL.revokeObjectURL(before), 1000);
    root.dataset.pictures = Number(root.dataset.pictures || 0) + 1;
    root.dataset.kind = kind;
  };
  const on = (name, act) => {
    model.on(`change:${name}`, act);
    ended.signal.addEventListener("abort", () => model.off(`change:${name}`, act));
    act();
  };
  on("_image", show);
  on("_message", () => (message.textContent = model.get("_message")));

  const turn = (right, down, light) => {
    const [azimuth, elevation] = light ? ["light_azimuth", "light_elevation"] : ["azimuth", "elevation"];
    if (light && !model.get("_has").light) return;
    change({
      [azimuth]: (model.get(azimuth) + (light ? right : -right)) % 360,
      [elevation]: between(-89, model.get(elevation) + (light ? -down : down), 89),
    });
  };
  const nearer = (factor) => change({ zoom: between(0.05, model.get("zoom") * factor, 50) });
  let resting = 0;
  const moves = () => {
    clearTimeout(resting);
    change({ _moves: true });
    resting = setTimeout(() => change({ _moves: false }), REST);
  };

  let last = null;
  listen(picture, "pointerdown", (event) => {
    last = [event.clientX, event.clientY];
    picture.setPointerCapture(event.pointerId);
    picture.focus({ preventScroll: true });
    event.preventDefault();
  });
  listen(picture, "pointermove", (event) => {
    if (!last) return;
    clearTimeout(resting);
    change({ _moves: true });
    turn((event.clientX - last[0]) * DEGREES_A_PIXEL, (event.clientY - last[1]) * DEGREES_A_PIXEL, event.shiftKey);
    last = [event.clientX, event.clientY];
  });
  const release = () => {
    if (last) change({ _moves: false });
    last = null;
  };
  listen(picture, "pointerup", release);
  listen(picture, "pointercancel", release);
  const wheel = (event) => {
    event.preventDefault();
    moves();
    nearer(Math.pow(NEARER, -Math.sign(event.deltaY)));
  };
  listen(picture, "wheel", wheel, { passive: false });
  const keys = {
    ArrowLeft: (light) => turn(-DEGREES_A_KEY, 0, light),
    ArrowRight: (light) => turn(DEGREES_A_KEY, 0, light),
    ArrowUp: (light) => turn(0, -DEGREES_A_KEY, light),
    ArrowDown: (light) => turn(0, DEGREES_A_KEY, light),
    "+": () => nearer(NEARER),
    "=": () => nearer(NEARER),
    "-": () => nearer(1 / NEARER),
    0: () => change(start),
  };
  const key = (event) => {
    const act = keys[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    // The notebook has keys of its own.
    event.preventDefault();
    event.stopPropagation();
    moves();
    act(event.shiftKey);
  };
  listen(picture, "keydown", key);

  const menu = element("select", { className: "vitrum-preset" });
  menu.append(element("option", { value: "", textContent: "as given" }));
  for (const [name, meaning] of Object.entries(model.get("_presets"))) menu.append(element("option", { value: name, textContent: name, title: meaning }));
  listen(menu, "change", () => change({ preset: menu.value }));
  on("preset", () => (menu.value = model.get("preset")));
  controls.append(element("label", {}, "preset", menu));

  // The sliders go from a quarter to four times the extinction, and from no refraction to twice as much.
  const slider = (name, text, low, high, of_slider, to_slider) => {
    const input = element("input", { type: "range", min: low, max: high, step: 0.01, className: `vitrum-${name}` });
    const shown = element("span");
    listen(input, "input", () => {
      clearTimeout(resting);
      change({ _moves: true, [name]: of_slider(Number(input.value)) });
    });
    listen(input, "change", () => change({ _moves: false }));
    on(name, () => {
      input.value = to_slider(model.get(name));
      shown.textContent = `× ${model.get(name).toFixed(2)}`;
    });
    on("_has", () => (input.disabled = !model.get("_has")[name]));
    controls.append(element("label", {}, text, input, shown));
  };
  slider("opacity", "opacity", -2, 2, (value) => 2 ** value, Math.log2);
  slider("eta", "η − 1", 0, 2, (value) => value, (value) => value);

  return () => {
    clearTimeout(resting);
    cancelAnimationFrame(scheduled);
    ended.abort();
    if (url) URL.revokeObjectURL(url);
  };
}

export default { render };
