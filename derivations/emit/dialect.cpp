#include <algorithm>
#include <derivations/emit/dialect.hpp>
#include <derivations/language/functions.hpp>
#include <stdexcept>

namespace rederive::emit {
using namespace language;

namespace {

std::string joined(const std::vector<std::string>& parts, const std::string& before,
                   const std::string& between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : between) + before + part;
  return text;
}

std::string prefixed(const std::vector<std::string>& lines, const std::string& prefix) {
  std::string text;
  for (const std::string& line : lines) text += prefix + line + "\n";
  return text;
}

/// Returns "T name(T a, T b) {", on several lines if one is not enough.
std::string signature(const std::string& type, const std::string& rest) {
  const bool fits = type.size() + rest.size() < 110;
  return (fits ? type + " " : type + "\n") + wrapped(rest, "    ", ", ") + "\n";
}

/// Returns "const T common_1 = alpha + theta;" for each shared expression.
std::string declarations(const Body& body, const std::string& type, const std::string& end) {
  std::string text;
  for (const auto& [name, expression] : body.shared) {
    text += wrapped("  " + type + name + " = " + expression + end, "      ") + "\n";
  }
  return text;
}

std::string result_list(const Body& body, bool named) {
  std::string text;
  for (const auto& [name, expression] : body.results) {
    text += (text.empty() ? "" : ", ") + (named ? name + ": " : "") + expression;
  }
  return text;
}

/// Returns the definition of the record that a function with derivatives returns.
std::string record_of(const std::string& function, const std::string& type, const Body& body) {
  std::string text = "struct " + function + "_result {\n  " + type + " ";
  for (const auto& [member, unused] : body.results) text += (member == "value" ? "" : ", ") + member;
  return text + ";\n};\n\n";
}

class Cpp : public Dialect {
 public:
  std::string number(const std::string& digits) const override { return "T(" + digits + ")"; }
  std::string pi() const override { return "pi<T>()"; }
  std::string comment(const std::vector<std::string>& lines) const override { return prefixed(lines, "// "); }
  std::string prologue() const override {
    return "#pragma once\n\n#include <cmath>\n\nnamespace rederive::emitted {\n\n"
           "/// Half a turn. Specialise it for types that are wider than long double, or enclose.\n"
           "template <class T>\nT pi() {\n  return T(3.14159265358979323846264338327950288L);\n}\n";
  }
  std::string epilogue() const override { return "\n}  // namespace rederive::emitted\n"; }
  std::string function(const std::string& name, const std::vector<std::string>& arguments,
                       const std::vector<std::string>& documentation, const Body& body) const override {
    const bool record = body.results.size() > 1;
    std::string text = record ? "template <class T>\n" + record_of(name, "T", body) : "";
    text += prefixed(documentation, "/// ") + "template <class T>\n";
    std::vector<std::string> parameters;
    for (const std::string& argument : arguments) {
      parameters.push_back(std::ranges::count(body.unused, argument) > 0 ? "T /*" + argument + "*/"
                                                                         : "T " + argument);
    }
    text += signature(record ? name + "_result<T>" : "T", name + "(" + joined(parameters, "", ", ") + ") {");
    for (const std::string& used : body.functions_used) text += "  using std::" + used + ";\n";
    text += declarations(body, "const T ", ";");
    const std::string result = result_list(body, false);
    return text + wrapped(record ? "  return {" + result + "};" : "  return " + result + ";", "      ") +
           "\n}\n";
  }
};

class C : public Dialect {
 public:
  std::string number(const std::string& digits) const override { return digits + ".0"; }
  std::string pi() const override { return "3.14159265358979323846"; }
  std::string comment(const std::vector<std::string>& lines) const override {
    return "/*\n" + prefixed(lines, " * ") + " */\n";
  }
  std::string prologue() const override { return "#include <math.h>\n"; }
  std::string function(const std::string& name, const std::vector<std::string>& arguments,
                       const std::vector<std::string>& documentation, const Body& body) const override {
    const bool record = body.results.size() > 1;
    std::string text = record ? record_of(name, "double", body) : "";
    const std::string type = record ? "struct " + name + "_result" : "double";
    text += comment(documentation);
    text += signature("static inline " + type, name + "(" + joined(arguments, "double ", ", ") + ") {");
    for (const std::string& argument : body.unused) text += "  (void)" + argument + ";\n";
    text += declarations(body, "const double ", ";");
    const std::string result = result_list(body, false);
    if (!record) return text + wrapped("  return " + result + ";", "      ") + "\n}\n";
    return text + wrapped("  const " + type + " result = {" + result + "};", "      ") +
           "\n  return result;\n}\n";
  }
};

class Python : public Dialect {
 public:
  std::string number(const std::string& digits) const override { return digits + ".0"; }
  std::string pi() const override { return "math.pi"; }
  std::string call(const std::string& function, const std::string& arguments) const override {
    return "math." + function + "(" + arguments + ")";
  }
  std::string comment(const std::vector<std::string>& lines) const override { return prefixed(lines, "# "); }
  std::string prologue() const override { return "import math\nfrom collections import namedtuple\n"; }
  std::string function(const std::string& name, const std::vector<std::string>& arguments,
                       const std::vector<std::string>& documentation, const Body& body) const override {
    const bool record = body.results.size() > 1;
    std::string text = "\n";
    if (record) {
      std::string members;
      for (const auto& [member, unused] : body.results) {
        members += (members.empty() ? "\"" : ", \"") + member + "\"";
      }
      const std::string type = name + "_result";
      text += wrapped(type + " = namedtuple(\"" + type + "\", [" + members + "])", "    ", ", ") + "\n\n\n";
    }
    text += wrapped("def " + name + "(" + joined(arguments, "", ", ") + "):", "        ", ", ") + "\n";
    text += "    \"\"\"" + documentation[0] + "\n";
    for (std::size_t i = 1; i < documentation.size(); ++i) text += "    " + documentation[i] + "\n";
    text += "    \"\"\"\n";
    for (const auto& [shared, expression] : body.shared)
      text += assignment("    " + shared + " = ", expression);
    const std::string result = result_list(body, false);
    if (!record) return text + assignment("    return ", result);
    return text + wrapped("    return " + name + "_result(" + result + ")", "        ") + "\n";
  }

