// What precompiled.hpp says is compiled once.
#include <.setup/precompiled.hpp>

#if defined(__GLIBCXX__) && _GLIBCXX_RELEASE == 12
namespace std::__detail {
template class _Compiler<regex_traits<char>>;
template bool __regex_algo_impl(string::const_iterator, string::const_iterator, smatch&, const regex&,
                                regex_constants::match_flag_type, _RegexExecutorPolicy, bool);
}  // namespace std::__detail
#endif
