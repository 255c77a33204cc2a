// The same for tests that read JSON, which is instantiated in main.cc alone: that spares them a fifth of
// their compiling. The others are spared what nlohmann's header costs each file that includes it, nearly a
// second.
#pragma once

#include <nlohmann/json.hpp>
#include <tests/precompiled.hpp>

using JsonText = nlohmann::detail::iterator_input_adapter<std::string::const_iterator>;
extern template class nlohmann::basic_json<>;
extern template class nlohmann::detail::serializer<nlohmann::json>;
extern template class nlohmann::detail::lexer<nlohmann::json, JsonText>;
extern template class nlohmann::detail::parser<nlohmann::json, JsonText>;
