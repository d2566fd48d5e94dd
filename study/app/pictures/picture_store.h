#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>

#include "study/app/pictures/picture_loader.h"
#include "study/trials/object_map.h"
#include "study/trials/rendered_set.h"
#include "window/texture.h"

namespace seamline::study::app {

/// The pictures of trials in graphics memory: at most three (previous, current, next), whatever the number of
/// trials. Needs the window's OpenGL context.
class PictureStore {
 public:
  /// `scaled`: pictures are not shown pixel for pixel and need smooth sampling.
  PictureStore(const RenderedSet& set, bool scaled);

  /// Has the trial that is due and the one after it decoded, and puts what is decoded into textures. Throws
  /// InputError when a picture cannot be read.
  void prepare(const Trial& due, const std::optional<Trial>& after);

  /// The trial's picture when it is ready to be shown.
  [[nodiscard]] const Texture* find(const Trial& trial) const;

  /// Where the objects of the trial's scene are.
  [[nodiscard]] const ObjectMap& objects(const Trial& trial) const;

 private:
  struct Slot {
    std::optional<Trial> trial;
    Texture texture;
    std::int64_t used = 0;  ///< the larger the later
  };
  void fetch(const Trial& trial);
  [[nodiscard]] Slot& oldest_slot();

  const RenderedSet& set_;
  bool scaled_;
  std::array<Slot, 3> slots_;
  std::int64_t clock_ = 0;
  std::map<std::string, ObjectMap> objects_;  ///< by scene
  PictureLoader loader_;
};

}  // namespace seamline::study::app
