#pragma once
#include "scenes/shapes/mesh.h"
#include "support/arithmetic/random.h"

namespace seamline::scenes {

/// Pieces of furniture, each one closed or nearly closed mesh that stands on y = 0, centred on x = z = 0, its
/// front towards +Z. Metres.

/// A chair with turned legs and a back of slats.
[[nodiscard]] TriangleMesh make_chair();
[[nodiscard]] TriangleMesh make_stool();
/// A table with four turned legs.
[[nodiscard]] TriangleMesh make_table(double length_m, double depth_m, double height_m);
/// A seat with arms and back, `seats` cushions wide.
[[nodiscard]] TriangleMesh make_sofa(int seats);
/// An open case of `boards` shelves between two sides, with a back.
[[nodiscard]] TriangleMesh make_bookcase(double width_m, double height_m, int boards);
/// Books of random thickness and height, some leaning, along x from -length_m / 2.
[[nodiscard]] TriangleMesh make_books(double length_m, Random& random);
/// A case with doors that stand out a little.
[[nodiscard]] TriangleMesh make_sideboard(double width_m, int doors);
/// A shade on a thin stand.
[[nodiscard]] TriangleMesh make_lamp(double height_m, double shade_radius_m);
/// A shade on a cord; its top is at y = 0, it hangs down by drop_m.
[[nodiscard]] TriangleMesh make_hanging_lamp(double drop_m);
[[nodiscard]] TriangleMesh make_vase(double height_m);
/// A pot with a bush of long bent leaves.
[[nodiscard]] TriangleMesh make_plant(double height_m, Random& random);
/// A picture in a frame, hanging in the plane z = 0, its centre at the origin.
[[nodiscard]] TriangleMesh make_picture(double width_m, double height_m);
/// A round plate or bowl.
[[nodiscard]] TriangleMesh make_dish(double radius_m, double height_m);
/// A curtain in folds that hangs along x, its lower edge at y = 0.
[[nodiscard]] TriangleMesh make_curtain(double width_m, double height_m);

}  // namespace seamline::scenes
