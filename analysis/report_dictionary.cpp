#include "analysis/report_dictionary.h"
namespace seamline {
CsvTable report_dictionary(const std::vector<CsvTable>& tables) {
  return data_dictionary(tables);
}
}  // namespace seamline
