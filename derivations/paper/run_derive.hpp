// The main program of a derive.cpp: the derivations of a paper in C++, written as data.
#pragma once

#include <derivations/paper/paper.hpp>
#include <derivations/paper/steps.hpp>
#include <functional>

namespace rederive::paper {

/// Adds the derivations of a paper's rows to `rows`; `symbols` are those of its paper.toml.
using DeriveRows = std::function<void(const language::Symbols& symbols, Derivations& rows)>;

/// Runs the command line of a derive.cpp: `int main(int argc, char** argv) { return run_derive(derive, argc,
/// argv); }`. It reads the symbols of the folder that is its argument, calls `derive`, which adds the
/// derivations of the rows, runs each derivation, and writes derivations.json whole or not at all. A
/// derivation that throws is an error of its row alone. Returns the exit code.
int run_derive(const DeriveRows& derive, int argc, char** argv);

}  // namespace rederive::paper
