// A paper as a static site.
#pragma once

#include <functional>
#include <lessons/exercises/course.hpp>

namespace rederive::site {

/// Runs the command line of `rederive DIR site OUT`: writes index.html, the lessons, exercises.html,
/// ledger.html with every row and its derivation, errata.html and ledger.json, and what the pages load: the
/// judge and MathLive. Pages link to each other and need nothing from elsewhere. `is_built_in` says whether
/// the judge knows the course by itself; otherwise the pages hand it the files of the paper's folder. Returns
/// the exit code.
int run_site(const std::function<const classroom::Course&()>& course, bool is_built_in, int argc,
             char** argv);

}  // namespace rederive::site
