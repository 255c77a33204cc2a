// The theorems of our files, and what they have to do with the paper where their names do not say it.
#pragma once

#include <derivations/paper/ledger.hpp>
#include <sstream>
#include <tests/block.hpp>
#include <tests/derivations/kernel/coq_files.hpp>

namespace rederive::coq {

/// All that are written by hand.
inline const std::vector<Theorem>& theorems() {
  static const std::vector<Theorem> all = [] {
    std::vector<Theorem> result;
    for (const std::string& name : theorem_files())
      for (Theorem& theorem : File(name).theorems) result.push_back(std::move(theorem));
    return result;
  }();
  return all;
}

inline const std::map<std::string, Entry>& entries() {
  static const std::map<std::string, Entry> all = [] {
    std::map<std::string, Entry> result;
    const auto rows = read_rows(equations_file());
    for (const Row& row : rows) result.emplace(row.id, judge(row, rows));
    return result;
  }();
  return all;
}

/// What is printed, or what should be.
inline std::string right_form_of(const std::string& id) {
  const Entry& entry = entries().at(id);
  return entry.proof.verdict == Verdict::refuted ? entry.correction : entry.row.claim();
}

/// What the paper's symbols are in theorems that have no such name: other rows, and ours.
inline const std::map<std::string, std::string>& meanings() {
  static const std::map<std::string, std::string> all{{"J_o", right_form_of("u3b")},
                                                      {"J_c", right_form_of("u2")},
                                                      {"b", right_form_of("42a")},
                                                      {"h", "h = R*cos(alpha)"},
                                                      {"m", "m = rho*(2*h*2*b)"},
                                                      {"x_cddot", right_form_of("48c")},
                                                      {"H", right_form_of("u9a")},
                                                      {"y_cddot", right_form_of("49c")},
                                                      {"u_gddot_0", "u_gddot_0 = lambda*a_p"},
                                                      {"A_1", right_form_of("70a")},
                                                      {"A_2", right_form_of("70b")},
                                                      {"T_ex", right_form_of("u20")},
                                                      {"t_o", "t_o = T_ex"}};
  return all;
}
/// Of derivatives of energies, for theta < 0 and for theta > 0.
inline const std::map<std::string, std::pair<std::string, std::string>> energies{
    {"ddt_dK_dthetadot", {"7b", "17b"}}, {"dK_dtheta", {"8", "18"}}, {"dOmega_dtheta", {"10", "19"}}};
/// A theorem whose name does not say its rows, or that has other names than the paper.
struct About {
  std::vector<std::string> rows;                  ///< none: those of its name
  std::map<std::string, std::string> names = {};  ///< what the paper's symbols are
  bool is_printed = false;                        ///< it is about the wrong row, as it is printed
};
inline const std::map<std::string, std::string> of_energy{{"theta", "q"}, {"thetadot", "v"}, {"u_gdot", "u"}},
    of_motion{{"theta", "x t"}, {"thetaddot", "Derive v t"}, {"a_p", "alpha / sin psi"}, {"g", "1"}},
    of_back{{"alpha", "alpha"}, {"p", "p"}, {"omega_p", "omega_p"}, {"psi", "psi"}, {"T_ex", "T_ex"}};
inline std::map<std::string, std::string> at_three(const std::string& angle,
                                                   const std::string& acceleration) {
  return {{"theta", angle}, {"thetaddot", acceleration}, {"a_p", "1/4 / sin psi"}, {"g", "1"},
          {"alpha", "1/4"}, {"omega_p", "3 * p"}};
}
inline const std::multimap<std::string, About> others{
    {"derivation_6_16b", {{}, of_energy}},
    {"derivation_7a_17a", {{}, of_energy}},
    {"derivation_8_18", {{}, of_energy}},
    {"derivation_10_19", {{}, of_energy}},
    {"derivation_43a", {{}, {}, true}},
    {"instance_92a", {{"r9", "95b"}, of_back}},
    {"threshold_exists", {{"71"}, {{"omega_p", "w"}, {"p", "1"}}}},
    {"threshold_is_unique", {{"71"}, {{"omega_p", "w"}, {"p", "1"}, {"psi", "x"}}}},
    {"threshold_at_1", {{"71"}, {{"omega_p", "1"}, {"p", "1"}}}},
    {"threshold_at_2", {{"71"}, {{"omega_p", "2"}, {"p", "1"}}}},
    {"threshold_at_3", {{"71"}, {{"omega_p", "3"}, {"p", "1"}}}},
    {"threshold_at_4", {{"71"}, {{"omega_p", "4"}, {"p", "1"}}}},
    {"response_solves",
     {{"56a"},
      {{"theta", "theta t"}, {"thetaddot", "Derive thetadot t"}, {"a_p", "alpha / sin psi"}, {"g", "1"}}}},
    {"free_solves", {{"61a"}, {{"theta", "free s"}, {"thetaddot", "Derive (fun x => Derive free x) s"}}}},
    {"overturns", {{"71"}}},
    {"comes_back", {{"71"}}},
    {"threshold_instance", {{"56a", "61a"}, of_motion}},
    {"threshold_of_the_motion", {{"71", "56a", "61a"}, of_motion}},
    {"claim_c54_figure_8_is_not_linear",
     {{"56a", "61a"},
      {{"theta", "x t"},
       {"thetaddot", "Derive v t"},
       {"a_p", "alpha / sin psi"},
       {"g", "1"},
       {"omega_p", "2 * p"}}}},
    {"claim_c55_figure_9_is_not_linear",
     {{"56a", "61a"},
      {{"theta", "x t"},
       {"thetaddot", "Derive v t"},
       {"a_p", "alpha / sin psi"},
       {"g", "1"},
       {"omega_p", "4 * p"}}}},
    {"claim_c69_nothing_lifts", {{"56a", "56b"}, {{"a_p", "u t"}, {"omega_p", "0"}, {"psi", "PI / 2"}}}},
    {"claim_c61_does_not_lift", {{"56a", "56b"}, {{"a_p", "71157/10^5 * (alpha * g)"}}}},
    {"claim_c51_103_is_78_shifted", {{"103"}, {{"theta_0", "0"}, {"thetadot_0", "0"}, {"alpha", "1"}}}},
    {"claim_c22_away_from_the_corner", {{"46b", "r16"}}},
    {"one_impact_motion_exists", {{"56a"}, at_three("x t", "Derive u t")}},
    {"one_impact_motion_exists", {{"56b", "61b"}, at_three("y t", "Derive v t")}},
    {"one_impact_motion_exists",
     {{"46a"}, {{"alpha", "1/4"}, {"thetadot_minus", "u t_i"}, {"thetadot_plus", "v t_i"}}}},
};
/// What has no row's formula, and why.
inline const std::map<std::string, std::string> not_comparable{
    {"derivation_r14",
     "the row is cos(pi - psi) = - cos psi; the theorem is what it is for: when the block is pushed"},
    {"response_starts_at_rest", "it says rest, which is no row"},
    {"critical_impact", "it is about the impact time at which `margin` is 0; one_impact_at_3 says what for"},
    {"critical_impact_behind", "it is about the psi at which `surplus` is 0; one_impact_at_3 says what for"},
    {"one_impact_at_3", "its equations are those of one_impact_motion_exists; the threshold is a number"},
    {"instance_r16", "its equations are what r16 starts from: an impulse, which no row has"},
};

/// The rows in the name of a theorem: of derivation_8_18, 8 and 18.
inline std::vector<std::string> rows_of(const std::string& theorem) {
  std::vector<std::string> rows;
  std::istringstream parts(theorem.substr(theorem.find('_') + 1));
  for (std::string part; std::getline(parts, part, '_');) rows.push_back(part);
  return rows;
}
/// With the rows that it is about.
inline std::vector<About> abouts_of(const Theorem& theorem) {
  std::vector<About> result;
  for (auto [at, end] = others.equal_range(theorem.name); at != end; ++at) result.push_back(at->second);
  if (result.empty()) result.push_back({});
  for (About& about : result)
    if (about.rows.empty()) about.rows = rows_of(theorem.name);
  return result;
}

}  // namespace rederive::coq
