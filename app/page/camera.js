// Where to look from, and from how far.
import * as THREE from "three";
import {COLOURINGS, cornerDisplacement} from "cleave/body.js";
import {facetCorners} from "cleave/mesh.js";

/// Degrees, of the height of the picture.
export const FIELD_OF_VIEW = 32;

/// Seen from the front, a little from the right and from above.
export const FRONT = {azimuth: -60, elevation: 22};

/// A unit vector from angles in degrees; z is up.
export function directionOf({azimuth, elevation}) {
  const a = THREE.MathUtils.degToRad(azimuth);
  const e = THREE.MathUtils.degToRad(THREE.MathUtils.clamp(elevation, -89, 89));
  return new THREE.Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
}

/// The places of the corners of the skin in a state, displacements scaled: 3 numbers each.
export function skinPlaces(mesh, state, scale) {
  const places = [], corners = [0, 0, 0], u = [0, 0, 0];
  for (let h = 0; h < mesh.mates.length; ++h) {
    if (mesh.mates[h] >= 0) continue;
    facetCorners(mesh, h, corners);
    for (const corner of corners) {
      cornerDisplacement(state, corner, u, 0);
      for (let axis = 0; axis < 3; ++axis)
        places.push(mesh.points[3 * mesh.cells[corner] + axis] + scale * u[axis]);
    }
  }
  return places;
}

/// The middle of what is seen of `places` from `direction`, and the distance from which all of it
/// is in the view of `camera`, with a margin.
export function frame(places, direction, camera) {
  const beside = new THREE.Vector3().crossVectors(camera.up, direction).normalize();
  const above = new THREE.Vector3().crossVectors(direction, beside);
  const axes = [beside, above, direction];
  const place = new THREE.Vector3(), low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let at = 0; at < places.length; at += 3) {
    place.fromArray(places, at);
    for (let i = 0; i < 3; ++i) {
      low[i] = Math.min(low[i], place.dot(axes[i]));
      high[i] = Math.max(high[i], place.dot(axes[i]));
    }
  }
  const target = new THREE.Vector3();
  axes.forEach((axis, i) => target.addScaledVector(axis, 0.5 * (low[i] + high[i])));
  const slope = Math.tan(THREE.MathUtils.degToRad(FIELD_OF_VIEW / 2));
  let distance = 0;
  for (let at = 0; at < places.length; at += 3) {
    place.fromArray(places, at).sub(target);
    const wide = Math.abs(place.dot(beside)) / camera.aspect, tall = Math.abs(place.dot(above));
    distance = Math.max(distance, Math.max(wide, tall) / slope + place.dot(direction));
  }
  return {target, distance: 1.12 * distance};
}

const PROBE = 96;  // pixels of a probing picture, either way

/// The direction, of some round the body, from which most of the opened facets of `scene` is seen:
/// it draws the scene small from each of them and counts. Views from far above or below count less.
/// FRONT if the cut is closed or there is none.
export function bestView(renderer, scene, uniforms, places) {
  const camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 1, 2);
  camera.up.set(0, 0, 1);
  const target = new THREE.WebGLRenderTarget(PROBE, PROBE);
  const pixels = new Uint8Array(4 * PROBE * PROBE), before = uniforms.colouring.value;
  uniforms.colouring.value = COLOURINGS.indexOf("probe");
  renderer.setRenderTarget(target);
  let best = FRONT, most = 8;
  for (let azimuth = -165; azimuth < 180; azimuth += 30) {
    for (const elevation of [15, -20, 45]) {
      const direction = directionOf({azimuth, elevation});
      const {target: middle, distance} = frame(places, direction, camera);
      camera.position.copy(direction).multiplyScalar(distance).add(middle);
      camera.near = 0.05 * distance;
      camera.far = 3 * distance;
      camera.updateProjectionMatrix();
      camera.lookAt(middle);
      renderer.clear();
      renderer.render(scene, camera);
      renderer.readRenderTargetPixels(target, 0, 0, PROBE, PROBE, pixels);
      let seen = 0;
      for (let i = 0; i < pixels.length; i += 4) seen += pixels[i] >> 7;
      seen *= 1 - Math.abs(elevation - 15) / 120;
      if (seen > most) [most, best] = [seen, {azimuth, elevation}];
    }
  }
  renderer.setRenderTarget(null);
  target.dispose();
  uniforms.colouring.value = before;
  return best;
}
