// A paper as a static site.
#pragma once

#include <functional>
#include <lessons/exercises/course.hpp>

namespace rederive::site {

/// Runs the command line of `rederive DIR site OUT`: writes index.html, the lessons, exercises.html,
/// ledger.html with every row and its derivation, errata.html and ledger.json, and what the pages load: the
/// judge and MathLive. Pages link to each other and need nothing from elsewhere. `has_module` says whether
/// the judge as a module knows the exercises of the course. Returns the exit code.
int run_site(const std::function<const classroom::Course&()>& course, bool has_module, int argc, char** argv);

}  // namespace rederive::site
