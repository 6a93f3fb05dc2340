// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file ErrorCapture.h
/// Keeps VTK's own messages from the screen, and the first one as a cause to tell.

#ifndef arris_ErrorCapture_h
#define arris_ErrorCapture_h

#include <vtkSmartPointer.h>

#include <sstream>
#include <streambuf>
#include <string>

class vtkOutputWindow;

namespace arris
{
/// While it lives, errors and warnings of VTK, and what the libraries under it write to std::cout
/// and std::cerr, are held back. Captures may be nested; the innermost hears.
class ErrorCapture
{
public:
  ErrorCapture();
  ~ErrorCapture();
  ErrorCapture(const ErrorCapture&) = delete;
  void operator=(const ErrorCapture&) = delete;

  /// The first error as one line, without VTK's file, line and address; empty if there was none.
  std::string FirstError() const;

  /// The same of warnings.
  std::string FirstWarning() const;

  /// The first error; without an error the first warning; else what was written to std::cerr.
  std::string FirstWord() const;

private:
  class Window;

  vtkSmartPointer<Window> Listener;
  vtkSmartPointer<vtkOutputWindow> PreviousWindow;
  std::ostringstream Out;
  std::ostringstream Err;
  std::streambuf* PreviousOut;
  std::streambuf* PreviousErr;
};
}

#endif
