// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Robust.h"

#include "Apexes.h"
#include "Core/Flagged.h"
#include "Core/Geometry.h"
#include "Core/StopWatch.h"
#include "Denoised.h"
#include "MeetingEdges.h"
#include "Placement.h"
#include "Retreat.h"
#include "Ridge.h"
#include "ThinFaces.h"
#include "Untangle.h"

#include <algorithm>

namespace arris
{
namespace
{
// How far the progress has come after smoothing what is rough, after measuring turns, and after
// fitting sides.
constexpr double Smooth = 0.2;
constexpr double Measured = 0.5;
constexpr double Fitted = 0.8;

/// The steps of the method, in order, on one mesh.
class Recovery
{
public:
  Recovery(const Mesh& input, const Connectivity& connectivity, double averageEdgeLength,
    const RobustParameters& parameters, const Monitor& monitor)
    : Input(input)
    , TheConnectivity(connectivity)
    , AverageEdgeLength(averageEdgeLength)
    , Parameters(parameters)
    , TheMonitor(monitor)
    , Scales(LocalScales(input, connectivity))
  {
  }

  RobustResult Run()
  {
    const StopWatch classification;
    if (!this->TakeSmoothCopy())
    {
      return {};
    }
    const Faces faces(this->Work(), this->TheConnectivity, this->AverageEdgeLength);
    if (!this->Classify(faces))
    {
      return {};
    }
    this->Result.ClassificationSeconds = classification.Seconds();

    const StopWatch thinning;
    const Surroundings around{ this->Work(), this->TheConnectivity, faces, this->Scales,
      this->Result.NormalDifferences, this->Result.Rounding, this->Result.Rough.Degree };
    Labelling labelling;
    if (!LabelVertices(
          around, this->TheMonitor.Part(Measured, Fitted), this->Result.Region, labelling))
    {
      return {};
    }
    const std::vector<Apex> apexes = FindApexes(around, this->Result.Region, labelling);
    const Ridge ridge = FindRidge(this->Work(), this->TheConnectivity, faces, labelling);
    this->Result.ThinningSeconds = thinning.Seconds();

    const StopWatch sharpening;
    this->Sharpen(labelling, apexes, ridge);
    this->Result.SharpeningSeconds = sharpening.Seconds();
    if (!this->TheMonitor.Report(1.0))
    {
      return {};
    }
    return std::move(this->Result);
  }

private:
  bool IsRough() const { return this->Result.Rough.Degree > 0.0; }

  /// The mesh that is worked on.
  const Mesh& Work() const { return this->IsRough() ? this->Copy : this->Input; }

  /// What is rough is worked on in a smooth copy.
  bool TakeSmoothCopy()
  {
    this->Result.Rough = MeasureRoughness(this->Input, this->TheConnectivity, this->Scales);
    if (this->IsRough())
    {
      this->Copy.Triangles = this->Input.Triangles;
      this->Copy.Points = DenoisedPoints(this->Input, this->TheConnectivity, this->Scales,
        this->Result.Rough, this->TheMonitor.Part(0.0, Smooth));
    }
    return this->Work().Points.size() == this->Input.Points.size();
  }

  /// Finds the sharp region.
  bool Classify(const Faces& faces)
  {
    // A window that the user has set is the same everywhere; all else about a turn goes with it.
    const double set = this->Parameters.WindowRadius / TurnWindow;
    const std::vector<double> scales =
      set > 0.0 ? std::vector<double>(this->Scales.size(), set) : this->Scales;
    const std::vector<Turn> turns = this->MeasureTurns(faces, scales);
    if (turns.size() != this->Work().Points.size())
    {
      return false;
    }
    this->TellTurns(turns, scales);
    const EdgeAngles angles =
      EdgeAngles::Of(this->Result.Rough.Degree, this->Parameters.SharpAngle);
    this->Result.SharpAngle = angles.Seed;
    SharpRegion sharp = FindSharpRegion(this->Work(), this->TheConnectivity, turns, scales, angles);
    this->Result.Region = std::move(sharp.Vertices);
    this->Result.Rounding = sharp.Rounding;
    ExtendToOtherEdges(
      this->Work(), this->TheConnectivity, faces, scales, turns, angles, this->Result.Region);
    SpareThinFaces(this->Work(), this->TheConnectivity, faces, this->Scales, this->Result.Region);
    return true;
  }

  std::vector<Turn> MeasureTurns(const Faces& faces, const std::vector<double>& scales) const
  {
    std::vector<Turn> turns(this->Work().Points.size());
    const bool finished =
      ParallelFor(this->Work().VertexCount(), this->TheMonitor.Part(Smooth, Measured),
        [&](Index begin, Index end)
        {
          TurnMeter meter(this->Work(), this->TheConnectivity, faces, scales);
          for (Index v = begin; v < end; ++v)
          {
            turns[v] = meter.Measure(v);
          }
        });
    return finished ? turns : std::vector<Turn>();
  }

  void TellTurns(const std::vector<Turn>& turns, const std::vector<double>& scales)
  {
    this->Result.WindowRadii.resize(turns.size());
    this->Result.NormalDifferences.resize(turns.size());
    this->Result.Jumps.resize(turns.size());
    for (std::size_t v = 0; v < turns.size(); ++v)
    {
      this->Result.WindowRadii[v] = TurnWindow * scales[v];
      this->Result.NormalDifferences[v] = DifferenceOfAngle(turns[v].Deviation);
      this->Result.Jumps[v] = std::max(0.0, turns[v].Jump);
    }
  }

  /// Puts the damaged vertices on the faces around them, as far as nothing folds or cuts.
  void Sharpen(const Labelling& labelling, const std::vector<Apex>& apexes, const Ridge& ridge)
  {
    Placement placement(
      this->Work(), this->TheConnectivity, labelling, this->Scales, ridge.FaceLabels);
    const std::vector<Index> damaged = Flagged(this->Result.Region);
    for (Index v : damaged)
    {
      placement.Place(v);
    }
    for (const Apex& apex : apexes)
    {
      for (Index v : apex.Members)
      {
        placement.Pin(v, v == apex.Vertex ? apex.Tip : this->Work().Points[v]);
      }
    }
    Untangle(this->Work(), this->TheConnectivity, this->Scales, placement);
    if (!this->Parameters.Denoise)
    {
      this->PutIntactBack(placement);
    }
    const std::vector<Vec3> wanted = placement.AllPoints();
    Retreat(this->Input, this->TheConnectivity, placement);
    TellSkeleton(this->TheConnectivity, placement, damaged, this->Result);
    TellOutcomes(this->Input.Points, wanted, placement, this->Result);
    this->Result.Points = placement.TakePoints();
  }

  void PutIntactBack(Placement& placement) const
  {
    for (Index v = 0; v < this->Input.VertexCount(); ++v)
    {
      if (!placement.IsDamaged(v))
      {
        placement.SetPoint(v, this->Input.Points[v]);
      }
    }
  }

  const Mesh& Input;
  const Connectivity& TheConnectivity;
  double AverageEdgeLength;
  const RobustParameters& Parameters;
  const Monitor& TheMonitor;
  std::vector<double> Scales;
  Mesh Copy; ///< the input smoothed, if it is rough
  RobustResult Result;
};
}

RobustResult RecoverRobustly(const Mesh& mesh, const Connectivity& connectivity,
  double averageEdgeLength, const RobustParameters& parameters, const Monitor& monitor)
{
  return Recovery(mesh, connectivity, averageEdgeLength, parameters, monitor).Run();
}
}
