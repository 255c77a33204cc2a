// What was asked for, by name.
#include <derivations/emit/emit.hpp>
#include <derivations/program/program.hpp>
#include <set>

namespace rederive {

const std::map<std::string, Target>& targets() {
  static const std::map<std::string, Target> all = [] {
    std::map<std::string, Target> found;
    for (const TargetLanguage& language : target_languages()) found[language.name] = language.target;
    return found;
  }();
  return all;
}

Emission chosen_from(Emission all, const std::vector<std::string>& names, Target target) {
  const std::set<std::string> named(names.begin(), names.end());
  const bool has_steppers = target == Target::cpp || target == Target::javascript;
  std::set<std::string> unknown = named;
  for (const EmittedFunction& function : all.functions) unknown.erase(function.name);
  for (const TaylorStepper& stepper : all.steppers)
    if (unknown.erase(stepper.name) != 0 && !has_steppers)
      throw BadInput("'" + stepper.name +
                     "' is a Taylor stepper: it can only be written in cpp and javascript");
  if (!unknown.empty())
    throw BadInput("there is no function '" + printable_line(*unknown.begin()) +
                   "'; emit --list shows all functions");
  const auto is_left_out = [&](const auto& f) { return !named.empty() && !named.contains(f.name); };
  std::erase_if(all.functions, is_left_out);
  std::erase_if(all.steppers, [&](const auto& f) { return !has_steppers || is_left_out(f); });
  return all;
}

}  // namespace rederive
