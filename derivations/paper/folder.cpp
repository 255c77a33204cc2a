// paper.toml and functions.toml → a paper.
#include <derivations/paper/derivation_file.hpp>
#include <derivations/paper/folder.hpp>
#include <derivations/program/toml_table.hpp>
#include <set>

namespace rederive::paper {
using namespace language;
using namespace mechanics;
using namespace emit;
using namespace program;
namespace fs = std::filesystem;

namespace {

/// The spelling of a name if nothing else is given: theta_0 as θ₀. `dots` is the number of time derivatives.
struct Spelling {
  std::string latex, unicode;
};

/// The Greek letter of a name: "θ" for "theta", "" for other names.
std::string greek_letter(const std::string& name) {
  for (const auto& [first, last] : {std::pair(U'Α', U'Ω'), std::pair(U'α', U'ω')})
    for (char32_t code = first; code <= last; ++code)
      if (greek_name(code) == name)
        return {static_cast<char>(0xC0 | (code >> 6)), static_cast<char>(0x80 | (code & 0x3F))};
  return {};
}

std::string subscript_of(const std::string& digits) {
  std::string text;
  for (const char digit : digits) text += "\xE2\x82" + std::string(1, static_cast<char>(0x80 + digit - '0'));
  return text;
}

Spelling spelling_of(const std::string& name, int dots) {
  const std::size_t bar = name.find('_');
  const std::string stem = name.substr(0, bar), index = bar == name.npos ? "" : name.substr(bar + 1);
  Spelling spelling{stem, stem};
  if (const std::string letter = greek_letter(stem); !letter.empty()) spelling = {"\\" + stem, letter};
  if (dots > 0) {
    spelling.latex = (dots == 1 ? "\\dot " : "\\ddot ") + spelling.latex;
    const std::size_t first = first_character(spelling.unicode).bytes;
    spelling.unicode.insert(first, dots == 1 ? "\u0307" : "\u0308");
  }
  if (index.empty()) return spelling;
  spelling.latex += index.size() == 1 ? "_" + index : "_{" + index + "}";
  const bool is_number = std::ranges::all_of(index, [](char c) { return c >= '0' && c <= '9'; });
  spelling.unicode += is_number ? subscript_of(index) : "_" + index;
  return spelling;
}

struct DeclaredSymbols {
  std::vector<Symbol> symbols;
  std::vector<std::string> integers;
};

std::string unit_of_rate(const std::string& unit, int dots) { return unit + (dots == 1 ? "/s" : "/s^2"); }

/// Puts the symbol of a table, and its rates, into `all`.
void read_symbol(TomlTable table, const std::string& name, DeclaredSymbols& all) {
  table.call_it("symbol " + name);
  const Spelling usual = spelling_of(name, 0);
  const auto text_or = [&](const char* key, const std::string& otherwise) {
    return table.has(key) ? table.needed_line(key) : otherwise;
  };
  const std::string latex = text_or("latex", usual.latex), unicode = text_or("unicode", usual.unicode),
                    unit = text_or("unit", "1"), range = text_or("range", all_numbers),
                    meaning = table.line("meaning"), introduced = table.line("introduced");
  const std::int64_t rates = table.whole("rates", 0, 2).value_or(0);
  const bool is_integer = table.flag("integer");
  table.done();
  const auto add = [&](Symbol symbol) {
    try {
      (void)parse_unit(symbol.unit);
    } catch (const std::invalid_argument& error) {
      table.fail(error.what(), "unit");
    }
    all.symbols.push_back(std::move(symbol));
  };
  try {
    (void)read_range(range);
    add({name, latex, unicode, unit, range, meaning, introduced});
  } catch (const std::invalid_argument& error) {
    table.fail(error.what(), "range");
  }
  if (is_integer) all.integers.push_back(name);
  for (int dots = 1; dots <= rates; ++dots) {
    const std::string ending = dots == 1 ? "dot" : "ddot";
    Spelling rate = spelling_of(name, dots);
    if (table.has("latex")) rate.latex = (dots == 1 ? "\\dot{" : "\\ddot{") + latex + "}";
    if (table.has("unicode"))
      rate.unicode =
          std::string(unicode).insert(first_character(unicode).bytes, dots == 1 ? "\u0307" : "\u0308");
    add({name + ending, rate.latex, rate.unicode, unit_of_rate(unit, dots), all_numbers,
         (dots == 1 ? "rate of " : "second rate of ") + (meaning.empty() ? name : meaning), introduced});
  }
}

DeclaredSymbols symbols_in(TomlTable& document) {
  DeclaredSymbols all;
  std::optional<TomlTable> table = document.table("symbols");
  if (!table) document.fail("the table [symbols] is missing");
  for (const std::string& name : table->keys()) {
    std::optional<TomlTable> one = table->table(name);
    read_symbol(*one, name, all);
  }
  return all;
}

/// The content of functions.toml. A function or a stepper refers to rows by their derivations.
class FunctionsFile {
 public:
  FunctionsFile(const Paper& paper, const fs::path& file) : paper_(paper), file_(file) {}

