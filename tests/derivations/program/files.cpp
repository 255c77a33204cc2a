// Files, as somebody sees them who breaks or attacks them: nothing is half-written, no planted link is
// followed, an error is never taken for the end of a file.
#include <sys/stat.h>

#include <tests/derivations/program/faults.hpp>

TEST_CASE("a file keeps its mode when it is written again, and a new one has the user's") {
  for (const std::string& writer : writers) {
    const TemporaryFolder folder;
    make_class(folder);
    INFO(writer);
    CHECK(run(folder, "umask 027 && " + writer).exit_code <= 1);
    CHECK(mode_of(folder.path / "file") == (has(writer, "--progress") ? 0600 : 0640));
    for (const unsigned mode : {0600U, 0644U, 0666U}) {
      fs::permissions(folder.path / "file", fs::perms{mode});
      CHECK(run(folder, "umask 077 && " + writer).exit_code <= 1);
      CHECK(mode_of(folder.path / "file") == mode);
    }
  }
}

TEST_CASE("what a program keeps of a user is for that user alone") {
  const TemporaryFolder folder;
  REQUIRE(
      run(folder, "umask 022 && export XDG_STATE_HOME=$PWD/state && exercises check momentum 1").exit_code ==
      1);
  CHECK(mode_of(folder.path / "state/rederive") == 0700);
  CHECK(mode_of(folder.path / "state/rederive/exercises.txt") == 0600);
  REQUIRE(run(folder,
              "umask 000 && export XDG_STATE_HOME=$PWD/state && lesson-03-energy-and-the-barrier --step 2")
              .exit_code == 0);
  if (fs::exists(folder.path / "state/rederive/figures"))  // where there is gnuplot
    CHECK(mode_of(folder.path / "state/rederive/figures") == 0700);
}

TEST_CASE("whatever system call fails as a file is written, the old file stays and nothing else is there") {
  if (!has_strace()) return;
  for (const std::string& writer : writers) {
    const TemporaryFolder folder;
    make_class(folder);
    REQUIRE(run(folder, writer).exit_code <= 1);
    const std::string before = read_file(folder.path / "file");
    const auto names = files_in(folder.path);
    for (const auto* failing :
         {"fsync:error=EIO", "fsync:error=ENOSPC", "rename:error=EACCES", "fchmod:error=EPERM"}) {
      const Result r =
          run(folder, std::string("strace -f -o /dev/null -e trace=fsync,rename,fchmod -e inject=") +
                          failing + " " + writer);
      INFO(failing << " " << writer << ": " << r.err);
      CHECK(r.exit_code == (has(writer, "check momentum") ? 1 : 2));  // the verdict is told all the same
      CHECK(has(r.err, "cannot write 'file': "));
      CHECK(has(r.err, "No space left on device") == has(failing, "ENOSPC"));
      CHECK(read_file(folder.path / "file") == before);
      auto there = files_in(folder.path);
      there.erase("file.part");  // the columns that are done
      CHECK(there == names);
    }
  }
  const TemporaryFolder folder;
  int told = 0;
  const std::string whole = run(folder, "emit --target c --function restitution").out;
  for (const std::string failing :
       {"write:error=ENOSPC:when=1", "write:error=EIO:when=1", "close:error=EIO:when="})
    for (int k = 1; k <= (failing.ends_with("=") ? 25 : 1); ++k) {  // some of the files closed are not ours
      write(folder.path / "file", "old");
      const std::string fault = failing + (failing.ends_with("=") ? std::to_string(k) : "");
      const Result r =
          run(folder, "strace -o /dev/null -e trace=write,close -e inject=" + fault + " " + emit + "file");
      INFO(fault << ": " << r.err);
      const bool is_told = r.exit_code == 2 && has(r.err, "cannot write 'file': ");
      CHECK((is_told || failing.ends_with("=")));
      CHECK((is_told || r.exit_code == 127 || r.exit_code == 0));
      CHECK(read_file(folder.path / "file") == (r.exit_code == 0 ? whole : "old"));
      CHECK(files_in(folder.path) == std::set<std::string>{"file"});
      told += is_told ? 1 : 0;
    }
  CHECK(told == 3);
}

TEST_CASE("a signal that comes as a file is written waits until it is whole") {
  if (!has_strace()) return;
  for (const std::string& writer : writers) {
    const TemporaryFolder folder;
    make_class(folder);
    REQUIRE(run(folder, writer).exit_code <= 1);
    const std::string whole = read_file(folder.path / "file");
    const auto names = files_in(folder.path);
    for (const auto* signal : {"HUP", "INT", "TERM", "QUIT", "USR1", "ALRM"}) {
      fs::remove(folder.path / "file");
      const Result r =
          run(folder, std::string("strace -f -o /dev/null -e trace=fsync -e inject=fsync:signal=") + signal +
                          " " + writer);
      INFO(signal << " " << writer << ", exit code " << r.exit_code << ": " << r.err);
      CHECK(read_file(folder.path / "file") == whole);
      auto there = files_in(folder.path);
      there.erase("file.part");
      CHECK(there == names);
    }
  }
}

