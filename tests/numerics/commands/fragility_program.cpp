// rocking fragility: table, CSV, JSON and plot, and what it refuses.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <tests/run_program.hpp>

namespace fs = std::filesystem;

namespace {

using Arguments = std::vector<std::string>;

/// Decaying oscillations, each of another period.
void write_records(const fs::path& folder, int count) {
  for (int k = 0; k < count; ++k) {
    std::ofstream file(folder / ("record-" + std::to_string(k) + ".txt"));
    for (int i = 0; i <= 300; ++i)
      file << i * 0.02 << ' ' << 0.3 * std::exp(-i * 0.01) * std::sin(i * 0.02 * (3 + 2.5 * k)) << '\n';
  }
}

struct Records : TemporaryFolder {
  explicit Records(int count = 6) {
    fs::create_directory(path / "records");
    write_records(path / "records", count);
  }
  Result fragility(const Arguments& more) const {
    Arguments all{"fragility", "--records", path / "records", "--amplitudes", "0.1:2:12"};
    all.insert(all.end(), more.begin(), more.end());
    return run_program("rocking", all);
  }
  /// Writes a file of blocks and gives its name.
  std::string blocks(const std::string& text) const {
    std::ofstream(path / "blocks.toml") << text;
    return path / "blocks.toml";
  }
};

void check_refused(const Result& result, const std::string& names) {
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK_MESSAGE(result.err.find(names) != std::string::npos, result.err);
}

const std::string two_blocks =
    "[[block]]\nname = \"stele, \\\"old\\\"\"\nhalf_width = 0.1\nhalf_height = 0.5\n"
    "[[block]]\nname = \"slab_1 `x`\"\nalpha = 0.6\nfrequency_parameter = 3\nrestitution = 0.8\n";

}  // namespace

TEST_CASE("a record counts at an amplitude if rocking response says that it overturns there") {
  const Records records;
  const Result result =
      records.fragility({"--json", "--half-width", "0.1", "--half-height", "0.5", "--model", "nonlinear"});
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  const auto document = nlohmann::json::parse(result.out);
  CHECK(document["unit"] == "g");
  CHECK(document["records"].size() == 6);
  int compared = 0;
  for (const std::size_t level : {0, 2, 4, 7, 11}) {
    const auto& at = document["blocks"][0]["levels"][level];
    int overturned = 0;
    for (const auto& file : fs::directory_iterator(records.path / "records")) {
      double peak = 0;
      std::ifstream text(file.path());
      for (double time = 0, value = 0; text >> time >> value;) peak = std::max(peak, std::abs(value));
      char scale[40];
      std::snprintf(scale, sizeof scale, "%.17g", at["amplitude"].get<double>() / peak);
      const Result response =
          run_program("rocking", {"response", "--record", file.path(), "--scale", scale, "--half-width",
                                  "0.1", "--half-height", "0.5", "--model", "nonlinear", "--json"});
      overturned += nlohmann::json::parse(response.out)["code"] != 0;
    }
    CHECK(at["overturned"] == overturned);
    CHECK(at["share"].get<double>() == doctest::Approx(overturned / 6.0));
    compared += overturned > 0 && overturned < 6;
  }
  CHECK(compared > 0);
}

TEST_CASE("blocks of a file come as table, CSV, JSON and plot, the same for any number of threads") {
  const Records records;
  const std::string blocks = records.blocks(two_blocks), csv = records.path / "f.csv";
  const Result one = records.fragility({"--blocks", blocks, "--threads", "1", "--csv", csv});
  const std::string table = read_file(csv);
  const Result three = records.fragility({"--blocks", blocks, "--threads", "3", "--csv", csv});
  REQUIRE_MESSAGE(one.exit_code == 0, one.err);
  CHECK(one.out == three.out);
  CHECK(table == read_file(csv));
  CHECK(
      table.starts_with("block,amplitude,records,overturned,share,fit,low,high\n\"stele, \"\"old\"\"\",0.1"));
  CHECK(std::count(table.begin(), table.end(), '\n') == 25);
  CHECK(one.out.find("6 records, linear model") != std::string::npos);
  CHECK(one.out.find("lognormal: median ") != std::string::npos);
  const auto document = nlohmann::json::parse(records.fragility({"--blocks", blocks, "--json"}).out);
  const auto& stele = document["blocks"][0];
  CHECK(stele["name"] == "stele, \"old\"");
  CHECK(stele["alpha"].get<double>() == doctest::Approx(std::atan(0.2)));
  CHECK(document["blocks"][1]["restitution"] == 0.8);
  CHECK(stele["median"]["low"] < stele["median"]["value"]);
  CHECK(stele["median"]["value"] < stele["median"]["high"]);
  CHECK(stele["why_no_fit"].is_null());
  const std::string plot = records.path / "f.svg";
  REQUIRE(records.fragility({"--blocks", blocks, "--plot", plot}).exit_code == 0);
  CHECK(read_file(plot).find("slab_1 'x'") != std::string::npos);
}

