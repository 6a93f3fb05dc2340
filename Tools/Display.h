// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Display.h
/// Whether pictures can be drawn here.

#ifndef arris_Display_h
#define arris_Display_h

namespace arris
{
/// Whether VTK can open a window to draw in, found out by letting a child process try. VTK ends the
/// process when it finds no display, or one without OpenGL, so asking X alone would not tell; and
/// the child also answers for a VTK that needs no display at all. Call it before any thread starts.
bool CanDraw();
}

#endif
