// A paper that is a folder: paper.toml, equations.toml, functions.toml and the derivations of derive.py or
// derive.cpp, which travel as derivations.json.
#pragma once

#include <derivations/paper/paper.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace rederive::paper {

/// Returns the paper in a folder. Its derivations are those of `derivations.json`; a paper without this file
/// has none. Throws BadInput, with file, line and field, for a file that is missing or cannot be read.
///
/// `paper.toml` has the keys `title`, `authors`, `year`, `doi`, `look_alikes` (symbols that a typesetter may
/// confuse, `{ b = "h" }`) and the table `[symbols]`. Each symbol is a table of optional keys:
///   - `latex`, `unicode`: how it is written. Default: from its name, `theta_0` as θ₀.
///   - `unit`: a product of powers of units. Default: "1".
///   - `range`: an interval such as "(0, alpha)". Default: all real numbers.
///   - `meaning`, `introduced`: words, and the place in the paper.
///   - `rates`: 1 or 2 declares the time derivatives `NAMEdot` and `NAMEddot`.
///   - `integer`: true for a whole number.
Paper read_paper(const std::filesystem::path& folder);

/// Returns the same paper without derivations: what paper.toml declares. Throws as read_paper does.
Paper read_declarations(const std::filesystem::path& folder);

/// Returns the events of a stepper of functions.toml, equations in our syntax such as "theta = 0". Throws as
/// read_paper does.
std::vector<std::string> events_of_stepper(const Paper& paper, const std::string& stepper);

/// Returns the file with the source of the derivations, derive.py or derive.cpp; an empty path if the folder
/// has neither. Throws BadInput if it has both.
std::filesystem::path source_of_derivations(const std::filesystem::path& folder);

/// Returns a text that changes when paper.toml or the source of the derivations changes.
std::string digest_of(const std::filesystem::path& folder);

/// Returns whether derivations.json was made from the present paper.toml and the present source of the
/// derivations. Without a source, returns true.
bool has_current_derivations(const std::filesystem::path& folder);

}  // namespace rederive::paper