TEST_CASE(
    "a new file has a random name, made by nobody else, and its bytes are on the disk before it is renamed") {
  if (!has_strace()) return;
  const TemporaryFolder folder;
  std::set<std::string> names;
  for (int k = 0; k < 3; ++k) {
    fs::remove(folder.path / "file");
    REQUIRE(run(folder, "strace -o trace -e trace=openat,fsync,rename " + emit + "file").exit_code == 0);
    const std::string trace = read_file(folder.path / "trace");
    const std::size_t opened = trace.find("\".rederive-"), synced = trace.find("fsync("),
                      renamed = trace.find("rename(");
    REQUIRE(opened != std::string::npos);
    const std::size_t begin = trace.rfind('\n', opened) + 1;
    const std::string call = trace.substr(begin, trace.find('\n', opened) - begin);
    for (const auto* flag : {"O_EXCL", "O_NOFOLLOW", "O_CLOEXEC", "0666"})
      CHECK_MESSAGE(has(call, flag), call);
    names.insert(call.substr(call.find('"'), call.find(',', call.find('"'))));
    CHECK(opened < synced);
    CHECK(synced < renamed);
    CHECK(renamed != std::string::npos);
  }
  CHECK(names.size() == 3);
}

TEST_CASE("a link of another user is refused, one's own is followed, and stays") {
  if (!has_users()) return;
  const TemporaryFolder folder;
  make_users(folder);
  for (const std::string& writer : writers) {
    make_class(folder);
    fs::permissions(folder.path / "class", fs::perms{0755});
    std::string call = writer;
    call.replace(call.find(" file"), 5, " shared/file");
    run(folder, "rm -rf shared/* && " + other + "ln -s $PWD/victim/thesis.tex shared/file");
    const Result r = run(folder, victim + "bash -c " + quoted("PATH='" REDERIVE_PROGRAMS "':$PATH; " + call));
    INFO(writer << ": " << r.err);
    CHECK((r.exit_code == 2 || has(writer, "check momentum")));
    if (!has(writer, "check momentum")) CHECK(has(r.err, "'shared/file': it is a link of another user"));
    CHECK(read_file(folder.path / "victim/thesis.tex") == "my thesis\n");
  }
  REQUIRE(run(folder, "rm -rf shared/* && touch file && ln -s ../file shared/file && " + emit + "shared/file")
              .exit_code == 0);
  CHECK(fs::is_symlink(folder.path / "shared/file"));
  CHECK(!read_file(folder.path / "file").empty());
}

TEST_CASE("another user's links at names that can be guessed lead nowhere") {
  if (!has_users()) return;
  const TemporaryFolder folder;
  make_users(folder);
  run(folder, other +
                  "bash -c 'cd shared && for k in $(seq $$ $(($$ + 300))); do "
                  "ln -s ../victim/thesis.tex out.part$k; ln -s ../victim/thesis.tex out$k; done; "
                  "ln -s ../victim/thesis.tex progress.lock; ln -s ../victim/thesis.tex map.h5.part'");
  const auto as_victim = [&](const std::string& call) {
    return run(folder, victim + "bash -c " + quoted("PATH='" REDERIVE_PROGRAMS "':$PATH; " + call));
  };
  CHECK(as_victim(emit + "shared/out").exit_code == 0);
  CHECK(fs::is_regular_file(folder.path / "shared/out"));
  CHECK(has(as_victim("exercises --progress shared/progress check momentum 1").err, "is a link"));
  const Result map = as_victim("rocking map --omega 1:5:8 --amplitude 1:3:5 --hdf5 shared/map.h5");
  if (!has(map.err, "without HDF5")) CHECK(has(map.err, "'shared/map.h5.part' is a link"));
  CHECK(map.exit_code == 2);
  CHECK(read_file(folder.path / "victim/thesis.tex") == "my thesis\n");
  run(folder,
      other + "bash -c 'cd shared && mkfifo pipe && ln -s ../victim pages && ln -s ../victim proofs'");
  CHECK(has(as_victim("timeout 100 " + emit + "shared/pipe").err, "it is a pipe of another user"));
  CHECK(has(as_victim("ledger certify shared/proofs 17b").err, "it is a link of another user"));
  make_class(folder);
  CHECK(has(as_victim("exercises grade class --feedback shared/pages").err, "it is a link of another user"));
  CHECK(files_in(folder.path / "victim") == std::set<std::string>{"thesis.tex"});
  // A file of another user is no map of ours to go on from.
  run(folder,
      "rm shared/map.h5.part && " + other + "touch shared/map.h5.part && chmod 666 shared/map.h5.part");
  CHECK(as_victim("rocking map --omega 1:5:8 --amplitude 1:3:5 --hdf5 shared/map.h5").exit_code == 2);
}

