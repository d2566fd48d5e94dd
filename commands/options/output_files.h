#pragma once
#include <CLI/CLI.hpp>
#include <initializer_list>
#include <span>
#include <string>

namespace seamline {

/// Before a command works: proves that the files which these options name can be written, and are none of
/// those that its other options name, nor of those that a scene or a table of objects names, as their readers
/// say (`files_named_by_gltf`, `files_named_by`; `require_outputs` of support/). `made` are options whose
/// files are made where they are missing, each of its own. Options that were not given say nothing.
void require_outputs(const CLI::App& command, std::initializer_list<const char*> outputs,
                     std::initializer_list<const char*> made = {});

/// The same of files that a command writes into the folder of `--out`: none of them is one that it reads.
void require_outputs_in_folder(const CLI::App& command, std::span<const std::string> files);
void require_outputs_in_folder(const CLI::App& command, std::initializer_list<const char*> files);

}  // namespace seamline
