// Files, as somebody sees them who breaks or attacks them: nothing is half-written, no planted link is
// followed, an error is never taken for the end of a file.
#include <sys/stat.h>

#include <tests/derivations/program/faults.hpp>

TEST_CASE("a file keeps its mode when it is written again, and a new one has the user's") {
  each_writer({"fast", "other"}, [](const TemporaryFolder& folder, const Text& writer) {
    CHECK(run(folder, "umask 027 && " + writer).exit_code <= 1);
    CHECK(mode_of(folder.path / "file") == (contains(writer, "--progress") ? 0600 : 0640));
    for (const unsigned mode : {0600U, 0666U}) {
      fs::permissions(folder.path / "file", fs::perms{mode});
      CHECK(run(folder, "umask 077 && " + writer).exit_code <= 1);
      CHECK(mode_of(folder.path / "file") == mode);
    }
  });
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
  each_writer({"fast", "other"}, [](const TemporaryFolder& folder, const Text& writer) {
    REQUIRE(run(folder, writer).exit_code <= 1);
    const Text before = read_file(folder.path / "file");
    const auto names = files_in(folder.path);
    for (const Text failing : {"fsync:error=ENOSPC", "rename:error=EACCES", "fchmod:error=EPERM"}) {
      const Result r = run(
          folder, "strace -f -o /dev/null -e trace=fsync,rename,fchmod -e inject=" + failing + " " + writer);
      INFO(failing << ": " << r.err);
      CHECK(r.exit_code == (contains(writer, "check momentum") ? 1 : 2));  // the verdict is told all the same
      CHECK(contains(r.err, "cannot write 'file': "));
      CHECK(contains(r.err, "No space left on device") == contains(failing, "ENOSPC"));
      CHECK(read_file(folder.path / "file") == before);
      auto there = files_in(folder.path);
      there.erase("file.part");  // the columns that are done
      CHECK(there == names);
    }
  });
}

TEST_CASE("an error of the system in any call that writes or closes is told, or does no harm") {
  if (!has_strace()) return;
  const TemporaryFolder folder;
  const Text whole = run(folder, "emit --target c --function restitution").out;
  std::vector<Text> faults{"write:error=ENOSPC:when=1", "write:error=EIO:when=1"};
  for (int k = 1; k <= 25; ++k) faults.push_back("close:error=EIO:when=" + std::to_string(k));
  int told = 0;
  for (const Text& fault : faults) {
    write_file(folder.path / "file", "old");
    const Result r =
        run(folder, "strace -o /dev/null -e trace=write,close -e inject=" + fault + " " + emit + "file");
    INFO(fault << ": " << r.err);
    const bool is_told = r.exit_code == 2 && contains(r.err, "cannot write 'file': ");
    CHECK((is_told || fault.starts_with("close")));  // some of the files closed are not ours
    CHECK((is_told || r.exit_code == 127 || r.exit_code == 0));
    CHECK(read_file(folder.path / "file") == (r.exit_code == 0 ? whole : "old"));
    CHECK(files_in(folder.path) == std::set<Text>{"file"});
    told += is_told ? 1 : 0;
  }
  CHECK(told == 3);
}

TEST_CASE("a signal that comes as a file is written waits until it is whole") {
  if (!has_strace()) return;
  each_writer({"fast", "other"}, [](const TemporaryFolder& folder, const Text& writer) {
    REQUIRE(run(folder, writer).exit_code <= 1);
    const Text whole = read_file(folder.path / "file");
    const auto names = files_in(folder.path);
    for (const Text signal : {"TERM", "ALRM"}) {
      fs::remove(folder.path / "file");
      const Result r = run(
          folder, "strace -f -o /dev/null -e trace=fsync -e inject=fsync:signal=" + signal + " " + writer);
      INFO(signal << ", exit code " << r.exit_code << ": " << r.err);
      CHECK(read_file(folder.path / "file") == whole);
      auto there = files_in(folder.path);
      there.erase("file.part");
      CHECK(there == names);
    }
  });
}

