// The motion of the block and its outcome: what emit writes, joined by impacts, rest and restart as in
// numerics/motion/response.cpp and numerics/motion/overturning.cpp. Times are p t. Inside, angles are in rad and accelerations
// over g; in the linear model, of which alpha is the only scale, angles are over alpha, accelerations over alpha g.
"use strict";

const restSpeed = 1e-9, soonAtRest = 1e-3, afterwards = 10;
const orders = { exact: 20, quick: 14 }, steppers = {};

/// The emitted stepper of one model and side.
function stepperOf(linear, side, order) {
  const name = (linear ? "linear_" : "") + "motion_in_pulse_" + (side < 0 ? "negative" : "positive");
  return (steppers[name + order] ??= new emitted[name](order));
}

/// A polynomial and its derivative; coefficients from `first` on.
function valueOf(c, t, first = 0) {
  let value = 0;
  for (let k = c.length - 1; k >= first; --k) value = value * t + c[k];
  return value;
}
function slopeOf(c, t, first) {
  let value = 0;
  for (let k = c.length - 1; k > first; --k) value = value * t + (k - first) * c[k];
  return value;
}

/// No less than the polynomial anywhere in [0, h].
function farthest(c, h) {
  let value = 0;
  for (let k = c.length - 1; k >= 0; --k) value = value * h + Math.abs(c[k]);
  return value;
}

/// The first zero in (0, h] of a polynomial that is positive at 0; -1 if there is none. Where |y''| <= bound, there is
/// none on an interval whose ends are high enough, and at most one where y' keeps its sign.
function firstZero(c, first, h) {
  let bound = 0;
  for (let k = c.length - 1; k >= first + 2; --k) bound = bound * h + (k - first) * (k - first - 1) * Math.abs(c[k]);
  const ends = [h];
  let low = 0, atLow = c[first];
  while (ends.length) {
    const high = ends[ends.length - 1], atHigh = valueOf(c, high, first), length = high - low;
    const stands = atHigh > 0 && Math.sqrt(atLow) + Math.sqrt(atHigh) >= length * Math.sqrt(bound / 2);
    const middle = low + length / 2, monotone = Math.abs(slopeOf(c, middle, first)) > (bound * length) / 2;
    if (!stands && !monotone && length > 1e-15 * h && ends.length < 60) {
      ends.push(middle);
      continue;
    }
    if (!stands && atHigh <= 0) return zeroBetween(c, first, low, high);
    low = high, atLow = atHigh;
    ends.pop();
  }
  return -1;
}

/// The zero between two times at which the signs are + and -: Newton's iteration in a bracket.
function zeroBetween(c, first, low, high) {
  let t = high;
  for (let i = 0; i < 100; ++i) {
    const value = valueOf(c, t, first), newton = t - value / slopeOf(c, t, first);
    if (value > 0) low = t;
    else high = t;
    const next = newton > low && newton < high ? newton : (low + high) / 2;
    if (Math.abs(next - t) <= 2e-16 * t || next === t) return next;
    t = next;
  }
  return t;
}

/// The ground motion of a case: a pulse that begins when rocking can start, as a sine with phase `phase`.
function pulseOf(c) {
  const linear = c.model === "linear", alpha = linear ? 1 : c.alpha;
  const level = linear ? emitted.amplitude_of_sine_pulse(1, Math.PI / 2) : emitted.ground_that_starts(alpha);
  const amplitude = c.amplitude * alpha, resting = c.angle === 0 && c.velocity === 0;
  const pulse = { linear, alpha, level, amplitude, omega: c.omega, phase: 0, end: 0 };
  if (c.amplitude === 0 || (resting && amplitude < level)) return { ...pulse, amplitude: 0 };
  if (amplitude < level)
    throw new RangeError(`the pulse has no instant at which rocking can start: its amplitude must be at least ` +
      `${(level / alpha).toPrecision(5)}, or 0 for free motion`);
  const psi = emitted.phase_of_sine_pulse(level / amplitude), sine = c.pulse === "sine";
  pulse.psi = sine ? psi : emitted.phase_of_cosine_pulse(level / amplitude);
  pulse.phase = sine ? psi : Math.PI - psi;  // a cos(x + psi) = a sin(x + psi + pi/2)
  pulse.end = sine ? emitted.end_of_sine_pulse(c.omega, psi) : emitted.end_of_cosine_pulse(c.omega, pulse.psi);
  pulse.rises = psi;
  return pulse;
}

function groundAt(pulse, time) {
  if (time > pulse.end || pulse.amplitude === 0) return 0;
  return emitted.ground_of_sine_pulse(pulse.amplitude, pulse.omega, pulse.phase, time);
}

/// The greatest |ground| from one time to another.
function greatestGround(pulse, from, to) {
  if (pulse.amplitude === 0 || from >= pulse.end) return 0;
  const crests = (time) => Math.floor((pulse.omega * time + pulse.phase) / Math.PI - 0.5);
  if (crests(to) > crests(from)) return pulse.amplitude;
  return Math.max(Math.abs(groundAt(pulse, from)), Math.abs(groundAt(pulse, Math.min(to, pulse.end))));
}

