// A view is one plain object; everything on the page shows it, and every control asks to change it:
//   position    place in time: 1.25 is a quarter from state 1 to state 2
//   before      state shown for comparison;  compare: whether it is
//   colour      "displacement", "material", "plain"
//   scale       factor on displacements;  range: displacement at the end of the colour map
//   axis, at, flip   slice: "off", "x", "y", "z"; place from 0 to 1; which side is hidden
//   edges, incision, seeThrough, findings[], playing
import {largestDisplacement, readData} from "cleave/data.js";
import {readFragment} from "cleave/fragment.js";
import {readMesh} from "cleave/mesh.js";
import {Panel} from "cleave/panel.js";
import {Stage} from "cleave/stage.js";

const root = document.documentElement;
const data = readData(document.getElementById("page-data").textContent);
const mesh = readMesh(data.cells, data.points);
const radius = 0.5 * Math.hypot(...mesh.high.map((x, axis) => x - mesh.low[axis])) || 1;
const stage = makeStage();
const last = data.states.length - 1;
const range = Math.max(...data.states.map(largestDisplacement));

// None without WebGL 2: then the page says so, and has the plot and the tables still.
function makeStage() {
  const context = document.createElement("canvas").getContext("webgl2");
  if (!context) return null;
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return new Stage(data, mesh, radius);
}

// 1 unless displacements are too small to see: then a round factor that makes them visible.
function niceScale() {
  if (range === 0 || range > 0.01 * radius) return 1;
  const wanted = 0.1 * radius / range, power = 10 ** Math.floor(Math.log10(wanted));
  return power * [5, 2, 1].find((m) => m * power <= wanted);
}

const colours = ["plain"];  // what there is to colour by, the best first
if (data.materialOfCell.length) colours.unshift("material");
if (range > 0) colours.unshift("displacement");
const limits = {
  colours,
  last,
  range,
  scale: niceScale(),
  low: mesh.low,
  high: mesh.high
};
const uncut = data.states.findLastIndex?.((state) => state.opened.length === 0) ?? 0;
const start = {
  position: last,
  before: Math.max(0, uncut),
  compare: false,
  colour: colours[0],
  scale: limits.scale,
  range,
  axis: "off",
  at: 0.5,
  flip: false,
  edges: true,
  incision: true,
  seeThrough: false,
  findings: data.findings.map(() => true),
  playing: false,
};

let view = readFragment(location.hash, start, limits);

function update(patch) {
  const change = typeof patch === "function" ? patch(view) : patch;
  if ("position" in change && !("playing" in change)) change.playing = false;
  if ("axis" in change && change.axis === view.axis) change.axis = "off";
  view = {...view, ...change};
  stage?.show(view);
  panel.show(view);
}

// Playing: each step eases in and out and rests a moment on its state.
const STEP = 1600, REST = 500;

function play() {
  if (view.playing || last === 0) return update({playing: false});
  update({playing: true, position: view.position >= last ? 0 : view.position});
  let from = Math.floor(view.position), elapsed = (view.position - from) * STEP, before = null;
  const tick = (now) => {
    if (!view.playing) return;
    elapsed += before === null ? 0 : Math.min(now - before, 100);
    before = now;
    if (elapsed > STEP + REST) {
      ++from;
      elapsed = 0;
    }
    if (from >= last) return update({playing: false, position: last});
    const t = Math.min(elapsed / STEP, 1);
    update({playing: true, position: from + t * t * (3 - 2 * t)});
    requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
}

function reset() {
  stage?.look();
  update({...start, position: view.position, playing: false});
}

const panel = new Panel(data, limits, update, {play, reset});

const choose = (colour) => colours.includes(colour) && update({colour});

const KEYS = {
  " ": play,
  "[": () => update({position: Math.max(0, Math.ceil(view.position) - 1)}),
  "]": () => update({position: Math.min(last, Math.floor(view.position) + 1)}),
  1: () => choose("displacement"),
  2: () => choose("material"),
  3: () => choose("plain"),
  e: () => update({edges: !view.edges}),
  i: () => update({incision: !view.incision}),
  t: () => update({seeThrough: !view.seeThrough}),
  c: () => update({compare: !view.compare}),
  x: () => update({axis: "x"}),
  y: () => update({axis: "y"}),
  z: () => update({axis: "z"}),
  o: () => update({axis: "off"}),
  r: reset,
};

const typing = (event) => event.ctrlKey || event.metaKey || event.altKey ||
    event.target.closest?.("select, details") ||
    (event.key === " " && event.target.closest?.("button, input"));

let held = null;  // the place in time to go back to when `b` is let go
addEventListener("keydown", (event) => {
  if (typing(event)) return;
  if (event.key === "b" && held === null) {
    held = view.position;
    update({position: view.before});
  } else if (KEYS[event.key]) {
    event.preventDefault();
    KEYS[event.key]();
  }
});
addEventListener("keyup", (event) => {
  if (event.key !== "b" || held === null) return;
  update({position: held});
  held = null;
});
addEventListener("hashchange", () => {
  view = readFragment(location.hash, start, limits);
  if (view.camera) stage?.look(view.camera);
  update({});
});

// What was drawn, for tests and for whoever takes pictures.
function reportDrawn() {
  Object.assign(root.dataset, stage.after.counts, {position: view.position, cells: mesh.cellCount});
  if (root.dataset.state) return;
  if (stage.renderer.getContext().getError()) throw new Error("WebGL reports an error");
  root.dataset.state = "ready";
}

if (stage) {
  stage.onDrawn = reportDrawn;
  stage.findHome(view.scale);
  document.getElementById("no-view").remove();
} else {
  root.dataset.state = "no-webgl";
}
update({});
stage?.look(view.camera);
