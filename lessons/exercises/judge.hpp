// Judges an answer of any kind, as it was typed.
#pragma once

#include <functional>
#include <lessons/exercises/prepared.hpp>

namespace rederive::classroom {

Opinion judge_answer(const Prepared& prepared, const std::string& text);

/// The limits for judging an answer, in seconds of the processor and in megabytes beyond the present size of
/// the process. Right answers need a small part of both, even on a busy machine.
constexpr double most_judging_seconds = 20;
constexpr long most_judging_megabytes = 1024;
/// Judges any text, in a process that can neither hang nor starve this one. Beyond the limits the outcome is
/// `undecided`.
Opinion judge_bounded(const Exercise& exercise, const std::string& text);
/// Returns what `judge` returns, within the same limits.
Opinion bounded(const std::function<Opinion()>& judge);

}  // namespace rederive::classroom
