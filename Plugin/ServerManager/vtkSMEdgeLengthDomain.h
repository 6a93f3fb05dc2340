// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkSMEdgeLengthDomain
 * @brief   a range of lengths that are multiples of the input's average edge length
 *
 * XML attributes: `minimum` and `maximum`, the ends of the range, and `default`, the default value,
 * all in average edge lengths. Without `default`, or while the input has no edges (it may not have
 * been updated yet), the property keeps the default of the XML. The required property `Input` is
 * the filter's input.
 */

#ifndef vtkSMEdgeLengthDomain_h
#define vtkSMEdgeLengthDomain_h

#include "ArrisServerManagerModule.h" // for the export macro

#include <vtkSMDoubleRangeDomain.h>

class ARRISSERVERMANAGER_EXPORT vtkSMEdgeLengthDomain : public vtkSMDoubleRangeDomain
{
public:
  static vtkSMEdgeLengthDomain* New();
  vtkTypeMacro(vtkSMEdgeLengthDomain, vtkSMDoubleRangeDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Update(vtkSMProperty* requestingProperty) override;
  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override;

protected:
  vtkSMEdgeLengthDomain() = default;
  ~vtkSMEdgeLengthDomain() override = default;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

  double Minimum = 0.0;
  double Maximum = 1.0;
  double Default = 0.0;
  double AverageEdgeLength = 0.0;

private:
  vtkSMEdgeLengthDomain(const vtkSMEdgeLengthDomain&) = delete;
  void operator=(const vtkSMEdgeLengthDomain&) = delete;
};

#endif