/// The next stretch of time in which the ground pushes hard enough to start a block at rest.
function pushAfter(pulse, time) {
  if (!(pulse.amplitude > pulse.level)) return null;
  for (let lobe = 0; lobe < 3; ++lobe) {
    const from = Math.max(0, time, (lobe * Math.PI + pulse.rises - pulse.phase) / pulse.omega);
    const to = Math.min(pulse.end, ((lobe + 1) * Math.PI - pulse.rises - pulse.phase) / pulse.omega);
    if (!(to > from)) continue;
    const gain = ((greatestGround(pulse, from, to) - pulse.level) / pulse.alpha) * (to - from);
    if (gain >= restSpeed) return { from, to, side: lobe % 2 === 0 ? -1 : 1 };
  }
  return null;
}

/// The acceleration of a block at upright, on the side theta < 0.
function accelerationAtUpright(pulse, ground) {
  const stepper = stepperOf(pulse.linear, -1, 2);
  stepper.start(pulse.alpha, 1, 1, 0, 0, ground, 0);
  stepper.expand();
  return stepper.thetadot[1];
}

/// When the chain of ever smaller impacts after this one is over, if certainly before the ground can start the block
/// again; else null: each hop takes 2 v/slowing, each e times the one before, with a factor of two to spare.
function timeOfRest(pulse, e, speed, begin, end) {
  const until = (time) => {
    const slowing = accelerationAtUpright(pulse, greatestGround(pulse, begin, time));
    return slowing > 4 * speed ? (4 * speed) / (Math.max(1 - e, 1e-4) * slowing) : Infinity;
  };
  const first = until(begin), over = Math.min(end, begin + 2 * first);
  return begin + until(over) <= over ? Math.min(over, begin + first / 2) : null;
}

/// What free motion on one side comes to: "critical_velocity", with which it just reaches |theta| = alpha from an
/// angle; "impact_velocity_squared", with which it comes to upright.
function ofFreeMotion({ linear, alpha }, what, side, ...state) {
  const name = (linear ? "linear_" : "") + what + (side < 0 ? "_negative" : "_positive");
  return linear ? emitted[name](...state) : emitted[name](alpha, ...state);
}

/// How far free motion is from overturning outwards and after one more impact; positive = it does. Energy is conserved
/// between impacts (22), and multiplied by e^2 at each.
function margins(c, pulse, side, angle, velocity) {
  const squared = ofFreeMotion(pulse, "impact_velocity_squared", side, angle, velocity);
  return {
    outward: side * (velocity - ofFreeMotion(pulse, "critical_velocity", side, angle)),
    returning: emitted.velocity_after_impact(c.e, Math.sqrt(Math.max(0, squared))) +
      side * ofFreeMotion(pulse, "critical_velocity", -side, 0)
  };
}

