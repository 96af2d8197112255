// Residual and energy-error estimate of every solve against run time, as SVG with a readout.
import {inWords, readable} from "cleave/data.js";

const COLOURS = [
  "var(--series-1)", "var(--series-2)", "var(--series-3)", "var(--series-4)", "var(--series-5)",
  "var(--series-6)", "var(--series-7)", "var(--series-8)"
];
const WIDTH = 360, HEIGHT = 216, LEFT = 42, RIGHT = 8, TOP = 8, BOTTOM = 30;
const CURVES = [["residual", "residual", ""], ["energyError", "energy-error estimate", "5 3"]];

function make(name, attributes, ...children) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

function html(name, className, ...children) {
  const node = document.createElement(name);
  node.className = className;
  node.append(...children);
  return node;
}

// Round steps of a linear axis from 0 to `most`.
function ticks(most) {
  const rough = most / 4, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((m) => m * power >= rough) ?? 10);
  const result = [];
  for (let i = 0; i * step <= most * 1.0001; ++i) result.push(i * step);
  return result;
}

// Screen coordinates of all that is plotted: time is linear, errors are logarithmic.
function scales(solves) {
  const positive =
      solves.flatMap((solve) => [...solve.residual, ...solve.energyError, solve.tolerance])
          .filter((x) => x > 0);
  const low = Math.floor(Math.log10(positive.reduce((a, b) => Math.min(a, b), 1)));
  const high =
      Math.max(low + 1, Math.ceil(Math.log10(positive.reduce((a, b) => Math.max(a, b), 1e-300))));
  const most = solves.flatMap((solve) => solve.seconds).reduce((a, b) => Math.max(a, b), 0) || 1;
  return {
    low,
    high,
    most,
    x: (seconds) => LEFT + seconds / most * (WIDTH - LEFT - RIGHT),
    y: (value) => TOP + (high - Math.log10(value)) / (high - low) * (HEIGHT - TOP - BOTTOM),
  };
}

// A path with gaps where a value is not known.
function path(solve, values, {x, y}) {
  let pen = "M", text = "";
  values.forEach((value, i) => {
    if (value > 0) text += `${pen}${x(solve.seconds[i]).toFixed(2)} ${y(value).toFixed(2)}`;
    pen = value > 0 ? "L" : "M";
  });
  return text;
}

const SECONDS = [[1, "s"], [1e-3, "ms"], [1e-6, "µs"]];

function axes(scale) {
  const {x, y, low, high, most} = scale, group = make("g", {class: "axes"});
  const every = Math.ceil((high - low) / 6);
  for (let power = low; power <= high; ++power) {
    group.append(
        make("line", {x1: LEFT, x2: WIDTH - RIGHT, y1: y(10 ** power), y2: y(10 ** power)}));
    if ((power - low) % every) continue;
    const label = make("text", {x: LEFT - 6, y: y(10 ** power) + 3.5, "text-anchor": "end"}, "10");
    label.append(make("tspan", {dy: -4, "font-size": "8"}, String(power).replace("-", "−")));
    group.append(label);
  }
  const [unit, name] = SECONDS.find(([size]) => most >= size) ?? SECONDS[2];
  for (const tick of ticks(most / unit))
    group.append(make(
        "text", {x: x(tick * unit), y: HEIGHT - BOTTOM + 14, "text-anchor": "middle"},
        readable(tick)));
  group.append(make(
      "text", {x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 3, "text-anchor": "middle"},
      `run time (${name})`));
  return group;
}

// The sample of any solve nearest to a place in time, by its pixel distance to the pointer.
function nearest(solves, scale, px, py) {
  let best = null, least = Infinity;
  solves.forEach((solve, s) => solve.seconds.forEach((seconds, i) => {
    for (const [key] of CURVES) {
      if (!(solve[key][i] > 0)) continue;
      const distance = Math.hypot(scale.x(seconds) - px, scale.y(solve[key][i]) - py);
      if (distance < least) [least, best] = [distance, {s, i}];
    }
  }));
  return best;
}

