/**
 * What answers the buttons of a page: `exercises serve`, or the module in a worker.
 * @typedef {object} Opinion  as `exercises check --json` writes it
 * @property {string} verdict
 * @property {number} score
 * @property {string[]} [readings]  texts, of which the student is to choose one
 *
 * @typedef {{exercise: string, button: string, answer: string}} Question
 * @typedef {{says: string, standing: string, opinion: ?Opinion}} Reply
 *
 * @typedef {object} Desk
 * @property {(request: Question) => Promise<Reply>} ask  rejects with an Error whose message is for the student
 * @property {(exercise: string) => Promise<string>} standing  what was done of an exercise so far
 */

/**
 * Returns the desk of `exercises serve`, which sent the page.
 * @returns {Desk}
 */
function deskOfServer() {
  /** @param {Question} request */
  const ask = async ({ exercise, button, answer }) => {
    const reply = await fetch(`exercise/${exercise}/${button}`, { method: "POST",
      headers: { "Content-Type": "application/json" }, body: JSON.stringify({ answer }) }).catch(() => {
      throw new Error("The server does not answer. Start it again: exercises serve");
    });
    if (!reply.ok) throw new Error(await reply.text());
    return reply.json();
  };
  return { ask, standing: async (exercise) => (await ask({ exercise, button: "read", answer: "" })).standing };
}
