#pragma once

#include "render/scene/palette.hpp"

/// Colours of panels by their meaning; the hues are those of the whole picture.
namespace jw::panels::theme {

using render::Colour;
namespace palette = render::palette;

inline constexpr Colour kInk = palette::kInk;
inline constexpr Colour kSoft = palette::kInkSoft;
inline constexpr Colour kFaint = palette::kInkFaint;
inline constexpr Colour kLine = palette::kLine;
inline constexpr Colour kPaper = palette::kPaper;
inline constexpr Colour kShade = palette::kPaperShade;
inline constexpr Colour kWhite = render::from_hex(0xFFFFFF);

inline constexpr Colour kAccent = palette::kVectorI;                   ///< progress, current row, curves
inline constexpr Colour kSubject = render::from_hex(0xFBF0D2);         ///< behind the subject of the step
inline constexpr Colour kSubjectMark = palette::kHighlight;            ///< at its edge
inline constexpr Colour kRedundant = palette::kBad;                    ///< redundant equations
inline constexpr Colour kRedundantShade = render::from_hex(0xF7E3D8);  ///< behind its label
inline constexpr Colour kWarning = render::from_hex(0x8A5A00);         ///< text of a warning
inline constexpr Colour kWarningShade = render::from_hex(0xFCF3DC);
inline constexpr Colour kFailureShade = render::from_hex(0xFBE9E1);
inline constexpr Colour kNegative = render::from_hex(0x1D62A8);  ///< entries of Φq below 0
inline constexpr Colour kPositive = render::from_hex(0xE07B12);  ///< entries of Φq above 0

// distances at 720, see Canvas::px
inline constexpr float kMargin = 16.0F;  ///< from the edge of a panel to its contents
inline constexpr float kGap = 14.0F;     ///< between panels

}  // namespace jw::panels::theme
