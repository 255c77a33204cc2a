// The module of WebAssembly, which .setup/wasm/build makes.
#pragma once

#include <tests/run_program.hpp>

/// The folder with judge.js and judge.wasm.
inline std::filesystem::path folder_of_module() {
  return std::filesystem::path(REDERIVE_SOURCE) / "build-wasm";
}

/// Returns whether the module is built; if it is not, the test is skipped.
inline bool is_module_built() {
  if (std::filesystem::exists(folder_of_module() / "judge.wasm")) return true;
  skip("build-wasm/judge.wasm does not exist: .setup/wasm/build makes it");
  return false;
}
