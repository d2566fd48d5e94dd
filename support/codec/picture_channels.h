#pragma once
#include <string>
#include <vector>

namespace seamline {

/// One channel of a picture file, whose EXR name "layer.name" is taken apart at its last dot; the part of a
/// file of several is part of the layer's name.
struct NamedChannel {
  std::string layer, name;
  int part = 0, index = 0;  ///< in which part, and which of its channels

  [[nodiscard]] std::string full() const { return layer.empty() ? name : layer + "." + name; }
};

/// Channels that are wanted of a file, all of one part.
struct ChosenChannels {
  int part = 0;
  std::vector<int> indices;
  int alpha = -1;                  ///< index of that which belongs to them
  std::vector<std::string> notes;  ///< which of several layers was taken, what was left out
};

/// Takes the names of a part's channels apart. `part_name` is empty for a file of one part.
void append_channels(const std::vector<std::string>& names, const std::string& part_name, int part,
                     std::vector<NamedChannel>& channels);

/// Red, green and blue: of the layer that is named; else of the unnamed layer, of the only one that has them,
/// of one with a usual name (Combined, beauty, rgba, ...), or of the first part that has them. A file with
/// one or two channels has them all, and one whose channels have no names its first three. Throws InputError
/// naming `file` and the layers where none or several could be meant.
[[nodiscard]] ChosenChannels colour_channels(const std::vector<NamedChannel>& channels,
                                             const std::string& layer, const std::string& file);

/// The channel of depth: the one that is named; else the only one; else one that is called Z, depth, V,
/// distance or Y, the same in layers called depth; else R, G and B, three indices whose values must be equal.
/// Z beside X and Y is a normal or a place and is not meant. Throws InputError likewise.
[[nodiscard]] ChosenChannels depth_channel(const std::vector<NamedChannel>& channels,
                                           const std::string& named, const std::string& file);

}  // namespace seamline
