// A paper as a static site.
#pragma once

#include <lessons/papers/paper_folder.hpp>

namespace rederive::papers {

/// Runs the command line of `rederive DIR site OUT`: writes index.html, the lessons, exercises.html,
/// ledger.html with every row and its derivation, errata.html and ledger.json. Pages link to each other and
/// need nothing from elsewhere. Returns the exit code.
int run_site(const std::function<const PaperFolder&()>& folder, int argc, char** argv);

}  // namespace rederive::papers
