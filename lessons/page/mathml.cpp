// LaTeX, as far as `print` and the symbols of papers use it, → MathML. Browsers draw MathML by themselves, so
// a page needs no script, no font and no network; and a reader's screen reader can read it aloud.
#include <algorithm>
#include <cctype>
#include <derivations/language/unicode.hpp>
#include <lessons/page/render.hpp>
#include <map>
#include <stdexcept>
#include <utility>

namespace rederive {
namespace {

using Signs = std::map<std::string, std::string, std::less<>>;

const Signs letters{
    {"alpha", "α"},      {"beta", "β"},   {"gamma", "γ"},    {"delta", "δ"},    {"epsilon", "ϵ"},
    {"varepsilon", "ε"}, {"zeta", "ζ"},   {"eta", "η"},      {"theta", "θ"},    {"vartheta", "ϑ"},
    {"iota", "ι"},       {"kappa", "κ"},  {"varkappa", "ϰ"}, {"lambda", "λ"},   {"mu", "μ"},
    {"nu", "ν"},         {"xi", "ξ"},     {"omicron", "ο"},  {"pi", "π"},       {"varpi", "ϖ"},
    {"rho", "ρ"},        {"varrho", "ϱ"}, {"sigma", "σ"},    {"varsigma", "ς"}, {"tau", "τ"},
    {"upsilon", "υ"},    {"phi", "ϕ"},    {"varphi", "φ"},   {"chi", "χ"},      {"psi", "ψ"},
    {"omega", "ω"},      {"Gamma", "Γ"},  {"Delta", "Δ"},    {"Theta", "Θ"},    {"Lambda", "Λ"},
    {"Xi", "Ξ"},         {"Pi", "Π"},     {"Sigma", "Σ"},    {"Upsilon", "Υ"},  {"Phi", "Φ"},
    {"Psi", "Ψ"},        {"Omega", "Ω"},  {"partial", "∂"},  {"nabla", "∇"},    {"ell", "ℓ"},
    {"hbar", "ℏ"},       {"infty", "∞"},  {"imath", "ı"},    {"jmath", "ȷ"}};
const Signs operators{{"cdot", "·"},   {"times", "×"},  {"le", "≤"},     {"leq", "≤"},      {"ge", "≥"},
                      {"geq", "≥"},    {"ne", "≠"},     {"neq", "≠"},    {"approx", "≈"},   {"sim", "∼"},
                      {"simeq", "≃"},  {"equiv", "≡"},  {"propto", "∝"}, {"in", "∈"},       {"pm", "±"},
                      {"mp", "∓"},     {"ast", "∗"},    {"star", "⋆"},   {"circ", "∘"},     {"bullet", "•"},
                      {"prime", "′"},  {"dagger", "†"}, {"perp", "⊥"},   {"parallel", "∥"}, {"to", "→"},
                      {"cdots", "⋯"},  {"ldots", "…"},  {"dots", "…"},   {"colon", ":"},    {"mid", "|"},
                      {"lbrace", "{"}, {"rbrace", "}"}, {"{", "{"},      {"}", "}"},        {"langle", "⟨"},
                      {"rangle", "⟩"}, {"lvert", "|"},  {"rvert", "|"},  {"vert", "|"},     {"|", "‖"},
                      {"%", "%"},      {"&", "&"},      {"_", "_"},      {"#", "#"}};
const Signs accents{{"dot", "˙"},   {"ddot", "¨"},    {"dddot", "⃛"},  {"bar", "¯"},       {"overline", "¯"},
                    {"hat", "ˆ"},   {"widehat", "ˆ"}, {"tilde", "˜"}, {"widetilde", "˜"}, {"vec", "→"},
                    {"check", "ˇ"}, {"breve", "˘"},   {"acute", "´"}, {"grave", "`"},     {"mathring", "˚"}};
const Signs gaps{{",", "0.17em"}, {":", "0.22em"}, {";", "0.28em"}, {"!", "-0.17em"},
                 {" ", "0.33em"}, {"quad", "1em"}, {"qquad", "2em"}};

constexpr std::string_view functions =
    " sin cos tan cot sec csc sinh cosh tanh coth exp log ln arcsin arccos arctan arsinh arcosh artanh min "
    "max ";
/// Whether a name is among words that have blanks around them.
bool is_one_of(const std::string& name, std::string_view words) {
  return words.find(" " + name + " ") != std::string_view::npos;
}
constexpr auto thin_gap = "<mspace width=\"0.17em\"/>";

class Translator {
 public:
  explicit Translator(const std::string& latex) : text_(latex) {}

