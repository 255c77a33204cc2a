#include <algorithm>
#include <derivations/rocking_block/kinematics.hpp>
#include <derivations/rocking_block/overturning_without_impact.hpp>
#include <lessons/exercises/definitions.hpp>

namespace rederive::classroom {
namespace {

bool all_at_hand(const GiNaC::ex& value, const std::set<std::string>& at_hand) {
  for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part) && !at_hand.contains(GiNaC::ex_to<GiNaC::symbol>(*part).get_name()))
      return false;
  return true;
}

}  // namespace

void add_definitions(std::vector<Given>& given, const std::set<std::string>& at_hand,
                     const std::string& asked_for) {
  std::vector<Given> known = sides_of_the_block();
  known.push_back({paper::J_c, paper::m * pow(paper::R, 2) / 3});
  known.push_back({paper::J_o, 4 * paper::m * pow(paper::R, 2) / 3});
  known.push_back({paper::R, 3 * paper::g / (4 * pow(paper::p, 2))});
  for (const auto& item : known) {
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(item.name).get_name();
    const bool there = std::any_of(given.begin(), given.end(),
                                   [&](const Given& other) { return other.name.is_equal(item.name); });
    if (!there && name != asked_for && at_hand.contains(name) && all_at_hand(item.value, at_hand))
      given.push_back(item);
  }
}

const std::map<std::string, Derivation (*)()>& derivations_of_exercises() {
  static const std::map<std::string, Derivation (*)()> all{{"mass_at_the_top", mass_at_the_top},
                                                           {"half_sine", half_sine}};
  return all;
}

Derivation mass_at_the_top() {
  const GiNaC::ex b = paper::b, h = paper::h, before = paper::thetadot_minus, after = paper::thetadot_plus,
                  top = 2 * h;
  const GiNaC::ex right = top * before,
                  up = -b * before;  // velocity while it still turns clockwise about O, at (b, 2h)
  const GiNaC::ex momentum = top * right - (-b) * up;  // moment about O', from which the mass is at (-b, 2h)
  Derivation result;
  result.left = paper::e;
  result.right = (momentum / (before * (b * b + top * top))).normal();
  result.steps = {{"Per unit of mass the moment about the new corner is, before the impact", paper::hO_minus,
                   momentum, "="},
                  {"and afterwards", paper::hO_plus, (b * b + top * top) * after, "="},
                  {"They are equal, hence", result.left, result.right, "="}};
  return result;
}

Derivation half_sine() {
  const GiNaC::ex end = (GiNaC::Pi - paper::psi) / paper::omega_p;
  const Given lifts = amplitude(Pulse::sine);
  const auto found = threshold_without_impact(Side::negative, ground_acceleration(Pulse::sine), lifts, end);
  const GiNaC::lst rest{paper::theta_0 == 0, paper::thetadot_0 == 0};
  const Derivation critical = equation_68();
  Derivation result;
  result.left = by_phase(found.left.subs(rest));
  result.right = found.right;
  result.steps = {
      {"From rest the block moves, by (57a) with the constants (70), as", paper::theta,
       forced_motion(Side::negative, Pulse::sine).subs(constants_from_rest())},
      {"It lifts when the ground acceleration is alpha*g, so that", lifts.name, lifts.value},
      {"Now the pulse ends when its argument is pi, at", paper::T_ex, end},
      {"The block just reaches the balance if its angle and rate at that time satisfy (68)", critical.left,
       critical.right},
      {"Put the motion and its rate at T_ex into that, join sinh and cosh to exponentials, and divide by "
       "the factor of the decaying one",
       result.left, result.right}};
  return result;
}

}  // namespace rederive::classroom
