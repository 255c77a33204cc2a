// Writes the workbench at build time: the element that lessons hold, and the page of its own.
// Usage: workbench_page FOLDER SOURCES
#include <derivations/program/program.hpp>
#include <derivations/rocking_block/emission.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <derivations/rocking_block/pulse.hpp>
#include <iostream>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <stdexcept>

using namespace rederive;
using namespace rederive::rocking_block;

namespace {

const Symbols& symbols() { return paper().symbols; }

Relation printed(const std::string& id) { return parse_relation(row_of(paper(), id).printed, symbols()); }

/// (88) as printed, left less right, to be drawn beside what is derived.
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

/// What emit writes of the functions that the page calls, in a scope of its own.
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
  std::string text = emit({emission_symbols(), functions, steppers}, Target::javascript), names;
  // "export function NAME(", "export class NAME {"
  for (std::size_t at = 0; (at = text.find("\nexport ", at)) != std::string::npos;) {
    text.erase(++at, std::string("export ").size());
    const std::size_t name = text.find(' ', at) + 1;
    names += text.substr(name, text.find_first_of("( ", name) - name) + ", ";
  }
  return "const emitted = (() => {\n" + text + "\nreturn { " + names + "};\n})();\n";
}

/// The same without what emit says of each function: lessons are long enough.
std::string without_documentation(std::string text) {
  for (std::size_t at = 0; (at = text.find("/**", at)) != std::string::npos;)
    text.erase(at, text.find("*/", at) + 3 - at);
  return text;
}

void write_all(const std::filesystem::path& folder, const std::filesystem::path& sources) {
  const std::string motion = read_whole(sources / "motion.js") + read_whole(sources / "map.js");
  std::string scripts;
  for (const char* name : {"case.js", "views.js", "workbench.js"}) scripts += read_whole(sources / name);
  std::string controls = read_whole(sources / "element.html");
  const std::string law = "<!-- (46b) -->";
  controls.replace(controls.find(law), law.size(),
                   mathml(print_statement(derived_relation(paper().derivations.at("46b"), symbols()),
                                          Notation::latex, symbols())));
  const auto element = [&](const std::string& emitted) {
    return "<style>\n" + read_whole(sources / "workbench.css") + "</style>\n" + controls +
           "<script class=\"workbench-physics\">\n" + emitted + motion + "</script>\n<script>\n" + scripts +
           "</script>\n";
  };
  const std::string emitted = physics(motion);
  write_whole(folder / "workbench_element.html", element(without_documentation(emitted)));
  write_whole(folder / "workbench.html", read_whole(sources / "head.html") + math_font_style() +
                                             "</head>\n<body class=\"own\">\n<h1>The rocking block</h1>\n" +
                                             element(emitted) + "</body>\n</html>\n");
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
