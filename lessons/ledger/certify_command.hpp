// The commands `ledger certify` and `ledger prove --certificate`.
#pragma once

#include <derivations/kernel/scripts.hpp>
#include <derivations/paper/prove.hpp>

namespace rederive::ledger {

struct CertifyOptions {
  std::string folder;            ///< for the scripts; if it is empty, none are written
  std::vector<std::string> ids;  ///< of the rows; if there are none, all rows are meant
  bool checks = false;           ///< let coqc check the scripts
  bool json = false;             ///< report in JSON
};

/// Writes the scripts of the rows, lets coqc check them if `options` ask for it, and reports on standard
/// output. A row without a script is skipped and named. Returns the exit code: 1 if a lemma does not pass, 3
/// if coqc is not installed. Throws BadInput for an unknown id and for a folder that cannot be written.
int certify(const paper::Paper& paper, const std::vector<paper::Entry>& entries,
            const CertifyOptions& options);

/// Returns the lemma of a row with its proof. Throws BadInput if there is none.
std::string lemma_page(const paper::Paper& paper, const paper::Entry& entry);

/// Proves what is requested and writes the proof as one script that needs no other file. Returns the exit
/// code: 3 if there is no script for the proof; then standard error says why. Throws BadInput for a statement
/// that cannot be read.
int write_certificate(const paper::Paper& paper, const paper::ProveRequest& request, const std::string& file);

}  // namespace rederive::ledger
