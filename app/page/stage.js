// The canvas: one or two views of the body, the controls of the camera, and picking.
import * as THREE from "three";
import {OrbitControls} from "three/OrbitControls.js";
import {Body, COLOURINGS, sharedUniforms} from "cleave/body.js";
import {FIELD_OF_VIEW, FRONT, bestView, directionOf, frame, skinPlaces} from "cleave/camera.js";
import {readable} from "cleave/data.js";
import {Marks} from "cleave/marks.js";
import {INSIDE, OPENED, SHUT, SKIN} from "cleave/mesh.js";
import {cellsBeyond, incisionEdges, scoredFacets, visibleFacets} from "cleave/mesh.js";
import {drawAxes, drawLabels} from "cleave/overlay.js";

const element = (id) => document.getElementById(id);

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
    this.counts = {
      triangles: visible.facets.length,
      skin: count(SKIN),
      inside: count(INSIDE),
      opened: count(OPENED),
      shut: count(SHUT)
    };
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
    this.controls.addEventListener("start", () => {
      this.framed = null;
    });
    this.home = FRONT;
    new ResizeObserver(() => this.resize()).observe(element("view"));
    this.framed = {};
    this.listen();
    this.resize();
  }

  listen() {
    let down = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      down = [event.clientX, event.clientY];
    });
    this.canvas.addEventListener("pointerup", (event) => {
      if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4)
        this.pick(event);
      down = null;
    });
    this.canvas.addEventListener("keydown", (event) => {
      const turn = {ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, 6], ArrowDown: [
                      0, -6
                    ]}[event.key];
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
    const direction = directionOf(camera ?? this.home);
    this.framed = {camera};
    this.camera.near = 0.01 * this.radius;
    this.camera.far = 40 * this.radius;
    this.controls.minDistance = 0.05 * this.radius;
    this.controls.maxDistance = 20 * this.radius;
    this.camera.updateProjectionMatrix();
    const {target, distance} = frame(this.places, direction, this.camera);
    this.controls.target.copy(target);
    this.camera.position.copy(direction).multiplyScalar(distance / (camera?.zoom ?? 1)).add(target);
    this.controls.update();
    this.invalidate();
  }

  turn(azimuth, elevation) {
    this.framed = null;
    const arm = this.camera.position.clone().sub(this.controls.target);
    arm.applyAxisAngle(this.camera.up, THREE.MathUtils.degToRad(azimuth));
    const beside = this.camera.up.clone().cross(arm).normalize();
    const polar = arm.angleTo(this.camera.up) - THREE.MathUtils.degToRad(elevation);
    if (polar > 0.02 && polar < Math.PI - 0.02)
      arm.applyAxisAngle(beside, -THREE.MathUtils.degToRad(elevation));
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

  /// Finds the view that the page opens with: of the body as it is last, displacements scaled.
  findHome(scale) {
    const last = this.data.states.at(-1);
    this.places = skinPlaces(this.mesh, last, scale);
    if (last.opened.length === 0) return;
    this.uniforms.scale.value = scale;
    this.after.show(last, last, new Uint8Array(this.mesh.cellCount), "home");
    this.after.marks.object.visible = this.after.sheet.object.visible = false;
    this.home = bestView(this.renderer, this.after.root, this.uniforms, this.places);
    this.after.marks.object.visible = true;
  }

  /// Shows a view (see main.js).
  show(view) {
    const {states} = this.data;
    const slice = `${view.axis},${view.at},${view.flip}`;
    if (slice !== this.slice) {
      this.hidden = cellsBeyond(this.mesh, view);
      this.slice = slice;
    }
    const a = Math.min(Math.floor(view.position), states.length - 1),
          b = Math.min(a + 1, states.length - 1);
    const t = view.position - a;
    const ends = t < 1e-6 ? [a, a] : t > 1 - 1e-6 ? [b, b] : [a, b];
    this.after.show(states[ends[0]], states[ends[1]], this.hidden, `${ends} ${slice}`);
    this.after.t.value = ends[0] === ends[1] ? 0 : t;
    if (view.compare) {
      this.before ??= new Scene(this.mesh, this.data, this.uniforms);
      this.before.show(
          states[view.before], states[view.before], this.hidden, `${view.before} ${slice}`);
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
      return [
        [this.before, 0, 0, width / 2, height], [this.after, width / 2, 0, width / 2, height]
      ];
    return [[this.before, 0, height / 2, width, height / 2], [this.after, 0, 0, width, height / 2]];
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = element("view");
    if (!width || !height) return;
    element("view").classList.toggle("stacked", width < height);
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    const [, , , w, h] = this.viewports()[0];
    this.camera.aspect = w / h;
    this.camera.updateProjectionMatrix();
    if (this.framed && this.places) this.look(this.framed.camera);
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
          labels.push({
            ...label,
            x: x + (0.5 + 0.5 * px) * w,
            y: top + (0.5 - 0.5 * py) * h,
            left: px > 0.6
          });
      }
    }
    drawLabels(element("labels"), labels);
    drawAxes(element("triad"), this.camera);
    this.onDrawn?.();
  }

  // Says which cell was clicked.
  pick(event) {
    const box = this.canvas.getBoundingClientRect(), said = element("picked");
    const px = event.clientX - box.left, py = event.clientY - box.top;
    const [scene, x, y, w, h] =
        this.viewports().find(
            ([, left, bottom, width, height]) => px >= left && px < left + width &&
                box.height - py >= bottom && box.height - py <= bottom + height) ??
        [];
    if (!scene) return;
    const pointer = new THREE.Vector2(2 * (px - x) / w - 1, 2 * (box.height - py - y) / h - 1);
    const caster = new THREE.Raycaster();
    caster.setFromCamera(pointer, this.camera);
    const facet = scene.body.pick(caster.ray, scene.t.value, this.view.scale);
    said.hidden = facet < 0;
    if (facet < 0) return;
    said.textContent = this.describe(scene.body, facet, scene.t.value);
    said.style.cssText = `left:${px}px;top:${py}px`;
    this.controls.addEventListener("start", () => {
      said.hidden = true;
    }, {once: true});
  }

  describe(body, facet, t) {
    const cell = body.drawn[facet] >> 2, {materials, materialOfCell, lengthUnit} = this.data;
    const {from, to} = body.geometry.attributes;
    let sum = 0;
    for (let i = 0; i < 3; ++i)
      sum += Math.hypot(...[0, 1, 2].map((axis) => {
        const at = 9 * facet + 3 * i + axis;
        return from.array[at] * (1 - t) + to.array[at] * t;
      })) /
          3;
    const words = [`cell ${this.data.cellNumber(cell)}`];
    if (materialOfCell.length) words.push(materials[materialOfCell[cell]]);
    words.push(`displacement ${readable(sum)} ${lengthUnit}`.trim());
    return words.join(" · ");
  }
}
