// Answers requests of pages: the classroom, the prover and the ledger of a paper as JSON.
#pragma once

#include <string>

namespace rederive::module {

/// Returns the answer to a request; both are JSON, in UTF-8. The requests are:
///
///     {"exercise": ID, "button": "check", "answer": TEXT, "seed": S}
///         a button of the form of an exercise, see classroom::reply; without "seed", of the exercise as it
///         is in the file. The answer is {"says": HTML, "standing": TEXT, "opinion": {…}}, with the opinion
///         as in `exercises check --json` if the button judges, else null.
///     {"prove": {"left": TEXT, "right": TEXT, "assume": [TEXT], "small": [TEXT], "order": N}}
///         the proof, as `ledger prove --json` writes it; only "left" and "right" are needed
///     {"show": "ledger"}     the ledger, as `ledger --json` writes it
///     {"show": ROW}          a row of the ledger, as `ledger show ROW --json` writes it
///     {"show": "exercises"}  the ids of all exercises, with a right answer for each
///     {"selftest": true}     {"code": N}, the exit code of `exercises selftest`; complaints go to standard
///                            output
///
///     {"paper": {NAME: TEXT}}
///         puts the paper and the exercises of a folder with these files in place of the built-in ones,
///         until the end. The files are paper.toml, equations.toml, derivations.json and exercises.toml, and
///         what else there is. The answer is {}.
///
/// The answer to a request that cannot be answered is {"error": TEXT}.
std::string reply_to(const std::string& request);

/// Returns the text of the progress file, "" if nothing was done yet.
std::string progress();
/// Replaces the progress file. Throws BadInput, with the line, for a text that is no progress file.
void set_progress(const std::string& text);

}  // namespace rederive::module