TEST_CASE("velocity is a peak, too, and a share without a curve says why") {
  const Records records;
  const auto velocity = nlohmann::json::parse(records.fragility({"--peak", "velocity", "--json"}).out);
  CHECK(velocity["unit"] == "m/s");
  CHECK(velocity["measure"] == "peak ground velocity");
  const Result safe =
      records.fragility({"--alpha", "0.7", "--restitution", "0.1", "--frequency-parameter", "0.01"});
  CHECK(safe.exit_code == 0);
  CHECK(safe.out.find("no lognormal curve: none overturns up to 2") != std::string::npos);
}

TEST_CASE("a folder with what is no record in it, or nothing, is refused by name") {
  const Records records;
  const fs::path folder = records.path / "records";
  fs::create_directory(folder / "more");
  std::ofstream(folder / ".hidden") << "x";
  CHECK(records.fragility({}).exit_code == 0);
  std::ofstream(folder / "note.md") << "see also";
  const std::string csv = records.path / "f.csv";
  check_refused(records.fragility({"--csv", csv}), "note.md:1");
  CHECK(!fs::exists(csv));
  std::ofstream(folder / "note.md") << "0 0\n1 0\n";
  check_refused(records.fragility({}), "note.md");
  fs::remove(folder / "note.md");
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);  // to be read it would wait for a writer
  check_refused(records.fragility({}), "pipe' is not an ordinary file");
  const Records none(0);
  check_refused(none.fragility({}), "contains no records");
  fs::remove(none.path / "records");
  check_refused(none.fragility({}), "cannot read the folder");
}

TEST_CASE("bad blocks are refused with file and line, bad options by name") {
  const Records records;
  const auto refused = [&](const std::string& text, const std::string& names) {
    CAPTURE(text);
    check_refused(records.fragility({"--blocks", records.blocks(text)}), names);
  };
  refused("", "no [[block]]");
  refused("[[block]]\n", "blocks.toml:1: 'name' is missing or empty");
  refused("[[block]]\nname = \"a\"\n", "blocks.toml:1: a block needs half_width");
  refused("[[block]]\nname = \"a\"\nhalf_width = 1\nalpha = 1\n", "blocks.toml:1: a block needs half_width");
  refused("[[block]]\nname = \"a\"\nhalf_width = \"1\"\nhalf_height = 1\n",
          "blocks.toml:3: 'half_width' must be a number");
  refused("[[block]]\nname = \"a\"\nhalf_width = nan\nhalf_height = 1\n",
          "blocks.toml:3: 'half_width' must be a finite number");
  refused("[[block]]\nname = \"a\"\nhalf_width = -1\nhalf_height = 1\n",
          "blocks.toml:1: half the width and half the height must be positive, but one is -1");
  refused("[[block]]\nname = \"a\"\ncolour = 1\n", "blocks.toml:3: there is no key 'colour' here");
  refused("[[blocks]]\nname = \"a\"\n",
          "blocks.toml:1: there is no key 'blocks' here: did you mean 'block'?");
  refused("[[block]]\nname = \"a\\n\"\nhalf_width = 1\nhalf_height = 4\n",
          "blocks.toml:2: 'name' must be one line");
  refused("\n[[block]\n", "blocks.toml:2");
  refused("block = 3\n", "blocks.toml:1");
  refused(two_blocks + two_blocks, "a second block has the name");
  check_refused(records.fragility({"--blocks", "/no/such/file"}), "/no/such/file");
  check_refused(records.fragility({"--blocks", "/"}), "'/'");
  check_refused(records.fragility({"--blocks", records.blocks(two_blocks), "--alpha", "0.2"}), "--alpha");
  check_refused(records.fragility({"--plot", records.path / "f.gif"}), "f.gif");
  check_refused(records.fragility({"--peak", "displacement"}), "displacement");
  for (const char* span : {"0:1:3", "-1:1:3", "2:1:3", "1:2:0", "1:1:3", "1:2", "1:inf:3"})
    check_refused(
        run_program("rocking", {"fragility", "--records", records.path / "records", "--amplitudes", span}),
        "--amplitudes");
  check_refused(run_program("rocking", {"fragility", "--amplitudes", "1:2:3"}), "--records");
}

TEST_CASE("the step and the unit of columns are refused where every record has a header") {
  const TemporaryFolder folder;
  const auto with_unit = [&] {
    return run_program("rocking",
                       {"fragility", "--records", folder.path, "--amplitudes", "1:2:2", "--unit", "g"});
  };
  std::ofstream(folder.path / "a.at2") << "PEER\nA station\nACCELERATION TIME HISTORY IN UNITS OF G\n"
                                          " 3  0.5  NPTS, DT\n0.0 0.6 -0.6\n";
  check_refused(with_unit(), "--unit must be left out: the headers of all records");
  std::ofstream(folder.path / "b.txt") << "0 0\n0.5 0.6\n1 0\n";
  CHECK(with_unit().exit_code == 0);
}