 private:
  static std::string assignment(const std::string& left, const std::string& right) {
    const std::string line = left + right;
    const std::string broken = wrapped(left + "(" + right + ")", "        ");
    return (broken.find('\n') == std::string::npos ? line : broken) + "\n";
  }
};

class JavaScript : public Dialect {
 public:
  std::string number(const std::string& digits) const override { return digits; }
  std::string pi() const override { return "Math.PI"; }
  std::string call(const std::string& function, const std::string& arguments) const override {
    const Function* known = find_function(function);  // none for pow and max
    const bool is_renamed = known != nullptr && !known->javascript.empty();
    return "Math." + (is_renamed ? std::string(known->javascript) : function) + "(" + arguments + ")";
  }
  std::string comment(const std::vector<std::string>& lines) const override { return prefixed(lines, "// "); }
  std::string prologue() const override { return "\"use strict\";\n"; }
  std::string function(const std::string& name, const std::vector<std::string>& arguments,
                       const std::vector<std::string>& documentation, const Body& body) const override {
    std::string text = "/**\n" + prefixed(documentation, " * ") + " */\n";
    text +=
        wrapped("export function " + name + "(" + joined(arguments, "", ", ") + ") {", "    ", ", ") + "\n";
    text += declarations(body, "const ", ";");
    const bool record = body.results.size() > 1;
    const std::string result = result_list(body, record);
    return text + wrapped(record ? "  return { " + result + " };" : "  return " + result + ";", "      ") +
           "\n}\n";
  }
};

/// Returns the only dialect of a language.
template <class Language>
const Dialect* the() {
  static const Language language;
  return &language;
}

}  // namespace

const std::vector<TargetLanguage>& target_languages() {
  static const std::vector<TargetLanguage> all{
      {Target::c, "c", the<C>()},
      {Target::cpp, "cpp", the<Cpp>()},
      {Target::javascript, "javascript", the<JavaScript>()},
      {Target::latex, "latex", nullptr},
      {Target::python, "python", the<Python>()},
  };
  return all;
}

const Dialect& dialect(Target target) {
  for (const TargetLanguage& language : target_languages())
    if (language.target == target && language.dialect != nullptr) return *language.dialect;
  throw std::invalid_argument("LaTeX is not a programming language");
}

std::string wrapped(const std::string& line, const std::string& indent, const std::string& separator) {
  constexpr std::size_t widest = 110;
  std::string text, rest = line;
  while (rest.size() > widest) {
    const std::size_t cut = rest.rfind(separator, widest - separator.size());
    const std::size_t start = rest.find_first_not_of(' ');
    if (cut == std::string::npos || cut <= start || rest.substr(0, cut).ends_with("return")) break;
    const std::size_t kept = cut + separator.size() - 1;  // without the space
    text += rest.substr(0, kept) + "\n";
    rest = indent + rest.substr(kept + 1);
  }
  return text + rest;
}

}  // namespace rederive::emit
