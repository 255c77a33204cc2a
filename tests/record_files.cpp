#include <doctest/doctest.h>

#include <fstream>
#include <numerics/ground_motion.hpp>
#include <stdexcept>

#include "run_program.hpp"

using namespace rederive;

namespace {

std::string written(const TemporaryFolder& folder, const std::string& text) {
  const auto path = folder.path / "record.txt";
  std::ofstream(path) << text;
  return path;
}

}  // namespace

TEST_CASE("a PEER file whose numbers run together is read by its columns") {
  const TemporaryFolder folder;
  const std::string head = "PEER NGA STRONG MOTION DATABASE RECORD\nMade up, 1/1/2001, Hill Station, 90\n";
  const std::string values =
      "  4.8744285E-04 -2.4599667E-04  1.0000000E-03 -2.0000000E-03  3.0000000E-03\n"
      "-0.12345678E-020.223456789E-02-0.32345678E-02\r\n";
  const auto peer = [&](const std::string& unit, const std::string& count) {
    return read_record(written(folder, head + "ACCELERATION TIME SERIES IN UNITS OF " + unit +
                                           "\nNPTS=   " + count + ", DT=   .0050 SEC,\n" + values),
                       RecordUnit::g);
  };
  CHECK(peer("G", "8").acceleration == std::vector<double>{4.8744285e-04, -2.4599667e-04, 1e-3, -2e-3, 3e-3,
                                                           -0.12345678e-2, 0.223456789e-2, -0.32345678e-2});
  CHECK(peer("G", "8").time[7] == doctest::Approx(0.035));
  for (const char* unit : {"CM/S**2", "CM/SEC/SEC", "GAL", "cm/s^2"})
    CHECK(peer(unit, "8").acceleration[2] == doctest::Approx(1e-5 / 9.81));
  CHECK(peer("M/S**2", "8").acceleration[2] == doctest::Approx(1e-3 / 9.81));
  for (const char* unit : {"CM/S", "M", "CM", "FURLONGS", "M/S"})
    CHECK_THROWS_WITH_AS(peer(unit, "8"), doctest::Contains("record.txt:3: the unit"), std::invalid_argument);
  for (const char* unit : {"G * 0.001", "G X 10**-3", "G (0.001)", "G SCALE FACTOR 0.001"})
    CHECK_THROWS_WITH_AS(peer(unit, "8"), doctest::Contains("record.txt:3: behind the unit stands"),
                         std::invalid_argument);
  CHECK(peer("G. FILTER POINTS: HP=0.1 Hz", "8").acceleration[2] == 1e-3);
  for (const char* count : {"7", "9", "4000"}) {
    CHECK_THROWS_WITH_AS(peer("G", count), doctest::Contains("holds 8 values, but NPTS is"),
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS(peer("G", count), doctest::Contains(count), std::invalid_argument);
  }
  for (const char* count : {"0", "-8", "8.5", "nan", "x", "", "8,000"})
    CHECK_THROWS_WITH_AS(peer("G", count), doctest::Contains("record.txt:4"), std::invalid_argument);
}

TEST_CASE("the step of a PEER file is in seconds, and a file that is cut off is refused") {
  const TemporaryFolder folder;
  const std::string value = "  1.0000000E-03", two = value + value + "\n";
  const auto peer = [&](const std::string& step, const std::string& values) {
    return read_record(
        written(folder, "PEER\nSomewhere\nIN UNITS OF G\nNPTS=  4, DT= " + step + "\n" + values),
        RecordUnit::g);
  };
  for (const char* step : {".0100 SEC,", "0.01", "0.01 s", ".0100SEC", "1e-2 sec"})
    CHECK(peer(step, two + two).time[1] == 0.01);
  for (const char* step : {"10 MSEC", "10 ms", "100 HZ"})
    CHECK_THROWS_WITH_AS(peer(step, two + two), doctest::Contains("record.txt:4: DT in '"),
                         std::invalid_argument);
  CHECK_THROWS_WITH_AS(peer("0.01", two + value + value.substr(0, 9)),
                       doctest::Contains("record.txt:6: the line ends inside a column"),
                       std::invalid_argument);
  // six columns of 10 are as long as four of 15, and no file is cut off that has two of them in its last
  // line
  const std::string ten = "  0.001000", six = ten + ten + ten + ten + ten + ten + "\n";
  const std::string head = "PEER\nSomewhere\nIN UNITS OF G\nNPTS= 14, DT= 0.01\n";
  CHECK(read_record(written(folder, head + six + six + ten + ten + "\n"), RecordUnit::g).time.size() == 14);
}

TEST_CASE("a byte order mark, very small numbers and characters that end a text are no obstacle") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& text) {
    return read_record(written(folder, text), RecordUnit::g);
  };
  CHECK(read("\uFEFF0 0.5\n1 1e-310\n2 1e-400\n").acceleration == std::vector<double>{0.5, 1e-310, 0});
  using namespace std::string_literals;
  CHECK_THROWS_WITH_AS(read("0 0\n1 0\0x\n"s), doctest::Contains("record.txt:2: '0?x' is not a number"),
                       std::invalid_argument);
  CHECK_THROWS_AS(read("0 0\n1 0x1p-3\n"), std::invalid_argument);
}

