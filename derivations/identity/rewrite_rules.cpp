#include <derivations/identity/translator.hpp>
#include <derivations/language/syntax.hpp>
#include <map>

namespace rederive {

const RewriteRule* rewrite_rule(const std::string& function) {
  struct Row {
    const char* function;
    std::vector<std::pair<const char*, Signs>> domain;
    const char* result = nullptr;
  };
  static const std::map<std::string, RewriteRule> rules = [] {
    const Signs nonzero = Signs::nonzero(), positive = Signs::positive(), nonnegative = Signs::nonnegative();
    const std::vector<Row> rows{{"tan", {{"cos(u)", nonzero}}, "sin(u)/cos(u)"},
                                {"sec", {{"cos(u)", nonzero}}, "1/cos(u)"},
                                {"cot", {{"sin(u)", nonzero}}, "cos(u)/sin(u)"},
                                {"csc", {{"sin(u)", nonzero}}, "1/sin(u)"},
                                {"sqrt", {{"u", nonnegative}}},
                                {"log", {{"u", positive}}},
                                {"asin", {{"1-u^2", nonnegative}}},
                                {"acos", {{"1-u^2", nonnegative}}, "pi/2-asin(u)"},
                                {"sinh", {}, "(exp(u)-exp(-u))/2"},
                                {"cosh", {}, "(exp(u)+exp(-u))/2"},
                                {"tanh", {}, "(exp(u)-exp(-u))/(exp(u)+exp(-u))"},
                                {"sech", {}, "2/(exp(u)+exp(-u))"},
                                {"coth", {{"u", nonzero}}, "(exp(u)+exp(-u))/(exp(u)-exp(-u))"},
                                {"csch", {{"u", nonzero}}, "2/(exp(u)-exp(-u))"},
                                {"asinh", {}, "log(u+sqrt(u^2+1))"},
                                {"acosh", {{"u-1", nonnegative}}, "log(u+sqrt(u^2-1))"},
                                {"atanh", {{"1-u", positive}, {"1+u", positive}}, "log((1+u)/(1-u))/2"}};
    Symbols symbols;
    symbols.declare("u", "u", "u", "1", all_numbers, "", "");
    std::map<std::string, RewriteRule> result;
    for (const Row& row : rows) {
      RewriteRule& rule = result[row.function];
      for (const auto& [value, signs] : row.domain) rule.domain.emplace_back(parse(value, symbols), signs);
      if (row.result != nullptr) rule.result = parse(row.result, symbols);
    }
    return result;
  }();
  const auto found = rules.find(function);
  return found == rules.end() ? nullptr : &found->second;
}

}  // namespace rederive
