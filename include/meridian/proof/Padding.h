// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_PADDING_H
#define MERIDIAN_PROOF_PADDING_H

namespace meridian {

/// \ingroup PkgMeridianVerification
/// how far apart charts are, at least: so many texels of a texture; by itself, so many of its sides.
struct Padding
{
  /// \param of_texels the distance; 0: none is asked for
  /// \param texels_right how many texels the texture has to the right
  /// \param texels_up how many upwards
  Padding(double of_texels = 0, int texels_right = 1, int texels_up = 1)
    : texels(of_texels), width(texels_right), height(texels_up)
  {}

  double texels; ///< the distance
  int width;     ///< of the texture, in texels
  int height;    ///< of the texture, in texels
};

} // namespace meridian

#endif // MERIDIAN_PROOF_PADDING_H
