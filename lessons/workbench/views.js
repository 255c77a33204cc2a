// Draws the block, the history, the phase plane and the map.

/// Returns the present colours of the style sheet, by name.
function inks(section) {
  const style = getComputedStyle(section), ink = (name) => style.getPropertyValue("--" + name).trim();
  return Object.fromEntries(["ink", "paper", "soft", "faint", "motion", "ground", "jump", "safe", "block"]
    .map((name) => [name, ink(name)]));
}

/// Makes a canvas as sharp as the screen. Returns its context, width and height.
function sheet(canvas) {
  const ratio = window.devicePixelRatio || 1, { clientWidth: width, clientHeight: height } = canvas;
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== h) canvas.width = w, canvas.height = h;
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  pen.font = '12px "DejaVu Sans", Arial, sans-serif';
  pen.lineJoin = "round";
  return { pen, width, height, ratio };
}

function stroke(pen, points, colour, width = 2, dash = []) {
  pen.beginPath();
  for (const [x, y] of points) pen.lineTo(x, y);
  pen.strokeStyle = colour, pen.lineWidth = width;
  pen.setLineDash(dash);
  pen.stroke();
  pen.setLineDash([]);
}
function dot(pen, x, y, radius, colour) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fillStyle = colour;
  pen.fill();
}
function arrow(pen, x, y, dx, dy, colour) {
  const length = Math.hypot(dx, dy), size = Math.min(7, length), [a, b] = [dx / length, dy / length];
  if (!(length > 1)) return;
  stroke(pen, [[x, y], [x + dx, y + dy]], colour, 2);
  stroke(pen, [[x + dx - size * (a + b / 2), y + dy - size * (b - a / 2)], [x + dx, y + dy],
    [x + dx - size * (a - b / 2), y + dy - size * (b + a / 2)]], colour, 2);
}
function write(pen, text, x, y, colour, align = "center") {
  pen.fillStyle = colour, pen.textAlign = align, pen.textBaseline = "middle";
  pen.fillText(text, x, y);
}

/// Returns about `count` round numbers between two numbers.
function ticks(low, high, count) {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= rough), all = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high * (1 + 1e-9); ++k) all.push(k * step);
  return all;
}

/// Draws axes with round numbers. Returns the functions that place x and y.
function axes({ pen, width, height }, c, [x0, x1], [y0, y1], margin = { left: 38, right: 10, top: 10, bottom: 22 }) {
  const x = (v) => margin.left + ((v - x0) / (x1 - x0)) * (width - margin.left - margin.right);
  const y = (v) => height - margin.bottom - ((v - y0) / (y1 - y0)) * (height - margin.top - margin.bottom);
  const frame = [x(x0), y(y1), x(x1) - x(x0), y(y0) - y(y1)];
  for (const v of ticks(x0, x1, width / 75)) {
    stroke(pen, [[x(v), y(y0)], [x(v), y(y1)]], c.faint, 1);
    write(pen, digits(v), Math.min(x(v), width - 10), height - 10, c.ink);
  }
  for (const v of ticks(y0, y1, height / 50)) {
    stroke(pen, [[x(x0), y(v)], [x(x1), y(v)]], c.faint, 1);
    write(pen, digits(v), margin.left - 5, y(v), c.ink, "right");
  }
  pen.strokeStyle = c.soft, pen.lineWidth = 1;
  pen.strokeRect(...frame);
  return { x, y, frame, clipped: (draw) => {
    pen.save();
    pen.beginPath();
    pen.rect(...frame);
    pen.clip();
    draw();
    pen.restore();
  } };
}

/// Returns the arcs of a motion as points [tau, theta/alpha, thetadot/(alpha p)], computed once.
function arcsOf(motion) {
  if (motion.arcs) return motion.arcs;
  motion.arcs = [];
  let side = 0, last = -1, arc;
  const { alpha } = motion.pulse;
  for (const step of motion.steps) {
    if (step.from > motion.end) break;
    if (step.side !== side || step.from > last + 1e-9) motion.arcs.push((arc = []));
    const count = Math.max(1, Math.ceil((step.to - step.from) / 0.03));
    for (let i = arc.length ? 1 : 0; i <= count; ++i) {
      const since = ((step.to - step.from) * i) / count;
      arc.push([step.from + since, valueOf(step.angle, since) / alpha, valueOf(step.velocity, since) / alpha]);
    }
    side = step.side, last = step.to;
  }
  return motion.arcs;
}

