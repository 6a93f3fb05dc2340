// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkSharpVertexCounter
 * @brief   counts the vertices that vtkUSSODFilter finds sharp
 */

#ifndef vtkSharpVertexCounter_h
#define vtkSharpVertexCounter_h

#include "SuperProbeModule.h" // for the export macro

#include <vtkObject.h>

class vtkPolyData;

class SUPERPROBE_EXPORT vtkSharpVertexCounter : public vtkObject
{
public:
  static vtkSharpVertexCounter* New();
  vtkTypeMacro(vtkSharpVertexCounter, vtkObject);

  /// The number of vertices of a mesh in its sharp region; -1 if that could not be found.
  vtkIdType Count(vtkPolyData* mesh);

protected:
  vtkSharpVertexCounter() = default;
  ~vtkSharpVertexCounter() override = default;

private:
  vtkSharpVertexCounter(const vtkSharpVertexCounter&) = delete;
  void operator=(const vtkSharpVertexCounter&) = delete;
};

#endif
