// A case: as a command writes it, as the fragment of an address, and in words.
"use strict";

/// The options of `rocking response` that the page knows, with their defaults and ranges.
const options = {
  omega: { value: 2, low: 0.01, high: 1000 },
  amplitude: { value: 2, low: 0, high: 1e6 },
  alpha: { value: 0.25, low: 1e-12, high: Math.PI / 2, open: true },
  restitution: { value: "auto", low: 0, high: 1, words: ["auto"] },
  "frequency-parameter": { value: 2.14, low: 0, high: 1e9 },
  model: { value: "linear", words: ["linear", "nonlinear"] },
  pulse: { value: "sine", words: ["sine", "cosine"] },
  theta0: { value: 0, low: -1e9, high: 1e9 },
  thetadot0: { value: 0, low: -1e9, high: 1e9 }
};
const always = ["omega", "amplitude"];  // the command requires these

/// Returns the value of an option from a text. Throws RangeError, with a message, for other texts.
function valueOfOption(name, text) {
  const { low, high, open, words } = options[name];
  if (words?.includes(text)) return text;
  const value = text.trim() === "" ? NaN : Number(text);
  if (low === undefined || !Number.isFinite(value))
    throw new RangeError(`${name}: '${text}' is not ${words && low === undefined ? words.join(" or ") : "a number"}`);
  const above = low === 0 && name !== "amplitude" ? value > 0 : value >= low;
  if (!above || !(open ? value < high : value <= high))
    throw new RangeError(`${name}: ${text} must lie between ${low} and ${Number(high.toPrecision(5))}`);
  return value;
}

/// Returns a state from the options of a command or from a fragment. Errors are left out and given to `complain`.
function stateFrom(text, complain = () => {}) {
  const state = Object.fromEntries(Object.entries(options).map(([name, { value }]) => [name, value]));
  for (const [, name, value] of text.matchAll(/(?:--|[#&]|^)([a-z][a-z0-9-]*)[=\s]+([^\s&]+)/g))
    try {
      if (!options[name]) throw new RangeError(`there is no option ${name}`);
      state[name] = valueOfOption(name, decodeURIComponent(value));
    } catch (error) {
      complain(error.message);
    }
  return state;
}

const said = (state) =>
  Object.keys(options).filter((name) => always.includes(name) || state[name] !== options[name].value);
const commandOf = (state) => "rocking response " + said(state).map((name) => `--${name}=${state[name]}`).join(" ");
const fragmentOf = (state) => "#" + said(state).map((name) => `${name}=${state[name]}`).join("&");

const digits = (x, n = 4) => String(Number(x.toPrecision(n))).replace("-", "−");

/// Returns the words of `rocking` for a code.
function wordsFor(code) {
  if (code === null) return "no pulse: the ground never pushes hard enough for rocking to start";
  if (code === 0) return outcomeWords.safe;
  const impacts = Math.abs(code) - 1, [left, right] = outcomeWords.sides;
  const how = outcomeWords.impacts[Math.min(impacts, 2)].replace("{}", impacts);
  return outcomeWords.pattern.replace("{}", code < 0 ? left : right).replace("{}", how).replace("theta", "θ");
}

/// Returns the case and its outcome in words.
function wordsForCase(state, motion) {
  const impacts = motion.events.filter((event) => event.kind === "impact").length, { theta0, thetadot0 } = state;
  const parts = [state.model === "linear" ? "Linear model" : "Nonlinear model"];
  if (state.amplitude === 0) parts.push("free motion");
  else parts.push(`one-${state.pulse} pulse`, `ω_p/p = ${digits(state.omega)}`, `a_p = ${digits(state.amplitude)} αg`);
  parts.push(`α = ${digits(state.alpha)}`, `e = ${digits(caseOf(state).e)}`);
  if (theta0 || thetadot0) parts.push(`θ_0 = ${digits(theta0)} rad`, `θ̇_0 = ${digits(thetadot0)} rad/s`);
  const end = motion.time !== null ? ` at τ = ${digits(motion.time)}`
    : motion.steps.length === 0 ? "; the block does not move"
    : `; ${impacts} impact${impacts === 1 ? "" : "s"} until τ = ${digits(motion.end)}`;
  return `${parts.join(", ")}: ${wordsFor(motion.code)}${end}.`;
}