/// Draws the block on the ground, turned about O (theta < 0) or O' (theta > 0), and beside it the energy of free motion
/// over the energy of the barrier.
function drawBlock(canvas, c, state, motion, at) {
  const view = sheet(canvas), { pen, width, height } = view, { alpha } = state;
  const [b, h] = [Math.sin(alpha), Math.cos(alpha)];
  const scale = Math.min((height - 50) / 2.1, (width - 60) / 4.4), ground = height - 34, middle = width / 2;
  const theta = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, at.angle * alpha));
  const pivot = theta < 0 ? -b : b;
  const place = (x, y) => {
    const dx = x - pivot, sin = Math.sin(theta), cos = Math.cos(theta);
    return [middle + scale * (pivot + dx * cos + y * sin), ground - scale * (y * cos - dx * sin)];
  };
  pen.beginPath();
  for (const [x, y] of [[-b, 0], [b, 0], [b, 2 * h], [-b, 2 * h]]) pen.lineTo(...place(x, y));
  pen.closePath();
  pen.fillStyle = c.block, pen.strokeStyle = c.ink, pen.lineWidth = 2;
  pen.fill();
  pen.stroke();
  stroke(pen, [[30, ground], [width - 8, ground]], c.ink, 2);
  const foot = [middle + scale * pivot, ground], centre = place(0, h);
  stroke(pen, [foot, [foot[0], ground - 1.25 * scale]], c.soft, 1, [2, 4]);
  stroke(pen, [foot, centre], c.motion, 1.5, [6, 4]);
  dot(pen, ...centre, 4, c.motion);
  write(pen, "C", centre[0] + 12, centre[1] - 8, c.ink);
  write(pen, "O", middle - scale * b - 9, ground + 11, c.ink);
  write(pen, "O′", middle + scale * b + 11, ground + 11, c.ink);
  const push = motion.pulse.amplitude ? (at.ground / motion.pulse.amplitude) * motion.pulse.alpha : 0;
  arrow(pen, middle, height - 10, push * width * 0.3, 0, c.ground);
  write(pen, "ü", width - 24, height - 11, c.ground);
  write(pen, "g", width - 16, height - 7, c.ground);
  drawEnergy(view, c, motion, at, ground);
}

/// Returns the energy of a free block here, over the energy that passes the barrier.
function energyShare({ pulse }, { side, angle, velocity }) {
  const critical = ofFreeMotion(pulse, "critical_velocity", side, 0);
  return ofFreeMotion(pulse, "impact_velocity_squared", side, angle, velocity) / (critical * critical);
}

function drawEnergy({ pen }, c, motion, at, ground) {
  const share = at.side ? energyShare(motion, at) : 0, top = 24, barrier = top + (ground - top) * 0.4;
  const y = Math.max(top, Math.min(ground, ground - share * (ground - barrier)));
  pen.fillStyle = share > 1 ? c.jump : c.motion;
  pen.fillRect(10, y, 12, ground - y);
  pen.strokeStyle = c.soft, pen.lineWidth = 1;
  pen.strokeRect(10, top, 12, ground - top);
  stroke(pen, [[6, barrier], [26, barrier]], c.ink, 2);
  write(pen, "barrier", 30, barrier, c.ink, "left");
  write(pen, "energy", 6, 12, c.ink, "left");
}

