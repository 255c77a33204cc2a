// write_site: the static site of the built-in paper. lessons/run --site calls it.
#include <lessons/rocking_block/course.hpp>
#include <lessons/site/site.hpp>

int main(int argc, char** argv) {
  return rederive::site::run_site(rederive::rocking_block::course, true, argc, argv);
}
