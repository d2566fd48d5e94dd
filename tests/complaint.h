#pragma once
#include <string>

#include "support/text/error.h"

namespace seamline::test {

/// The sentence of the InputError that `work` throws; "no complaint" when it throws none.
template <class Work>
std::string complaint_of(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

}  // namespace seamline::test