function readout(solves, scale, svg, text) {
  const cursor =
      make("line", {class: "cursor", y1: TOP, y2: HEIGHT - BOTTOM, visibility: "hidden"});
  const dots = CURVES.map(() => make("circle", {r: 3.5, visibility: "hidden"}));
  svg.append(cursor, ...dots);
  const show = (sample) => {
    const solve = solves[sample.s], seconds = solve.seconds[sample.i];
    cursor.setAttribute("x1", scale.x(seconds));
    cursor.setAttribute("x2", scale.x(seconds));
    cursor.setAttribute("visibility", "visible");
    const words =
        [`${solve.label}: iteration ${solve.iteration[sample.i]}, ${readable(1000 * seconds)} ms`];
    CURVES.forEach(([key, name], k) => {
      const value = solve[key][sample.i];
      dots[k].setAttribute("visibility", value > 0 ? "visible" : "hidden");
      if (!(value > 0)) return;
      dots[k].setAttribute("cx", scale.x(seconds));
      dots[k].setAttribute("cy", scale.y(value));
      dots[k].setAttribute("fill", COLOURS[sample.s % COLOURS.length]);
      words.push(`${name} ${value.toExponential(2)}`);
    });
    text.textContent = words.join(" · ");
  };
  let shown = null;
  svg.addEventListener("pointermove", (event) => {
    const box = svg.getBoundingClientRect();
    shown = nearest(
        solves, scale, (event.clientX - box.left) / box.width * WIDTH,
        (event.clientY - box.top) / box.height * HEIGHT);
    if (shown) show(shown);
  });
  svg.addEventListener("keydown", (event) => {
    const step = {ArrowLeft: -1, ArrowRight: 1}[event.key],
          solve = {ArrowUp: -1, ArrowDown: 1}[event.key];
    if (!step && !solve) return;
    event.preventDefault();
    shown ??= {s: 0, i: 0};
    if (solve) shown = {s: (shown.s + solve + solves.length) % solves.length, i: 0};
    else shown.i = Math.min(Math.max(shown.i + step, 0), solves[shown.s].seconds.length - 1);
    show(shown);
  });
}

/// Fills `into` with the plot of `solves` (those with samples; none: nothing). Returns how many.
export function drawPlot(into, all) {
  const solves = all.filter((solve) => solve.seconds.length > 0);
  if (solves.length === 0) return 0;
  const scale = scales(solves);
  const svg = make("svg", {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    tabindex: 0,
    role: "img",
    "aria-label": "Residual and energy-error estimate against run time; arrow keys read out samples"
  });
  svg.append(axes(scale));
  for (const tolerance of new Set(solves.map((solve) => solve.tolerance).filter((x) => x > 0)))
    svg.append(make(
        "line", {
          class: "tolerance",
          x1: LEFT,
          x2: WIDTH - RIGHT,
          y1: scale.y(tolerance),
          y2: scale.y(tolerance)
        },
        make("title", {}, `tolerance ${tolerance.toExponential(0)}`)));
  const curves = solves.map((solve, s) => {
    const group = make("g", {class: "curves", stroke: COLOURS[s % COLOURS.length]});
    for (const [key, name, dashes] of CURVES)
      group.append(make("path", {d: path(solve, solve[key], scale), "stroke-dasharray": dashes},
                        make("title", {}, `${solve.label}: ${name}`)));
    return group;
  });
  svg.append(...curves);
  const names = solves.map((solve, s) => {
    const swatch = html("i", "swatch");
    swatch.style.background = COLOURS[s % COLOURS.length];
    const name = html("button", "", swatch, solve.label, html("small", "", inWords(solve.outcome)));
    name.type = "button";
    name.addEventListener("click", () => {
      const alone = name.getAttribute("aria-pressed") !== "true";
      names.forEach((other, i) => {
        other.setAttribute("aria-pressed", alone && i === s);
        curves[i].classList.toggle("faint", alone && i !== s);
      });
    });
    return name;
  });
  const kinds = CURVES.map(
      ([, name, dashes]) => html("span", dashes ? "dashed" : "solid", html("i", "stroke"), name));
  const text = html("p", "readout", "Point at a curve to read it.");
  text.setAttribute("role", "status");
  readout(solves, scale, svg, text);
  into.append(svg, html("div", "key", ...kinds), html("div", "key", ...names), text);
  return solves.length;
}