TEST_CASE("a PEER file of the old header may run together anywhere before a sign") {
  const TemporaryFolder folder;
  const std::string head = "PEER\nSomewhere\nACCELERATION TIME HISTORY IN UNITS OF G\n 5  0.0100  NPTS, DT\n";
  const Record record = read_record(
      written(folder, head + "  4.8744285E-04-2.45996670E-04-1.00000000E-03 -2.0000000E-03-3.00000000E-03\n"),
      RecordUnit::g);
  CHECK(record.acceleration == std::vector<double>{4.8744285e-04, -2.4599667e-04, -1e-3, -2e-3, -3e-3});
  const Record unaligned = read_record(
      written(folder, head + "4.8744285E-04-2.4599667E-04-1.E-03\n -.2E-02-.3E-02\n"), RecordUnit::g);
  CHECK(unaligned.acceleration == std::vector<double>{4.8744285e-04, -2.4599667e-04, -1e-3, -2e-3, -3e-3});
  CHECK_THROWS_WITH_AS(read_record(written(folder, head + "4.8744285E-04*2.4599667E-04\n"), RecordUnit::g),
                       doctest::Contains("record.txt:5"), std::invalid_argument);
}

TEST_CASE("a K-NET file is read in gal about its mean") {
  const TemporaryFolder folder;
  const std::string text =
      "Origin Time       2001/01/01 12:00:00\nLat.              35.000\nLong.             135.000\n"
      "Depth. (km)       10\nMag.              5.5\nStation Code      TST001\nStation Lat.      35.1000\n"
      "Station Long.     135.1000\nStation Height(m) 10\nRecord Time       2001/01/01 12:00:15\n"
      "Sampling Freq(Hz) 5Hz\nDuration Time(s)  2\nDir.              N-S\nScale Factor      "
      "3920(gal)/6182761\n"
      "Max. Acc. (gal)   1.0\nLast Correction   2001/01/01 12:00:00\nMemo.             \n";
  const std::string values =
      "    1000     3000     1000     3000     1000     3000     1000     3000\n     500     3500\n";
  const Record record = read_record(written(folder, text + values), RecordUnit::g);
  REQUIRE(record.acceleration.size() == 10);
  CHECK(record.time[9] == doctest::Approx(1.8));
  CHECK(record.acceleration[1] == doctest::Approx(1000 * 3920.0 / 6182761 / 981));
  CHECK(record.acceleration[8] == doctest::Approx(-1500 * 3920.0 / 6182761 / 981));
  CHECK_THROWS_WITH_AS(read_record(written(folder, text + values + "1\n"), RecordUnit::g),
                       doctest::Contains("holds 11 values, but Sampling Freq times Duration Time is 10"),
                       std::invalid_argument);
  for (const char* line :
       {"Sampling Freq(Hz) 5Hz", "Duration Time(s)  2", "Scale Factor      3920(gal)/6182761", "Memo.  "}) {
    CAPTURE(line);
    std::string other = text + values;
    other.replace(other.find(line), std::string(line).size(), "Scale Factor      3920(m)/0");
    CHECK_THROWS_WITH_AS(read_record(written(folder, other), RecordUnit::g), doctest::Contains("record.txt:"),
                         std::invalid_argument);
  }
}

TEST_CASE("an ESM file is read in the unit of its header") {
  const TemporaryFolder folder;
  std::string text =
      "EVENT_NAME: MADE UP\nEVENT_ID: XX-2001-0001\nEVENT_DATE_YYYYMMDD: 20010101\n"
      "STATION_CODE: HILL\nSAMPLING_INTERVAL_S: 0.005000\nNDATA: 4\nDURATION_S: 0.015\n"
      "STREAM: HNE\nUNITS: cm/s^2\nPGA_CM/S^2: 98.1\nTIME_PGA_S: 0.010000\nBASELINE_CORRECTION: \n"
      "DATA_TYPE: ACCELERATION\n";
  for (int line = 14; line <= 64; ++line) text += "USER" + std::to_string(line) + ":\n";
  const std::string values = "0.0\n-9.81\n 98.1\n1.962e1\n";
  const Record record = read_record(written(folder, text + values), RecordUnit::g);
  CHECK(record.acceleration[2] == doctest::Approx(0.1));
  CHECK(record.acceleration[3] == doctest::Approx(0.02));
  CHECK(record.time[3] == doctest::Approx(0.015));
  CHECK_THROWS_WITH_AS(read_record(written(folder, text + "1\n2\n"), RecordUnit::g),
                       doctest::Contains("holds 2 values, but NDATA is 4"), std::invalid_argument);
  CHECK_THROWS_WITH_AS(read_record(written(folder, text + values + "x\n"), RecordUnit::g),
                       doctest::Contains("record.txt:69: 'x' is not a number"), std::invalid_argument);
  text.replace(text.find("cm/s^2"), 6, "cm/s");
  CHECK_THROWS_WITH_AS(read_record(written(folder, text + values), RecordUnit::g),
                       doctest::Contains("record.txt:9: the unit 'cm/s'"), std::invalid_argument);
}