/// The motion of a case {alpha, e, omega, amplitude, model, pulse, angle, velocity}: angle = theta/alpha and velocity =
/// thetadot/(alpha p) at the start. With `history`, events and every step as polynomials {from, to, side, angle,
/// velocity}; without, the outcome alone, at the tolerance of a map.
function motionOf(c, history = true) {
  const pulse = pulseOf(c), { linear, alpha } = pulse, quick = !history;
  const tolerance = (quick ? 1e-12 : 1e-17) * alpha, lying = linear ? Infinity : Math.PI / 2;
  const beyond = linear ? 1 + pulse.amplitude : Infinity;  // from here on no ground brings it back
  const events = [], steps = [];
  let time = 0, theta = c.angle * alpha, thetadot = c.velocity * alpha, total = 0, instants = 0, impacts = 0;
  let side = Math.sign(theta || thetadot), end = pulse.end, push = null, moved = side !== 0, outcome = null;
  const note = (kind, after, at = time) =>
    history && events.push({ kind, time: at, angle: theta / alpha, before: thetadot / alpha, after });
  const rest = (at) => {
    time = at, theta = thetadot = side = instants = 0;
    note("rest", 0);
  };
  if (moved) note("start", thetadot / alpha);

  function impact() {
    const after = emitted.velocity_after_impact(c.e, thetadot);
    theta = 0;
    note("impact", after / alpha);
    ++total, ++impacts;
    thetadot = after, side = -side;
    const speed = Math.abs(after) / alpha, small = history ? restSpeed : soonAtRest;
    if (total > 5000 ? speed < 1e-4 && Math.abs(groundAt(pulse, time)) < pulse.level : speed < small) {
      const over = total > 5000 ? time : timeOfRest(pulse, c.e, speed * alpha, time, end);
      if (over !== null) rest(over);
    }
  }

  function swing() {
    const stepper = stepperOf(linear, side, quick ? orders.quick : orders.exact);
    const free = time >= pulse.end, launched = theta === 0 && thetadot === 0;
    const ground = free ? 0 : groundAt(pulse, time), outwards = new Float64Array(stepper.order + 1);
    const turn = free || pulse.amplitude === 0 ? 0
      : emitted.quadrature_of_sine_pulse(pulse.amplitude, pulse.omega, pulse.phase, time);
    stepper.start(alpha, 1, pulse.omega, theta, thetadot, ground, turn);
    for (let left = end - time, go = true; go && left > 0 && side !== 0;) {
      stepper.expand();
      let h = Math.min(stepper.step_size(tolerance), left), hit = -1;
      if (launched && push && time < push.to) h = Math.min(h, push.to - time);
      const angle = stepper.theta, bend = side * angle[2], first = angle[0] === 0 ? 1 : 0;
      if (first && side * angle[1] > 0 && bend < 0) h = Math.min(h, (-1.25 * side * angle[1]) / bend);
      for (let k = 0; k < angle.length; ++k) outwards[k] = side * angle[k];
      if (!(first && angle[1] === 0)) hit = firstZero(outwards, first, h);
      if (hit > 0) h = hit;
      const fall = farthest(outwards, h) < lying ? -1 : firstZero(outwards.map((x, k) => (k ? -x : lying - x)), 0, h);
      const lies = fall > 0;
      if (lies) h = fall, hit = -1;
      if (history)
        steps.push({ from: time, to: time + h, side, angle: angle.slice(), velocity: stepper.thetadot.slice() });
      stepper.advance(h);
      instants = time + h > time ? 0 : instants + 1;
      go = h < left && hit <= 0 && !lies && instants < 3;
      left -= h;
      time = left > 0 ? time + h : end;
      theta = stepper.theta[0], thetadot = stepper.thetadot[0];
      if (hit > 0) impact();
      else if (side * theta < 0) theta = stepper.theta[0] = 0;  // rounding, on leaving upright
      if (lies || (side * theta > beyond && side * thetadot >= 0)) {
        outcome ??= { code: side * (impacts + 1), impacts };
        if (lies || !history || side * theta > 30 * beyond) return false;
      }
      if (instants >= 3) rest(time);
    }
    return true;
  }

  function wait() {
    push = time < pulse.end ? pushAfter(pulse, time) : null;
    if (!push) return void (time = end);
    time = push.from, side = push.side, impacts = 0;
    note(moved ? "restart" : "start", 0);
    moved = true;
  }

  function through(last) {
    end = last;
    while (time < end) {
      if (side === 0) wait();
      else if (!swing()) return false;
    }
    return true;
  }

  const goes = through(pulse.end);
  if (!outcome) {
    const free = side === 0 ? null : margins(c, pulse, side, theta / alpha, thetadot / alpha);
    outcome = { code: 0, impacts };
    if (free && free.outward > 0) outcome.code = side * (impacts + 1);
    else if (free && free.returning > 0) outcome = { code: -side * (impacts + 2), impacts: impacts + 1 };
  }
  if (!history) return outcome;
  if (goes) note("pulse_end", thetadot / alpha);
  if (goes) through(pulse.end + afterwards + (outcome.code ? 50 : 0));
  const over = outcome.code ? overturning(steps, Math.sign(outcome.code), alpha) : null;
  if (over) events.push(over);
  events.sort((a, b) => a.time - b.time);
  const rested = events.find((event) => event.kind === "rest" && event.time >= pulse.end);
  const last = steps.length ? steps[steps.length - 1].to : 0;
  const stop = over ? Math.min(last, over.time + (linear ? 1 : 5)) : rested ? rested.time : pulse.end + afterwards;
  return { ...outcome, pulse, events: events.filter((event) => event.time <= stop), steps,
    time: over ? over.time : null, end: Math.max(stop, pulse.end, 1e-3) };
}

/// The last passage of |theta| = alpha outwards on the side to which the block overturns.
function overturning(steps, side, alpha) {
  for (let i = steps.length - 1; i >= 0; --i) {
    const step = steps[i], length = step.to - step.from;
    if (step.side !== side || side * step.angle[0] >= alpha || side * valueOf(step.angle, length) < alpha) continue;
    const at = zeroBetween(step.angle.map((x, k) => (k ? -side * x : alpha - side * x)), 0, 0, length);
    const velocity = valueOf(step.velocity, at) / alpha;
    return { kind: "overturn", time: step.from + at, angle: side, before: velocity, after: velocity };
  }
  const first = steps[0];  // it began beyond
  return first && { kind: "overturn", time: 0, angle: first.angle[0] / alpha, before: first.velocity[0] / alpha,
    after: first.velocity[0] / alpha };
}

/// theta/alpha, thetadot/(alpha p) and the ground acceleration over alpha g at a time of a motion.
function stateAt(motion, time) {
  const { steps, pulse } = motion;
  let low = 0, high = steps.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (steps[middle].to < time) low = middle + 1;
    else high = middle;
  }
  const ground = groundAt(pulse, time) / pulse.alpha;
  const step = steps[low] ?? (steps.length && motion.code ? steps[steps.length - 1] : null);
  if (!step || step.from > time) return { angle: 0, velocity: 0, ground, side: 0 };
  const since = Math.min(time, step.to) - step.from;
  return { angle: valueOf(step.angle, since) / pulse.alpha, velocity: valueOf(step.velocity, since) / pulse.alpha,
    ground, side: step.side };
}
