// The workbench: reacts to what the reader types, drags and plays.

const physics = () => document.querySelector("script.workbench-physics").textContent;
const still = matchMedia("(prefers-reduced-motion: reduce)");
const cells = 200;

/// The map of a case, computed by workers. `changed` is called as the map grows.
class OutcomeMap {
  constructor(changed) {
    this.changed = changed, this.job = 0, this.version = 0, this.curves = [];
    const program = URL.createObjectURL(new Blob([physics()], { type: "text/javascript" }));
    const count = Math.max(1, Math.min(4, navigator.hardwareConcurrency || 2));
    this.workers = Array.from({ length: count }, () => new Worker(program));
    for (const worker of this.workers) worker.onmessage = ({ data }) => data.job === this.job && this.take(data);
  }
  start(c, omegas, amplitudes) {
    const count = omegas.count * amplitudes.count;
    Object.assign(this, { omegas, amplitudes, curves: [] });
    this.cells = new Array(count), this.fineness = new Array(count).fill(Infinity);
    this.waits = this.workers.length, this.began = performance.now(), this.seconds = null;
    ++this.job, ++this.version;
    this.workers.forEach((worker, share) =>
      worker.postMessage({ job: this.job, c, omegas, amplitudes, share, of: this.workers.length }));
  }
  take({ stride, column, codes, curves, done }) {
    const { omegas, amplitudes } = this;
    if (curves) this.curves = curves;
    if (done && --this.waits === 0) this.seconds = (performance.now() - this.began) / 1000;
    codes?.forEach((code, k) => {
      for (let i = column; code !== undefined && i < Math.min(column + stride, omegas.count); ++i)
        for (let j = k * stride; j < Math.min((k + 1) * stride, amplitudes.count); ++j) {
          const at = i * amplitudes.count + j;  // another worker may have done it
          if (stride <= this.fineness[at]) this.cells[at] = code, this.fineness[at] = stride;
        }
    });
    this.soon ??= setTimeout(() => {  // drawing takes time from the workers
      this.soon = null;
      ++this.version;
      this.changed();
    }, 100);
  }
}

/// Returns a function that calls another at most once per interval, and surely the last time.
function seldom(action, milliseconds) {
  let timer = null;
  return () => {
    clearTimeout(timer);
    timer = setTimeout(action, milliseconds);
  };
}

class Workbench {
  constructor(section) {
    this.section = section;
    this.find = (what) => section.querySelector(what);
    this.own = document.body.classList.contains("own");
    this.time = 0, this.playing = false, this.started = this.own;
    this.tell = seldom(() => this.say(wordsForCase(this.state, this.motion)), 350);
    this.remember = seldom(() => this.own && history.replaceState(null, "", fragmentOf(this.state)), 350);
    this.recompute = seldom(() => this.startMap(), 60);
    this.listen();
    this.open(this.own && location.hash.length > 1 ? location.hash : section.dataset.case);
  }

  open(text) {
    this.complaint = "";
    this.set(stateFrom(text, (words) => (this.complaint = words)));
  }

  /// Changes the case and everything that depends on it.
  set(changes) {
    const state = { ...this.state, ...changes };
    try {
      const c = caseOf(state);
      if (!(c.e > 0)) throw new RangeError(`restitution: by (46) such a stocky block does not rock on; give a number`);
      if (state.model === "nonlinear" && Math.abs(state.theta0) >= Math.PI / 2)
        throw new RangeError("theta0 must be below pi/2 in size: the block already lies on its side");
      this.motion = motionOf(c);
      this.state = state;
      this.find(".error").textContent = this.complaint;
    } catch (error) {
      this.find(".error").textContent = error.message;
      if (!this.state) this.state = stateFrom(""), this.motion = motionOf(caseOf(this.state));
    }
    this.complaint = "";
    this.time = Math.min(this.time, this.motion.end);
    this.show();
    this.tell();
    this.remember();
    const { omega, amplitude, ...rest } = this.state;
    const key = JSON.stringify([rest, this.spans()]);
    if (key !== this.mapKey) this.mapKey = key, this.recompute();
  }

