// judge_lines: answers the requests of desk.hpp, one a line on standard input, as the module in a page does.
// For example:
//
//   {"exercise": "barrier", "button": "check", "answer": "m*g*R"}
#include <iostream>
#include <lessons/module/desk.hpp>

int main() {
  for (std::string line; std::getline(std::cin, line);)
    std::cout << rederive::module::reply_to(line) << std::endl;
}
