// Judges an answer of any kind, as typed.
#pragma once

#include <functional>
#include <lessons/exercises/prepared.hpp>

namespace rederive::classroom {

Opinion judge_answer(const Prepared& prepared, const std::string& text);

/// What judging an answer may take, in seconds of the processor and in megabytes beyond what this process
/// has. Right answers take a small part of it, on a busy machine as well.
constexpr double most_judging_seconds = 20;
constexpr long most_judging_megabytes = 1024;
/// Judges whatever may have been typed, in a process that can neither hang nor starve this one. The outcome
/// is `undecided` beyond these limits.
Opinion judge_bounded(const Exercise& exercise, const std::string& text);
/// Returns what `judge` returns, within the same limits.
Opinion bounded(const std::function<Opinion()>& judge);

}  // namespace rederive::classroom
