// The controls beside and under the canvas. They ask for changes through `update(patch)` and show
// the view they are given; they keep no state of their own.
import {inWords, readable} from "cleave/data.js";
import {OPENED_COLOUR, SHUT_COLOUR, displacementGradient, materialColour} from "cleave/colours.js";
import {MARK_COLOURS} from "cleave/marks.js";
import {drawPlot} from "cleave/plot.js";

const element = (id) => document.getElementById(id);

function make(name, properties = {}, ...children) {
  const node = Object.assign(document.createElement(name), properties);
  node.append(...children);
  return node;
}

function swatch(colour) {
  const node = make("i", {className: "swatch"});
  node.style.background = colour;
  return node;
}

const CHECKBOXES = {
  edges: "edges",
  incision: "incision",
  "see-through": "seeThrough",
  compare: "compare",
  flip: "flip"
};
const RANGES = {position: "position", scale: "scale", slice: "at"};

export class Panel {
  constructor(data, limits, update, actions) {
    this.data = data;
    for (const [id, name] of Object.entries(CHECKBOXES))
      element(id).addEventListener("change", (event) => update({[name]: event.target.checked}));
    for (const [id, name] of Object.entries(RANGES))
      element(id).addEventListener(
          "input", (event) => update({[name]: Number(event.target.value)}));
    for (const [id, name] of [["colour", "colour"], ["axis", "axis"]])
      for (const button of element(id).children)
        button.addEventListener("click", () => update({[name]: button.dataset.value}));
    element("before").addEventListener(
        "change", (event) => update({before: Number(event.target.value)}));
    element("reset").addEventListener("click", actions.reset);
    element("play").addEventListener("click", actions.play);
    element("position").max = limits.last;
    element("scale").max = 3 * limits.scale;
    for (const button of element("colour").children)
      button.hidden = !limits.colours.includes(button.dataset.value);
    element("scale-row").hidden = limits.range === 0;
    element("timeline").hidden = data.states.length === 1;
    this.fillStates(update);
    this.fillFindings(update);
    element("plot-section").hidden = drawPlot(element("plot"), data.solves) === 0;
    this.limits = limits;
  }

  fillStates(update) {
    const {states} = this.data;
    const go = (position) => () => update({position});
    element("before").append(...states.map(({label}, i) => make("option", {value: i}, label)));
    element("stops").append(
        ...states.map(({label}, i) => make("button", {type: "button", onclick: go(i)}, label)));
    element("states").append(...states.map((state, i) => {
      const solved = state.iterations >= 0;
      const cell = (text) => make("td", {}, String(text));
      const name =
          make("th", {scope: "row"}, make("button", {type: "button", onclick: go(i)}, state.label));
      const outcome = make(
          "td", {},
          make(
              "span", {className: `outcome ${state.outcome === "converged" ? "good" : "bad"}`},
              inWords(state.outcome)));
      return make(
          "tr", {}, name, cell(state.pieces), cell(state.opened.length), cell(state.shut.length),
          cell(solved ? state.iterations : "–"), state.outcome ? outcome : cell("–"));
    }));
  }

  fillFindings(update) {
    const {findings} = this.data;
    element("findings-section").hidden = findings.length === 0;
    this.boxes = findings.map((finding, i) => {
      const box = make("input", {
        type: "checkbox",
        onchange: () => update(
            (view) => ({findings: view.findings.map((on, k) => (k === i ? box.checked : on))}))
      });
      const list = make("ul", {}, ...finding.marks.map(({label}) => make("li", {}, label)));
      const name = make(
          "label", {}, box, swatch(MARK_COLOURS[i % MARK_COLOURS.length]),
          `${finding.name} (${finding.marks.length})`);
      element("findings")
          .append(make("div", {}, name, make("details", {}, make("summary", {}, "Which?"), list)));
      return box;
    });
  }

  /// Shows a view (see main.js).
  show(view) {
    const {states, lengthUnit, origin} = this.data;
    for (const [id, name] of Object.entries(CHECKBOXES)) element(id).checked = view[name];
    for (const [id, name] of Object.entries(RANGES)) element(id).value = view[name];
    for (const [id, value] of [["colour", view.colour], ["axis", view.axis]])
      for (const button of element(id).children)
        button.setAttribute("aria-pressed", button.dataset.value === value);
    this.boxes.forEach((box, i) => {
      box.checked = view.findings[i];
    });
    element("before").value = view.before;
    element("before-row").hidden = !view.compare;
    element("scale-value").textContent = `×${readable(view.scale)}`;
    const sliced = view.axis !== "off";
    element("slice").disabled = element("flip").disabled = !sliced;
    element("slice-value").textContent = sliced ? this.slicePlace(view, origin, lengthUnit) : "";
    const nearest = Math.round(view.position);
    [...element("states").children].forEach(
        (row, i) => row.classList.toggle("current", i === nearest));
    [...element("stops").children].forEach(
        (stop, i) => stop.setAttribute("aria-current", i === nearest));
    element("position").setAttribute("aria-valuetext", states[nearest].label);
    element("play").classList.toggle("playing", view.playing);
    element("play").setAttribute("aria-label", view.playing ? "Pause" : "Play the states");
    element("caption-before").hidden = !view.compare;
    element("caption-before").textContent = states[view.before].label;
    element("caption-after").textContent = states[nearest].label;
    element("view").classList.toggle("compared", view.compare);
    this.showLegend(view);
  }

  slicePlace(view, origin, unit) {
    const a = "xyz".indexOf(view.axis), {low, high} = this.limits;
    return `${view.axis} = ${readable(origin[a] + low[a] + view.at * (high[a] - low[a]))} ${unit}`;
  }

  showLegend(view) {
    const {materials, states, lengthUnit} = this.data;
    const key = `${view.colour} ${view.incision} ${view.scale}`;
    if (key === this.legend) return;
    this.legend = key;
    const parts = [];
    if (view.colour === "displacement") {
      const bar = make("div", {className: "bar"});
      bar.style.background = displacementGradient();
      const ends = [0, 0.5 * view.range, view.range].map((x) => make("span", {}, readable(x)));
      const unit = lengthUnit ? ` (${lengthUnit})` : "";
      const drawn = view.scale === 1 ? "" : `, drawn ×${readable(view.scale)}`;
      parts.push(
          make("p", {}, `Displacement${unit}${drawn}`), bar,
          make("div", {className: "ends"}, ...ends));
    } else if (view.colour === "material") {
      parts.push(...materials.map((name, i) => make("p", {}, swatch(materialColour(i)), name)));
    }
    const any = (name) => view.incision && states.some((state) => state[name].length > 0);
    if (any("opened")) parts.push(make("p", {}, swatch(OPENED_COLOUR), "opened, both sides"));
    if (any("shut")) parts.push(make("p", {}, swatch(SHUT_COLOUR), "asked for, still shut"));
    element("legend").replaceChildren(...parts);
  }
}
