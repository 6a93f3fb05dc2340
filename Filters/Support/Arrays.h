// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Arrays.h
/// The arrays that Arris' filters add and read: their names are part of its interface.

#ifndef arris_Arrays_h
#define arris_Arrays_h

#include "Core/Robust/Account.h"
#include "Core/Skeleton.h"
#include "Core/Types.h"

#include <vtkType.h>

#include <string>

class vtkDataArray;
class vtkPoints;
class vtkPolyData;

namespace arris
{
struct Surface;

namespace array
{
constexpr const char* Ussod = "USSOD";
constexpr const char* NormalDeviation = "NormalDeviation";
constexpr const char* SharpRegion = "SharpRegion";
constexpr const char* ThinningRound = "ThinningRound";
constexpr const char* SkeletonRole = "SkeletonRole";
constexpr const char* Displacement = "Displacement";
constexpr const char* Window = "Window";
constexpr const char* EdgeAngle = "EdgeAngle";
constexpr const char* Outcome = "Outcome";
constexpr const char* SurfaceId = "SurfaceId";
constexpr const char* DihedralAngle = "DihedralAngle";
constexpr const char* CurveId = "CurveId";
constexpr const char* CurveLength = "Length";
constexpr const char* MinimumDihedralAngle = "MinimumDihedralAngle";
constexpr const char* MaximumDihedralAngle = "MaximumDihedralAngle";
constexpr const char* CurveKind = "CurveKind";
constexpr const char* Closed = "Closed";
constexpr const char* LeftSurfaceId = "LeftSurfaceId";
constexpr const char* RightSurfaceId = "RightSurfaceId";
constexpr const char* Tangent = "Tangent";
constexpr const char* MeshPointId = "MeshPointId";
constexpr const char* Valence = "Valence";
constexpr const char* CurveIds = "CurveIds";
constexpr const char* CornerKind = "CornerKind";
constexpr const char* Tip = "Tip";
constexpr const char* FaceArea = "Area";
constexpr const char* FaceTriangles = "Triangles";
constexpr const char* FaceBoundaryLoops = "BoundaryLoops";
constexpr const char* FacePrimitive = "Primitive";
constexpr const char* FacePoint = "Point";
constexpr const char* FaceAxis = "Axis";
constexpr const char* FaceRadius = "Radius";
constexpr const char* FaceMinorRadius = "MinorRadius";
constexpr const char* FaceHalfAngle = "HalfAngle";
constexpr const char* FaceResidual = "Residual";
constexpr const char* Lambda = "Lambda";
constexpr const char* SharpAngle = "SharpAngle";
constexpr const char* AverageEdgeLength = "AverageEdgeLength";
constexpr const char* Roughness = "Roughness";
constexpr const char* Rounding = "Rounding";
constexpr const char* BendTriangleSize = "BendTriangleSize";
constexpr const char* EdgeFlips = "EdgeFlips";
constexpr const char* BendsAreMeant = "BendsAreMeant";
constexpr const char* ClassificationSeconds = "ClassificationSeconds";
constexpr const char* ThinningSeconds = "ThinningSeconds";
constexpr const char* SharpeningSeconds = "SharpeningSeconds";
}

/// Reads one number a point from an array that a filter was told to use; what is wrong with it, or
/// nothing. `name` is what the array is called unless the user chose another.
std::string ReadPointValues(
  vtkDataArray* array, const char* name, vtkPolyData* input, std::vector<double>& values);

/// Reads the rounds of thinning as ThinningRounds gives them; what is wrong with them, or nothing.
std::string ReadThinningRounds(vtkDataArray* array, vtkPolyData* input, std::vector<int>& rounds);

/// 1 where a value is not 0.
Flags NonZero(const std::vector<double>& values);

/// USSOD, NormalDeviation and SharpRegion on points, from λτ and the window radius λ, of all points
/// or of each.
void AddClassification(vtkPolyData* output, const std::vector<double>& normalDifferences,
  double windowRadius, const Flags& sharpRegion);
void AddClassification(vtkPolyData* output, const std::vector<double>& normalDifferences,
  const std::vector<double>& windowRadii, const Flags& sharpRegion);

/// ThinningRound and SkeletonRole on points.
void AddThinning(
  vtkPolyData* output, const std::vector<int>& rounds, const std::vector<SkeletonRole>& roles);

/// Window, EdgeAngle and Outcome on points: what the robust method used and did where.
void AddAccount(vtkPolyData* output, const std::vector<double>& windowRadii,
  const std::vector<double>& edgeAngles, const std::vector<Outcome>& outcomes);

/// SurfaceId on cells, from the ids of the surface's triangles; NoIndex on all others.
void AddSurfaceIds(vtkPolyData* output, const std::vector<Index>& ids, const Surface& surface);

/// Displacement on points: output minus input position, as both are stored. The input may have no
/// points.
void AddDisplacement(vtkPolyData* output, vtkPoints* before);

/// One number of the field data; replaces one of that name.
void AddFieldValue(vtkPolyData* output, const char* name, double value);

/// The number of that name in the field data, or `otherwise` if there is none.
double FieldValue(vtkPolyData* input, const char* name, double otherwise);
}

#endif
