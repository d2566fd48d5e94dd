#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/app/pictures/clip_player.h"
#include "study/app/pictures/picture_loader.h"
#include "study/trials/object_map.h"
#include "study/trials/rendered_set.h"
#include "window/window_texture.h"

namespace seamline::study {
struct LevelLadders;  // study/trials/level_ladders.h
}

namespace seamline::study::app {

/// The pictures of trials in graphics memory: those of at most three trials (previous, current, next),
/// whatever the number of trials. `Trial` names one picture here (`shown_pictures`). Needs the window's
/// OpenGL context.
class PictureStore {
 public:
  /// `scaled`: pictures are not shown pixel for pixel and need smooth sampling.
  PictureStore(const RenderedSet& set, bool scaled);

  /// Has what the trial that is due and the one after it show decoded, and puts what is decoded into
  /// textures. Throws InputError when a picture cannot be read.
  void prepare(const Trial& due, const std::optional<Trial>& after);

  /// The pictures that a trial shows; of a match those among which it moves.
  [[nodiscard]] std::vector<Trial> pictures_of(const Trial& trial) const;

  /// A picture when it is ready to be shown.
  [[nodiscard]] const WindowTexture* find(const Trial& trial) const;

  /// Where the objects of the trial's scene are, in the frame that is on the screen.
  [[nodiscard]] const ObjectMap& objects(const Trial& trial) const;

  /// Puts the frame of a trial's clip that is due at `now_ns` after its onset into its texture; nothing of
  /// stills. The clip begins with the first call for a trial. Throws InputError when it cannot be read.
  void play(const Trial& trial, std::int64_t now_ns);
  /// The clip that plays; null of stills, and before the first call of `play`.
  [[nodiscard]] ClipPlayer* clip() const { return player_.get(); }
  void end_clip();  ///< shown again, it begins with its first frame

 private:
  struct Slot {
    std::optional<Trial> trial;
    WindowTexture texture;
    std::int64_t used = 0;  ///< the larger the later
  };
  void fetch(const Trial& trial);
  [[nodiscard]] Slot& oldest_slot();

  const RenderedSet& set_;
  bool scaled_;
  std::shared_ptr<const LevelLadders> ladders_;  ///< of a match
  std::vector<Slot> slots_;  ///< three, or six of tasks that show two different pictures, or two ladders
  std::int64_t clock_ = 0;
  std::map<std::string, std::vector<ObjectMap>> objects_;  ///< by scene; of each frame of a clip
  std::optional<Trial> playing_ = {};
  std::unique_ptr<ClipPlayer> player_;
  PictureLoader loader_;
};

}  // namespace seamline::study::app
