#include <doctest/doctest.h>

#include <fstream>
#include <numerics/records/record.hpp>
#include <stdexcept>
#include <tests/run_program.hpp>

using namespace rederive::numerics;

namespace {

std::string written(const TemporaryFolder& folder, const std::string& text) {
  const auto path = folder.path / "record.txt";
  std::ofstream(path) << text;
  return path;
}

/// The text of a PEER file of four values.
const std::string peer_head = "PEER\nSomewhere\nACCELERATION TIME SERIES IN UNITS OF G\n";
const std::string peer_counts = "NPTS=      4, DT=  0.0200 SEC,\n";
const std::string peer_values = "  1.0000000E-03 -2.5000000E-02\n  3.1250000E-01  4.0000000E-03\n";
const std::vector<double> four{1e-3, -2.5e-2, 0.3125, 4e-3};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

std::string in_utf16(const std::string& text, bool little) {
  std::string bytes;
  for (const char c : text) bytes += little ? std::string{c, '\0'} : std::string{'\0', c};
  return bytes;
}

/// What is said of a file that is refused; "" if it is read.
std::string refusal_of(const std::string& text, const RecordOptions& options = {}) {
  const TemporaryFolder folder;
  try {
    (void)read_record(written(folder, text), options);
  } catch (const std::invalid_argument& error) {
    const std::string said = error.what();
    return said.substr(std::min(said.find("record.txt:"), said.size()));
  }
  return "";
}

Record record_in(const std::string& text, const RecordOptions& options = {}) {
  const TemporaryFolder folder;
  return read_record(written(folder, text), options);
}

/// Checks that a file is refused, with this in what is said.
void check_refused(const std::string& text, const std::string& said, const RecordOptions& options = {}) {
  const std::string refusal = refusal_of(text, options);
  CAPTURE(text.substr(0, 200));
  CHECK_MESSAGE(refusal.find(said) != std::string::npos, "'", refusal, "' does not say '", said, "'");
}

}  // namespace

TEST_CASE("a file is the same record in every encoding, with every line end and end mark") {
  const std::string plain = peer_head + peer_counts + peer_values, crlf = replaced(plain, "\n", "\r\n");
  using namespace std::string_literals;
  for (const std::string& text : std::vector<std::string>{
           plain, crlf, replaced(plain, "\n", "\r"), replaced(plain, "\n", "\r\r\n"), "\uFEFF" + plain,
           "\xFF\xFE" + in_utf16(plain, true), "\xFE\xFF" + in_utf16(crlf, false), in_utf16(plain, true),
           in_utf16(plain, false), crlf + "\x1A", crlf + "\x1A\x1A\0\0"s, plain + "\0\0\0"s,
           replaced(plain, "Somewhere",
                    "Orl\xE9"
                    "ans"),
           replaced(plain, "Somewhere", "Orléans"), replaced(plain, "-2.5", "\u22122.5"),
           replaced(plain, "  3.", " \u00A03."), plain.substr(0, plain.size() - 1)}) {
    const Record record = record_in(text);
    CHECK(record.acceleration == four);
    CHECK(record.time == std::vector<double>{0, 0.02, 0.04, 0.06});
  }
  check_refused(crlf + "\x1A\r\n1.0\r\n", "record.txt:7: the file continues after an end mark");
  for (const std::string& text : {"\x1F\x8B\b"s, "PK\x03\x04"s, "\xFF\xFE\0\0"s,
                                  "\xFF\xFE"
                                  "0"s})
    CHECK_THROWS_AS(record_in(text), std::invalid_argument);
}

