// Lessons as a LaTeX article that pdflatex takes as it is.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/language/text.hpp>
#include <derivations/program/bad_input.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <sstream>

namespace rederive::page {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace program;
using namespace paper;
namespace {

constexpr auto preamble = R"(\documentclass[11pt,a4paper]{article}
\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage{lmodern}
\usepackage{amsmath,amssymb,graphicx,textcomp}
\usepackage[margin=25mm]{geometry}
\usepackage[hidelinks]{hyperref}
\setlength{\parindent}{0pt}\setlength{\parskip}{6pt plus 2pt}
\allowdisplaybreaks\emergencystretch=3em
% A displayed formula that may break at its relation signs and terms.
\newcommand{\shown}[1]{\begin{list}{}{\leftmargin=2em\rightmargin=0pt\topsep=2pt}\item\raggedright
  $\displaystyle #1$\end{list}}
\newcommand{\numbered}[2]{\begin{list}{}{\leftmargin=2em\rightmargin=0pt\topsep=2pt}\item\raggedright
  $\displaystyle #1$\hspace*{\fill}\mbox{#2}\end{list}}
)";

/// A sign, what LaTeX has for it, and a bar.
constexpr auto latex_signs =
    R"(% \%|& \&|# \#|_ \_|$ \$|{ \{|} \}|^ \textasciicircum{}|~ \textasciitilde{}|\ \textbackslash{}|
< \textless{}|> \textgreater{}|θ̈ $\ddot\theta$|θ̇ $\dot\theta$|θ $\theta$|α $\alpha$|ψ $\psi$|
ω $\omega$|π $\pi$|μ $\mu$|λ $\lambda$|τ $\tau$|² $^2$|³ $^3$|· $\cdot$|− $-$|≥ $\ge$|≤ $\le$|≠ $\ne$|
′ $'$|ẍ $\ddot x$|ÿ $\ddot y$|ü $\ddot u$|Ω $\Omega$|ρ $\rho$|φ $\varphi$|∂ $\partial$|→ $\to$|
∞ $\infty$|– --|— ---|’ '|½ $\frac12$|× $\times$|… \dots{}|ẋ $\dot x$|ẏ $\dot y$|u̇ $\dot u$|≈ $\approx$|
√ $\surd$|⁺ $^+$|⁻ $^-$|₊ $_+$|₋ $_-$|₀ $_0$|₁ $_1$|₂ $_2$|₃ $_3$|₄ $_4$|
ξ $\xi$|η $\eta$|ε $\varepsilon$|∫ $\int$|)";

class LatexRenderer : public Renderer {
 public:
  using Renderer::Renderer;

  std::string begin(const Front& front) override {
    const auto line = [this](const auto& about) {
      return "\\textbf{" + about.first + ":} " + flat(about.second) + "\n";
    };
    return fmt::format("{}\\title{{{}}}\n\\author{{}}\\date{{}}\n\\begin{{document}}\n\\maketitle\n",
                       preamble, latex_escaped(front.title)) +
           joined(front.about, "\n", line);
  }

  std::string end() override { return "\n\\end{document}\n"; }

 private:
  using Renderer::render;
  static std::string environment(const std::string& name, const std::string& text) {
    return "\\begin{" + name + "}" + text + "\\end{" + name + "}\n";
  }
  std::string latex(const Relation& relation) const {
    return print_statement(relation, Notation::latex, symbols());
  }

  std::string math(const Relation& relation) override { return "$" + latex(relation) + "$"; }
  std::string styled(const Span& span) override {
    const std::string text = latex_escaped(span.text);
    if (span.kind == Span::Kind::code) return "\\texttt{" + text + "}";
    return span.kind == Span::Kind::emphasis ? "\\emph{" + text + "}" : text;
  }

  std::string render(const Heading& part) override {
    return (part.number > 0 ? "\\section{" : "\\section*{") + flat(part.text) + "}\n";
  }

  std::string render(const Paragraph& part) override { return flat(part.text) + "\n"; }

  std::string render(const Formula& part) override {
    const std::string formula = latex(part.relation) + part.mark;
    return part.number.empty() ? "\\shown{" + formula + "}\n"
                               : "\\numbered{" + formula + "}{(" + part.number + ")}\n";
  }

  std::string render(const Findings& part) override {
    std::string text = "\\small\\textbf{" + latex_escaped(part.headline) + "}\n";
    for (const auto& line : part.lines) {
      const std::string words = line.verbatim.empty() ? flat(line.words) : latex_escaped(line.verbatim);
      text += "\\\\" + (line.label.empty() ? "" : "\\emph{" + latex_escaped(line.label) + ":} ") +
              "{\\raggedright " + (line.formula ? "$\\displaystyle " + latex(*line.formula) + "$" : words) +
              "}\n";
    }
    return environment("quote", text);
  }

  std::string row(const std::vector<std::string>& cells) { return joined(flat(cells), " & ") + " \\\\\n"; }

  std::string render(const Table& part) override {
    const std::size_t count = part.rows.empty() ? part.header.size() : part.rows[0].size();
    std::string text = "{" + std::string(count, 'l') + "}\\hline\n";
    if (!part.header.empty()) text += row(part.header) + "\\hline\n";
    for (const auto& cells : part.rows) text += row(cells);
    std::string table = environment("tabular", text + "\\hline");
    table.pop_back();
    return environment("center", "\\small" + table);
  }

  std::string render(const Figure& part) override {
    const auto picture = draw(part, "pdf", *setting_.figures);
    const std::string image = picture ? "\\includegraphics[width=.75\\linewidth]{" +
                                            printable_name(setting_.beside ? picture->filename() : *picture) +
                                            "}\\\\\n"
                                      : "";
    return environment("center", image + "\\small " + flat(part.caption));
  }

  std::string render(const Commands& part) override {
    return environment("verbatim", "\n" + joined(part.lines, "\n") + "\n");
  }

  std::string render(const Theorem& part) override {
    return flat("(" + part.id + ") as a lemma of Coq: " + part.where) + "\n\n";
  }

  std::string render(const BulletList& part) override {
    return environment("itemize", "\n" + joined(flat(part.items), "", [](const std::string& item) {
                                    return "\\item " + item + "\n";
                                  }));
  }
};

}  // namespace

std::string latex_escaped(std::string_view text) {
  static const auto table = [] {
    std::map<std::string, std::string, std::greater<>> result;  // the longer one first
    std::istringstream signs(latex_signs);
    for (std::string sign, with; signs >> sign >> std::ws && std::getline(signs, with, '|');)
      result[sign] = with;
    return result;
  }();
  std::string out;
  while (!text.empty()) {
    const auto known = std::find_if(table.begin(), table.end(),
                                    [&](const auto& entry) { return text.starts_with(entry.first); });
    const auto [code, length] = first_character(text);
    const std::size_t bytes = std::max<std::size_t>(length, 1);
    const bool is_letter = bytes == 1 || (code >= 0xC0 && code < 0x250);
    out += known != table.end() ? known->second : is_letter ? std::string(text.substr(0, bytes)) : "?";
    text.remove_prefix(known != table.end() ? known->first.size() : bytes);
  }
  return out;
}

std::unique_ptr<Renderer> latex_renderer(const Setting& setting) {
  return std::make_unique<LatexRenderer>(setting);
}

}  // namespace rederive::page
