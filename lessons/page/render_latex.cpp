// Lessons as a LaTeX article that pdflatex takes as it is.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/language/unicode.hpp>
#include <derivations/program/bad_input.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <sstream>

namespace rederive {
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
  explicit LatexRenderer(const Setting& setting) : setting_(setting) {}

  std::string begin(const Lesson& lesson) override {
    const std::string ids = numbers_of(setting_.equations_of(lesson));
    return preamble +
           fmt::format("\\title{{Lesson {}. {}}}\n\\author{{}}\\date{{}}\n\\begin{{document}}\n\\maketitle\n",
                       lesson.number, latex_escaped(lesson.title)) +
           "\\textbf{Teaches:} " + flat(lesson.teaches) + "\n\n\\textbf{Builds on:} " +
           flat(lesson.builds_on) + "\n" + (ids.empty() ? "" : "\n\\textbf{Equations:} " + ids + "\n");
  }

  std::string step(std::size_t, const std::string& heading, const Page& page) override {
    std::string text = "\n\\section{" + latex_escaped(heading) + "}\n";
    for (const auto& block : page.blocks())
      text += "\n" + std::visit([this](const auto& part) { return this->render(part); }, block);
    return text;
  }

  std::string end(const Lesson&) override { return "\n\\end{document}\n"; }

 private:
  std::string flat(const std::string& sentence) const {
    std::string text;
    for (const auto& span : spans(sentence)) {
      if (span.kind == Span::Kind::math)
        text += "$" + print_inline(span.text, Notation::latex, setting_.paper.symbols) + "$";
      else if (span.kind == Span::Kind::code)
        text += "\\texttt{" + latex_escaped(span.text) + "}";
      else if (span.kind == Span::Kind::emphasis)
        text += "\\emph{" + latex_escaped(span.text) + "}";
      else
        text += latex_escaped(span.text);
    }
    return text;
  }

  std::string render(const Paragraph& part) const { return flat(part.text) + "\n"; }

  std::string render(const Formula& part) const {
    const std::string formula =
        print_statement(part.relation, Notation::latex, setting_.paper.symbols) + part.mark;
    return part.number.empty() ? "\\shown{" + formula + "}\n"
                               : "\\numbered{" + formula + "}{(" + part.number + ")}\n";
  }

  std::string render(const Judgement& part) const {
    std::string text =
        "\\begin{quote}\\small\\textbf{The ledger on " + latex_escaped(headline(part.entry)) + "}\n";
    for (const auto& line : findings(part.entry, setting_.paper))
      text +=
          "\\\\\\emph{" + line.label + ":} {\\raggedright " +
          (line.formula ? "$\\displaystyle " +
                              print_statement(*line.formula, Notation::latex, setting_.paper.symbols) + "$"
                        : flat(line.words)) +
          "}\n";
    return text + "\\end{quote}\n";
  }

  std::string row(const std::vector<std::string>& cells) const {
    return joined(cells, " & ", [this](const std::string& cell) { return flat(cell); }) + " \\\\\n";
  }

  std::string render(const Table& part) const {
    const std::string align(part.header.size(), 'l');
    std::string text =
        "\\begin{center}\\small\\begin{tabular}{" + align + "}\\hline\n" + row(part.header) + "\\hline\n";
    for (const auto& cells : part.rows) text += row(cells);
    return text + "\\hline\\end{tabular}\\end{center}\n";
  }

  std::string render(const Figure& part) const {
    const auto picture = draw(part, "pdf", *setting_.figures);
    const std::string image = picture ? "\\includegraphics[width=.75\\linewidth]{" +
                                            printable_name(setting_.beside ? picture->filename() : *picture) +
                                            "}\\\\\n"
                                      : "";
    return "\\begin{center}" + image + "\\small " + flat(part.caption) + "\\end{center}\n";
  }

  static std::string render(const Commands& part) {
    std::string text = "\\begin{verbatim}\n";
    for (const auto& line : part.lines) text += line + "\n";
    return text + "\\end{verbatim}\n";
  }

  std::string render(const CoqLemma& part) const {
    return flat("(" + part.id + ") as a lemma of Coq: " + part.where) + "\n\n";
  }

  std::string render(const BulletList& part) const {
    std::string text = "\\begin{itemize}\n";
    for (const auto& item : part.items) text += "\\item " + flat(item) + "\n";
    return text + "\\end{itemize}\n";
  }

  Setting setting_;
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

}  // namespace rederive