TEST_CASE("count and step of a PEER file are found in every spelling, and refused in their line") {
  for (const std::string line :
       {"NPTS=  4, DT= .0200 SEC", "NPTS=4,DT=0.02", "   4    0.0200  NPTS, DT", "4 , 0.02 , NPTS , DT",
        "0.02 4 DT, NPTS", "NPT = 4, TSTEP = 0.02", "npts= 4, dt= 0.02 sec", "NPTS: 4 DT: 0.02",
        "DT= .02SEC, NPTS= 4", "NPTS 4 DT 0.02", "NPTS = 4 , DT = 2.0E-02 SECONDS",
        "NPTS= 4, DT= 2.0D-02 SEC", "NPTS= 4, DT= 0,02 SEC", "NUMBER OF POINTS= 4, TIME STEP= 0.02"}) {
    CAPTURE(line);
    const Record record = record_in(peer_head + line + "\n" + peer_values);
    CHECK(record.acceleration == four);
    CHECK(record.time[3] == doctest::Approx(0.06));
  }
  CHECK(record_in("PEER\n\n" + peer_head.substr(5) + peer_counts + peer_values).acceleration == four);
  for (const std::string line : {"NPTS= 4", "4 0.02", "NPTTS= 4, DTT= 0.02", "NPTS= four, DT= 0.02",
                                 "NPTS= 4, DT= 0", "NPTS= 4, DT= 20 MSEC", "NPTS= 4,000, DT= 0.02"})
    check_refused(peer_head + line + "\n" + peer_values, "record.txt:4: ");
  for (const std::string what :
       {"VELOCITY TIME SERIES IN UNITS OF CM/S", "DISPLACEMENT TIME SERIES IN UNITS OF CM",
        "VELOCITY TIME HISTORY IN UNITS OF G"}) {
    check_refused("PEER\nSomewhere\n" + what + "\n" + peer_counts + peer_values,
                  "record.txt:3: '" + what.substr(0, 8));
  }
}

TEST_CASE("numbers are read as programs write them") {
  for (const std::string& values : std::vector<std::string>{
           replaced(peer_values, "E-0", "D-0"), replaced(peer_values, "E-0", "d-0"),
           replaced(peer_values, "E-0", "-0"), replaced(peer_values, ".", ","), ".001,-.025,.3125,.004\n",
           "+1.0-3 -2.5-2 3.125-1 4.0-3", "1.0E-3-2.5E-2.3125 .004", "1.0-003-2.5-2\n3.125E-001+.4D-2",
           "1e-3;-25e-3;3125e-4;4e-3"}) {
    CAPTURE(values);
    if (values.find("2.3125") != std::string::npos)  // run together without a sign
      check_refused(peer_head + peer_counts + values, "record.txt:5: '1.0E-3-2.5E-2.3125' is not a number");
    else
      CHECK(record_in(peer_head + peer_counts + values).acceleration == four);
  }
  CHECK(record_in("0,00 0,1\n0,01 -0,2\n").acceleration == std::vector<double>{0.1, -0.2});
  CHECK(record_in("0,00;0,1\n0,01;-0,2\n").time[1] == 0.01);
  CHECK(record_in("0,0012\n-0,01\n", {.step = 0.1}).acceleration == std::vector<double>{0.0012, -0.01});
  check_refused("0,1\n1,2\n2,5\n", "record.txt:1: a comma here may be a decimal point");
  for (const std::string word :
       {"0.1x", "0x1", "1.2.3", "1e", "1e+", "e5", "1-2", "2001-01-01", "1.0-3.", "..1"})
    check_refused("0 0.1\n1 " + word + "\n", "record.txt:2: ", {.step = 0});
  check_refused("0 0\n1 2e9\n", "record.txt:2: '2e9' is out of range");
  CHECK(record_in(peer_head + peer_counts + peer_values + "# the end\n").acceleration == four);
  check_refused(peer_head + peer_counts + peer_values + "the end\n", "record.txt:7: 'the' is not a number");
}

