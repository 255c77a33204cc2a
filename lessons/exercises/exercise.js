// Exercises in a page: what is typed goes to the desk, which judges it, and its words are shown.
if (site.judge) recall();
/** @type {?ReturnType<typeof deskOfModule>} */
const moduleDesk = site.judge ? deskOfModule() : null;
/** @type {Desk} */
const desk = moduleDesk ?? deskOfServer();
const report = moduleDesk ? reporter() : null;

/**
 * @param {ParentNode} within
 * @param {string} selector
 * @returns {any}
 */
const find = (within, selector) => within.querySelector(selector);

/**
 * Shows the buttons of the readings of an answer; the one that is picked is checked.
 * @param {HTMLFormElement} form
 * @param {string[]} readings
 * @param {HTMLElement} place
 */
function askWhich(form, readings, place) {
  const choice = document.createElement("p");
  choice.append("Which do you mean? ");
  for (const reading of readings) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = reading;
    button.addEventListener("click", () => {
      const line = /** @type {HTMLInputElement} */ (form.elements.namedItem("answer"));
      line.value = reading;
      form.requestSubmit(find(form, "button[value=check]"));
    });
    choice.append(button);
  }
  place.append(choice);
}

/**
 * Gives life to an exercise.
 * @param {HTMLDetailsElement} box
 */
function attend(box) {
  const exercise = box.dataset.id ?? "", form = /** @type {HTMLFormElement} */ (find(box, "form"));
  const read = /** @type {?HTMLElement} */ (find(form, "output"));
  const said = /** @type {HTMLElement} */ (find(form, ".reply"));
  const line = /** @type {?HTMLInputElement} */ (form.querySelector("input:not([type])"));
  const standing = /** @type {HTMLElement} */ (find(box, ".standing"));
  const typed = () => new FormData(form).get("answer")?.toString() ?? "";
  let latest = 0, timer = 0;

  /** @param {string} button @param {string} answer @param {HTMLElement} place */
  const ask = async (button, answer, place) => {
    const mine = button === "read" ? ++latest : latest;
    const waiting = setTimeout(() => place.setAttribute("aria-busy", "true"), 300);
    try {
      const reply = await desk.ask({ exercise, button, answer });
      if (button === "read" && mine !== latest) return;  // more was typed since
      place.innerHTML = reply.says;
      if (reply.standing) standing.textContent = reply.standing;
      if (reply.opinion) judged(answer, reply.opinion, place);
    } catch (error) {
      place.textContent = /** @type {Error} */ (error).message;
    } finally {
      clearTimeout(waiting);
      place.removeAttribute("aria-busy");
    }
  };
  /** @param {string} answer @param {Opinion} opinion @param {HTMLElement} place */
  const judged = (answer, opinion, place) => {
    if (opinion.verdict === "ambiguous" && opinion.readings) askWhich(form, opinion.readings, place);
    kept.scores[exercise] = Math.max(kept.scores[exercise] ?? 0, opinion.score ?? 0);
    if (site.judge) keep();
    report?.(exercise, answer, opinion);
  };
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const button = /** @type {HTMLButtonElement} */ (event.submitter ?? find(form, "button[value=check]")).value;
    const answer = button === "working" ? new FormData(form).get("working")?.toString() ?? "" : typed();
    ask(button, answer, said);
  });
  form.addEventListener("input", (event) => {
    if (/** @type {HTMLInputElement} */ (event.target).name !== "answer") return;
    if (site.judge) {
      kept.drafts[exercise] = typed();
      keep();
    }
    if (!read) return;
    clearTimeout(timer);
    timer = setTimeout(() => ask("read", typed(), read), site.judge ? 60 : 250);
  });
  let isOpened = false;
  const open = async () => {
    if (!box.open || isOpened) return;
    isOpened = true;
    if (line && kept.drafts[exercise]) line.value = kept.drafts[exercise];
    if (line && site.mathlive && form.dataset.symbols !== "[]")
      await addFormulaField(form, line).catch((error) => console.error(error));
  };
  box.addEventListener("toggle", open);
  open();
  if (moduleDesk || box.open)
    desk.standing(exercise).then((words) => words && (standing.textContent = words), () => {});
}

/**
 * Puts the variant of the seed in place of an exercise.
 * @param {HTMLDetailsElement} box
 */
async function inVariant(box) {
  const { says } = await desk.ask({ exercise: box.dataset.id ?? "", button: "form", answer: "" });
  const template = document.createElement("template");
  template.innerHTML = says;
  const variant = /** @type {HTMLDetailsElement} */ (template.content.firstElementChild);
  variant.open = box.open;
  box.replaceWith(variant);
  attend(variant);
}

/** @type {NodeListOf<HTMLDetailsElement>} */
const boxes = document.querySelectorAll("details.exercise[data-id]");
for (const box of boxes)
  if (!kept.seed) attend(box);
  else if (box.open) inVariant(box);
  else box.addEventListener("toggle", () => inVariant(box), { once: true });

/** The buttons that hand the progress file out and take one in. */
function keepsProgress() {
  const place = document.createElement("div"), heading = document.getElementById("answers");
  if (!heading || !moduleDesk) return;
  heading.after(place);
  place.innerHTML = '<p>Your answers stay in this browser. ' +
    '<button type="button" value="save">Save them as a file</button> ' +
    '<label>Read them from a file: <input type="file" accept=".txt,text/plain"></label></p>' +
    '<p role="status"></p>';
  const words = /** @type {HTMLElement} */ (find(place, "[role=status]"));
  if (kept.seed) words.textContent = `The exercises are in the variant ${kept.seed}.`;
  find(place, "button").addEventListener("click", () => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([kept.progress], { type: "text/plain" }));
    link.download = "exercises.txt";
    link.click();
  });
  const input = /** @type {HTMLInputElement} */ (find(place, "input"));
  input.addEventListener("change", async () => {
    const file = input.files?.[0];
    if (!file) return;
    const trouble = await moduleDesk.replaceProgress(await file.text()).catch((error) => error.message);
    if (trouble) words.textContent = `${file.name}: ${trouble}`;
    else location.reload();
  });
}
keepsProgress();

/// A link to an exercise opens it.
const opened = () => document.getElementById(location.hash.slice(1))?.closest("details")?.setAttribute("open", "");
addEventListener("hashchange", opened);
opened();
