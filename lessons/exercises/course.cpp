#include <fmt/format.h>

#include <algorithm>
#include <lessons/exercises/course.hpp>
#include <stdexcept>

namespace rederive::classroom {
namespace {

bool all_at_hand(const GiNaC::ex& value, const std::set<std::string>& at_hand) {
  for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part) && !at_hand.contains(GiNaC::ex_to<GiNaC::symbol>(*part).get_name()))
      return false;
  return true;
}

}  // namespace

const NumericFunction& function_named(const std::string& name, const Course& course) {
  const auto found = std::ranges::find(course.functions, name, &NumericFunction::name);
  if (found == course.functions.end()) throw std::out_of_range("there is no function " + name);
  return *found;
}

void check_arguments(const NumericFunction& function, const Arguments& arguments) {
  for (const auto& argument : function.arguments)
    if (argument.is_needed && !arguments.contains(argument.name))
      throw std::invalid_argument("the argument " + argument.name + " is missing");
  for (const auto& [name, value] : arguments) {
    const auto known = std::ranges::find(function.arguments, name, &NumericFunction::Argument::name);
    if (known == function.arguments.end())
      throw std::invalid_argument(function.name + " takes no argument " + name);
  }
  for (const auto& [name, least, largest, is_needed] : function.arguments)
    if (const auto found = arguments.find(name);
        found != arguments.end() && !(found->second >= least && found->second <= largest))
      throw std::invalid_argument(fmt::format("the argument {} must be from {} to {}", name, least, largest));
}

void add_definitions(std::vector<Given>& given, const std::set<std::string>& at_hand,
                     const std::string& asked_for, const Course& course) {
  for (const Given& item : course.definitions) {
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(item.name).get_name();
    const bool there = std::any_of(given.begin(), given.end(),
                                   [&](const Given& other) { return other.name.is_equal(item.name); });
    if (!there && name != asked_for && at_hand.contains(name) && all_at_hand(item.value, at_hand))
      given.push_back(item);
  }
}

}  // namespace rederive::classroom