TEST_CASE("a value that stands for none is refused with its line, or taken as one is told") {
  for (const std::string filling :
       {"-999", "999.99", "-999.9", "9999", "99999.0", "-9999.99", "-9.99E+02", "-12345", "99"}) {
    const std::string text = "0 0.1\n1 " + filling + "\n2 0.3\n";
    check_refused(text, "record.txt:2: ", {.unit = RecordUnit::g});
    check_refused(text, "--accept", {.unit = RecordUnit::g});
    const Record over = record_in(text, {.interpolate = true});
    CHECK(over.acceleration == std::vector<double>{0.1, 0.3});
    CHECK(over.time == std::vector<double>{0, 2});
    const double value = std::strtod(filling.c_str(), nullptr);
    CHECK(record_in(text, {.unit = RecordUnit::g, .accept = value}).acceleration[1] == value);
  }
  for (const std::string missing : {"NaN", "nan", "-nan", "NA", "***", "null", "--"}) {
    check_refused("0 0.1\n1 " + missing + "\n2 0.3\n",
                  "record.txt:2: '" + missing + "': a value is missing; --gaps interpolate");
    CHECK(record_in("0 0.1\n1 " + missing + "\n2 0.3\n", {.interpolate = true}).time.size() == 2);
  }
  check_refused("0.1,0.2,,0.3\n", "record.txt:1: nothing between two commas", {.step = 1});
  CHECK(record_in("0.1,0.2,,0.3,\n", {.step = 1, .interpolate = true}).time == std::vector<double>{0, 1, 3});
  check_refused("0 -999\n1 0.1\n2 0.3\n", "record.txt:1: the first or the last", {.interpolate = true});
  check_refused(peer_head + peer_counts + replaced(peer_values, "3.1250000E-01", "-9.990000E+02"),
                "record.txt:6: -999 is a value that programs write");
  CHECK(record_in("0 98\n1 -99.5\n2 99\n", {.unit = RecordUnit::gal}).time.size() == 3);
  CHECK(record_in("0 0.998\n1 -0.999\n2 9.99\n").time.size() == 3);
}

TEST_CASE("times between which samples are missing are refused, or drawn over as one is told") {
  const std::string gap = "0.00 0\n0.02 1\n0.04 2\n0.10 3\n0.12 4\n";
  check_refused(gap, "record.txt:4: the time goes from 0.04 to 0.1 s, but the usual step is 0.02 s");
  CHECK(record_in(gap, {.interpolate = true}).time[3] == 0.1);
  check_refused("0 0\n1 1\n2 2\n2.4 1\n3.4 0\n", "record.txt:4: the time goes");
  CHECK(record_in("0.0000 0\n0.0078 1\n0.0156 2\n0.0234 1\n0.0313 0\n").time.size() == 5);
  check_refused("0 0\n1 1\n1 2\n", "record.txt:3: time must increase");
}

TEST_CASE(
    "values alone are read with a step, several a line too, and columns of times are not taken for values") {
  const RecordOptions step{.step = 0.1};
  for (const std::string text : {"1\n2\n3\n4\n5\n", "# g\n1 2 3 4 5", "1 2 3\n\n4 5\n", "1;2;3\n4;5;\n"})
    CHECK(record_in(text, step).acceleration == std::vector<double>{1, 2, 3, 4, 5});
  CHECK(record_in("1 -2\n-3 4\n5\n", step).acceleration == std::vector<double>{1, -2, -3, 4, 5});
  check_refused("1.0 2 3\n4 5\n6 7 8\n", "record.txt:2: the line has 2 values, but the first one has 3",
                step);
  check_refused("1.0 2\n4 5 6\n", "record.txt:1: ", step);
  for (const std::string times :
       {"0 1\n0.1 2\n0.2 3\n", "0 1\n0.1 2\n0.5 3\n", "1 5 6 7\n2 5 6 8\n3 5 7 7\n", "0 1\n0.1 2\n"})
    check_refused(times, "record.txt:1: with a time step, columns of values alone", step);
  check_refused("0.1\n0.2\n", "record.txt:1: two columns are expected, time and acceleration");
  check_refused("0 1 2\n", "record.txt:1: two columns are expected");
  check_refused("Time (s), Acc (g)\n0, 0\n1, 1\n",
                "record.txt:1: 'Time (s), Acc (g)' is neither a line of numbers");
}

TEST_CASE("columns are in the unit that is said, and in g only as far as ground moves so") {
  const std::string text = "0 0\n1 98.1\n";
  CHECK(record_in(text, {.unit = RecordUnit::gal}).acceleration[1] == doctest::Approx(0.1));
  CHECK(record_in(text, {.unit = RecordUnit::metres_per_second_squared}).acceleration[1] ==
        doctest::Approx(10));
  CHECK(record_in(text, {.unit = RecordUnit::g}).acceleration[1] == 98.1);
  check_refused(text, "record.txt:2: 98.1 is more than 10 g: say the unit");
}

