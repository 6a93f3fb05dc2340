// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMEdgeLengthDomain.h"

#include "vtkPVEdgeLengthInformation.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMUncheckedPropertyHelper.h>

vtkStandardNewMacro(vtkSMEdgeLengthDomain);

namespace
{
/// Of what is connected to the property; 0 if nothing is, or it has no polygons.
double AverageEdgeLengthOf(vtkSMProperty* input)
{
  vtkSMUncheckedPropertyHelper connection(input);
  auto* source = connection.GetNumberOfElements() > 0
    ? vtkSMSourceProxy::SafeDownCast(connection.GetAsProxy(0))
    : nullptr;
  if (source == nullptr)
  {
    return 0.0;
  }
  source->CreateOutputPorts();
  vtkNew<vtkPVEdgeLengthInformation> information;
  information->SetPortNumber(static_cast<int>(connection.GetOutputPort(0)));
  source->GatherInformation(information);
  return information->GetAverageEdgeLength();
}
}

//------------------------------------------------------------------------------
int vtkSMEdgeLengthDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  if (!this->Superclass::ReadXMLAttributes(property, element))
  {
    return 0;
  }
  element->GetScalarAttribute("minimum", &this->Minimum);
  element->GetScalarAttribute("maximum", &this->Maximum);
  element->GetScalarAttribute("default", &this->Default);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSMEdgeLengthDomain::Update(vtkSMProperty*)
{
  vtkSMProperty* input = this->GetRequiredProperty("Input");
  this->AverageEdgeLength = input != nullptr ? AverageEdgeLengthOf(input) : 0.0;
  if (this->AverageEdgeLength > 0.0)
  {
    this->SetEntries({ vtkEntry(
      this->Minimum * this->AverageEdgeLength, this->Maximum * this->AverageEdgeLength) });
  }
}

//------------------------------------------------------------------------------
int vtkSMEdgeLengthDomain::SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues)
{
  if (this->Default <= 0.0 || this->AverageEdgeLength <= 0.0)
  {
    return 0; // and so the property keeps the default of the XML
  }
  const double value = this->Default * this->AverageEdgeLength;
  vtkSMPropertyHelper helper(property);
  helper.SetUseUnchecked(useUncheckedValues);
  helper.Set(0, value);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSMEdgeLengthDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AverageEdgeLength: " << this->AverageEdgeLength << "\n";
}
