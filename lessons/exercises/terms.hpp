// The terms of a printed equation, at one of which an answer must point.
#pragma once

#include <derivations/paper/paper.hpp>
#include <lessons/exercises/course.hpp>

namespace rederive::classroom {

/// Returns the terms at which a reader can point, from left to right.
std::vector<language::Tree> terms_to_point_at(const language::Relation& relation);
/// Returns a row as printed, with one wrong term: as the paper has it, or corrected and with a slip of
/// `mutants` in it. Throws std::runtime_error if no slip leaves one term to point at.
language::Relation printed_with_slip(const Reference& reference, const paper::Paper& paper);
/// Returns the one term (from 1) that, edited alone, makes what is printed say what is derived for the row.
/// Throws std::runtime_error if there is not exactly one.
std::size_t wrong_term(const language::Relation& printed, const std::string& row, const paper::Paper& paper);

}  // namespace rederive::classroom