TEST_CASE("an SMC file is read by the places of its header") {
  std::string text = "2 CORRECTED ACCELEROGRAM\n";
  for (int line = 2; line <= 11; ++line) text += "*\n";
  for (int line = 0; line < 6; ++line)
    text += line == 1 ? "    -32768    -32768    -32768    -32768    -32768    -32768    -32768         1\n"
            : line == 2
                ? "        10    -32768    -32768    -32768    -32768    -32768    -32768    -32768\n"
                : "    -32768    -32768    -32768    -32768    -32768    -32768    -32768    -32768\n";
  for (int line = 0; line < 10; ++line)
    text += "  1.7000000E+38" + std::string(line == 0 ? "  2.0000000E+02" : "  1.7000000E+38") +
            "  0.0000000E+00\n";
  text += "| a comment\n";
  const std::string values =
      " 9.8100E+1-9.8100E+0 0.0000E+0 1.0000E+0 1.0000E+0 1.0000E+0 1.0000E+0 1.0000E+0\n"
      " 1.0000E+0-1.9620E+1\n";
  const Record record = record_in(text + values);
  REQUIRE(record.acceleration.size() == 10);
  CHECK(record.acceleration[0] == doctest::Approx(0.1));
  CHECK(record.acceleration[9] == doctest::Approx(-0.02));
  CHECK(record.time[9] == doctest::Approx(0.045));
  check_refused(replaced(text, "2 CORRECTED ACCELEROGRAM", "3 VELOCITY") + values,
                "record.txt:1: '3 VELOCITY'");
  check_refused(replaced(text, "        10", "        11") + values,
                "record.txt:30: the file holds 10 values");
  check_refused(replaced(text, "2.0000000E+02", "0.0000000E+00") + values,
                "record.txt:18: the sampling rate");
}

TEST_CASE("a COSMOS file is read by what announces its blocks") {
  std::string text = "Corrected acceleration   (Format v01.20 with 13 text lines)\n";
  for (int line = 2; line <= 13; ++line) text += "text\n";
  text += "   2 Integer-header values follow on   1 lines, Format= (10I8)\n       2    -999\n";
  text += " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n";
  for (int i = 1; i <= 100; ++i)
    text += (i == 62 ? "    10.000000" : "  -999.000000") + std::string(i % 6 == 0 || i == 100 ? "\n" : "");
  text += "   1 Comment line(s) follow, each starting with a \"|\":\n| made up\n";
  const std::string data = "      10 acceleration pts, approx   0 secs, units=cm/sec2(04),Format=(8F10.3)\n";
  const std::string values =
                        "    98.100    -9.810     0.000     1.000     1.000     1.000     1.000  -100.000\n"
                        "     1.000   -19.620\n",
                    end = "End-of-data for Chan 1 acceleration\n";
  const std::string line = replaced(data, "approx   0", "approx 0.1");
  const Record record = record_in(text + line + values + end);
  REQUIRE(record.acceleration.size() == 10);
  CHECK(record.acceleration[0] == doctest::Approx(0.1));
  CHECK(record.time[9] == doctest::Approx(0.09));
  check_refused(text + replaced(line, "acceleration", "velocity") + values + end, "record.txt:36: ");
  check_refused(text + replaced(line, "cm/sec2(04)", "cm/sec(05)") + values + end, "record.txt:36: the unit");
  check_refused(text + replaced(line, "0.1 secs", "80 secs") + values + end,
                "record.txt:36: 10 points at the step");
  check_refused(text + line + values + end + text, "record.txt:40: the file continues after its end mark");
}

