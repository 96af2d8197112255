// Writes the page of the bar to stdout, for page_in_chromium.sh; with an argument: the bar at rest.
#include <iostream>

#include "page_bar.hpp"

int main(int count, char**) {
  using namespace cleave::app;
  write_page(std::cout, count > 1 ? bar_at_rest() : bar_cut_in_two());
  return std::cout.flush() ? 0 : 1;
}