/// Draws theta/alpha (left axis) and the acceleration of the ground (right axis) against tau.
function drawHistory(canvas, c, motion, at, time) {
  const view = sheet(canvas), { pen, width } = view, { pulse } = motion, arcs = arcsOf(motion);
  let most = 1.2;
  for (const arc of arcs) for (const [, angle] of arc) most = Math.max(most, Math.abs(angle));
  most = Math.min(most * 1.05, 2.4);
  const plot = axes(view, c, [0, motion.end], [-most, most], { left: 38, right: 46, top: 10, bottom: 22 });
  const high = pulse.amplitude / pulse.alpha || 1, strong = (ground) => plot.y((ground / high) * most * 0.9);
  for (const value of pulse.amplitude ? [-high, 0, high] : []) write(pen, digits(value, 3), width - 42, strong(value), c.ground, "left");
  plot.clipped(() => {
    for (const level of [-1, 1])
      stroke(pen, [[plot.x(0), plot.y(level)], [plot.x(motion.end), plot.y(level)]], c.soft, 1, [2, 3]);
    const ground = [];
    for (let i = 0; pulse.amplitude && i <= 200; ++i) {
      const t = (pulse.end * i) / 200;
      ground.push([plot.x(t), strong(groundAt(pulse, t) / pulse.alpha)]);
    }
    ground.push([plot.x(pulse.end), strong(0)], [plot.x(motion.end), strong(0)]);
    stroke(pen, ground, c.ground, 1.5, [6, 4]);
    let rested = 0;
    for (const arc of arcs) {
      if (arc[0][0] > rested) stroke(pen, [[plot.x(rested), plot.y(0)], [plot.x(arc[0][0]), plot.y(0)]], c.motion, 2.5);
      stroke(pen, arc.map(([t, angle]) => [plot.x(t), plot.y(angle)]), c.motion, 2.5);
      rested = arc[arc.length - 1][0];
    }
    if (!motion.code) stroke(pen, [[plot.x(rested), plot.y(0)], [plot.x(motion.end), plot.y(0)]], c.motion, 2.5);
    for (const event of motion.events) if (event.kind === "impact") dot(pen, plot.x(event.time), plot.y(0), 3, c.jump);
    stroke(pen, [[plot.x(time), plot.y(-most)], [plot.x(time), plot.y(most)]], c.ink, 1.5);
    dot(pen, plot.x(time), plot.y(at.angle), 5, c.motion);
  });
}

/// Draws the phase plane with the separatrix, on which free motion just reaches |theta| = alpha.
function drawPhase(canvas, c, motion, at, time) {
  const view = sheet(canvas), { pen } = view, arcs = arcsOf(motion);
  let [wide, high] = [1.3, 1.3];
  for (const [, angle, velocity] of arcs.flat())
    wide = Math.max(wide, Math.abs(angle)), high = Math.max(high, Math.abs(velocity));
  wide = Math.min(wide * 1.05, 2.4), high = Math.min(high * 1.05, 4);
  const plot = axes(view, c, [-wide, wide], [-high, high]);
  plot.clipped(() => {
    for (const side of [-1, 1])
      for (const sign of [-1, 1])
        stroke(pen, Array.from({ length: 61 }, (_, i) => {
          const angle = (side * wide * i) / 60;
          return [plot.x(angle), plot.y(sign * ofFreeMotion(motion.pulse, "critical_velocity", side, angle))];
        }), c.ink, 1.5, [2, 4]);
    for (const arc of arcs)
      stroke(pen, arc.map(([, angle, velocity]) => [plot.x(angle), plot.y(velocity)]), c.motion, 1.5);
    for (const { kind, time: when, before, after } of motion.events) {
      if (kind !== "impact" || Math.abs(before) < 1e-3) continue;
      const now = Math.abs(when - time) < 1e-9, from = plot.y(before);
      stroke(pen, [[plot.x(0), from], [plot.x(0), plot.y(after)]], c.jump, now ? 5 : 2.5);
      dot(pen, plot.x(0), plot.y(after), now ? 5 : 2.5, c.jump);
    }
    dot(pen, plot.x(at.angle), plot.y(at.velocity), 5, c.motion);
  });
}

/// Colours after Okabe and Ito, and hatchings, so that outcomes also differ without colour.
const palette = {
  "-1": [[0, 114, 178], () => false],
  1: [[213, 94, 0], (x, y) => x % 6 < 2],
  "-2": [[86, 180, 233], (x, y) => (x + y) % 8 < 2],
  2: [[240, 190, 60], (x, y) => (x - y + 8e4) % 8 < 2],
  "-3": [[204, 121, 167], (x, y) => y % 6 < 2],
  3: [[0, 158, 115], (x, y) => x % 5 < 2 && y % 5 < 2]
};
const kindOf = (code) => (code === null ? null : Math.sign(code) * Math.min(3, Math.abs(code)));