  /// Writes a text into its option.
  type(name, text) {
    try {
      const value = valueOfOption(name, text.replace(",", ".").replace("−", "-"));
      this.set({ [name]: value });
    } catch (error) {
      this.find(".error").textContent = error.message;
    }
  }

  spans() {
    const reach = (value, usual) => { while (usual < value) usual *= 2; return usual; };
    const { omega, amplitude } = this.state;
    return [{ from: omega < 0.2 ? 0.01 : 0.2, to: reach(omega, 10), count: cells },
      { from: amplitude < 0.5 ? 0 : 0.5, to: reach(amplitude, 12), count: cells }];
  }

  startMap() {
    if (!this.started) return;
    try {
      this.map ??= new OutcomeMap(() => this.draw());
      this.map.start(caseOf(this.state), ...this.spans());
    } catch (error) {
      this.find(".about-curves").textContent = "This browser runs no worker from a file: no map. " + error.message;
    }
  }

  listen() {
    const { section } = this;
    section.addEventListener("input", ({ target: { dataset, name, value } }) => {
      if (dataset.of) this.set({ [dataset.of]: Number(value) });
      if (name === "time") this.pause(), this.go(Number(value));
    });
    section.addEventListener("change", ({ target: { name, value, checked } }) => {
      if (name === "curves") this.draw();
      else if (name === "auto") this.set({ restitution: checked ? "auto" : Number(caseOf(this.state).e.toPrecision(6)) });
      else if (name in options) this.type(name, value);
    });
    this.find(".controls").addEventListener("keydown", (event) =>
      event.key === "Enter" && (event.preventDefault(), event.target.blur()));
    for (const button of section.querySelectorAll("[data-do]"))
      button.addEventListener("click", () => this[button.dataset.do](Number(button.dataset.way)));
    (this.own ? document : section).addEventListener("keydown", (event) => {
      const elsewhere = event.target.closest("input,select,button,textarea,summary,a");
      if (elsewhere || event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key === " ") this.play();
      else if (!this.nudge(event)) return;
      event.preventDefault();
    });
    const canvas = this.find(".map canvas");
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.drag(event);
    });
    canvas.addEventListener("pointermove", (event) => canvas.hasPointerCapture(event.pointerId) && this.drag(event));
    const redraw = () => this.draw();
    new ResizeObserver(redraw).observe(section);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
    for (const event of ["beforeprint", "afterprint"])
      window.addEventListener(event, () => {
        section.classList.toggle("printing", event === "beforeprint");  // print dark on light, even if the screen is dark
        this.drawNow();
      });
    if (this.own) window.addEventListener("hashchange", () => this.open(location.hash));
    else new IntersectionObserver((seen, observer) => {
      if (!seen.some((entry) => entry.isIntersecting)) return;
      observer.disconnect();
      this.started = true;
      this.startMap();
    }, { rootMargin: "300px" }).observe(section);
  }

  radiosOf(name) { return [...this.section.querySelectorAll(`[type=radio][name=${name}]`)]; }

  /// Moves the point of the map by dragging, rounded to the size of a pixel.
  drag(event) {
    const { left, top } = event.target.getBoundingClientRect(), { omegas, amplitudes } = this.map;
    const [x, y, w, h] = this.plot.frame;
    const part = (v) => Math.max(0, Math.min(1, v));
    const at = (span, share) => Number((span.from + (span.to - span.from) * part(share)).toPrecision(3));
    this.set({ omega: Math.max(0.01, at(omegas, (event.clientX - left - x) / w)),
      amplitude: at(amplitudes, 1 - (event.clientY - top - y) / h) });
  }

  /// Handles an arrow key, on the map or elsewhere.
  nudge(event) {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!way) return false;
    if (!event.target.closest(".map")) return way[0] ? (this.step(way[0]), true) : false;
    const by = event.shiftKey ? 0.005 : 0.05;
    const moved = (value, sign) => Number(Math.max(0.01, value + sign * by).toFixed(4));
    this.set({ omega: moved(this.state.omega, way[0]), amplitude: moved(this.state.amplitude, way[1]) });
    return true;
  }

  go(time) {
    this.time = Math.max(0, Math.min(this.motion.end, time));
    this.draw();
  }
  step(way) {
    this.pause();
    this.go(this.time + way * 0.05);
  }
  toEvent(way) {
    this.pause();
    const times = [0, ...this.motion.events.map((event) => event.time), this.motion.end].sort((a, b) => way * (a - b));
    this.go(times.find((when) => way * (when - this.time) > 1e-9) ?? this.time);
    const event = this.motion.events.find((one) => Math.abs(one.time - this.time) < 1e-9);
    if (event) this.say(this.wordsOf(event));
  }
  wordsOf(event) {
    const words = { start: "it starts to rock", rest: "it comes to rest", restart: "it starts again",
      pulse_end: "the ground comes to rest", overturn: "it passes |θ| = α and overturns" };
    if (event.kind !== "impact") return `τ = ${digits(event.time)}: ${words[event.kind]}.`;
    const number = this.motion.events.filter((one) => one.kind === "impact").indexOf(event) + 1;
    return `Impact ${number} at τ = ${digits(event.time)}: θ̇/(αp) from ${digits(event.before)} to ${digits(event.after)}.`;
  }

  play() {
    if (this.playing) return this.pause();
    if (this.time >= this.motion.end - 1e-9) this.time = 0;
    this.playing = true;
    this.last = null;
    this.button();
    requestAnimationFrame((now) => this.frame(now));
  }
  pause() {
    this.playing = false;
    this.button();
  }
  button() {
    const button = this.find("[data-do=play]");
    button.textContent = this.playing ? "❚❚" : "▶";
    button.setAttribute("aria-label", this.playing ? "pause" : "play");
  }

  /// Draws one frame of the animation; with reduced motion, two pictures per second.
  frame(now) {
    if (!this.playing) return;
    this.last ??= now;
    const passed = (now - this.last) / 1000;
    if (!still.matches || passed > 0.5) {
      const speed = Number(this.find("[name=speed]").value) * this.state["frequency-parameter"];
      let time = this.time + Math.min(passed, 0.6) * speed;
      const halt = this.find("[name=halt]").checked && this.motion.events.find((event) =>
        event.kind === "impact" && event.time > this.time + 1e-9 && event.time <= time &&
        Math.abs(event.before) > 1e-3);
      if (halt) time = halt.time;
      this.last = now;
      this.go(time);
      if (halt) this.say(this.wordsOf(halt));
      if (halt || time >= this.motion.end) return this.pause();
    }
    requestAnimationFrame((next) => this.frame(next));
  }

  say(words) {
    const html = words.replace(/[&<>]/g, (c) => `&#${c.charCodeAt(0)};`).replace(/_(\w+)/g, "<sub>$1</sub>");
    if (this.said !== html) this.find(".state").innerHTML = this.said = html;
  }

  /// Puts the case into the controls.
  show() {
    const { state } = this, e = caseOf(state).e;
    for (const name of Object.keys(options)) {
      const value = name === "restitution" ? e : state[name];
      const input = this.find(`.controls input:not([type])[name="${name}"]`);
      if (input && input !== document.activeElement)
        input.value = name === "restitution" && state[name] === "auto" ? digits(e, 6) : String(value);
      for (const slider of this.section.querySelectorAll(`[data-of="${name}"]`)) slider.value = value;
      for (const radio of this.radiosOf(name)) radio.checked = radio.value === value;
    }
    this.find("[name=auto]").checked = state.restitution === "auto";
    this.find(".command").textContent = commandOf(state);
    this.draw();
  }

  draw() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => this.drawNow());
  }

  drawNow() {
    this.waiting = null;
    const { state, motion, time, map } = this, c = inks(this.section), at = stateAt(motion, time);
    drawBlock(this.find(".block canvas"), c, state, motion, at);
    drawHistory(this.find(".history canvas"), c, motion, at, time);
    drawPhase(this.find(".phase canvas"), c, motion, at, time);
    const slider = this.find("[name=time]");
    slider.max = motion.end, slider.value = time;
    const words = `τ = ${time.toFixed(2)}, θ/α = ${at.angle.toFixed(3)}`.replaceAll("-", "−");
    slider.setAttribute("aria-valuetext", words);
    this.find(".now").textContent = `${words}, t = ${(time / state["frequency-parameter"]).toFixed(2)} s`;
    if (map?.cells) this.drawMap(c, map);
  }

  drawMap(c, map) {
    const chosen = this.radiosOf("curves").find((radio) => radio.checked).value, printed = chosen === "printed";
    let curves = chosen === "none" ? [] : map.curves.filter(({ name }) => !printed || name !== "(r15)");
    const running = "(86), (88)";  // (88) as printed has a running t, the time of the picture
    if (printed && formsFor(caseOf(this.state)).includes(running)) {
      const key = [map.job, this.time].join();
      if (key !== this.printedKey) {
        this.printedKey = key;
        this.printed = curvesOf(caseOf(this.state), { ...map.omegas, count: 70 }, [running], this.time)[0];
      }
      curves = curves.map((curve) => (curve.name === running ? this.printed : curve));
    }
    this.plot = drawMap(this.find(".map canvas"), c, map, curves, printed, this.state);
    this.about(chosen, curves);
    const present = [...new Set(map.cells.filter((code) => code !== undefined).map(kindOf))].sort((a, b) => a - b);
    const legend = this.find(".legend");
    const key = present.join() + c.safe;
    if (key === legend.dataset.key) return;
    legend.dataset.key = key;
    legend.replaceChildren(...present.map((code) => {
      const entry = document.createElement("span");
      const words = Math.abs(code) === 3 ? wordsFor(code).replace("2 impacts", "2 impacts or more") : wordsFor(code);
      entry.append(swatch(code, c), `${code > 0 ? "+" : ""}${String(code ?? "").replace("-", "−")} ${words}`);
      return entry;
    }));
  }

  /// Says which curves are drawn, and what is wrong with the printed ones.
  about(chosen, curves) {
    const drawn = ({ points }) =>
      points.some(([, found, real]) => (chosen === "printed" ? found.length : real.includes(true)));
    const style = { "": "full", "2,3": "dotted", "9,4": "dashed", "9,3,2,3": "dash-dotted" };
    const shown = curves.filter(drawn).map(({ name }) => name), has = (name) => shown.some((one) => one.includes(name));
    const names = shown.map((name) => `${name} ${style[dashes[name]]}`).join("; ");
    const words = chosen === "none" ? "" : chosen === "corrected"
      ? (names ? `${names}: roots at which the linear block's motion does change.` : "No closed form holds here.") +
        (has("(88)") ? " In (88) the time is that of the impact." : "") +
        (has("r15") ? " (r15) is a result of the ledger; the paper has none from rest." : "")
      : `${names || "No root"}: every root.` +
        (has("(88)") ? " (88) is printed with a running t: here that of the player, p t = " +
          `${this.time.toFixed(2)}, and the curve moves with it.` : "") +
        (has("(103)") ? " (103) is of a block that is on the side θ > 0 from the start." : "");
    const text = curves.length || chosen === "none" ? words : "Curves are being computed.";
    const place = this.find(".about-curves");
    if (place.textContent !== text) place.textContent = text;
  }

  command() { this.copy(commandOf(this.state), "The command"); }
  link() {
    const page = this.own ? location.href.split("#")[0] : new URL("workbench.html", location.href).href;
    this.copy(page + fragmentOf(this.state), "The link");
  }
  async copy(text, what) {
    try {
      await navigator.clipboard.writeText(text);
      this.say(what + " is in the clipboard.");
    } catch {
      const code = this.find(".command");
      code.textContent = text;
      getSelection().selectAllChildren(code);
      this.say(what + " is selected below: copy it from there.");
    }
  }
}

const workbenches = [...document.querySelectorAll(".workbench")].map((section) => new Workbench(section));
