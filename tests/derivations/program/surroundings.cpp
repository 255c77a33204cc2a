// What is around a program: streams that are closed, names of others, settings of the user, terminals.
#include <tests/derivations/program/faults.hpp>

TEST_CASE("/dev/stdout and other names of open descriptors take what is written, after what was there") {
  const TemporaryFolder folder;
  const std::string function = run(folder, "emit --target c --function restitution").out;
  for (const std::string name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
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
  CHECK(has(both.out, "required friction"));
  CHECK(run(folder, emit + "/dev/stdin <file").exit_code == 2);  // it is open to be read
  CHECK(run(folder, emit + "/dev/fd/77").exit_code == 2);
  CHECK(run(folder, emit + "/dev/full").exit_code == 2);
  for (const std::string& call : std::vector<std::string>{
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
  const TemporaryFolder folder;
  make_class(folder);
  for (const std::string& writer : writers) {
    INFO(writer);
    fs::remove(folder.path / "file");
    const bool is_silent = writer.starts_with("emit") || has(writer, "html") || has(writer, "spectrum");
    REQUIRE(run(folder, writer).exit_code <= 1);
    const std::string whole = read_file(folder.path / "file");
    fs::remove(folder.path / "file");
    const Result r = run(folder, writer + " <&- >&- 2>&-");
    CHECK(r.exit_code == (is_silent ? 0 : 2));
    CHECK(read_file(folder.path / "file") == whole);
  }
}

TEST_CASE("what others wrote into a name reaches no terminal") {
  const TemporaryFolder folder;
  make_class(folder);
  const std::string name =
                        "x\033]0;title\007\n\x9b"
                        "31m\xc2\x9b\xe2\x80\xae.txt",
                    word = quoted(name);
  write(folder.path / name, "R\n");
  fs::copy(folder.path / name, folder.path / "class/ann" / name);
  fs::create_directories(folder.path / "class" / (name + "dir"));
  write(folder.path / "class" / (name + "dir") / "momentum.txt", "1\n");
  const std::string bad_option = "--opt" + word;
  for (const std::string& call : std::vector<std::string>{
           "exercises --progress p grade class",
           "exercises --progress p grade class --json",
           "exercises --progress p grade class --json --csv " + word,
           "exercises --progress p grade " + word,
           "exercises --progress p grade class --csv " + word + "/x",
           "exercises --progress p grade class --gradebook " + word + "/x",
           "exercises --progress p grade class --gradebook g --weights " + word,
           "exercises --progress p grade class --deadline " + word,
           "exercises --progress " + word + " list",
           "exercises --progress " + word + "2 check momentum 1",
           "exercises --progress " + word + "2 reset momentum",
           "exercises --progress p watch --once class/ann",
           "exercises --progress p watch " + word + "3",
           "exercises --progress p check momentum --file " + word + "4",
           "exercises --progress p check " + word + " 1",
           "exercises --seed " + word + " show",
           "exercises " + word,
           "env REDERIVE_PROGRESS=" + word + " exercises list",
           "rocking response --record " + word,
           "rocking fragility --amplitudes 1:2:2 --records class/" + word + "dir",
           "rocking fragility --amplitudes 1:2:2 --records " + word,
           response + "--csv " + word + "/x",
           response + "--plot " + word,
           "rocking figure 8 --data " + word + "/x",
           response + bad_option,
           "rocking map --omega 1:5:8 --amplitude 1:3:5 --hdf5 " + word + "/x",
           "emit --target c --out " + word + "/x",
           "emit --target " + word,
           "emit --target c --function " + word,
           "ledger --equations " + word,
           "ledger show " + word,
           "ledger claims " + word,
           "ledger certify " + word + " 17b",
           "ledger certify " + word + "c 17b",
           "ledger certify " + word + "c 17b --json",
           "ledger prove --table " + word,
           "ledger prove " + word + " x",
           "ledger prove --json " + word + " x",
           "lesson-03-energy-and-the-barrier --out " + word + "/x",
           "lesson-03-energy-and-the-barrier --format " + word,
           "env HOME=/nowhere TMPDIR=$PWD/class/" + word + "dir lesson-03-energy-and-the-barrier --step 2",
           "exec -a " + word + " " REDERIVE_PROGRAMS "/emit --nonsense",
           "exec -a " + word + " " REDERIVE_PROGRAMS "/ledger --help"}) {
    const Result r = run(folder, call);
    INFO(call << "\n" << r.out << r.err);
    CHECK(r.exit_code <= 3);
    CHECK(!has(r.err, "internal failure"));
    const std::string said = r.out + r.err;
    for (const auto* bad : {"\033", "\007", "\x9b", "\xe2\x80\xae"}) CHECK(!has(said, bad));
    const bool has_lines = has(call, " prove ") || has(call, "grade class");  // a quoted text, a cell of CSV
    if (!has_lines) CHECK((!has(said, "title?\n") && !has(said, "title\n")));
  }
}

TEST_CASE("gnuplot draws the same whatever the user has set for it") {
  if (!has_tool("gnuplot")) return;
  const TemporaryFolder folder;
  write(folder.path / ".gnuplot", "set logscale y\nset decimalsign ','\nset grid lw 9\n");
  for (const std::string kind : {"svg", "png", "pdf"}) {
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
  const auto is_coloured = [&](const std::string& environment) {
    return has(run(folder, "script -qec 'env " + environment + " ledger show 17b' /dev/null").out, "\033[");
  };
  CHECK(is_coloured("-u NO_COLOR TERM=xterm"));
  CHECK(is_coloured("NO_COLOR= TERM=xterm"));
  CHECK(!is_coloured("NO_COLOR=1 TERM=xterm"));
  CHECK(!is_coloured("-u NO_COLOR TERM=dumb"));
}