  Emission emission() const {
    Emission all{.symbols = paper_.symbols, .functions = {}};
    if (!fs::exists(file_)) return all;
    TomlTable document(file_);
    for (TomlTable& table : document.tables("function")) all.functions.push_back(read_function(table));
    for (TomlTable& table : document.tables("stepper")) all.steppers.push_back(read_stepper(table));
    document.done();
    return all;
  }

 private:
  std::vector<SymbolExpression> symbols_of(TomlTable& table, const char* key) const {
    std::vector<SymbolExpression> found;
    const std::vector<std::string>& known = paper_.symbols.names();
    for (const std::string& name : table.texts(key)) {
      table.check_word(key, name, known);
      found.push_back(paper_.symbols[name]);
    }
    return found;
  }

  /// The derivation of a row, with what its names stand for put in.
  Derivation derivation_in(const TomlTable& table, const char* key, const std::string& id) const {
    table.check_word(key, id, paper_.derivations.ids());
    Derivation result = *derivation_of(paper_, id);
    for (const Given& given : result.given) {
      result.left = result.left.subs(given.name == given.value);
      result.right = result.right.subs(given.name == given.value);
    }
    return result;
  }

  static std::set<std::string> symbols_of(const GiNaC::ex& value) {
    std::set<std::string> names;
    for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part)
      if (GiNaC::is_a<GiNaC::symbol>(*part)) names.insert(GiNaC::ex_to<GiNaC::symbol>(*part).get_name());
    return names;
  }