TEST_CASE(
    "a new file has a random name, made by nobody else, and its bytes are on the disk before it is renamed") {
  if (!has_strace()) return;
  const TemporaryFolder folder;
  std::set<Text> names;
  for (int k = 0; k < 3; ++k) {
    fs::remove(folder.path / "file");
    REQUIRE(run(folder, "strace -o trace -e trace=openat,fsync,rename " + emit + "file").exit_code == 0);
    const Text trace = read_file(folder.path / "trace");
    const std::size_t opened = trace.find("\".rederive-"), synced = trace.find("fsync("),
                      renamed = trace.find("rename(");
    REQUIRE(opened != std::string::npos);
    const std::size_t begin = trace.rfind('\n', opened) + 1;
    const Text call = trace.substr(begin, trace.find('\n', opened) - begin);
    for (const auto* flag : {"O_EXCL", "O_NOFOLLOW", "O_CLOEXEC", "0666"})
      CHECK_MESSAGE(contains(call, flag), call);
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
  each_writer({"fast", "other"}, [&](const TemporaryFolder&, const Text& writer) {
    make_class(folder);
    fs::permissions(folder.path / "class", fs::perms{0755});
    Text call = writer;
    call.replace(call.find(" file"), 5, " shared/file");
    run(folder, "rm -rf shared/* && " + other + "ln -s $PWD/victim/thesis.tex shared/file");
    const Result r = run(folder, victim + "bash -c " + quoted("PATH='" REDERIVE_PROGRAMS "':$PATH; " + call));
    INFO(r.err);
    const bool tells_its_verdict = contains(writer, "check momentum");
    CHECK((r.exit_code == 2 || tells_its_verdict));
    CHECK((contains(r.err, "'shared/file': it is a link of another user") || tells_its_verdict));
    CHECK(read_file(folder.path / "victim/thesis.tex") == "my thesis\n");
  });
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
  const auto as_victim = [&](const Text& call) {
    return run(folder, victim + "bash -c " + quoted("PATH='" REDERIVE_PROGRAMS "':$PATH; " + call));
  };
  CHECK(as_victim(emit + "shared/out").exit_code == 0);
  CHECK(fs::is_regular_file(folder.path / "shared/out"));
  CHECK(contains(as_victim("exercises --progress shared/progress check momentum 1").err, "is a link"));
  const Result map = as_victim("rocking map --omega 1:5:8 --amplitude 1:3:5 --hdf5 shared/map.h5");
  if (!contains(map.err, "without HDF5")) CHECK(contains(map.err, "'shared/map.h5.part' is a link"));
  CHECK(map.exit_code == 2);
  CHECK(read_file(folder.path / "victim/thesis.tex") == "my thesis\n");
  run(folder,
      other + "bash -c 'cd shared && mkfifo pipe && ln -s ../victim pages && ln -s ../victim proofs'");
  CHECK(contains(as_victim("timeout 100 " + emit + "shared/pipe").err, "it is a pipe of another user"));
  CHECK(contains(as_victim("ledger certify shared/proofs 17b").err, "it is a link of another user"));
  make_class(folder);
  CHECK(contains(as_victim("exercises grade class --feedback shared/pages").err,
                 "it is a link of another user"));
  CHECK(files_in(folder.path / "victim") == std::set<Text>{"thesis.tex"});
  // A file of another user is no map of ours to go on from.
  run(folder,
      "rm shared/map.h5.part && " + other + "touch shared/map.h5.part && chmod 666 shared/map.h5.part");
  CHECK(as_victim("rocking map --omega 1:5:8 --amplitude 1:3:5 --hdf5 shared/map.h5").exit_code == 2);
}

TEST_CASE("an error in reading is never taken for the end of a file, and nothing is saved over it") {
  if (!has_strace()) return;
  const TemporaryFolder folder;
  make_class(folder);
  REQUIRE(
      run(folder, "exercises --progress progress check height-of-centre 'R*(cos(alpha-theta)-cos(alpha))'")
          .exit_code == 0);
  fs::create_directories(folder.path / "records");
  each_case("files", [&](Text name, Text text) { write_file(folder.path / name, text); });
  for (const Text name : {"equations", "claims"})
    fs::copy(REDERIVE_SOURCE "/derivations/rocking_block/" + name + ".toml", folder.path / name);
  const Text progress = read_file(folder.path / "progress");
  REQUIRE(contains(progress, "solved"));
  each_case("readers", [&](Text file, Text call) {
    for (const Text fault : {"read:error=EIO:when=1+", "openat:error=EACCES", "openat:error=EMFILE"}) {
      const Result r =
          run(folder, "strace -f -o /dev/null -P " + file + " -e trace=" + fault.substr(0, fault.find(':')) +
                          " -e inject=" + fault + " " + call);
      INFO(fault << ": " << r.out << r.err);
      const bool is_told = contains(call, "check momentum 1");  // the verdict, and that it is not kept
      CHECK(r.exit_code == (is_told ? 1 : 2));
      CHECK(contains(r.err, "read '"));
      CHECK(read_file(folder.path / "progress") == progress);
      CHECK(!fs::exists(folder.path / "book"));
    }
  });
}

TEST_CASE("a folder in the place of a file is told, and no pipe is waited for where it could be anybody's") {
  const TemporaryFolder folder;
  make_class(folder);
  fs::create_directories(folder.path / "folder");
  REQUIRE(::mkfifo((folder.path / "pipe").c_str(), 0600) == 0);
  each_case("odd files", [&](Text call) {
    const Result r = run(folder, "timeout 100 " + call);
    INFO(r.err);
    CHECK(r.exit_code == 2);
    CHECK(!contains(r.err, "internal failure"));
  });
}

TEST_CASE("a name of 255 bytes is one like any other") {
  const TemporaryFolder folder;
  const Text name(255, 'n');
  CHECK(run(folder, emit + name).exit_code == 0);
  CHECK(files_in(folder.path) == std::set<Text>{name});
  CHECK(run(folder, emit + name + "n").exit_code == 2);
}

TEST_CASE("a full disk is told, and the old file stays") {
  if (::geteuid() != 0 || !has_tool("unshare")) return skip("only root can make a small disk");
  each_writer({"fast", "other"}, [](const TemporaryFolder& folder, const Text& writer) {
    if (writer.starts_with("emit") || contains(writer, "--certificate") || contains(writer, "progress"))
      return;  // small
    const Result r = run(
        folder,
        "mkdir disk && unshare -m bash -c " +
            quoted("mount -t tmpfs -o size=8k none disk && cp -r class disk && cd disk && echo old > file && "
                   "head -c 9000 /dev/zero 2>&1 > fill; " +
                   writer + "; code=$?; rm fill; ls -A; cat file; exit $code"));
    if (contains(r.err, "mount: ")) return skip("nothing can be mounted here");
    INFO(r.out << r.err);
    CHECK(r.exit_code == 2);
    CHECK(contains(r.err, "No space left on device"));
    CHECK(r.out.ends_with("class\nfile\nold\n"));
  });
}
