#include <dlfcn.h>
#include <link.h>
#include <sys/auxv.h>

#include <derivations/program/data_folder.hpp>

namespace rederive::program {

std::filesystem::path loaded_from() {
  Dl_info ignored;
  link_map* loaded = nullptr;
  ::dladdr1(reinterpret_cast<const void*>(&loaded_from), &ignored, reinterpret_cast<void**>(&loaded),
            RTLD_DL_LINKMAP);
  const bool is_program = loaded == nullptr || *loaded->l_name == '\0';
  std::error_code error;
  std::filesystem::path file =
      std::filesystem::canonical(is_program ? "/proc/self/exe" : loaded->l_name, error);
  if (error) file = std::filesystem::canonical(reinterpret_cast<const char*>(::getauxval(AT_EXECFN)), error);
  return error ? "/" : file;
}

}  // namespace rederive::program
