// Writes the page of the bar to stdout, for page_in_chromium.sh.
#include <iostream>

#include "page_bar.hpp"

int main() {
  cleave::app::write_page(std::cout, cleave::app::bar_cut_in_two());
  return std::cout.flush() ? 0 : 1;
}
