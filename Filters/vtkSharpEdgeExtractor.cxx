// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSharpEdgeExtractor.h"

#include "Core/Features/FeatureExtraction.h"
#include "Core/Features/Resampling.h"
#include "Support/Arrays.h"
#include "Support/FeatureOutputs.h"
#include "Support/FilterMonitor.h"
#include "Support/Parameters.h"
#include "Support/PointMerging.h"
#include "Support/Surface.h"

#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>

vtkStandardNewMacro(vtkSharpEdgeExtractor);

namespace
{
enum Port
{
  Curves,
  Corners,
  Mesh,
  Faces,
  PortCount
};

/// A mesh that is cut into pieces may leave some of them empty.
bool IsOneOfSeveralPieces(vtkInformationVector* outputs)
{
  vtkInformationIntegerKey* pieces = vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES();
  bool several = false;
  for (int port = 0; port < PortCount; ++port)
  {
    vtkInformation* output = outputs->GetInformationObject(port); // one of them is asked for
    several = several || (output->Has(pieces) && output->Get(pieces) > 1);
  }
  return several;
}

/// Fills the mesh that is looked at, its open points merged; what is wrong with it, or nothing.
std::string ReadMesh(
  vtkPolyData* input, bool mayBeEmpty, double tolerance, vtkPolyData* output, arris::Surface& mesh)
{
  std::string problem = arris::ReadSurface(input, output, mesh);
  if (!problem.empty())
  {
    return problem;
  }
  arris::MergeOpenPoints(tolerance, mesh);
  if (mesh.Triangulation.Triangles.empty() && input->GetNumberOfPolys() == 0 &&
    input->GetNumberOfStrips() == 0 && !mayBeEmpty)
  {
    problem = "the input has no triangles: give a mesh of triangles or polygons";
  }
  else if (arris::IsSoup(mesh))
  {
    problem = "no two triangles share an edge, as the points are not merged: raise MergeTolerance";
  }
  if (!problem.empty())
  {
    output->Initialize();
  }
  return problem;
}

/// The vertices where vtkSharpEdgeReconstruction put the edges, if that is where the mesh is from
/// and it put any: a mesh that it left as it was may be sharp all the same.
arris::Flags SkeletonOf(vtkPolyData* mesh)
{
  std::vector<double> roles;
  const std::string problem =
    arris::ReadPointValues(mesh->GetPointData()->GetArray(arris::array::SkeletonRole),
      arris::array::SkeletonRole, mesh, roles);
  const bool any = std::any_of(roles.begin(), roles.end(), [](double role) { return role != 0.0; });
  return problem.empty() && any ? arris::NonZero(roles) : arris::Flags();
}
}

//------------------------------------------------------------------------------
vtkSharpEdgeExtractor::vtkSharpEdgeExtractor()
  : FeatureAngle(arris::DefaultFeatureAngle)
  , CornerAngle(arris::DefaultCornerAngle)
  , NoiseFactor(arris::DefaultNoiseFactor)
  , MergeTolerance(arris::DefaultMergeTolerance)
  , FitTolerance(arris::DefaultFitTolerance)
{
  this->SetNumberOfOutputPorts(PortCount);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSharpEdgeExtractor::GetCorners()
{
  return this->GetOutput(Corners);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSharpEdgeExtractor::GetSurfaces()
{
  return this->GetOutput(Mesh);
}

//------------------------------------------------------------------------------
vtkTable* vtkSharpEdgeExtractor::GetFaces()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(Faces));
}

//------------------------------------------------------------------------------
int vtkSharpEdgeExtractor::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == Faces ? "vtkTable" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkSharpEdgeExtractor::ProblemWithParameters() const
{
  return arris::FirstProblem({ arris::ProblemWithAngle("FeatureAngle", this->FeatureAngle),
                               arris::ProblemWithAngle("CornerAngle", this->CornerAngle),
                               arris::ProblemWithSize("NoiseFactor", this->NoiseFactor),
                               arris::ProblemWithLength("GapLength", this->GapLength),
                               arris::ProblemWithLength("TailLength", this->TailLength),
                               arris::ProblemWithSize("MinimumLength", this->MinimumLength),
                               arris::ProblemWithSize("MergeTolerance", this->MergeTolerance),
                               arris::ProblemWithSize("ResampleStep", this->ResampleStep),
                               arris::ProblemWithSize("FitTolerance", this->FitTolerance) },
    [this]() -> std::string
    {
      if (!(this->ContinuationAngle >= 0.0 && this->ContinuationAngle <= this->FeatureAngle))
      {
        return "ContinuationAngle must be from 0 to FeatureAngle (" +
          std::to_string(this->FeatureAngle) + "); it is " +
          std::to_string(this->ContinuationAngle);
      }
      if (!(this->MaximumAngle >= this->FeatureAngle && this->MaximumAngle <= 180.0))
      {
        return "MaximumAngle must be from FeatureAngle (" + std::to_string(this->FeatureAngle) +
          ") to 180; it is " + std::to_string(this->MaximumAngle);
      }
      return {};
    });
}

