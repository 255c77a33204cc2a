#include <sys/resource.h>

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <vector>
#endif
#if __has_include(<valgrind/valgrind.h>)
#include <valgrind/valgrind.h>
#else
#define RUNNING_ON_VALGRIND 0
#endif

#include <derivations/program/seal.hpp>

namespace rederive::program {
namespace {

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
/// Restricts this thread to allocating memory, reading the time, waiting, writing to `report`, and ending.
/// Every other system call fails with EPERM. Returns false if the system has no such filter (seccomp).
bool allow_computing_only(int report) {
#if defined(__x86_64__)
  constexpr unsigned machine = AUDIT_ARCH_X86_64;
#else
  constexpr unsigned machine = AUDIT_ARCH_AARCH64;
#endif
  const auto load = [](std::size_t offset) {
    return sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(offset));
  };
  const auto unless = [](auto value, unsigned char skip) {
    return sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(value), 0, skip);
  };
  const sock_filter allow = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
                    refuse = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM);
  std::vector<sock_filter> filter{load(offsetof(seccomp_data, arch)),
                                  BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, machine, 1, 0), refuse,
                                  load(offsetof(seccomp_data, nr))};
  for (const long call :
       {SYS_brk, SYS_munmap, SYS_mremap, SYS_mprotect, SYS_madvise, SYS_futex, SYS_clock_gettime,
        SYS_clock_getres, SYS_gettimeofday, SYS_clock_nanosleep, SYS_nanosleep, SYS_restart_syscall,
        SYS_getpid, SYS_getrusage, SYS_rt_sigreturn, SYS_exit, SYS_exit_group})
    filter.insert(filter.end(), {unless(call, 1), allow});
  const auto allow_with = [&](long call, std::size_t argument, auto value) {
    filter.insert(filter.end(), {unless(call, 4), load(offsetof(seccomp_data, args) + 8 * argument),
                                 unless(value, 1), allow, refuse});
  };
  allow_with(SYS_mmap, 4, -1);  // memory, and no file
  allow_with(SYS_write, 0, report);
  filter.push_back(refuse);
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}
#else
bool allow_computing_only(int) { return false; }
#endif

}  // namespace

bool is_watched() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;
#else
  return RUNNING_ON_VALGRIND;
#endif
}

void seal(int report) {
  if (is_watched()) return;
  constexpr rlimit none{0, 0};
  for (const auto what : {RLIMIT_NOFILE, RLIMIT_FSIZE, RLIMIT_NPROC, RLIMIT_CORE}) ::setrlimit(what, &none);
  (void)allow_computing_only(report);
}

}  // namespace rederive::program
