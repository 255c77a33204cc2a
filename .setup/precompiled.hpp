// What nearly every file of the rooms includes, read once; and a search by regular expression, compiled once
// instead of in each file that has one: two seconds each.
#pragma once

#include <ginac/ginac.h>

#include <regex>

#if defined(__GLIBCXX__) && _GLIBCXX_RELEASE == 12
namespace std::__detail {
extern template class _Compiler<regex_traits<char>>;
extern template bool __regex_algo_impl(string::const_iterator, string::const_iterator, smatch&, const regex&,
                                       regex_constants::match_flag_type, _RegexExecutorPolicy, bool);
}  // namespace std::__detail
#endif
