// The canvas: camera, controls, one or two views of the body, labels, the little axes, and picking.
import * as THREE from "three";
import {OrbitControls} from "three/OrbitControls.js";
import {Body, COLOURINGS, cornerDisplacement, sharedUniforms} from "cleave/body.js";
import {readable} from "cleave/data.js";
import {Marks, MARK_COLOURS} from "cleave/marks.js";
import {INSIDE, OPENED, SHUT, SKIN, cellsBeyond, facetCorners, incisionEdges, scoredFacets, visibleFacets} from "cleave/mesh.js";

const element = (id) => document.getElementById(id);
const FIELD_OF_VIEW = 32;

// One body between two states, with its marks and, to see through, its incision alone.
class Scene {
  constructor(mesh, data, uniforms) {
    this.mesh = mesh;
    this.t = {value: 0};
    this.body = new Body(mesh, data.materialOfCell, uniforms, this.t);
    this.sheet = new Body(mesh, data.materialOfCell, uniforms, this.t);
    this.sheet.material.side = THREE.DoubleSide;
    this.marks = new Marks(mesh, data.findings, uniforms, this.t);
    this.root = new THREE.Scene();
    this.root.add(this.body.object, this.sheet.object, this.marks.object);
    this.shown = "";
  }

  /// Refills the geometry when the states or the slice are others than before.
  show(fromState, toState, hidden, key) {
    if (key === this.shown) return;
    this.shown = key;
    const scored = scoredFacets(this.mesh, [fromState, toState]);
    const visible = visibleFacets(this.mesh, scored, hidden);
    this.body.fill(visible, fromState, toState, incisionEdges(this.mesh, scored));
    const facets = [], kinds = [];
    for (let h = 0; h < scored.length; ++h)
      if (scored[h] && !hidden[h >> 2]) facets.push(h), kinds.push(scored[h]);
    this.sheet.fill({facets, kinds}, fromState, toState, () => 0);
    this.marks.fill(fromState, toState);
    const count = (kind) => visible.kinds.reduce((n, k) => n + (k === kind), 0);
    this.counts = {triangles: visible.facets.length, skin: count(SKIN), inside: count(INSIDE),
      opened: count(OPENED), shut: count(SHUT)};
  }

  seeThrough(on) {
    this.sheet.object.visible = on;
    const {material, opacity} = this.body;
    opacity.value = on ? 0.28 : 1;
    if (material.transparent !== on) material.needsUpdate = true;
    material.transparent = on;
    material.depthWrite = !on;
  }
}

/// Whence to look at the incision: against the skin it opens, a little from above; else from the front.
function directionOfIncision(mesh, states) {
  const scored = scoredFacets(mesh, states), rim = incisionEdges(mesh, scored);
  const sum = new THREE.Vector3(), corners = [0, 0, 0];
  const at = (corner) => new THREE.Vector3().fromArray(mesh.points, 3 * mesh.cells[corner]);
  for (let h = 0; h < scored.length; ++h) {
    if (mesh.mates[h] >= 0) continue;
    facetCorners(mesh, h, corners);
    const v = corners.map((corner) => mesh.cells[corner]);
    if (![0, 1, 2].some((i) => rim(v[i], v[(i + 1) % 3]) === OPENED)) continue;
    const [a, b, c] = corners.map(at);
    sum.add(b.sub(a).cross(c.sub(a)).normalize());
  }
  if (sum.length() < 1e-3) return new THREE.Vector3(0.55, -0.75, 0.4).normalize();
  const direction = sum.normalize();
  const beside = new THREE.Vector3(0, 0, 1).cross(direction);
  if (beside.length() < 0.2) beside.set(1, -1, 0);
  direction.addScaledVector(beside.normalize(), 0.35);
  direction.z = THREE.MathUtils.clamp(direction.z, -0.75, 0.85);
  return direction.normalize();
}

