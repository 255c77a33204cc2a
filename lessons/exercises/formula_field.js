/**
 * A symbol that an answer may use.
 * @typedef {{name: string, latex: string}} Key
 */

/** @type {?Promise<void>} */
let mathlive = null;

/**
 * Loads MathLive, which lies beside the page, with its letters.
 * @returns {Promise<void>}
 */
function loadMathlive() {
  mathlive ??= (async () => {
    const style = document.createElement("link");
    style.rel = "stylesheet";
    style.href = "mathlive.css";
    document.head.append(style);
    await loadScript("mathlive.min.js");
    MathfieldElement.fontsDirectory = null;  // mathlive.css has them
    MathfieldElement.soundsDirectory = null;
    MathfieldElement.plonkSound = null;
    await customElements.whenDefined("math-field");
    mathVirtualKeyboard.container = document.querySelector("main") ?? document.body;
  })();
  return mathlive;
}

/**
 * Returns the keyboard for an exercise: its symbols, and what formulas are built of. A fraction, a square, a dot
 * above a letter take one touch.
 * @param {Key[]} symbols
 */
function keyboardFor(symbols) {
  /** @type {(latex: string, insert: string, tooltip: string) => object} */
  const key = (latex, insert, tooltip) => ({ latex, insert, tooltip });
  const named = symbols.map(({ name, latex }) => key(latex, latex, name));
  const rows = [];
  for (let at = 0; at < named.length; at += 8) rows.push(named.slice(at, at + 8));
  const functions = ["sin", "cos", "tan", "sinh", "cosh", "ln"].map((name) =>
    key(`\\${name}`, `\\${name}\\left(#?\\right)`, name));
  return { label: "formula", tooltip: "formula", rows: [
    ...rows,
    [key("\\frac{a}{b}", "\\frac{#@}{#?}", "fraction"), key("x^2", "#@^{2}", "square"),
      key("x^{n}", "#@^{#?}", "power"), key("\\sqrt{x}", "\\sqrt{#0}", "root"),
      key("\\dot{x}", "\\dot{#@}", "rate"), key("\\ddot{x}", "\\ddot{#@}", "second rate"),
      key("e^{x}", "e^{#?}", "exponential"), key("\\pi", "\\pi", "pi")],
    [...functions, key("\\lvert x\\rvert", "\\left|#0\\right|", "absolute value"),
      key("\\alpha^\\circ", "^{\\circ}", "degrees")],
    ["7", "8", "9", "+", key("\\cdot", "\\cdot", "times"), "(", ")", "[backspace]"],
    ["4", "5", "6", "-", "=", key("<", "<", "less"), key(">", ">", "greater"), "[left]"],
    ["1", "2", "3", "0", ".", key("\\pm", "\\pm", "plus or minus"), "[hide-keyboard]", "[right]"],
  ] };
}

/**
 * Returns what becomes a sign as soon as it is typed on a keyboard of letters: names, functions, Greek letters.
 * @param {Key[]} symbols
 * @returns {Record<string, string>}
 */
function shortcutsFor(symbols) {
  /** @type {Record<string, string>} */
  const shortcuts = { sqrt: "\\sqrt{#?}", "*": "\\cdot", "<=": "\\le", ">=": "\\ge" };
  const names = "sin cos tan sinh cosh tanh ln exp arcsin arccos arctan alpha beta gamma theta phi psi omega zeta eta pi rho mu";
  for (const name of names.split(" ")) shortcuts[name] = `\\${name}`;
  for (const { name, latex } of symbols) if (name.length > 1) shortcuts[name] = latex;
  return shortcuts;
}

/**
 * Puts a field for formulas in place of a line of text, and a switch between the two. The line keeps what is
 * handed over: LaTeX, or what was typed.
 * @param {HTMLFormElement} form
 * @param {HTMLInputElement} line
 */
async function addFormulaField(form, line) {
  await loadMathlive();
  const field = /** @type {any} */ (document.createElement("math-field"));
  const label = form.querySelector(`label[for="${line.id}"]`);
  field.setAttribute("aria-label", label?.textContent ?? "Your answer");
  line.before(field);
  /** @type {Key[]} */
  const symbols = JSON.parse(form.dataset.symbols ?? "[]");
  const layout = keyboardFor(symbols);
  field.menuItems = [];
  field.inlineShortcuts = shortcutsFor(symbols);
  field.addEventListener("focusin", () => (mathVirtualKeyboard.layouts = [layout, "greek", "alphabetic"]));
  field.addEventListener("input", () => {
    line.value = field.getValue("latex");
    line.dispatchEvent(new Event("input", { bubbles: true }));
  });
  field.addEventListener("change", (/** @type {Event} */ event) => event.stopPropagation());
  field.addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => {
    if (event.key !== "Enter") return;
    event.preventDefault();
    form.requestSubmit(/** @type {HTMLButtonElement} */ (form.querySelector("button[value=check]")));
  });
  const toggle = document.createElement("button");
  toggle.type = "button";
  toggle.className = "switch";
  line.after(toggle);
  /** @param {boolean} isText */
  const show = (isText) => {
    line.hidden = !isText;
    field.hidden = isText;
    toggle.textContent = isText ? "Type with signs of formulas" : "Type as plain text";
  };
  toggle.addEventListener("click", () => {
    const isText = line.hidden;
    if (isText) line.value = plainText(form) ?? line.value;
    else field.setValue(latexOf(form) ?? "", { silenceNotifications: true });
    show(isText);
    (isText ? line : field).focus();
    line.dispatchEvent(new Event("input", { bubbles: true }));
  });
  if (line.value) show(true);
  else show(false);
}

/**
 * What the judge has read last, as plain text.
 * @param {HTMLFormElement} form
 */
const plainText = (form) => /** @type {?HTMLElement} */ (form.querySelector("output [data-plain]"))?.dataset.plain;
/**
 * The same as LaTeX.
 * @param {HTMLFormElement} form
 */
const latexOf = (form) => /** @type {?HTMLElement} */ (form.querySelector("output [data-latex]"))?.dataset.latex;
