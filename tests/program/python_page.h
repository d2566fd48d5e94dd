#pragma once
#include "exchange_examples.h"

/// The blocks of documentation/how-to/use_from_python.md, in a folder with a log and its report.
namespace seamline::test {

class PythonPage : public ExchangeTables {
 protected:
  void SetUp() override {
    ExchangeTables::SetUp();
    std::filesystem::copy_file(folder / "log.sqlite", folder / "answers.sqlite");
  }
  [[nodiscard]] Outcome in_python(const std::string& script) const {
    const std::string source = SEAMLINE_SOURCE_DIR;
    return in_folder("SEAMLINE=" SEAMLINE_PROGRAM " PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=" + source +
                     "/python python3 " + script + " 2>&1");
  }
  /// The `number`th block of Python, from 0.
  [[nodiscard]] Outcome python(int number) const {
    write_text(folder / "block.py", example_of("documentation/how-to/use_from_python.md", "python", number));
    return in_python("block.py");
  }
};

}  // namespace seamline::test