TEST_CASE("an error in reading is never taken for the end of a file, and nothing is saved over it") {
  if (!has_strace()) return;
  const TemporaryFolder folder;
  make_class(folder);
  REQUIRE(run(folder, check).exit_code == 0);
  write(folder.path / "record", "0 0\n0.1 0.1\n0.2 0\n");
  write(folder.path / "blocks", "[[block]]\nname = \"a\"\nalpha = 0.2\nfrequency_parameter = 2\n");
  write(folder.path / "weights", "exercise,weight\nmomentum,2\n");
  fs::create_directories(folder.path / "records");
  fs::copy(folder.path / "record", folder.path / "records/one");
  fs::copy(REDERIVE_SOURCE "/derivations/rocking_block/equations.toml", folder.path / "equations");
  fs::copy(REDERIVE_SOURCE "/derivations/rocking_block/claims.toml", folder.path / "claims");
  const std::string progress = read_file(folder.path / "progress");
  REQUIRE(has(progress, "solved"));
  struct Reader {
    std::string file, call;
  };
  for (const Reader& reader :
       {Reader{"progress", "exercises --progress progress list"},
        {"progress", "exercises --progress progress check momentum 1"},
        {"progress", "exercises --progress progress reset height-of-centre"},
        {"progress", "exercises --progress progress solution momentum --give-up"},
        {"progress", "exercises --progress progress hint momentum"},
        {"record", "rocking response --record record"},
        {"records/one", "rocking fragility --records records --amplitudes 0.1:1:3"},
        {"blocks", "rocking fragility --records records --amplitudes 0.1:1:3 --blocks blocks"},
        {"weights", "exercises grade class --weights weights --gradebook book"},
        {"weights", "exercises grade class --deadline weights --gradebook book"},
        {"equations", "ledger --equations equations show 17b"},
        {"claims", "ledger claims c01 --claims claims"},
        {"class/ann/height-of-centre.txt", "exercises check momentum --file class/ann/height-of-centre.txt"}})
    for (const auto* fault : {"read:error=EIO:when=1+", "openat:error=EACCES", "openat:error=EMFILE"}) {
      const std::string trace = std::string(fault).substr(0, std::string(fault).find(':'));
      const Result r = run(folder, "strace -f -o /dev/null -P " + reader.file + " -e trace=" + trace +
                                       " -e inject=" + fault + " " + reader.call);
      INFO(fault << " " << reader.call << ": " << r.out << r.err);
      const bool is_told = has(reader.call, "check momentum 1");  // the verdict, and that it is not kept
      CHECK(r.exit_code == (is_told ? 1 : 2));
      CHECK(has(r.err, "read '"));
      CHECK(read_file(folder.path / "progress") == progress);
      CHECK(!fs::exists(folder.path / "book"));
    }
}

TEST_CASE("a folder in the place of a file is told, and no pipe is waited for where it could be anybody's") {
  const TemporaryFolder folder;
  make_class(folder);
  fs::create_directories(folder.path / "folder");
  REQUIRE(::mkfifo((folder.path / "pipe").c_str(), 0600) == 0);
  for (const std::string call : {"exercises --progress folder list", "exercises --progress pipe list",
                                 "rocking response --record folder", "ledger --equations folder",
                                 "exercises grade class --weights folder --gradebook book",
                                 "rocking fragility --records class/ann --amplitudes 1:2:2 --blocks folder",
                                 "exercises --progress p check momentum --file pipe"}) {
    const Result r = run(folder, "timeout 100 " + call);
    INFO(call << ": " << r.err);
    CHECK(r.exit_code == 2);
    CHECK(!has(r.err, "internal failure"));
  }
}

TEST_CASE("a name of 255 bytes is one like any other") {
  const TemporaryFolder folder;
  const std::string name(255, 'n');
  CHECK(run(folder, emit + name).exit_code == 0);
  CHECK(files_in(folder.path) == std::set<std::string>{name});
  CHECK(run(folder, emit + name + "n").exit_code == 2);
}

TEST_CASE("a full disk is told, and the old file stays") {
  if (::geteuid() != 0 || !has_tool("unshare")) return skip("only root can make a small disk");
  for (const std::string& writer : writers) {
    if (writer.starts_with("emit") || has(writer, "--certificate") || has(writer, "progress"))
      continue;  // small
    const TemporaryFolder folder;
    make_class(folder);
    const Result r = run(
        folder,
        "mkdir disk && unshare -m bash -c " +
            quoted("mount -t tmpfs -o size=8k none disk && cp -r class disk && cd disk && echo old > file && "
                   "head -c 9000 /dev/zero 2>&1 > fill; " +
                   writer + "; code=$?; rm fill; ls -A; cat file; exit $code"));
    if (has(r.err, "mount: ")) return skip("nothing can be mounted here");
    INFO(writer << ": " << r.out << r.err);
    CHECK(r.exit_code == 2);
    CHECK(has(r.err, "No space left on device"));
    CHECK(r.out.ends_with("class\nfile\nold\n"));
  }
}