/// Returns the colour of one pixel of an outcome.
function paint(pixels, at, code, x, y, blank) {
  const [colour, hatched] = palette[kindOf(code)] ?? [blank, () => code === null && (x * y) % 7 === 0];
  const shade = hatched(x, y) ? 0.62 : 1;
  for (let k = 0; k < 3; ++k) pixels[at + k] = colour[k] * shade;
  pixels[at + 3] = 255;
}

const rgb = (text) => [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16));

/// Returns the cells of the map as an image, which is kept until the map changes.
function mapImage(map, frame, ratio, c) {
  const [w, h] = [frame[2], frame[3]].map((length) => Math.max(1, Math.round(length * ratio)));
  const key = [w, h, map.version, c.safe].join();
  if (map.key === key) return map.image;
  const image = new ImageData(w, h), { omegas, amplitudes, cells } = map, blank = rgb(c.safe), unknown = rgb(c.paper);
  for (let y = 0; y < h; ++y) {
    const j = Math.round((1 - (y + 0.5) / h) * (amplitudes.count - 1));
    for (let x = 0; x < w; ++x) {
      const code = cells[Math.round(((x + 0.5) / w) * (omegas.count - 1)) * amplitudes.count + j];
      const [kind, colour] = code === undefined ? [0, unknown] : [code, blank];
      paint(image.data, 4 * (y * w + x), kind, Math.floor(x / ratio), Math.floor(y / ratio), colour);
    }
  }
  map.key = key;
  map.image = document.createElement("canvas");
  [map.image.width, map.image.height] = [w, h];
  map.image.getContext("2d").putImageData(image, 0, 0);
  return map.image;
}

const dashes = { "(71)": [], "(78)": [2, 3], "(86), (88)": [9, 4], "(92a), (96)": [9, 3, 2, 3],
  "(103)": [2, 3], "(r15)": [], "(104)": [] };

function drawCurve(pen, plot, { name, points }, only, ink, c) {
  const last = [];
  const threads = [];  // each thread is a line of neighbouring roots
  for (const [omega, found, real] of points) {
    const next = [];
    found.forEach((amplitude, i) => {
      if (only && !real[i]) return;
      const thread = last.find((one) => !next.includes(one) && Math.abs(one.end - amplitude) < 0.1 + 0.12 * amplitude);
      const here = thread ?? { line: [], end: 0 };
      if (!thread) threads.push(here.line);
      here.line.push([plot.x(omega), plot.y(amplitude)]);
      here.end = amplitude;
      next.push(here);
    });
    last.splice(0, last.length, ...next);
  }
  for (const line of threads) {
    stroke(pen, line.length > 1 ? line : [line[0], line[0].map((v) => v + 1)], c.paper, 5);
    stroke(pen, line.length > 1 ? line : [line[0], line[0].map((v) => v + 1)], ink, 2, dashes[name]);
  }
}

/// Draws the map, its curves and the present point. Returns the axes.
function drawMap(canvas, c, map, curves, printed, state) {
  const view = sheet(canvas), { pen, ratio } = view, { omegas, amplitudes } = map;
  const plot = axes(view, c, [omegas.from, omegas.to], [amplitudes.from, amplitudes.to]);
  pen.drawImage(mapImage(map, plot.frame, ratio, c), ...plot.frame);
  plot.clipped(() => {
    for (const curve of curves) drawCurve(pen, plot, curve, !printed, printed ? c.jump : c.ink, c);
    const [x, y] = [plot.x(state.omega), plot.y(state.amplitude)];
    for (const [colour, width] of [[c.paper, 6], [c.ink, 2.5]]) {
      pen.beginPath();
      pen.arc(x, y, 8, 0, 2 * Math.PI);
      pen.strokeStyle = colour, pen.lineWidth = width;
      pen.stroke();
      for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]])
        stroke(pen, [[x + 4 * dx, y + 4 * dy], [x + 14 * dx, y + 14 * dy]], colour, width);
    }
  });
  return plot;
}

/// Draws a small picture of one outcome for the legend.
function swatch(code, c) {
  const canvas = document.createElement("canvas"), [w, h] = [canvas.width, canvas.height] = [26, 16];
  const image = new ImageData(w, h);
  for (let y = 0; y < h; ++y) for (let x = 0; x < w; ++x) paint(image.data, 4 * (y * w + x), code, x, y, rgb(c.safe));
  canvas.getContext("2d").putImageData(image, 0, 0);
  return canvas;
}
