/**
 * What a browser keeps of a student's work.
 * @typedef {object} Kept
 * @property {string} progress  the text of the progress file
 * @property {string} seed
 * @property {Record<string, string>} standings  by exercise
 * @property {Record<string, number>} scores  the best, from 0 to 1
 * @property {Record<string, string>} drafts  what was typed last
 */

/** @type {Kept} */
const kept = { progress: "", seed: "", standings: {}, scores: {}, drafts: {} };

/** Keeps it beyond this page, where the browser allows that. */
function keep() {
  try {
    localStorage.setItem(`rederive ${site.paper}`, JSON.stringify(kept));
  } catch { /* a private window: it lasts as long as the page */ }
}

/** Reads what was kept, and the seed of the address, which a teacher may have set. */
function recall() {
  try {
    Object.assign(kept, JSON.parse(localStorage.getItem(`rederive ${site.paper}`) ?? "{}"));
  } catch { /* nothing was kept, or not by us */ }
  const seed = new URLSearchParams(location.search).get("seed");
  if (seed === null || seed === kept.seed) return;
  kept.seed = seed;
  kept.drafts = {};
  keep();
}

/**
 * The code of the worker. It is sent as text behind that of judge.js, which defines `rederive`.
 */
function workOfJudge() {
  /** @type {any} */
  let judge = null;
  const call = (/** @type {string} */ name, /** @type {string[]} */ ...texts) =>
    judge.ccall(name, "string", texts.map(() => "string"), texts);
  onmessage = async ({ data }) => {
    const answer = { error: "", reply: "", progress: "" };
    try {
      if (data.binary) {
        judge = await rederive({ wasmBinary: data.binary, print() {}, printErr() {} });
        if (data.files) answer.error = JSON.parse(call("rederive_reply", JSON.stringify({ paper: data.files }))).error ?? "";
        answer.error ||= call("rederive_set_progress", data.progress);
      } else if (data.progress !== undefined) answer.error = call("rederive_set_progress", data.progress);
      else answer.reply = call("rederive_reply", data.request);
      answer.progress = call("rederive_progress");
      postMessage(answer);
    } catch (error) {
      postMessage({ crash: String(error) });
    }
  };
}

/**
 * The sentence of an answer on which the module gave up.
 * @param {string} why
 * @returns {Reply}
 */
function undecided(why) {
  const box = document.createElement("div");
  box.innerHTML = '<div class="said undecided"><p><b>Undecided.</b></p><p></p></div>';
  /** @type {HTMLElement} */ (box.querySelector("p:last-child")).textContent = why;
  return { says: box.innerHTML, standing: "", opinion: { verdict: "undecided", score: 0 } };
}

/**
 * Returns the desk that judges in the page: it loads the module at the first question, asks it one question at a
 * time, and starts it again when it has crashed or been ended.
 * @param {number} [patience]  the milliseconds after which an answer is given up
 * @returns {Desk & {replaceProgress: (text: string) => Promise<string>, seconds: () => number}}
 */
function deskOfModule(patience = 60_000) {
  /** @type {?Promise<{code: string, binary: ArrayBuffer}>} */
  let source = null;
  /** @type {?Worker} */
  let worker = null;
  /** @type {Promise<unknown>} */
  let queue = Promise.resolve();
  let spent = 0;

  const load = async () => {
    if (location.protocol !== "file:") {
      const files = await Promise.all([fetch("judge.js"), fetch("judge.wasm")]);
      if (files.every((file) => file.ok)) return { code: await files[0].text(), binary: await files[1].arrayBuffer() };
    }
    await loadScript("judge.inline.js");  // a page of a file may fetch no other file, but a script
    const bytes = Uint8Array.from(atob(inlined.binary), (byte) => byte.charCodeAt(0));
    return { code: inlined.code, binary: bytes.buffer };
  };
  const end = () => {
    worker?.terminate();
    worker = null;
  };
  /** @param {object} message @returns {Promise<any>} */
  const tell = (message) => new Promise((done) => {
    if (!worker) return done({ crash: "there is no worker" });
    const timer = setTimeout(() => done({ crash: "it took too long" }), patience);
    worker.onmessage = ({ data }) => (clearTimeout(timer), done(data));
    worker.onerror = (event) => (event.preventDefault(), clearTimeout(timer), done({ crash: event.message }));
    worker.postMessage(message);
  });
  const start = async () => {
    if (worker) return;
    source ??= load().catch(() => {
      source = null;
      throw new Error("The judge could not be loaded. Copy the whole folder, with judge.js, judge.wasm and " +
        "judge.inline.js, and open this page again.");
    });
    const { code, binary } = await source;
    const text = new Blob([code, `\n;(${workOfJudge})();`], { type: "text/javascript" });
    worker = new Worker(URL.createObjectURL(text));
    const files = Object.keys(site.files).length > 0 ? site.files : null;
    const begun = await tell({ binary, files, progress: kept.progress });
    if (!begun.crash) return;
    end();
    throw new Error("This browser cannot run the judge. A browser of 2022 or later can.");
  };
  /**
   * Asks one question after the others.
   * @param {object} message
   * @returns {Promise<any>}
   */
  const inTurn = (message) => {
    const mine = queue.then(async () => {
      await start();
      const from = performance.now(), answer = await tell(message);
      spent = performance.now() - from;
      if (answer.crash) end();
      return answer;
    });
    queue = mine.catch(() => {});
    return mine;
  };
  return {
    seconds: () => spent / 1000,
    standing: async (exercise) => kept.standings[exercise] ?? "",
    async ask(request) {
      const told = await inTurn({ request: JSON.stringify({ ...request, seed: kept.seed }) });
      const reply = told.crash ? { crash: true } : JSON.parse(told.reply);
      if (reply.error !== undefined && request.button !== "check") throw new Error(reply.error);
      if (reply.error !== undefined) end();  // it may have run out of memory
      if (reply.crash || reply.error !== undefined)
        return undecided("The judge reached a limit of time or memory with this answer. Write it in another way, " +
          "or ask your teacher.");
      kept.progress = told.progress;
      if (reply.standing) kept.standings[request.exercise] = reply.standing;
      keep();
      return reply;
    },
    async replaceProgress(text) {
      const { error, crash, progress } = await inTurn({ progress: text });
      if (error || crash) return error || "it could not be read";
      Object.assign(kept, { progress, standings: {}, scores: {} });
      for (const exercise of site.exercises)
        kept.standings[exercise] = (await this.ask({ exercise, button: "read", answer: "" })).standing;
      keep();
      return "";
    },
  };
}

/**
 * Loads a script that lies beside the page.
 * @param {string} name
 * @returns {Promise<unknown>}
 */
function loadScript(name) {
  return new Promise((done, failed) => {
    const script = document.createElement("script");
    script.src = name;
    script.onload = done;
    script.onerror = () => failed(new Error(`${name} could not be loaded`));
    document.head.append(script);
  });
}