export class Stage {
  constructor(data, mesh, radius) {
    this.data = data;
    this.mesh = mesh;
    this.radius = radius;
    this.uniforms = sharedUniforms();
    this.after = new Scene(this.mesh, data, this.uniforms);
    this.before = null;
    this.canvas = element("canvas");
    this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: true, alpha: true});
    this.renderer.autoClear = false;
    this.camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 1, 2);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.controls.dampingFactor = 0.12;
    this.controls.addEventListener("change", () => this.invalidate());
    this.controls.addEventListener("start", () => { this.framed = null; });
    this.home = directionOfIncision(this.mesh, data.states);
    new ResizeObserver(() => this.resize()).observe(element("view"));
    this.framed = {};
    this.listen();
    this.resize();
  }

  listen() {
    let down = null;
    this.canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
    this.canvas.addEventListener("pointerup", (event) => {
      if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) this.pick(event);
      down = null;
    });
    this.canvas.addEventListener("keydown", (event) => {
      const turn = {ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, 6], ArrowDown: [0, -6]}[event.key];
      if (turn) this.turn(...turn);
      else if (event.key === "+" || event.key === "=") this.approach(0.9);
      else if (event.key === "-") this.approach(1 / 0.9);
      else return;
      event.preventDefault();
    });
    this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    this.canvas.addEventListener("webglcontextrestored", () => this.invalidate());
  }

  /// Looks at the body as it is last, from `azimuth` and `elevation` (degrees), or at the incision;
  /// frames all of it. Stays framed when the window changes, until somebody moves the camera.
  look(camera) {
    let direction = this.home;
    if (camera) {
      const [a, e] = [camera.azimuth, Math.min(Math.max(camera.elevation, -89), 89)].map(THREE.MathUtils.degToRad);
      direction = new THREE.Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
    }
    this.framed = {camera};
    this.camera.near = 0.01 * this.radius;
    this.camera.far = 40 * this.radius;
    this.controls.minDistance = 0.05 * this.radius;
    this.controls.maxDistance = 20 * this.radius;
    this.camera.updateProjectionMatrix();
    const {target, distance} = this.frameOf(direction, (this.view ?? {scale: 1}).scale);
    this.controls.target.copy(target);
    this.camera.position.copy(direction).multiplyScalar(distance / (camera?.zoom ?? 1)).add(target);
    this.controls.update();
    this.invalidate();
  }

  skinCorners() {
    if (this.skin) return this.skin;
    const corners = [0, 0, 0];
    this.skin = [];
    for (let h = 0; h < this.mesh.mates.length; ++h) {
      if (this.mesh.mates[h] >= 0) continue;
      facetCorners(this.mesh, h, corners);
      this.skin.push(...corners);
    }
    return this.skin;
  }

  // The middle of what is seen from `direction`, and the distance from which all of it is in view.
  frameOf(direction, scale) {
    const beside = new THREE.Vector3().crossVectors(this.camera.up, direction).normalize();
    const above = new THREE.Vector3().crossVectors(direction, beside);
    const axes = [beside, above, direction], box = axes.map(() => [Infinity, -Infinity]);
    const state = this.data.states.at(-1), u = [0, 0, 0], place = new THREE.Vector3(), places = [];
    for (const corner of this.skinCorners()) {
      cornerDisplacement(state, corner, u, 0);
      place.fromArray(this.mesh.points, 3 * this.mesh.cells[corner]);
      place.set(place.x + scale * u[0], place.y + scale * u[1], place.z + scale * u[2]);
      axes.forEach((axis, i) => {
        const x = place.dot(axis);
        places.push(x);
        box[i] = [Math.min(box[i][0], x), Math.max(box[i][1], x)];
      });
    }
    const middle = box.map(([low, high]) => 0.5 * (low + high));
    const slope = Math.tan(THREE.MathUtils.degToRad(FIELD_OF_VIEW / 2));
    let distance = 0;
    for (let i = 0; i < places.length; i += 3) {
      const wide = Math.abs(places[i] - middle[0]) / (slope * this.camera.aspect);
      const high = Math.abs(places[i + 1] - middle[1]) / slope;
      distance = Math.max(distance, Math.max(wide, high) + places[i + 2] - middle[2]);
    }
    const target = new THREE.Vector3();
    axes.forEach((axis, i) => target.addScaledVector(axis, middle[i]));
    return {target, distance: 1.12 * distance || this.radius};
  }

  turn(azimuth, elevation) {
    this.framed = null;
    const arm = this.camera.position.clone().sub(this.controls.target);
    arm.applyAxisAngle(this.camera.up, THREE.MathUtils.degToRad(azimuth));
    const beside = this.camera.up.clone().cross(arm).normalize();
    const polar = arm.angleTo(this.camera.up) - THREE.MathUtils.degToRad(elevation);
    if (polar > 0.02 && polar < Math.PI - 0.02) arm.applyAxisAngle(beside, -THREE.MathUtils.degToRad(elevation));
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
    this.invalidate();
  }

  approach(factor) {
    this.framed = null;
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.invalidate();
  }

  /// Shows a view (see main.js).
  show(view) {
    const {states} = this.data;
    const slice = `${view.axis},${view.at},${view.flip}`;
    if (slice !== this.slice) {
      this.hidden = cellsBeyond(this.mesh, view);
      this.slice = slice;
    }
    const a = Math.min(Math.floor(view.position), states.length - 1), b = Math.min(a + 1, states.length - 1);
    const t = view.position - a;
    const ends = t < 1e-6 ? [a, a] : t > 1 - 1e-6 ? [b, b] : [a, b];
    this.after.show(states[ends[0]], states[ends[1]], this.hidden, `${ends} ${slice}`);
    this.after.t.value = ends[0] === ends[1] ? 0 : t;
    if (view.compare) {
      this.before ??= new Scene(this.mesh, this.data, this.uniforms);
      this.before.show(states[view.before], states[view.before], this.hidden, `${view.before} ${slice}`);
    }
    const split = view.compare !== !!this.view?.compare;
    this.view = view;
    for (const scene of [this.after, this.before]) {
      scene?.seeThrough(view.seeThrough);
      scene?.marks.show(view.findings);
    }
    this.uniforms.scale.value = view.scale;
    this.uniforms.range.value = view.range || 1;
    this.uniforms.colouring.value = COLOURINGS.indexOf(view.colour);
    this.uniforms.edges.value = view.edges && !view.seeThrough ? 1 : 0;
    this.uniforms.incision.value = view.incision ? 1 : 0;
    if (split) this.resize();
    this.invalidate();
  }

  // The viewports: one, or two beside or above each other.
  viewports() {
    const {clientWidth: width, clientHeight: height} = element("view");
    if (!this.view?.compare) return [[this.after, 0, 0, width, height]];
    if (width >= height)
      return [[this.before, 0, 0, width / 2, height], [this.after, width / 2, 0, width / 2, height]];
    return [[this.before, 0, height / 2, width, height / 2], [this.after, 0, 0, width, height / 2]];
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = element("view");
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    const [, , , w, h] = this.viewports()[0];
    this.camera.aspect = w / h;
    this.camera.updateProjectionMatrix();
    if (this.framed) this.look(this.framed.camera);
    this.draw();  // at once: the new size cleared the canvas
  }

  invalidate() {
    this.frame ??= requestAnimationFrame(() => {
      this.frame = null;
      this.draw();
    });
  }

  draw() {
    if (!this.view) return;
    this.controls.update();
    this.camera.updateMatrixWorld();
    this.uniforms.up.value.copy(this.camera.up).transformDirection(this.camera.matrixWorldInverse);
    this.renderer.setScissorTest(false);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    const labels = [], ratio = this.renderer.getPixelRatio();
    for (const [scene, x, y, w, h] of this.viewports()) {
      this.renderer.setViewport(x, y, w, h);
      this.renderer.setScissor(x, y, w, h);
      scene.marks.uniforms.pixelRatio.value = ratio;
      scene.marks.uniforms.viewport.value.set(w * ratio, h * ratio);
      this.renderer.render(scene.root, this.camera);
      const top = element("view").clientHeight - y - h;
      for (const label of scene.marks.visibleLabels(this.camera, scene.t.value, this.view.scale)) {
        const {x: px, y: py, z} = label.at.project(this.camera);
        if (Math.abs(px) < 1 && Math.abs(py) < 1 && z < 1)
          labels.push([label, x + (0.5 + 0.5 * px) * w, top + (0.5 - 0.5 * py) * h, px > 0.6]);
      }
    }
    this.drawLabels(labels);
    this.drawAxes();
    this.onDrawn?.();
  }

  // Labels that would cover another one move down.
  drawLabels(labels) {
    const taken = [];
    for (const entry of labels) {
      const width = 26 + 6.2 * entry[0].label.length, left = entry[3] ? entry[1] - width : entry[1];
      const covers = (other) => Math.abs(other.y - entry[2]) < 19 && left < other.right && other.left < left + width;
      for (let tries = 0; tries < 12 && taken.some(covers); ++tries) entry[2] += 6;
      taken.push({left, right: left + width, y: entry[2]});
    }
    element("labels").replaceChildren(...labels.map(([{label, finding}, x, y, toTheLeft]) => {
      const span = document.createElement("span");
      span.textContent = label;
      span.classList.toggle("left", toTheLeft);
      span.style.cssText = `left:${x}px;top:${y}px;--mark:${MARK_COLOURS[finding % MARK_COLOURS.length]}`;
      return span;
    }));
  }

  drawAxes() {
    const view = this.camera.matrixWorldInverse, lines = ["x", "y", "z"].map((name, axis) => {
      const tip = new THREE.Vector3().setComponent(axis, 1).transformDirection(view);
      return {name, tip};
    }).sort((p, q) => p.tip.z - q.tip.z);
    element("triad").innerHTML = lines.map(({name, tip}) =>
        `<g class="axis-${name}"><line x2="${17 * tip.x}" y2="${-17 * tip.y}"/>` +
        `<text x="${24 * tip.x}" y="${-24 * tip.y}">${name}</text></g>`).join("");
  }

  // Says which cell was clicked.
  pick(event) {
    const box = this.canvas.getBoundingClientRect(), said = element("picked");
    const px = event.clientX - box.left, py = event.clientY - box.top;
    const [scene, x, y, w, h] = this.viewports().find(([, left, bottom, width, height]) =>
        px >= left && px < left + width && box.height - py >= bottom && box.height - py <= bottom + height) ?? [];
    if (!scene) return;
    const pointer = new THREE.Vector2(2 * (px - x) / w - 1, 2 * (box.height - py - y) / h - 1);
    const caster = new THREE.Raycaster();
    caster.setFromCamera(pointer, this.camera);
    const facet = scene.body.pick(caster.ray, scene.t.value, this.view.scale);
    said.hidden = facet < 0;
    if (facet < 0) return;
    said.textContent = this.describe(scene.body, facet, scene.t.value);
    said.style.cssText = `left:${px}px;top:${py}px`;
    this.controls.addEventListener("start", () => { said.hidden = true; }, {once: true});
  }

  describe(body, facet, t) {
    const cell = body.drawn[facet] >> 2, {materials, materialOfCell, lengthUnit} = this.data;
    const {from, to} = body.geometry.attributes;
    let sum = 0;
    for (let i = 0; i < 3; ++i)
      sum += Math.hypot(...[0, 1, 2].map((axis) => {
        const at = 9 * facet + 3 * i + axis;
        return from.array[at] * (1 - t) + to.array[at] * t;
      })) / 3;
    const words = [`cell ${this.data.cellNumber(cell)}`];
    if (materialOfCell.length) words.push(materials[materialOfCell[cell]]);
    words.push(`displacement ${readable(sum)} ${lengthUnit}`.trim());
    return words.join(" · ");
  }
}
