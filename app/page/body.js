// The drawn body: the visible facets as loose triangles. Each corner carries its place at rest and
// its displacement in two states, so that a copy leaves its parent smoothly and playing costs no
// refill.
import * as THREE from "three";
import {displacementColours, materialColour} from "cleave/colours.js";
import {OPENED_COLOUR, PLAIN_COLOUR, SHUT_COLOUR} from "cleave/colours.js";
import {SKIN, facetCorners} from "cleave/mesh.js";

const VERTEX = `
attribute vec3 from, to, tint;
attribute vec2 kindAndRim;
uniform float t, scale, range;
varying vec3 vPosition, vTint, vEdge;
varying float vMagnitude;
flat varying vec2 vKindAndRim;
void main() {
  vec3 u = mix(from, to, t);
  vec4 view = modelViewMatrix * vec4(position + scale * u, 1.0);
  int corner = gl_VertexID % 3;
  vPosition = view.xyz;
  vTint = tint;
  vEdge = vec3(corner == 2, corner == 0, corner == 1);  // 0 on edge 01, 12, 20
  vMagnitude = length(u) / range;
  vKindAndRim = kindAndRim;
  gl_Position = projectionMatrix * view;
}`;

const FRAGMENT = `
uniform sampler2D map;
uniform int colouring;  // 0 plain, 1 displacement, 2 material, 3 white where opened, else black
uniform float edges, incision, opacity;
uniform vec3 plain, opened, shut, up;
varying vec3 vPosition, vTint, vEdge;
varying float vMagnitude;
flat varying vec2 vKindAndRim;

vec3 lit(vec3 base, vec3 n) {
  vec3 sky = vec3(0.46, 0.49, 0.54), ground = vec3(0.27, 0.25, 0.24);
  vec3 light = mix(ground, sky, 0.5 + 0.5 * dot(n, up));
  light += vec3(1.02, 0.99, 0.94) * max(dot(n, vec3(-0.42, 0.55, 0.72)), 0.0) * 0.62;
  light += vec3(0.80, 0.88, 1.00) * max(dot(n, vec3(0.83, -0.10, 0.55)), 0.0) * 0.20;
  float grazing = pow(1.0 - max(dot(n, normalize(-vPosition)), 0.0), 3.0);
  return base * light + vec3(0.10) * grazing;
}

void main() {
  vec3 n = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
  int kind = int(vKindAndRim.x + 0.5), rim = int(vKindAndRim.y + 0.5);
  if (colouring == 3) {
    gl_FragColor = vec4(vec3(kind == 2), 1.0);
    return;
  }
  vec3 base = colouring == 1 ? texture2D(map, vec2(clamp(vMagnitude, 0.0, 1.0), 0.5)).rgb
            : colouring == 2 ? vTint : plain;
  if (kind == 1) base = mix(base, vec3(dot(base, vec3(0.3, 0.59, 0.11))), 0.25) * 1.12;
  base *= mix(0.6, 1.0, step(1.0, opacity));  // see-through: a stained glass
  if (kind >= 2) base = mix(base, kind == 2 ? opened : shut, 0.82 * incision);

  vec3 width = fwidth(vEdge), pixels = vEdge / width;
  float nearest = min(pixels.x, min(pixels.y, pixels.z));
  float fine = smoothstep(0.12, 0.4, max(width.x, max(width.y, width.z)));  // no room for lines
  base *= 1.0 - edges * 0.55 * (1.0 - fine) * (1.0 - smoothstep(0.3, 1.3, nearest));
  vec3 colour = lit(base, n);
  float facing = abs(dot(n, normalize(vPosition)));
  float alpha = mix(opacity, 1.0, opacity < 1.0 ? 0.7 * pow(1.0 - facing, 1.5) : 0.0);
  for (int i = 0; i < 3; ++i) {
    int of = (rim >> (2 * i)) & 3;
    if (of == 0) continue;
    float line = incision * (1.0 - smoothstep(1.6, 2.6, pixels[i]));
    colour = mix(colour, of == 2 ? opened : shut, line);
    alpha = max(alpha, line);
  }
  gl_FragColor = vec4(colour, alpha);
  #include <colorspace_fragment>
}`;