TEST_CASE("a PEER file whose numbers run together is read by its columns") {
  const std::string head = "PEER NGA STRONG MOTION DATABASE RECORD\nMade up, 1/1/2001, Hill Station, 90\n";
  const std::string values =
      "  4.8744285E-04 -2.4599667E-04  1.0000000E-03 -2.0000000E-03  3.0000000E-03\n"
      "-0.12345678E-020.223456789E-02-0.32345678E-02\r\n";
  const auto peer = [&](const std::string& unit, const std::string& count) {
    return head + "ACCELERATION TIME SERIES IN UNITS OF " + unit + "\nNPTS=   " + count +
           ", DT=   .0050 SEC,\n" + values;
  };
  CHECK(record_in(peer("G", "8")).acceleration == std::vector<double>{4.8744285e-04, -2.4599667e-04, 1e-3,
                                                                      -2e-3, 3e-3, -0.12345678e-2,
                                                                      0.223456789e-2, -0.32345678e-2});
  CHECK(record_in(peer("G", "8")).time[7] == doctest::Approx(0.035));
  for (const char* unit : {"CM/S**2", "CM/SEC/SEC", "GAL", "cm/s^2"})
    CHECK(record_in(peer(unit, "8")).acceleration[2] == doctest::Approx(1e-5 / 9.81));
  CHECK(record_in(peer("M/S**2", "8")).acceleration[2] == doctest::Approx(1e-3 / 9.81));
  for (const char* unit : {"CM/S", "M", "CM", "FURLONGS", "M/S"})
    check_refused(peer(unit, "8"), "record.txt:3: the unit");
  for (const char* unit : {"G * 0.001", "G X 10**-3", "G (0.001)", "G SCALE FACTOR 0.001"})
    check_refused(peer(unit, "8"), "follows the unit: a factor is not expected");
  CHECK(record_in(peer("G. FILTER POINTS: HP=0.1 Hz", "8")).acceleration[2] == 1e-3);
  for (const char* count : {"7", "9", "4000"}) {
    check_refused(peer("G", count), "holds 8 values, but NPTS is");
    check_refused(peer("G", count), count);
  }
  for (const char* count : {"0", "-8", "8.5", "nan", "x", "", "8,000"})
    check_refused(peer("G", count), "record.txt:4");
}

TEST_CASE("the step of a PEER file is in seconds, and a file that is cut off is refused") {
  const std::string value = "  1.0000000E-03", two = value + value + "\n";
  const auto peer = [&](const std::string& step, const std::string& values) {
    return "PEER\nSomewhere\nIN UNITS OF G\nNPTS=  4, DT= " + step + "\n" + values;
  };
  for (const char* step : {".0100 SEC,", "0.01", "0.01 s", ".0100SEC", "1e-2 sec"})
    CHECK(record_in(peer(step, two + two)).time[1] == 0.01);
  for (const char* step : {"10 MSEC", "10 ms", "100 HZ"})
    check_refused(peer(step, two + two), "record.txt:4: DT in '");
  check_refused(peer("0.01", two + value + value.substr(0, 9)),
                "record.txt:6: the line ends inside a column");
  // six columns of 10 are as long as four of 15, and no file is cut off that has two of them in its last
  // line
  const std::string ten = "  0.001000", six = ten + ten + ten + ten + ten + ten + "\n";
  const std::string head = "PEER\nSomewhere\nIN UNITS OF G\nNPTS= 14, DT= 0.01\n";
  CHECK(record_in(head + six + six + ten + ten + "\n").time.size() == 14);
}

TEST_CASE("a byte order mark, very small numbers and characters that end a text are no obstacle") {
  CHECK(record_in("\uFEFF0 0.5\n1 1e-310\n2 1e-400\n").acceleration == std::vector<double>{0.5, 1e-310, 0});
  using namespace std::string_literals;
  check_refused("0 0\n1 0\0x\n"s, "record.txt:2: '0?x' is not a number");
  CHECK_THROWS_AS(record_in("0 0\n1 0x1p-3\n"), std::invalid_argument);
}

