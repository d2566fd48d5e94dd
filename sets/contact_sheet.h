#pragma once
#include <filesystem>

namespace seamline::renderer {

/// Writes `SET/contact-ARTIFACT.png` for every artifact of a set: a row an object under its name, from the
/// finest depth map on the left to the coarsest on the right and the reference last, all cropped to where the
/// artifact is (paper Fig. 3).
void write_contact_sheets(const std::filesystem::path& set_folder);

}  // namespace seamline::renderer