  static std::string named(TomlTable& table) {
    const std::string name = table.needed_line("name");
    const auto is_letter = [](char c) {
      return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    const auto belongs = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
    if (!name.empty() && (!is_letter(name[0]) || !std::ranges::all_of(name, belongs)))
      table.fail("'" + name + "' is not a name of a function: letters, digits and _", "name");
    return name;
  }

  EmittedFunction read_function(TomlTable& table) const {
    EmittedFunction function;
    function.name = named(table);
    table.call_it("function " + function.name);
    function.equation = table.needed_line("row");
    function.brief = table.line("brief");
    const std::string side = table.word("side", {"left", "right"});
    function.arguments = symbols_of(table, "arguments");
    function.derivatives = symbols_of(table, "derivatives");
    table.done();
    const Derivation derivation = derivation_in(table, "row", function.equation);
    function.value = side == "left" ? derivation.left : derivation.right;
    for (const std::string& name : symbols_of(function.value))
      if (std::ranges::find(function.arguments, name, name_of) == function.arguments.end())
        table.fail("the value has the symbol " + name + ", which is not an argument", "arguments");
    return function;
  }

  TaylorStepper read_stepper(TomlTable& table) const {
    TaylorStepper stepper;
    stepper.name = named(table);
    table.call_it("stepper " + stepper.name);
    std::vector<std::string> rows = table.texts("rows");
    if (table.has("row")) rows.insert(rows.begin(), table.needed_line("row"));
    if (rows.empty()) table.fail("'row' is missing: the row that derives the highest rate");
    stepper.equation = rows[0];
    stepper.brief = table.line("brief");
    const std::vector<SymbolExpression> state = symbols_of(table, "state");
    stepper.parameters = symbols_of(table, "parameters");
    const std::string time = table.line("time");
    (void)table.texts("events");
    table.done();
    if (!time.empty()) {
      table.check_word("time", time, paper_.symbols.names());
      stepper.time = paper_.symbols[time];
    } else if (paper_.symbols.find("t") != nullptr) {
      stepper.time = paper_.symbols["t"];
    } else {
      stepper.time = SymbolExpression(GiNaC::realsymbol("t"));
    }
    for (const SymbolExpression& one : state)
      stepper.rates.emplace_back(one, rate_of(table, one, state, rows));
    return stepper;
  }

  /// The rate of a part of the state: another part, or the right side of the row that derives it.
  GiNaC::ex rate_of(const TomlTable& table, const SymbolExpression& one,
                    const std::vector<SymbolExpression>& state, const std::vector<std::string>& rows) const {
    const std::string name = name_of(one);
    const std::string rate = name.ends_with("dot") && !name.ends_with("ddot")
                                 ? name.substr(0, name.size() - 3) + "ddot"
                                 : name + "dot";
    if (std::ranges::find(state, rate, name_of) != state.end()) return paper_.symbols[rate];
    for (const std::string& id : rows) {
      const Derivation derivation = derivation_in(table, "rows", id);
      if (paper_.symbols.find(rate) != nullptr && derivation.left.is_equal(paper_.symbols[rate]))
        return derivation.right;
    }
    table.fail("the rate of " + name +
                   " is unknown: it is neither in the state nor the left side of a row; " + rate +
                   " must be one of them",
               "state");
  }

  const Paper& paper_;
  fs::path file_;
};

}  // namespace

Paper read_declarations(const fs::path& folder) {
  const fs::path file = folder / "paper.toml";
  if (!fs::exists(file))
    throw BadInput("there is no paper in '" + printable_name(folder) +
                   "': a paper is a folder with the files paper.toml and equations.toml");
  TomlTable document(file);
  Paper paper{.source = ""};
  paper.title = document.needed_line("title");
  paper.authors = document.lines("authors");
  if (const auto year = document.whole("year", 1, 9999)) paper.year = std::to_string(*year);
  paper.doi = document.line("doi");
  paper.look_alikes = document.named_texts("look_alikes");
  const DeclaredSymbols declared = symbols_in(document);
  document.done();
  paper.folder = fs::absolute(folder);
  paper.equations = paper.folder / "equations.toml";
  try {
    paper.declare(declared.symbols);
    paper.integers = declared.integers;
  } catch (const std::invalid_argument& error) {
    document.fail(error.what(), "symbols");
  }
  for (const auto& [name, other] : paper.look_alikes)
    for (const std::string& one : {name, other})
      document.check_word("look_alikes", one, paper.symbols.names());
  return paper;
}

Paper read_paper(const fs::path& folder) {
  Paper paper = read_declarations(folder);
  const fs::path derivations = paper.folder / "derivations.json";
  if (fs::exists(derivations)) paper.derivations = read_derivations(derivations, paper.symbols);
  paper.emission = [paper] { return FunctionsFile(paper, paper.folder / "functions.toml").emission(); };
  return paper;
}

std::vector<std::string> events_of_stepper(const Paper& paper, const std::string& stepper) {
  TomlTable document(paper.folder / "functions.toml");
  for (TomlTable& table : document.tables("stepper"))
    if (table.line("name") == stepper) return table.lines("events");
  return {};
}

fs::path source_of_derivations(const fs::path& folder) {
  const fs::path python = folder / "derive.py", cpp = folder / "derive.cpp";
  if (fs::exists(python) && fs::exists(cpp))
    throw BadInput("the folder '" + printable_name(folder) +
                   "' has both derive.py and derive.cpp; a paper has one of them");
  if (fs::exists(python)) return python;
  return fs::exists(cpp) ? cpp : fs::path();
}

std::string digest_of(const fs::path& folder) {
  const fs::path source = source_of_derivations(folder);
  return hash_of(read_whole(folder / "paper.toml") + (source.empty() ? "" : read_whole(source)));
}

bool has_current_derivations(const fs::path& folder) {
  return source_of_derivations(folder).empty() || digest_in(folder / "derivations.json") == digest_of(folder);
}

}  // namespace rederive::paper
