// What lies over the canvas: labels of findings and the little axes.
import * as THREE from "three";
import {MARK_COLOURS} from "cleave/marks.js";

const LINE = 19;  // height of a label in pixels

function element(name, className, text) {
  const node = document.createElement(name);
  node.className = className;
  node.textContent = text;
  return node;
}

/// Labels {label, finding, x, y, left}: a place in pixels, and whether the text is to the left of
/// it. A label that would cover another one moves down.
export function drawLabels(into, labels) {
  const taken = [];
  into.replaceChildren(...labels.map(({label, finding, x, y, left}) => {
    const width = 26 + 6.2 * label.length, from = left ? x - width : x, to = from + width;
    const covered = () =>
        taken.some((other) => Math.abs(other.y - y) < LINE && from < other.to && other.from < to);
    for (let tries = 0; tries < 40 && covered(); ++tries) y += LINE / 3;
    taken.push({from, to, y});
    const span = element("span", left ? "left" : "", label);
    const colour = MARK_COLOURS[finding % MARK_COLOURS.length];
    span.style.cssText = `left:${x}px;top:${y}px;--mark:${colour}`;
    return span;
  }));
}

/// The directions of x, y and z as `camera` sees them, the nearest last.
export function drawAxes(into, camera) {
  const axes = ["x", "y", "z"].map((name, axis) => {
    const tip = new THREE.Vector3().setComponent(axis, 1);
    return {name, tip: tip.transformDirection(camera.matrixWorldInverse)};
  });
  axes.sort((p, q) => p.tip.z - q.tip.z);
  into.innerHTML = axes.map(
                           ({name, tip: {x, y}}) =>
                               `<g class="axis-${name}"><line x2="${17 * x}" y2="${- 17 * y}"/>` +
                               `<text x="${24 * x}" y="${- 24 * y}">${name}</text></g>`)
                       .join("");
}
