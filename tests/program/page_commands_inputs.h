#pragma once
#include <filesystem>
#include <string>

/// The files and folders that pages speak of and do not make.
namespace seamline::page_commands {

/// Puts what a page means by `word` into its folder, unless it is there: a study file, a rendered set, a log,
/// a photograph, a depth map, a scene. Other words mean nothing. What is put there is made once for all test
/// programs of a build, by the program itself where it can.
void provide(const std::filesystem::path& folder, const std::string& page, const std::string& word);

}  // namespace seamline::page_commands
