// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Mixed.h
/// Numbers that follow how rounded or how rough a sampling is.

#ifndef arris_Robust_Mixed_h
#define arris_Robust_Mixed_h

namespace arris
{
/// Between what suits one kind of sampling and what suits another, by how far it is the other.
inline double Mixed(double one, double other, double degree)
{
  return one + degree * (other - one);
}

}

#endif
