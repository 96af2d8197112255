// Findings in the body: vertices as dots, edges as bars of constant width, labels as HTML above
// them. Where the body hides them they are drawn faintly.
import * as THREE from "three";
import {cornerDisplacement} from "cleave/body.js";

const PLACE = `
attribute vec3 from, to;
uniform float t, scale, pixelRatio;
vec4 place(vec3 rest, vec3 a, vec3 b) {
  vec4 view = modelViewMatrix * vec4(rest + scale * mix(a, b, t), 1.0);
  view.xyz *= 0.985;  // a little nearer: not half inside the facets around it
  return projectionMatrix * view;
}`;

const DOT_VERTEX = `${PLACE}
void main() {
  gl_Position = place(position, from, to);
  gl_PointSize = 15.0 * pixelRatio;
}`;

const DOT_FRAGMENT = `
uniform vec3 colour;
uniform float opacity;
void main() {
  float r = 2.0 * length(gl_PointCoord - 0.5);
  float soft = fwidth(r);
  float inner = 1.0 - smoothstep(0.58 - soft, 0.58 + soft, r);
  float disc = 1.0 - smoothstep(1.0 - 2.0 * soft, 1.0, r);
  gl_FragColor = vec4(mix(vec3(1.0), colour, inner), opacity * disc);
  #include <colorspace_fragment>
}`;

const BAR_VERTEX = `${PLACE}
attribute vec3 otherRest, otherFrom, otherTo;
attribute float side;
uniform vec2 viewport;
void main() {
  vec4 here = place(position, from, to), there = place(otherRest, otherFrom, otherTo);
  vec2 along = (there.xy / there.w - here.xy / here.w) * viewport;
  vec2 across = normalize(vec2(-along.y, along.x) + 1e-9);
  here.xy += across * side * 5.0 * pixelRatio / viewport * here.w;
  gl_Position = here;
}`;

const BAR_FRAGMENT = `
uniform vec3 colour;
uniform float opacity;
void main() {
  gl_FragColor = vec4(colour, opacity);
  #include <colorspace_fragment>
}`;

export const MARK_COLOURS = ["#e0245e", "#7b2ff7", "#0a84ff", "#b26a00"];
const LABELS_AT_MOST = 40;

// A corner of each vertex that the marks name; a vertex without cell has none.
function cornersOf(cells, findings) {
  const corner = new Map();
  for (const {marks} of findings)
    for (const {vertices} of marks)
      for (const v of vertices) corner.set(v, -1);
  for (let h = 0; h < cells.length; ++h)
    if (corner.get(cells[h]) === -1) corner.set(cells[h], h);
  return corner;
}

export class Marks {
  constructor(mesh, findings, uniforms, t) {
    this.mesh = mesh;
    this.findings = findings;
    this.corners = cornersOf(mesh.cells, findings);
    this.uniforms =
        {...uniforms, t, pixelRatio: {value: 1}, viewport: {value: new THREE.Vector2(1, 1)}};
    this.object = new THREE.Group();
    this.groups = findings.map(
        (finding, i) => this.makeGroup(finding, MARK_COLOURS[i % MARK_COLOURS.length]));
    for (const group of this.groups) this.object.add(group);
    this.labels = [];
  }

  makeGroup(finding, colour) {
    const group = new THREE.Group();
    const dots =
        finding.marks.filter((mark) => mark.vertices.length === 1).map((mark) => mark.vertices);
    const bars =
        finding.marks.filter((mark) => mark.vertices.length === 2)
            .flatMap(({
                       vertices: [a, b]
                     }) => [[a, b, 1], [a, b, -1], [b, a, 1], [b, a, 1], [b, a, -1], [a, b, 1]]);
    this.addMeshes(group, dots, colour, THREE.Points, DOT_VERTEX, DOT_FRAGMENT);
    this.addMeshes(group, bars, colour, THREE.Mesh, BAR_VERTEX, BAR_FRAGMENT);
    return group;
  }

  // The same geometry twice: what the body hides faintly, what it does not hide fully.
  addMeshes(group, places, colour, Kind, vertexShader, fragmentShader) {
    if (places.length === 0) return;
    const geometry = new THREE.BufferGeometry();
    geometry.userData.places = places;
    for (const name of ["position", "from", "to", "otherRest", "otherFrom", "otherTo"])
      geometry.setAttribute(
          name, new THREE.BufferAttribute(new Float32Array(3 * places.length), 3));
    const sides = new Float32Array(places.map((place) => place[2] ?? 0));
    geometry.setAttribute("side", new THREE.BufferAttribute(sides, 1));
    for (const [depthTest, opacity] of [[false, 0.4], [true, 1]]) {
      const uniforms = {
        ...this.uniforms,
        colour: {value: new THREE.Color(colour)},
        opacity: {value: opacity}
      };
      const material = new THREE.ShaderMaterial({
        vertexShader,
        fragmentShader,
        uniforms,
        depthTest,
        depthWrite: false,
        transparent: true,
        side: THREE.DoubleSide
      });
      const mesh = new Kind(geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = depthTest ? 3 : 2;
      group.add(mesh);
    }
  }

  /// The place at rest and displacements of a mark's vertex.
  place(vertex, fromState, toState) {
    const rest = Array.from(this.mesh.points.subarray(3 * vertex, 3 * vertex + 3));
    const from = [0, 0, 0], to = [0, 0, 0], corner = this.corners.get(vertex);
    if (corner >= 0) {
      cornerDisplacement(fromState, corner, from, 0);
      cornerDisplacement(toState, corner, to, 0);
    }
    return {rest, from, to};
  }

  fill(fromState, toState) {
    for (const group of this.groups)
      for (const {geometry: {attributes, userData}} of group.children)
        userData.places.forEach(([a, b], i) => {
          const here = this.place(a, fromState, toState),
                there = this.place(b ?? a, fromState, toState);
          const set = (name, value) => attributes[name].array.set(value, 3 * i);
          set("position", here.rest);
          set("from", here.from);
          set("to", here.to);
          set("otherRest", there.rest);
          set("otherFrom", there.from);
          set("otherTo", there.to);
          for (const name of Object.keys(attributes)) attributes[name].needsUpdate = true;
        });
    this.labels = this.findings.flatMap(
        ({marks}, finding) =>
            marks.map(({label, vertices}) => ({
                        label: label.split(":")[0],
                        finding,
                        places: vertices.map((v) => this.place(v, fromState, toState))
                      })));
  }

  show(shown) {
    this.groups.forEach((group, i) => {
      group.visible = shown[i];
    });
    this.shown = shown;
  }

  /// The shown labels nearest to the camera, with their places in the deformed body.
  visibleLabels(camera, t, scale) {
    const all =
        this.labels.filter(({finding}) => this.shown[finding]).map(({label, finding, places}) => {
          const at = new THREE.Vector3();
          for (const {rest, from, to} of places)
            at.add(new THREE.Vector3(
                ...rest.map((x, i) => x + scale * (from[i] * (1 - t) + to[i] * t))));
          return {label, finding, at: at.divideScalar(places.length)};
        });
    all.sort(
        (a, b) =>
            a.at.distanceToSquared(camera.position) - b.at.distanceToSquared(camera.position));
    return all.slice(0, LABELS_AT_MOST);
  }
}
