// Writes the workbench at build time: the element for lessons, and a page that contains only this element.
#include <fmt/format.h>

#include <derivations/program/program.hpp>
#include <derivations/rocking_block/emission.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <derivations/rocking_block/pulse.hpp>
#include <iostream>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <nlohmann/json.hpp>
#include <numerics/motion/overturning.hpp>
#include <regex>
#include <stdexcept>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::program;
using namespace rederive::emit;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::page;
using namespace rederive::rocking_block;

namespace {

const Symbols& symbols() { return paper().symbols; }

Relation printed(const std::string& id) { return parse_relation(row_of(paper(), id).printed, symbols()); }

/// Returns (88) as printed, left minus right, to be drawn beside what is derived.
EmittedFunction printed_88() {
  const Relation relation = printed("88");
  const GiNaC::ex residual =
      lower(relation.sides.front(), symbols()) - lower(relation.sides.back(), symbols());
  return {"overturning_impact_during_pulse_as_printed",
          {omega_p, p, psi, t_i, t, e},
          residual.subs(T_ex == end_of_pulse(Pulse::sine)),
          {},
          "88",
          "As printed, with a running t: vanishes where an impact leads to the threshold"};
}

/// The definition of e.
EmittedFunction impact() {
  return {"velocity_after_impact",
          {e, thetadot_before},
          lower(printed("u23").sides.back(), symbols()),
          {},
          "u23",
          "Angular velocity after an impact"};
}

/// The threshold of the cosine pulse from rest, of which the paper has no equation.
EmittedFunction cosine_from_rest() {
  const Derivation& derivation = paper().derivations.at("r15");
  return {"overturning_cosine_pulse_from_rest",
          {omega_p, p, psi},
          derivation.left - derivation.right,
          {},
          "r15",
          "Left less right of the threshold of the one-cosine pulse from rest, theta > 0"};
}

/// Returns the functions that the page calls, as emit writes them, in a scope of their own.
std::string physics(const std::string& script) {
  std::vector<EmittedFunction> functions = emitted_functions();
  functions.push_back(printed_88());
  functions.push_back(cosine_from_rest());
  functions.push_back(impact());
  std::vector<TaylorStepper> steppers = taylor_steppers();
  // The script names a pair by what both sides have in common.
  const auto is_unused = [&](const auto& f) {
    std::string name = f.name;
    for (const std::string side : {"_negative", "_positive"})
      if (name.ends_with(side)) name.resize(name.size() - side.size());
    if (name.starts_with("linear_")) name.erase(0, 7);
    return script.find("emitted." + name) == std::string::npos &&
           script.find('"' + name) == std::string::npos;
  };
  std::erase_if(functions, is_unused);
  std::erase_if(steppers, is_unused);
  std::string names;
  for (const EmittedFunction& f : functions) {
    names += f.name + ", ";
    if (!f.derivatives.empty()) names += f.name + "_with_derivatives, ";
  }
  if (!steppers.empty()) names += "value_at, ";
  for (const TaylorStepper& stepper : steppers) names += stepper.name + ", ";
  const std::string text = std::regex_replace(
      emit({emission_symbols(), functions, steppers}, Target::javascript), std::regex("\nexport "), "\n");
  return "const emitted = (() => {\n" + text + "\nreturn { " + names + "};\n})();\n";
}

/// The same without what emit says of each function: lessons are long enough.
std::string without_documentation(std::string text) {
  for (std::size_t at = 0; (at = text.find("/**", at)) != std::string::npos;)
    text.erase(at, text.find("*/", at) + 3 - at);
  return text;
}

/// Returns the words of the scripts for each outcome, from `words_for`.
std::string outcome_words() {
  using namespace rederive::numerics;
  return "const outcomeWords = " +
         nlohmann::json{{"safe", words_for(0)},
                        {"pattern", words_of_overturning},
                        {"sides", words_of_sides},
                        {"impacts", words_of_impacts}}
             .dump() +
         ";\n";
}

void write_all(const std::filesystem::path& folder, const std::filesystem::path& sources) {
  const auto source = [&](const char* name) { return read_whole(sources / name); };
  const std::string motion = source("motion.js") + source("map.js"),
                    law = mathml(derived_relation(paper().derivations.at("46b"), symbols()), symbols());
  const std::string element = "<style>\n" + source("workbench.css") + "</style>\n" +
                              fmt::format(fmt::runtime(source("element.html")), fmt::arg("law_46b", law)) +
                              "<script class=\"workbench-physics\">\n" +
                              without_documentation(physics(motion)) + motion + "</script>\n<script>\n" +
                              outcome_words() + source("case.js") + source("views.js") +
                              source("workbench.js") + "</script>\n";
  const std::string head =
      source("head.html") + math_font_style() + "</head>\n<body class=\"own\">\n<h1>The rocking block</h1>\n";
  const std::string opening = source("opening.html");
  write_whole(folder / "workbench_head.html", head);
  write_whole(folder / "workbench_opening.html", opening);
  write_whole(folder / "workbench_element.html", element);
  write_whole(folder / "workbench.html",
              head + fmt::format(fmt::runtime(opening), "") + element + "</body>\n</html>\n");
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  try {
    if (argc != 3) throw std::runtime_error("usage: workbench_page FOLDER SOURCES");
    write_all(argv[1], argv[2]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "workbench_page: " << printable(error.what()) << "\n";
    return 3;
  }
}
