// Views in the address: page.html#state=2&colour=material&slice=x,0.4. See docs/page.md.

const yes = (text) => text !== "0";

const READERS = {
  state: (text) => ({position: Number(text)}),
  before: (text) => ({before: Number(text)}),
  colour: (text) => ({colour: text}),
  scale: (text) => ({scale: Number(text)}),
  slice: (text) => {
    const [axis, at = "0.5", side] = text.split(",");
    return {axis, at: Number(at), flip: side === "other"};
  },
  edges: (text) => ({edges: yes(text)}),
  incision: (text) => ({incision: yes(text)}),
  "see-through": (text) => ({seeThrough: yes(text)}),
  compare: (text) => ({compare: yes(text)}),
  findings: (text, view) => ({findings: view.findings.map(() => yes(text))}),
  camera: (text) => {
    const [azimuth, elevation, zoom = 1] = text.split(",").map(Number);
    return {camera: {azimuth, elevation, zoom}};
  },
};

const ALLOWED = {
  position: (x, {last}) => x >= 0 && x <= last,
  before: (x, {last}) => Number.isInteger(x) && x >= 0 && x <= last,
  colour: (x, {colours}) => colours.includes(x),
  scale: (x) => Number.isFinite(x) && x >= 0,
  axis: (x) => ["off", "x", "y", "z"].includes(x),
  at: (x) => x >= 0 && x <= 1,
  camera:
      ({azimuth, elevation, zoom}) => [azimuth, elevation, zoom].every(Number.isFinite) && zoom > 0,
};

/// What the fragment asks for, laid over `view`. A key that cannot mean a view changes nothing.
export function readFragment(fragment, view, limits) {
  const result = {...view};
  for (const [key, text] of new URLSearchParams(fragment.replace(/^#/, ""))) {
    const wanted = READERS[key]?.(text, view) ?? {};
    if (Object.entries(wanted).every(([name, value]) => ALLOWED[name]?.(value, limits) ?? true))
      Object.assign(result, wanted);
  }
  return result;
}