//------------------------------------------------------------------------------
void vtkSharpEdgeExtractor::FillCriteria(
  double averageEdgeLength, arris::FeatureCriteria& criteria) const
{
  const double continuation = this->ContinuationAngle > 0.0
    ? this->ContinuationAngle
    : arris::DefaultContinuation * this->FeatureAngle;
  criteria.Band = { this->FeatureAngle, continuation, this->MaximumAngle, this->CornerAngle };
  criteria.CornerReach = arris::CornerReach * averageEdgeLength;
  criteria.NoiseFactor = this->NoiseFactor;
  criteria.Boundary = this->BoundaryEdges;
  criteria.NonManifold = this->NonManifoldEdges;
  criteria.GapLength =
    this->GapLength < 0.0 ? arris::DefaultGap * averageEdgeLength : this->GapLength;
  criteria.FoldedGapLength = arris::FoldedGap * criteria.GapLength;
  criteria.TailLength =
    this->TailLength < 0.0 ? arris::DefaultTail * averageEdgeLength : this->TailLength;
  criteria.UnlikelyLength = arris::UnlikelyTail * averageEdgeLength;
  criteria.MinimumLength = this->MinimumLength;
}

//------------------------------------------------------------------------------
int vtkSharpEdgeExtractor::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, Mesh);

  arris::Surface surface;
  const bool mayBeEmpty = IsOneOfSeveralPieces(outputVector);
  const std::string problem = arris::FirstProblem({ this->ProblemWithParameters() },
    [&] { return ReadMesh(input, mayBeEmpty, this->MergeTolerance, output, surface); });
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 1;
  }
  if (output->GetNumberOfPoints() == 0)
  {
    return 1;
  }

  arris::ExtractionParameters parameters;
  this->FillCriteria(surface.AverageEdgeLength, parameters.Criteria);
  parameters.Criteria.Likely = SkeletonOf(output);
  parameters.FitShapes = this->FitPrimitives;
  parameters.FitTolerance = this->FitTolerance;
  const arris::Mesh& mesh = surface.Triangulation;
  arris::FeatureSet features;
  if (!arris::ExtractFeatures(
        mesh, surface.Adjacency, parameters, arris::MonitorOf(this), features))
  {
    output->Initialize();
    return 1;
  }
  const std::string problemWithStep = this->ResampleStep > 0.0
    ? arris::ProblemWithStep(features.Network.Curves, mesh.Points, this->ResampleStep)
    : std::string();
  if (!problemWithStep.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< problemWithStep);
    return 1;
  }
  arris::FillCurves(
    vtkPolyData::GetData(outputVector, Curves), features, mesh.Points, this->ResampleStep, output);
  arris::FillCorners(vtkPolyData::GetData(outputVector, Corners), features.Corners, output);
  arris::AddSurfaceIds(output, features.Faces.Ids, surface);
  arris::FillFaceTable(
    vtkTable::GetData(outputVector, Faces), features.Faces.Measures, features.Fits);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSharpEdgeExtractor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "ContinuationAngle: " << this->ContinuationAngle << "\n";
  os << indent << "MaximumAngle: " << this->MaximumAngle << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "NoiseFactor: " << this->NoiseFactor << "\n";
  os << indent << "BoundaryEdges: " << this->BoundaryEdges << "\n";
  os << indent << "NonManifoldEdges: " << this->NonManifoldEdges << "\n";
  os << indent << "GapLength: " << this->GapLength << "\n";
  os << indent << "TailLength: " << this->TailLength << "\n";
  os << indent << "MinimumLength: " << this->MinimumLength << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "ResampleStep: " << this->ResampleStep << "\n";
  os << indent << "FitPrimitives: " << this->FitPrimitives << "\n";
  os << indent << "FitTolerance: " << this->FitTolerance << "\n";
}
