// SPDX-License-Identifier: Apache-2.0
// What a hurried hand draws: lines that are overdrawn, wobble and do not quite meet. Points are [x, y] on a sheet of 1000 x 800.
import { seededRandom } from "./random.mjs";

/** A line through these points as a hand would follow it: smooth, and a little beside them. */
function wobbly(points, random, wobble) {
  const phases = [random(), random(), random(), random()].map((share) => share * 2 * Math.PI);
  return points.map(([x, y], index) => {
    const t = index / 7;
    return [
      x + wobble * (Math.sin(t + phases[0]) + 0.5 * Math.sin(2.3 * t + phases[1])),
      y + wobble * (Math.sin(t + phases[2]) + 0.5 * Math.sin(1.7 * t + phases[3])),
    ];
  });
}

function arc([cx, cy], [rx, ry], from, to) {
  const count = Math.max(8, Math.ceil(Math.abs(to - from) * 14));
  return Array.from({ length: count + 1 }, (_, index) => {
    const angle = from + ((to - from) * index) / count;
    return [cx + rx * Math.cos(angle), cy + ry * Math.sin(angle)];
  });
}

/**
 * A closed shape of several strokes. The first ones leave a small gap between each other; each is drawn a second time in part.
 * @returns {number[][][]} strokes
 */
export function roughLoop(centre, radii, seed, { pieces = 3, gap = 0.06, wobble = 2.5 } = {}) {
  const random = seededRandom(seed);
  const strokes = [];
  const turn = (2 * Math.PI) / pieces;
  // At the top: there the empty paper has nothing that could be pressed instead.
  const start = -Math.PI / 2;
  for (let piece = 0; piece < pieces; ++piece) {
    const from = start + piece * turn + (gap * turn) / 2;
    const to = from + turn * (1 - gap);
    strokes.push(wobbly(arc(centre, radii, from, to), random, wobble));
    const middle = from + (0.2 + 0.3 * random()) * turn;
    strokes.push(wobbly(arc(centre, radii, middle, middle + 0.35 * turn), random, wobble));
  }
  return strokes;
}

/** An arm from a root to a hand, open at the root: down one side, round the hand, back on the other. */
export function roughArm(root, hand, width, seed) {
  const random = seededRandom(seed);
  const [dx, dy] = [hand[0] - root[0], hand[1] - root[1]];
  const length = Math.hypot(dx, dy);
  const along = [dx / length, dy / length];
  const at = (t, side) => [
    root[0] + along[0] * t * length - along[1] * side,
    root[1] + along[1] * t * length + along[0] * side,
  ];
  const way = [];
  for (let step = 0; step <= 14; ++step) way.push(at(step / 14, width / 2));
  for (let step = 1; step < 12; ++step) {
    const angle = Math.PI / 2 - (Math.PI * step) / 12;
    way.push(at(1 + (Math.cos(angle) * width * 0.5) / length, Math.sin(angle) * width * 0.5));
  }
  for (let step = 14; step >= 0; --step) way.push(at(step / 14, -width / 2));
  const strokes = [wobbly(way, random, 1.5)];
  return { strokes, helpLine: [at(0, width / 2 + 2), at(0, 0), at(0, -width / 2 - 2)] };
}

/** Somebody with a head, a body and an arm to each side. */
export function roughCharacter(seed = 1) {
  return {
    body: roughLoop([500, 500], [170, 210], seed, { pieces: 4 }),
    head: roughLoop([500, 190], [115, 110], seed + 1),
    nearArm: roughArm([610, 420], [860, 330], 76, seed + 2),
    farArm: roughArm([390, 420], [140, 330], 76, seed + 3),
  };
}

/** Maps the sheet into a rectangle of the window, as large as fits. */
export function placedIn(rect) {
  const scale = Math.min(rect.width / 1000, rect.height / 800);
  const left = rect.x + (rect.width - 1000 * scale) / 2;
  const top = rect.y + (rect.height - 800 * scale) / 2;
  return ([x, y]) => [left + x * scale, top + y * scale];
}
