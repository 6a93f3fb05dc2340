// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkPVEdgeLengthInformation
 * @brief   the average edge length of a mesh on the server
 *
 * Gathered from an algorithm, of the polygons on one of its output ports, blocks and ranks taken
 * together. An edge counts once for each polygon that has it.
 */

#ifndef vtkPVEdgeLengthInformation_h
#define vtkPVEdgeLengthInformation_h

#include "ArrisServerManagerModule.h" // for the export macro

#include <vtkPVInformation.h>

class ARRISSERVERMANAGER_EXPORT vtkPVEdgeLengthInformation : public vtkPVInformation
{
public:
  static vtkPVEdgeLengthInformation* New();
  vtkTypeMacro(vtkPVEdgeLengthInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The output port to look at. Default: 0.
  vtkSetMacro(PortNumber, int);
  vtkGetMacro(PortNumber, int);
  ///@}

  /// The mean length of an edge; 0 where there is none.
  double GetAverageEdgeLength() const;

  void CopyFromObject(vtkObject* algorithm) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;
  void CopyParametersToStream(vtkMultiProcessStream& stream) override;
  void CopyParametersFromStream(vtkMultiProcessStream& stream) override;

protected:
  vtkPVEdgeLengthInformation() = default;
  ~vtkPVEdgeLengthInformation() override = default;

  int PortNumber = 0;
  double Length = 0.0; ///< of all edges
  double Count = 0.0; ///< of edges

private:
  vtkPVEdgeLengthInformation(const vtkPVEdgeLengthInformation&) = delete;
  void operator=(const vtkPVEdgeLengthInformation&) = delete;
};

#endif
