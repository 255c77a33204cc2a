// Judges an expression or an equation: it is right by proof.
#pragma once

#include <derivations/reader/generous.hpp>
#include <lessons/exercises/prepared.hpp>

namespace rederive::classroom {

/// Reads the statement to judge, as students write, in all ways that differ in value. Of "y_c = ..." it is
/// the right side, if an expression is asked for and y_c is its name. Throws SyntaxError.
reader::Readings read_answer(const Exercise& exercise, const std::string& text);
/// Returns all ways to read a statement. Throws SyntaxError.
reader::Readings readings_of(const Exercise& exercise, const std::string& text);
/// Returns whether this is the name of what the exercise asks for, in any order of its factors.
bool is_asked_for(const Exercise& exercise, const language::Tree& left);
/// Throws SyntaxError unless the relation may follow that name: =, or the bound of the exercise, strict or
/// not.
void check_relation(const Exercise& exercise, const std::string& relation);

Opinion judge_formula(const Prepared& prepared, const std::string& text);
Opinion judge_formula(const Prepared& prepared, const language::Relation& read);

}  // namespace rederive::classroom
