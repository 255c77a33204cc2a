/**
 * The interface of a learning platform, SCORM 1.2.
 * @typedef {{LMSInitialize(nothing: string): string, LMSGetValue(name: string): string,
 *   LMSSetValue(name: string, value: string): string, LMSCommit(nothing: string): string,
 *   LMSFinish(nothing: string): string}} Platform
 */

/**
 * Returns the interface that a platform offers to the pages that it frames or opens.
 * @returns {?Platform}
 */
function findPlatform() {
  /** @type {any} */
  let frame = window;
  try {
    for (let depth = 0; depth < 10 && frame; ++depth) {
      if (frame.API) return frame.API;
      frame = frame.parent === frame ? frame.opener : frame.parent;
    }
  } catch { /* a frame of another site */ }
  return null;
}

/**
 * Returns a duration as SCORM 1.2 writes it.
 * @param {number} seconds
 */
function asTimespan(seconds) {
  const two = (/** @type {number} */ number) => String(Math.floor(number)).padStart(2, "0");
  return `${String(Math.floor(seconds / 3600)).padStart(4, "0")}:${two(seconds / 60 % 60)}:${two(seconds % 60)}`;
}

/**
 * Returns a function that reports an answer with its opinion, or null if no platform is there. The score of an
 * exercise is its best one; the score of all is their mean, in percent.
 * @returns {?(exercise: string, answer: string, opinion: Opinion) => void}
 */
function reporter() {
  const platform = findPlatform();
  if (!platform || platform.LMSInitialize("") !== "true") return null;
  const set = (/** @type {string} */ name, /** @type {string|number} */ value) => platform.LMSSetValue(name, String(value));
  const began = Date.now();
  const handedOver = platform.LMSGetValue("cmi.suspend_data");
  if (!kept.progress && handedOver) kept.progress = handedOver;
  /** @type {string[]} */
  const objectives = [];
  const known = Number(platform.LMSGetValue("cmi.objectives._count")) || 0;
  for (let i = 0; i < known; ++i) objectives.push(platform.LMSGetValue(`cmi.objectives.${i}.id`));
  let interactions = Number(platform.LMSGetValue("cmi.interactions._count")) || 0;
  set("cmi.core.score.min", 0);
  set("cmi.core.score.max", 100);
  if (platform.LMSGetValue("cmi.core.lesson_status") === "not attempted")
    set("cmi.core.lesson_status", "incomplete");
  addEventListener("pagehide", () => {
    set("cmi.core.session_time", asTimespan((Date.now() - began) / 1000));
    platform.LMSFinish("");
  });
  return (exercise, answer, { verdict }) => {
    const score = kept.scores[exercise] ?? 0, scores = Object.values(kept.scores);
    if (!objectives.includes(exercise)) objectives.push(exercise);
    const objective = `cmi.objectives.${objectives.indexOf(exercise)}`;
    const interaction = `cmi.interactions.${interactions++}`;
    set(`${objective}.id`, exercise);
    set(`${objective}.score.raw`, Math.round(100 * score));
    set(`${objective}.status`, score === 1 ? "completed" : "incomplete");
    set(`${interaction}.id`, exercise);
    set(`${interaction}.type`, "fill-in");
    set(`${interaction}.student_response`, answer.slice(0, 255));
    set(`${interaction}.result`, new Map([["correct", "correct"], ["wrong", "wrong"]]).get(verdict) ?? "neutral");
    set("cmi.core.score.raw", Math.round(100 * scores.reduce((sum, one) => sum + one, 0) / site.exercises.length));
    if (scores.filter((one) => one === 1).length === site.exercises.length) set("cmi.core.lesson_status", "completed");
    if (kept.progress.length <= 4096) set("cmi.suspend_data", kept.progress);
    platform.LMSCommit("");
  };
}
