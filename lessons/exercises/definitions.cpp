#include <algorithm>
#include <derivations/rocking_block/kinematics.hpp>
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

}  // namespace rederive::classroom
