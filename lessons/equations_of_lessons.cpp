// Which lesson covers which equations of the paper.
#include <algorithm>
#include <lessons/lesson.hpp>

namespace rederive {
namespace {

const std::map<int, std::vector<std::string>>& covered() {
  static const std::map<int, std::vector<std::string>> all{
      {1,
       {"2a",  "2b", "3",  "4a",  "4b",  "5",   "u2",  "6",   "7a",  "7b", "8",  "9",  "10", "11",  "12a",
        "12b", "13", "14", "15a", "15b", "16a", "16b", "17a", "17b", "18", "19", "20", "u5", "21a", "21b"}},
      {2, {"1", "7b", "8", "9", "10", "11", "17b", "18", "19", "20", "u3a", "u3b", "u4", "21a", "21b"}},
      {3, {"3", "13", "9", "14", "10", "19", "u8", "22a", "22b"}},
      {4, {"23",   "u9a",  "u9b", "24a", "24b", "25a", "25b", "26a", "26b", "27",
           "u10a", "u10b", "28a", "28b", "29",  "30",  "31",  "u11", "32a", "33"}},
      {5, {"34",  "u12a", "u12b", "35",  "u13", "36", "37a", "37b", "38",  "39",  "40a",
           "40b", "41",   "42a",  "43a", "43b", "44", "45a", "45b", "u16", "46a", "46b"}},
      {6, {"47a", "47b", "48a", "48b", "48c", "49a", "49b", "49c", "50a", "50b", "50", "50c",
           "u17", "51a", "51b", "51c", "r1",  "r2",  "r3",  "r4",  "r5",  "r6",  "r7", "r8"}},
      {7, {"52",  "52b", "52c", "53a", "53b", "53c", "u18", "54",  "55b", "56a", "56b",  "57a",
           "57b", "58a", "58b", "58c", "58d", "59a", "59b", "60a", "60b", "60c", "u19a", "u19b",
           "61a", "61b", "62a", "62b", "63a", "63b", "64a", "64b", "64c", "64d"}},
      {8, {"65a", "65b", "66a", "66b", "67",  "68", "u6", "69a", "69b", "70a", "70b", "71",
           "u21", "72a", "72b", "73a", "73b", "74", "75", "76a", "76b", "77a", "77b", "78"}},
      {9, {"79a",  "79b",  "80a", "80b", "u22", "u23", "81",  "82",  "83",  "84",  "85",  "86",  "87a",
           "87b",  "88",   "89a", "89b", "90a", "90b", "91a", "91b", "92a", "92b", "93a", "93b", "u24",
           "u25a", "u25b", "94a", "94b", "95a", "95b", "96",  "r9",  "r10", "r11", "r12"}},
      {10, {"u27a", "u27b", "u27c", "u27d", "u27e", "97",  "98",  "99",  "100a", "100b",
            "u28",  "101a", "101b", "102",  "103",  "104", "u29", "r13", "r14",  "r15"}},
      {11, {"71", "86", "88", "92a", "96", "r9", "r10", "r11", "r12"}},
      {12, {"28b", "24a", "52c", "u20", "u21", "71"}},
  };
  return all;
}

}  // namespace

std::vector<std::string> equations_of(int lesson) {
  const auto found = covered().find(lesson);
  return found == covered().end() ? std::vector<std::string>() : found->second;
}

int lesson_with(const std::string& id) {
  for (const auto& [lesson, ids] : covered())
    if (std::find(ids.begin(), ids.end(), id) != ids.end()) return lesson;
  return 0;
}

}  // namespace rederive