  std::string all() {
    std::string result = row("");
    if (at_ != text_.size()) fail("unmatched '" + text_.substr(at_, 1) + "'");
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw std::invalid_argument("cannot turn into MathML (" + why + "): " + text_);
  }
  bool done() const { return at_ >= text_.size(); }
  void skip_blanks() {
    while (!done() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  std::string command() {  // at the letters behind a backslash
    std::size_t end = at_;
    while (end < text_.size() && std::isalpha(static_cast<unsigned char>(text_[end]))) ++end;
    if (end == at_) ++end;
    const std::string name = text_.substr(at_, end - at_);
    at_ = end;
    return name;
  }
  bool next_is(std::string_view token) {
    skip_blanks();
    return text_.compare(at_, token.size(), token) == 0;
  }

  /// Does the name of a function come next?
  bool at_word() const {
    if (text_[at_] != '\\') return false;
    std::size_t end = at_ + 1;
    while (end < text_.size() && std::isalpha(static_cast<unsigned char>(text_[end]))) ++end;
    return is_one_of(text_.substr(at_ + 1, end - at_ - 1), functions);
  }

  /// Atoms with their scripts, until the text or the group ends.
  std::string row(const std::string& until) {
    std::string result;
    for (skip_blanks(); !done() && text_[at_] != '}'; skip_blanks()) {
      if (!until.empty() && next_is(until)) break;
      const bool apart = at_word() && !result.empty() && !result.ends_with("</mo>");
      const bool leads = result.empty() || result.ends_with("</mo>");
      std::string part = scripted();
      if (leads && part == "<mo>−</mo>") part = "<mo form=\"prefix\">−</mo>";  // the sign of what follows
      result += (apart ? thin_gap : "") + part;
    }
    return result;
  }

  std::string scripted() {
    std::string base = atom(), below, above;
    for (skip_blanks(); !done() && (text_[at_] == '_' || text_[at_] == '^' || text_[at_] == '\'');
         skip_blanks()) {
      const char mark = text_[at_++];
      if (mark == '\'')
        above += "<mo>′</mo>";
      else if (mark == '_' && !word_in_braces().empty())
        below += "<mi mathvariant=\"normal\">" + words() + "</mi>";
      else
        (mark == '_' ? below : above) += argument();
    }
    if (below.empty() && above.empty()) return base;
    if (above.empty()) return "<msub>" + base + grouped(below) + "</msub>";
    if (below.empty()) return "<msup>" + base + grouped(above) + "</msup>";
    return "<msubsup>" + base + grouped(below) + grouped(above) + "</msubsup>";
  }

  static std::string grouped(const std::string& inner) { return "<mrow>" + inner + "</mrow>"; }

  /// What a command or a script applies to: a group or one atom.
  std::string argument() {
    skip_blanks();
    if (done()) fail("an argument is missing at the end");
    return atom();
  }

  std::string group() {  // behind the opening brace
    const std::string inner = row("");
    if (done()) fail("'{' is not closed");
    ++at_;
    return grouped(inner);
  }

  /// "after" of {after}: a word that is no product of letters. Empty if no such thing comes next.
  std::string word_in_braces() {
    skip_blanks();
    const std::size_t close = text_.find('}', at_);
    if (done() || text_[at_] != '{' || close == std::string::npos || close < at_ + 3) return "";
    const std::string inner = text_.substr(at_ + 1, close - at_ - 1);
    const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0; };
    return std::all_of(inner.begin(), inner.end(), is_letter) ? inner : "";
  }

  /// The words of \mathrm{...} and \text{...}.
  std::string words() {
    skip_blanks();
    if (done() || text_[at_] != '{') fail("'{' expected");
    const std::size_t close = text_.find('}', at_);
    if (close == std::string::npos) fail("'{' is not closed");
    const std::string inner = text_.substr(at_ + 1, close - at_ - 1);
    at_ = close + 1;
    return inner;
  }

  std::string atom() {
    const char c = text_[at_++];
    if (c == '{') return group();
    if (c == '\\') return by_name(command());
    if (std::isdigit(static_cast<unsigned char>(c))) {
      std::string number(1, c);
      while (!done() && (std::isdigit(static_cast<unsigned char>(text_[at_])) || text_[at_] == '.'))
        number += text_[at_++];
      return "<mn>" + number + "</mn>";
    }
    if (std::isalpha(static_cast<unsigned char>(c))) return std::string("<mi>") + c + "</mi>";
    if (static_cast<unsigned char>(c) >= 0x80) {
      const std::size_t bytes = first_character(std::string_view(text_).substr(at_ - 1)).bytes;
      if (bytes == 0) fail("bytes that are not UTF-8");
      at_ += bytes - 1;
      return "<mi>" + text_.substr(at_ - bytes, bytes) + "</mi>";
    }
    return "<mo>" + (c == '-' ? std::string("−") : escaped(std::string(1, c))) + "</mo>";
  }

  std::string delimiter(const std::string& form, bool stretches = true) {
    skip_blanks();
    if (done()) fail("a bracket is missing at the end");
    std::string sign(1, text_[at_++]);
    if (sign == "\\") {
      const std::string name = command();
      const auto found = operators.find(name);
      if (found == operators.end()) fail("unknown bracket \\" + name);
      sign = found->second;
    }
    const std::string stretchy = stretches ? "true" : "false";
    return sign == "." ? std::string()
                       : "<mo form=\"" + form + "\" lspace=\"0\" rspace=\"0\" stretchy=\"" + stretchy +
                             "\">" + escaped(sign) + "</mo>";
  }

  std::string by_name(const std::string& name) {
    if (const auto found = letters.find(name); found != letters.end())
      return "<mi>" + found->second + "</mi>";
    if (const auto found = operators.find(name); found != operators.end())
      return "<mo>" + escaped(found->second) + "</mo>";
    if (const auto found = accents.find(name); found != accents.end())
      return "<mover accent=\"true\">" + argument() + "<mo stretchy=\"false\">" + found->second +
             "</mo></mover>";
    if (const auto found = gaps.find(name); found != gaps.end())
      return "<mspace width=\"" + found->second + "\"/>";
    if (name == "frac" || name == "dfrac" || name == "tfrac") {
      const std::string over = argument();
      return "<mfrac>" + over + argument() + "</mfrac>";
    }
    if (name == "sqrt") return root();
    if (name == "left") {
      const std::size_t bracket = at_;
      delimiter("prefix");
      const std::string inner = row("\\right");
      if (!next_is("\\right")) fail("\\left without \\right");
      at_ += 6;
      const bool tall =
          inner.find("<mfrac") != std::string::npos || inner.find("<msqrt") != std::string::npos;
      const std::string close = delimiter("postfix", tall);
      const std::size_t end = std::exchange(at_, bracket);
      const std::string open = delimiter("prefix", tall);
      at_ = end;
      return "<mrow>" + open + inner + close + "</mrow>";
    }
    if (is_one_of(name, " mathrm operatorname text textrm mathnormal "))
      return "<mi mathvariant=\"normal\">" + escaped(words()) + "</mi>";
    if (is_one_of(name, " mathbf boldsymbol bm textbf "))
      return "<mrow style=\"font-weight:bold\">" + argument() + "</mrow>";
    if (is_one_of(name, " mathit mathsf mathcal mathbb mathfrak mathscr textit ")) return argument();
    return function(name);
  }

  /// \sqrt{x}, or \sqrt[3]{x}.
  std::string root() {
    if (!next_is("[")) return "<msqrt>" + argument() + "</msqrt>";
    ++at_;
    const std::string degree = row("]");
    if (!next_is("]")) fail("'[' is not closed");
    ++at_;
    return "<mroot>" + argument() + grouped(degree) + "</mroot>";
  }

  /// \sin and its kin: an upright word, and a thin gap before what it is taken of.
  std::string function(const std::string& name) {
    if (!is_one_of(name, functions)) fail("unknown command \\" + name);
    const bool apart = !next_is("^") && !next_is("_") && !next_is("\\left") && !next_is("(");
    return "<mi>" + name + "</mi>" + (apart ? thin_gap : "");
  }

  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string mathml(const std::string& latex) { return "<math>" + Translator(latex).all() + "</math>"; }

}  // namespace rederive
