#pragma once

#include <complex>
#include <optional>

#include "app/session/picture/picture.hpp"
#include "app/session/rest/rest.hpp"

/// Poses and pictures of an equilibrium and of the small motions about it.
namespace jw {

/// Pose displaced by Re(z (shape + i shape_late)) of a mode from the equilibrium, and then moved by Newton's
/// method so that all equations hold; frames as given.
/// @param z  turn of the body that turns most [rad], or its displacement [extents]
/// @return nothing if Newton's method does not reach such a pose: the displacement is too large
std::optional<State> pose_in_mode(const RestView& view, std::size_t mode, std::complex<double> z);

/// Picture of the whole lesson at rest, with the reactions, or at another pose without them. Nothing in it
/// can be pointed at or pulled, because it is not the pose of a step.
Picture picture_at_rest(
    const Story& story, const PictureStyle& style, const RestView& view, const std::optional<State>& moved);

}  // namespace jw
