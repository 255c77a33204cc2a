// What most tests include, read once. JSON is instantiated in main.cc alone: that spares them a fifth of
// their compiling.
#pragma once

#include <doctest/doctest.h>
#include <ginac/ginac.h>

#include <nlohmann/json.hpp>
#include <regex>

using JsonText = nlohmann::detail::iterator_input_adapter<std::string::const_iterator>;
extern template class nlohmann::basic_json<>;
extern template class nlohmann::detail::serializer<nlohmann::json>;
extern template class nlohmann::detail::lexer<nlohmann::json, JsonText>;
extern template class nlohmann::detail::parser<nlohmann::json, JsonText>;
