// What the checks of the claims share: judged rows and thresholds, each computed once.
#pragma once

#include <memory>

namespace rederive {

class JudgedRows;
class Thresholds;
std::shared_ptr<JudgedRows> make_judged_rows();
std::shared_ptr<Thresholds> make_thresholds();

/// One bench serves all claims of one run. Derivations and numerics stay behind their own headers,
/// claims_rows.hpp and claims_thresholds.hpp.
class Workbench {
 public:
  Workbench() : rows_(make_judged_rows()), thresholds_(make_thresholds()) {}
  JudgedRows& rows() { return *rows_; }
  Thresholds& thresholds() { return *thresholds_; }

 private:
  std::shared_ptr<JudgedRows> rows_;
  std::shared_ptr<Thresholds> thresholds_;
};

}  // namespace rederive
