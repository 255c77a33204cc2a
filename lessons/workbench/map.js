// The outcome over a grid of omega_p/p and amplitude, and the closed forms of the paper. This script and those before it
// are also the whole program of a Web Worker.

/// Returns a case from the numbers of a command; rad and rad/s become theta/alpha and thetadot/(alpha p).
function caseOf(state) {
  const { alpha, omega, amplitude, model, pulse } = state;
  return {
    alpha, omega, amplitude, model, pulse,
    e: state.restitution === "auto" ? emitted.restitution(alpha) : state.restitution,
    angle: state.theta0 / alpha,
    velocity: state.thetadot0 / (alpha * state["frequency-parameter"])
  };
}

const station = ({ from, to, count }, i) => (count === 1 ? from : from + ((to - from) * i) / (count - 1));

/// Returns the code of one cell; null if the pulse has no instant at which rocking can start.
function codeOf(c, omega, amplitude) {
  try {
    return motionOf({ ...c, omega, amplitude }, false).code;
  } catch {
    return null;
  }
}

/// Returns the roots of f between two numbers. f is small at a root, but not at a jump.
function rootsOf(f, low, high, count) {
  const roots = [];
  let x = low, y = f(x);
  for (let i = 1; i <= count; ++i) {
    const next = low + ((high - low) * i) / count, value = f(next);
    if (y < 0 !== value < 0 && Number.isFinite(y + value)) {
      let a = x, b = next;
      for (let k = 0; k < 60; ++k) {
        const middle = (a + b) / 2;
        if (f(middle) < 0 === y < 0) a = middle;
        else b = middle;
      }
      if (Math.abs(f(b) - f(a)) < 1e-6 * (1 + Math.abs(y) + Math.abs(value))) roots.push(b);
    }
    x = next, y = value;
  }
  return roots;
}

const inside = 1e-7;
const amplitudeAt = (psi) => emitted.amplitude_of_sine_pulse(1, psi);

/// Returns the phase in (0, pi) for which theta = 0 at tau, by (86), which is linear in sin(psi) and cos(psi).
function phaseOfImpact(omega, tau) {
  const at = emitted.impact_during_pulse_with_derivatives(omega, 0, tau), psi = Math.atan2(-at.value, at.d_psi);
  return psi > 0 ? psi : psi + Math.PI;
}

/// The paper's conditions for overturning: the code, and the amplitudes at one omega_p/p. `t` is the running time in
/// (88) as printed.
const forms = {
  "(71)": { code: -1, amplitudes: ({ omega }) =>
    rootsOf((psi) => emitted.overturning_without_impact_negative(omega, psi), inside, Math.PI - inside, 300)
      .map(amplitudeAt) },
  "(78)": { code: 1, amplitudes: ({ omega }) =>
    rootsOf((psi) => emitted.overturning_without_impact_positive(omega, psi), inside, Math.PI - inside, 300)
      .map(amplitudeAt) },
  "(86), (88)": { code: 2, amplitudes: ({ omega, e, t }) => {
    const end = (psi) => emitted.end_of_sine_pulse(omega, psi), longest = end(0);
    const value = (tau) => t === undefined
      ? emitted.overturning_impact_during_pulse(omega, phaseOfImpact(omega, tau), tau, e)
      : emitted.overturning_impact_during_pulse_as_printed(omega, 1, phaseOfImpact(omega, tau), tau, t, e);
    return rootsOf(value, 1e-3 * longest, longest, t === undefined ? 300 : 120)
      .map((tau) => ({ tau, psi: phaseOfImpact(omega, tau) }))
      .filter(({ tau, psi }) => tau <= end(psi)).map(({ psi }) => amplitudeAt(psi));
  } },
  "(92a), (96)": { code: 2, amplitudes: ({ omega, e }) => {
    const growth = (psi) => emitted.growth_to_critical_impact(omega, psi, e);
    const value = (psi) => emitted.impact_after_pulse(omega, psi,
      emitted.end_of_sine_pulse(omega, psi) + Math.log(growth(psi)));
    return rootsOf(value, inside, Math.PI - inside, 300).filter((psi) => growth(psi) >= 1).map(amplitudeAt);
  } },
  "(103)": { code: 1, amplitudes: ({ omega, push }) =>
    rootsOf((psi) => emitted.overturning_cosine_pulse(omega, psi, push), inside - Math.PI / 2, Math.PI / 2 - inside, 300)
      .map((psi) => emitted.amplitude_of_cosine_pulse(1, psi)) },
  "(r15)": { code: 1, amplitudes: ({ omega }) =>  // our result: the paper has no condition from rest
    rootsOf((psi) => emitted.overturning_cosine_pulse_from_rest(omega, 1, psi), inside, Math.PI / 2 - inside, 300)
      .map((psi) => emitted.amplitude_of_cosine_pulse(1, psi)) },
  "(104)": { code: -1, amplitudes: ({ omega, push }) =>
    rootsOf((psi) => emitted.overturning_sine_pulse(omega, psi, push), inside, Math.PI - inside, 300).map(amplitudeAt) }
};

/// Returns the conditions that apply to a pulse and its initial conditions.
function formsFor(c) {
  const rests = !c.angle && !c.velocity;
  if (c.pulse === "cosine") return rests ? ["(103)", "(r15)"] : ["(103)"];
  return rests ? ["(71)", "(78)", "(86), (88)", "(92a), (96)"] : ["(104)"];
}

/// Returns whether the outcome of the linear block changes there as the form says.
function isReal(c, form, omega, amplitude) {
  const codes = [1e-6, -1e-6].map((d) => codeOf({ ...c, model: "linear" }, omega, amplitude * (1 + d)));
  return codes[0] !== codes[1] && codes.includes(form.code);
}

/// Returns the curves over a span of omega_p/p: {name, points: [[omega, amplitudes, real]...]}.
function curvesOf(c, span, names = formsFor(c), t = undefined) {
  return names.map((name) => {
    const points = [];
    for (let i = 0; i < span.count; ++i) {
      const omega = station(span, i);
      const found = forms[name].amplitudes({ omega, e: c.e, push: c.angle + c.velocity, t });
      points.push([omega, found, t === undefined ? found.map((a) => isReal(c, forms[name], omega, a)) : []]);
    }
    return { name, points };
  });
}

const strides = [8, 4, 2, 1];

/// Runs in a worker: computes its columns, coarse ones first. One worker computes the curves before that.
function work() {
  const pause = new MessageChannel();
  let current = 0;
  const yielded = () => new Promise((resume) => {
    pause.port1.onmessage = resume;
    pause.port2.postMessage(0);
  });
  self.onmessage = async ({ data: { job, c, omegas, amplitudes, share, of } }) => {
    current = job;
    for (const stride of strides) {
      for (let i = share * stride; i < omegas.count; i += of * stride) {
        const omega = station(omegas, i), codes = [];
        for (let j = 0; j < amplitudes.count; j += stride) {
          const known = stride < strides[0] && i % (2 * stride) === 0 && j % (2 * stride) === 0;
          codes.push(known ? undefined : codeOf(c, omega, station(amplitudes, j)));
        }
        await yielded();
        if (job !== current) return;
        self.postMessage({ job, stride, column: i, codes });
      }
      if (stride === strides[0] && share === 0)
        self.postMessage({ job, curves: curvesOf(c, { ...omegas, count: 120 }) });
    }
    self.postMessage({ job, done: true });
  };
}
if (typeof document === "undefined" && typeof self !== "undefined") work();
