// Lessons as a LaTeX article that pdflatex takes as it is.
#include <fmt/format.h>

#include <lessons/prose.hpp>
#include <lessons/render.hpp>

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

/// Letters that appear in sentences, as pdflatex wants them declared.
constexpr auto declared_letters = R"(\DeclareUnicodeCharacter{03B1}{\ensuremath{\alpha}}
\DeclareUnicodeCharacter{03B8}{\ensuremath{\theta}}
\DeclareUnicodeCharacter{03C8}{\ensuremath{\psi}}
\DeclareUnicodeCharacter{03C9}{\ensuremath{\omega}}
\DeclareUnicodeCharacter{03C0}{\ensuremath{\pi}}
\DeclareUnicodeCharacter{03C4}{\ensuremath{\tau}}
\DeclareUnicodeCharacter{03C1}{\ensuremath{\rho}}
\DeclareUnicodeCharacter{03C6}{\ensuremath{\varphi}}
\DeclareUnicodeCharacter{03BC}{\ensuremath{\mu}}
\DeclareUnicodeCharacter{03BB}{\ensuremath{\lambda}}
\DeclareUnicodeCharacter{03A9}{\ensuremath{\Omega}}
\DeclareUnicodeCharacter{0307}{\ensuremath{^{\cdot}}}
\DeclareUnicodeCharacter{0308}{\ensuremath{^{\cdot\cdot}}}
\DeclareUnicodeCharacter{207A}{\ensuremath{^{+}}}
\DeclareUnicodeCharacter{207B}{\ensuremath{^{-}}}
\DeclareUnicodeCharacter{208A}{\ensuremath{_{+}}}
\DeclareUnicodeCharacter{208B}{\ensuremath{_{-}}}
\DeclareUnicodeCharacter{2080}{\ensuremath{_0}}
\DeclareUnicodeCharacter{2081}{\ensuremath{_1}}
\DeclareUnicodeCharacter{2082}{\ensuremath{_2}}
\DeclareUnicodeCharacter{2083}{\ensuremath{_3}}
\DeclareUnicodeCharacter{2084}{\ensuremath{_4}}
\DeclareUnicodeCharacter{2070}{\ensuremath{^0}}
\DeclareUnicodeCharacter{222B}{\ensuremath{\int}}
\DeclareUnicodeCharacter{221A}{\ensuremath{\surd}}
\DeclareUnicodeCharacter{2212}{\ensuremath{-}}
\DeclareUnicodeCharacter{2202}{\ensuremath{\partial}}
\DeclareUnicodeCharacter{2264}{\ensuremath{\le}}
\DeclareUnicodeCharacter{2265}{\ensuremath{\ge}}
\DeclareUnicodeCharacter{2248}{\ensuremath{\approx}}
\DeclareUnicodeCharacter{2260}{\ensuremath{\ne}}
\DeclareUnicodeCharacter{2032}{\ensuremath{'}}
\DeclareUnicodeCharacter{2192}{\ensuremath{\to}}
\DeclareUnicodeCharacter{221E}{\ensuremath{\infty}}
)";

std::string protect(const std::string& text) {
  std::string result;
  for (char c : text) {
    switch (c) {
      case '\\':
        result += "\\textbackslash{}";
        break;
      case '~':
        result += "\\textasciitilde{}";
        break;
      case '^':
        result += "\\textasciicircum{}";
        break;
      case '&':
      case '%':
      case '#':
      case '_':
      case '{':
      case '}':
      case '$':
        result += '\\';
        [[fallthrough]];
      default:
        result += c;
    }
  }
  return result;
}

class LatexRenderer : public Renderer {
 public:
  explicit LatexRenderer(const Setting& setting) : setting_(setting) {}

  std::string begin(const Lesson& lesson) override {
    std::string ids;
    for (const auto& id : lesson.equations) ids += fmt::format("{}({})", ids.empty() ? "" : " ", id);
    return std::string(preamble) + declared_letters +
           fmt::format("\\title{{Lesson {}. {}}}\n\\author{{}}\\date{{}}\n\\begin{{document}}\n\\maketitle\n",
                       lesson.number, protect(lesson.title)) +
           "\\textbf{Teaches:} " + flat(lesson.teaches) + "\n\n\\textbf{Builds on:} " +
           flat(lesson.builds_on) + "\n" + (ids.empty() ? "" : "\n\\textbf{Equations:} " + ids + "\n");
  }

  std::string step(std::size_t, const std::string& heading, const Page& page) override {
    std::string text = "\n\\section{" + protect(heading) + "}\n";
    for (const auto& block : page.blocks())
      text += "\n" + std::visit([this](const auto& part) { return render(part); }, block);
    return text;
  }

  std::string end(const Lesson&) override { return "\n\\end{document}\n"; }

 private:
  static std::string flat(const std::string& sentence) {
    std::string text;
    for (const auto& span : spans(sentence)) {
      if (span.kind == Span::Kind::math)
        text += "$" + print_inline(span.text, Notation::latex) + "$";
      else if (span.kind == Span::Kind::code)
        text += "\\texttt{" + protect(span.text) + "}";
      else if (span.kind == Span::Kind::emphasis)
        text += "\\emph{" + protect(span.text) + "}";
      else
        text += protect(span.text);
    }
    return text;
  }

  static std::string render(const Paragraph& part) { return flat(part.text) + "\n"; }

  static std::string render(const Formula& part) {
    const std::string formula = print_statement(part.relation, Notation::latex) + part.mark;
    return part.number.empty() ? "\\shown{" + formula + "}\n"
                               : "\\numbered{" + formula + "}{(" + part.number + ")}\n";
  }

  static std::string render(const Judgement& part) {
    std::string text = "\\begin{quote}\\small\\textbf{The ledger on " + protect(headline(part.entry)) + "}\n";
    for (const auto& line : findings(part.entry))
      text += "\\\\\\emph{" + line.label + ":} {\\raggedright " +
              (line.formula ? "$\\displaystyle " + print_statement(*line.formula, Notation::latex) + "$"
                            : flat(line.words)) +
              "}\n";
    return text + "\\end{quote}\n";
  }

  static std::string row(const std::vector<std::string>& cells) {
    std::string line;
    for (const auto& cell : cells) line += (line.empty() ? "" : " & ") + flat(cell);
    return line + " \\\\\n";
  }

  static std::string render(const Table& part) {
    const std::string align(part.header.size(), 'l');
    std::string text =
        "\\begin{center}\\small\\begin{tabular}{" + align + "}\\hline\n" + row(part.header) + "\\hline\n";
    for (const auto& cells : part.rows) text += row(cells);
    return text + "\\hline\\end{tabular}\\end{center}\n";
  }

  std::string render(const Figure& part) const {
    const auto picture = draw(part, "pdf", setting_.figures);
    const std::string image = picture ? "\\includegraphics[width=.75\\linewidth]{" +
                                            (setting_.beside ? picture->filename() : *picture).string() +
                                            "}\\\\\n"
                                      : "";
    return "\\begin{center}" + image + "\\small " + flat(part.caption) + "\\end{center}\n";
  }

  static std::string render(const Commands& part) {
    std::string text = "\\begin{verbatim}\n";
    for (const auto& line : part.lines) text += line + "\n";
    return text + "\\end{verbatim}\n";
  }

  static std::string render(const CoqLemma& part) {
    return flat("(" + part.id + ") as a lemma of Coq: " + part.where) + "\n\n";
  }

  static std::string render(const BulletList& part) {
    std::string text = "\\begin{itemize}\n";
    for (const auto& item : part.items) text += "\\item " + flat(item) + "\n";
    return text + "\\end{itemize}\n";
  }

  Setting setting_;
};

}  // namespace

std::unique_ptr<Renderer> latex_renderer(const Setting& setting) {
  return std::make_unique<LatexRenderer>(setting);
}

}  // namespace rederive
