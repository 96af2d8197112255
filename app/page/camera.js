// Where to look from, and from how far.
import * as THREE from "three";
import {cornerDisplacement} from "cleave/body.js";
import {OPENED, facetCorners, incisionEdges, scoredFacets} from "cleave/mesh.js";

/// Degrees, of the height of the picture.
export const FIELD_OF_VIEW = 32;

/// Whence to look at the incision: against the skin it opens, a little from the side; if it opens
/// none, from the front.
export function directionOfIncision(mesh, states) {
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
