// Letters by MPI: a library of its own, which the program loads under mpirun.
#define OMPI_SKIP_MPICXX 1  // C alone
#include <mpi.h>

#include <numerics/commands/ranks.hpp>

namespace rederive::numerics::commands {
namespace {

/// MPI ends all processes by itself where one of its calls fails.
class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    int level = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &level);
    if (level < MPI_THREAD_SERIALIZED) MPI_Abort(MPI_COMM_WORLD, 3);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  ~MpiRanks() override { MPI_Finalize(); }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  void send(int to, const std::string& text) override {
    MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, 0, MPI_COMM_WORLD);
  }

  std::optional<Letter> receive() override {
    int is_there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &is_there, &status);
    if (is_there == 0) return std::nullopt;
    return Letter{status.MPI_SOURCE, read(status)};
  }

  std::string wait() override {
    MPI_Status status;
    MPI_Probe(0, 0, MPI_COMM_WORLD, &status);
    return read(status);
  }

 private:
  static std::string read(const MPI_Status& status) {
    int size = 0;
    MPI_Get_count(&status, MPI_CHAR, &size);
    std::string text(static_cast<std::size_t>(size), '\0');
    MPI_Recv(text.data(), size, MPI_CHAR, status.MPI_SOURCE, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return text;
  }

  int rank_ = 0, size_ = 1;
};

}  // namespace
}  // namespace rederive::numerics::commands

extern "C" rederive::numerics::commands::Ranks* rederive_join_ranks() {
  return new rederive::numerics::commands::MpiRanks;
}
