// `ledger certify`, and the certificate of `ledger prove`.
#pragma once

#include <derivations/kernel/scripts.hpp>
#include <derivations/paper/prove.hpp>

namespace rederive {

struct CertifyOptions {
  std::string folder;            ///< where the scripts are written; empty: nowhere
  std::vector<std::string> ids;  ///< rows alone; empty: all
  bool checks = false, json = false;
};

/// Writes the scripts of the rows, lets coqc check them if that is asked for, and reports on standard output.
/// A row without a script is skipped and named. Returns the exit code: 1 where a lemma does not pass, 3 where
/// there is no coqc. Throws BadInput.
int certify(const Paper& paper, const std::vector<Entry>& entries, const CertifyOptions& options);

/// The lemma of a row, for a reader. Throws BadInput where it has none.
std::string lemma_page(const Paper& paper, const Entry& entry);

/// Writes what was asked and is proved as one script that needs no other file. Returns the exit code: 3 where
/// there is no script for the proof, and standard error says why. Throws BadInput for what cannot be read.
int write_certificate(const Paper& paper, const ProveRequest& request, const std::string& file);

}  // namespace rederive