TEST_CASE("a PEER file of the old header may run together anywhere before a sign") {
  const std::string head = "PEER\nSomewhere\nACCELERATION TIME HISTORY IN UNITS OF G\n 5  0.0100  NPTS, DT\n";
  const Record record =
      record_in(head + "  4.8744285E-04-2.45996670E-04-1.00000000E-03 -2.0000000E-03-3.00000000E-03\n");
  CHECK(record.acceleration == std::vector<double>{4.8744285e-04, -2.4599667e-04, -1e-3, -2e-3, -3e-3});
  const Record unaligned = record_in(head + "4.8744285E-04-2.4599667E-04-1.E-03\n -.2E-02-.3E-02\n");
  CHECK(unaligned.acceleration == std::vector<double>{4.8744285e-04, -2.4599667e-04, -1e-3, -2e-3, -3e-3});
  check_refused(head + "4.8744285E-04*2.4599667E-04\n", "record.txt:5");
}

TEST_CASE("a K-NET file is read in gal about its mean") {
  const std::string text =
      "Origin Time       2001/01/01 12:00:00\nLat.              35.000\nLong.             135.000\n"
      "Depth. (km)       10\nMag.              5.5\nStation Code      TST001\nStation Lat.      35.1000\n"
      "Station Long.     135.1000\nStation Height(m) 10\nRecord Time       2001/01/01 12:00:15\n"
      "Sampling Freq(Hz) 5Hz\nDuration Time(s)  2\nDir.              N-S\nScale Factor      "
      "3920(gal)/6182761\n"
      "Max. Acc. (gal)   1.0\nLast Correction   2001/01/01 12:00:00\nMemo.             \n";
  const std::string values =
      "    1000     3000     1000     3000     1000     3000     1000     3000\n     500     3500\n";
  const Record record = record_in(text + values);
  REQUIRE(record.acceleration.size() == 10);
  CHECK(record.time[9] == doctest::Approx(1.8));
  CHECK(record.acceleration[1] == doctest::Approx(1000 * 3920.0 / 6182761 / 981));
  CHECK(record.acceleration[8] == doctest::Approx(-1500 * 3920.0 / 6182761 / 981));
  check_refused(text + values + "1\n", "holds 11 values, but Sampling Freq times Duration Time is 10");
  for (const char* line :
       {"Sampling Freq(Hz) 5Hz", "Duration Time(s)  2", "Scale Factor      3920(gal)/6182761", "Memo.  "}) {
    CAPTURE(line);
    std::string other = text + values;
    other.replace(other.find(line), std::string(line).size(), "Scale Factor      3920(m)/0");
    check_refused(other, "record.txt:");
  }
}

TEST_CASE("an ESM file is read in the unit of its header") {
  std::string text =
      "EVENT_NAME: MADE UP\nEVENT_ID: XX-2001-0001\nEVENT_DATE_YYYYMMDD: 20010101\n"
      "STATION_CODE: HILL\nSAMPLING_INTERVAL_S: 0.005000\nNDATA: 4\nDURATION_S: 0.015\n"
      "STREAM: HNE\nUNITS: cm/s^2\nPGA_CM/S^2: 98.1\nTIME_PGA_S: 0.010000\nBASELINE_CORRECTION: \n"
      "DATA_TYPE: ACCELERATION\n";
  for (int line = 14; line <= 64; ++line) text += "USER" + std::to_string(line) + ":\n";
  const std::string values = "0.0\n-9.81\n 98.1\n1.962e1\n";
  const Record record = record_in(text + values);
  CHECK(record.acceleration[2] == doctest::Approx(0.1));
  CHECK(record.acceleration[3] == doctest::Approx(0.02));
  CHECK(record.time[3] == doctest::Approx(0.015));
  check_refused(text + "1\n2\n", "holds 2 values, but NDATA is 4");
  check_refused(text + values + "x\n", "record.txt:69: 'x' is not a number");
  for (const std::string type : {"VELOCITY", "DISPLACEMENT", "ACCELERATION RESPONSE SPECTRUM"})
    check_refused(replaced(text, "TYPE: ACCELERATION", "TYPE: " + type) + values,
                  "record.txt:13: DATA_TYPE is '" + type + "'");
  text.replace(text.find("cm/s^2"), 6, "cm/s");
  check_refused(text + values, "record.txt:9: the unit 'cm/s'");
}
