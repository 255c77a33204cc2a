// What is around a program: streams that are closed, names of others, settings of the user, terminals.
#include <tests/derivations/program/faults.hpp>
#include <tests/random.hpp>

TEST_CASE("/dev/stdout and other names of open descriptors take what is written, after what was there") {
  const TemporaryFolder folder;
  const Text function = run(folder, "emit --target c --function restitution").out;
  for (const Text name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    CHECK(run(folder, emit + name).out == function);
    CHECK(run(folder, emit + name + " | cat").out == function);
    CHECK(run(folder, "echo before > file && " + emit + name + " >> file && cat file").out ==
          "before\n" + function);
  }
  CHECK(run(folder, emit + "/dev/fd/7 7>file && cat file").out == function);
  CHECK(run(folder, emit + ">(cat > pipe) && while [ ! -s pipe ]; do sleep 0.01; done && cat pipe").out ==
        function);
  const Result both = run(folder, response + "--csv /dev/stdout");
  CHECK(both.out.starts_with("tau,theta_over_alpha"));
  CHECK(contains(both.out, "required friction"));
  CHECK(run(folder, emit + "/dev/stdin <file").exit_code == 2);  // it is open to be read
  CHECK(run(folder, emit + "/dev/fd/77").exit_code == 2);
  CHECK(run(folder, emit + "/dev/full").exit_code == 2);
  for (const Text& call : std::vector<Text>{
           "rocking figure 8 --out /dev/stdout --data file2", response + "--csv file2 --plot /dev/fd/1",
           "rocking map --omega 1:5:8 --amplitude 1:3:5 --csv file2 --hdf5 /dev/stdout"}) {
    const Result r = run(folder, call);
    INFO(call);
    CHECK(r.exit_code == 2);
    CHECK(r.out == "");
    CHECK(!fs::exists(folder.path / "file2"));
  }
  const auto devices = files_in("/dev");
  CHECK(run(folder, "lesson-03-energy-and-the-barrier --format markdown --out /dev/stdout").out.size() >
        1000);
  CHECK(files_in("/dev") == devices);
}

TEST_CASE("standard streams that are closed are no place for our files") {
  each_writer({"fast", "other"}, [](const TemporaryFolder& folder, const Text& writer) {
    fs::remove(folder.path / "file");
    const bool is_silent =
        writer.starts_with("emit") || writer.starts_with("lesson") || contains(writer, "spectrum");
    REQUIRE(run(folder, writer).exit_code <= 1);
    const Text whole = read_file(folder.path / "file");
    fs::remove(folder.path / "file");
    const Result r = run(folder, writer + " <&- >&- 2>&-");
    CHECK(r.exit_code == (is_silent ? 0 : 2));
    CHECK(read_file(folder.path / "file") == whole);
  });
}

TEST_CASE("what others wrote into a name reaches no terminal") {
  const TemporaryFolder folder;
  make_class(folder);
  const Text name =
                 "x\033]0;title\007\n\x9b"
                 "31m\xc2\x9b\xe2\x80\xae.txt",
             word = quoted(name);
  write_file(folder.path / name, "R\n");
  fs::copy(folder.path / name, folder.path / "class/ann" / name);
  fs::create_directories(folder.path / "class" / (name + "dir"));
  write_file(folder.path / "class" / (name + "dir") / "momentum.txt", "1\n");
  each_case("names", [&](Text call) {
    call = rederive::test::filled(call, {{"NAME", word}, {"PROGRAMS", REDERIVE_PROGRAMS}});
    const Result r = run(folder, call);
    INFO(r.out << r.err);
    CHECK(r.exit_code <= 3);
    CHECK(!contains(r.err, "internal failure"));
    const Text said = r.out + r.err;
    for (const auto* bad : {"\033", "\007", "\x9b", "\xe2\x80\xae"}) CHECK(!contains(said, bad));
    const bool has_lines =
        contains(call, " prove ") || contains(call, "grade class");  // a quoted text, a cell of CSV
    if (!has_lines) CHECK((!contains(said, "title?\n") && !contains(said, "title\n")));
  });
}

TEST_CASE("gnuplot draws the same whatever the user has set for it") {
  if (!has_tool("gnuplot")) return;
  const TemporaryFolder folder;
  write_file(folder.path / ".gnuplot", "set logscale y\nset decimalsign ','\nset grid lw 9\n");
  for (const Text kind : {"svg", "png", "pdf"}) {
    REQUIRE(run(folder, "HOME=/nonexistent rocking figure 8 --out usual." + kind).exit_code == 0);
    REQUIRE(
        run(folder,
            "HOME=$PWD XDG_CONFIG_HOME=$PWD GNUTERM=dumb GNUPLOT_LIB=$PWD GNUPLOT_FONTPATH=$PWD "
            "GDFONTPATH=$PWD "
            "FIT_LOG=x LC_ALL=de_DE.UTF-8 LANGUAGE=de TZ=Asia/Tokyo PAGER=false rocking figure 8 --out odd." +
                kind)
            .exit_code == 0);
    CHECK(read_file(folder.path / ("usual." + kind)) == read_file(folder.path / ("odd." + kind)));
  }
}

TEST_CASE("a terminal is plain where it is dumb or NO_COLOR is not empty") {
  if (!has_tool("script")) return;
  const TemporaryFolder folder;
  const auto is_coloured = [&](const Text& environment) {
    return contains(run(folder, "script -qec 'env " + environment + " ledger show 17b' /dev/null").out,
                    "\033[");
  };
  CHECK(is_coloured("-u NO_COLOR TERM=xterm"));
  CHECK(is_coloured("NO_COLOR= TERM=xterm"));
  CHECK(!is_coloured("NO_COLOR=1 TERM=xterm"));
  CHECK(!is_coloured("-u NO_COLOR TERM=dumb"));
}
