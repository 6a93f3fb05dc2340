// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Display.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cerrno>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace arris
{
namespace
{
/// Draws an empty picture; the process may not survive it.
void TryToDraw()
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->SetOffScreenRendering(1);
  window->SetSize(16, 16);
  window->AddRenderer(renderer);
  window->Render();
}

/// What happens in the child: silent, without a core file, and not for ever.
[[noreturn]] void Child()
{
  constexpr unsigned int SecondsToAnswer = 30;
  const rlimit none = { 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  alarm(SecondsToAnswer);
  TryToDraw();
  _exit(0);
}
}

bool CanDraw()
{
  const pid_t child = fork();
  if (child < 0)
  {
    return false;
  }
  if (child == 0)
  {
    Child();
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
  {
    if (errno != EINTR)
    {
      return false;
    }
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}
}