function displacementTexture() {
  const texture = new THREE.DataTexture(displacementColours(256), 256, 1);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.magFilter = texture.minFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

export const COLOURINGS = ["plain", "displacement", "material", "probe"];

/// Uniforms that all drawn things of one viewport share; `t` is its own.
export function sharedUniforms() {
  const colour = (text) => ({value: new THREE.Color(text)});
  return {
    scale: {value: 1},
    range: {value: 1},
    map: {value: displacementTexture()},
    colouring: {value: 1},
    edges: {value: 1},
    incision: {value: 1},
    up: {value: new THREE.Vector3(0, 0, 1)},
    plain: colour(PLAIN_COLOUR),
    opened: colour(OPENED_COLOUR),
    shut: colour(SHUT_COLOUR),
  };
}

/// Writes 3 numbers per corner: its displacement in `state`.
export function cornerDisplacement(state, corner, into, at) {
  const u = state.displacement;
  if (!u) {
    into[at] = into[at + 1] = into[at + 2] = 0;
    return;
  }
  const v = 3 * state.cells[corner];
  into[at] = u[v];
  into[at + 1] = u[v + 1];
  into[at + 2] = u[v + 2];
}

const SIZES = {position: 3, from: 3, to: 3, tint: 3, kindAndRim: 2};

export class Body {
  constructor(mesh, materialOfCell, uniforms, t) {
    this.mesh = mesh;
    this.materialOfCell = materialOfCell;
    this.tints = [];
    this.opacity = {value: 1};
    this.geometry = new THREE.BufferGeometry();
    this.material = new THREE.ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {...uniforms, t, opacity: this.opacity},
    });
    this.object = new THREE.Mesh(this.geometry, this.material);
    this.object.frustumCulled = false;
    this.capacity = 0;
    this.drawn = [];
  }

  // Room for `corners` corners; attributes grow by doubling and are reused.
  reserve(corners) {
    if (corners <= this.capacity) return;
    this.capacity = Math.max(corners, 2 * this.capacity);
    this.geometry.dispose();
    for (const [name, size] of Object.entries(SIZES)) {
      const bytes = name === "tint" || name === "kindAndRim";
      const array = new (bytes ? Uint8Array : Float32Array)(size * this.capacity);
      const attribute = new THREE.BufferAttribute(array, size, name === "tint");
      attribute.setUsage(THREE.DynamicDrawUsage);
      this.geometry.setAttribute(name, attribute);
    }
  }

  tintOf(cell) {
    const material = this.materialOfCell.length ? this.materialOfCell[cell] : 0;
    return this.tints[material] ??=
               new THREE.Color(materialColour(material)).toArray().map((x) => Math.round(255 * x));
  }

  /// Draws `facets` of the given kinds between two states; rim(a, b) tells edges of the incision.
  fill({facets, kinds}, fromState, toState, rim) {
    const {cells, points} = this.mesh, corners = [0, 0, 0];
    this.drawn = facets;
    this.reserve(3 * facets.length);
    const attribute = this.geometry.attributes;
    if (!attribute.position) return;
    const [position, from, to, tint, kindAndRim] =
        Object.keys(SIZES).map((name) => attribute[name].array);
    for (let f = 0; f < facets.length; ++f) {
      facetCorners(this.mesh, facets[f], corners);
      const rgb = this.tintOf(facets[f] >> 2);
      let edges = 0;
      if (kinds[f] === SKIN)
        for (let i = 0; i < 3; ++i)
          edges |= rim(cells[corners[i]], cells[corners[(i + 1) % 3]]) << (2 * i);
      for (let i = 0; i < 3; ++i) {
        const at = 3 * f + i, v = 3 * cells[corners[i]];
        for (let axis = 0; axis < 3; ++axis) {
          position[3 * at + axis] = points[v + axis];
          tint[3 * at + axis] = rgb[axis];
        }
        cornerDisplacement(fromState, corners[i], from, 3 * at);
        cornerDisplacement(toState, corners[i], to, 3 * at);
        kindAndRim[2 * at] = kinds[f];
        kindAndRim[2 * at + 1] = edges;
      }
    }
    for (const name of Object.keys(SIZES)) attribute[name].needsUpdate = true;
    this.geometry.setDrawRange(0, 3 * facets.length);
  }

  /// The place in `drawn` of the nearest facet that the ray meets, or -1. Linear in what is drawn.
  pick(ray, t, scale) {
    const {position, from, to} = this.geometry.attributes;
    const corner = [0, 1, 2].map(() => new THREE.Vector3()), hit = new THREE.Vector3();
    let best = -1, nearest = Infinity;
    for (let f = 0; f < this.drawn.length; ++f) {
      for (let i = 0; i < 3; ++i) {
        const at = 9 * f + 3 * i;
        const place = (axis) => position.array[at + axis] +
            scale * (from.array[at + axis] * (1 - t) + to.array[at + axis] * t);
        corner[i].set(place(0), place(1), place(2));
      }
      if (!ray.intersectTriangle(...corner, true, hit)) continue;
      const distance = hit.distanceToSquared(ray.origin);
      if (distance < nearest) [nearest, best] = [distance, f];
    }
    return best;
  }
}
