// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Robust.h"

#include "Apexes.h"
#include "Core/EdgeLengths.h"
#include "Core/Flagged.h"
#include "Core/Geometry.h"
#include "Core/StopWatch.h"
#include "DamageFinder.h"
#include "Denoised.h"
#include "EdgeFlips.h"
#include "FarFromRidge.h"
#include "FineBends.h"
#include "Junctions.h"
#include "Labelled.h"
#include "Mending.h"
#include "OwnMesh.h"
#include "Placement.h"
#include "Ridge.h"
#include "Settled.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace arris
{
namespace
{
// How far the progress has come after smoothing what is rough; in a pass after measuring turns, and
// after fitting sides.
constexpr double Smooth = 0.1;
constexpr double Measured = 0.4;
constexpr double Fitted = 0.8;

/// Where edges meet, the first pass may not see all of them; on what it has recovered the next
/// does.
constexpr int RecoveryPasses = 2;

/// A mesh whose edges may be flipped.
struct Flippable
{
  Mesh TheMesh;
  Connectivity TheConnectivity;
};

/// The steps of the method, in order, on one mesh: on one 2-manifold, or on the patches of an
/// assembly with vertices of their own. Their common vertices are brought together to be placed.
class Recovery
{
public:
  Recovery(const Mesh& input, const Connectivity& connectivity, const Whole* whole,
    const RobustParameters& parameters, const Monitor& monitor, Flippable* flippable = nullptr)
    : Input(input)
    , TheConnectivity(connectivity)
    , Together(whole)
    , AverageEdgeLength(arris::AverageEdgeLength(input, connectivity))
    , Parameters(parameters)
    , TheMonitor(monitor)
    , MayFlip(flippable)
    , Scales(LocalScales(input, connectivity))
  {
  }

  RobustResult Run()
  {
    this->Result.Region.assign(this->WholeCount(), 0);
    this->Result.Outcomes.assign(this->WholeCount(), Outcome::Intact);
    if (!this->TakeSmoothCopy())
    {
      return {};
    }
    for (bool done = false; !done; ++this->Pass)
    {
      const double part = (1.0 - Smooth) / RecoveryPasses;
      const double start = Smooth + this->Pass * part;
      if (!this->RunPass(this->TheMonitor.Part(start, Smooth + (this->Pass + 1) * part)))
      {
        return {};
      }
      done = this->IsLastPass();
    }
    if (!this->TheMonitor.Report(1.0))
    {
      return {};
    }
    this->Result.Points = std::move(this->Work.Points);
    this->Result.Points.resize(this->WholeCount());
    this->TellOfWhole(this->Result.WindowRadii);
    this->TellOfWhole(this->Result.NormalDifferences);
    this->TellOfWhole(this->Result.Jumps);
    return std::move(this->Result);
  }

private:
  bool IsRough() const { return this->Result.Rough.Degree > 0.0; }

  /// Whether noise or a blur has moved what is intact as well. A second pass would hold what the
  /// first has recovered against it.
  bool IsMovedAllOver() const { return this->IsRough() || this->Result.Rounding > BlurRounding; }

  /// Once the sharp region is known.
  bool IsLastPass() const { return this->Pass + 1 == RecoveryPasses || this->IsMovedAllOver(); }

  std::size_t WholeCount() const
  {
    return this->Together ? this->Together->TheMesh.Points.size() : this->Input.Points.size();
  }

  Index WholeOf(std::size_t part) const
  {
    return this->Together ? this->Together->Apart.WholeOf[part] : static_cast<Index>(part);
  }

  /// A vertex of the whole has the flag if one of its parts has.
  Flags FlagsOfWhole(const Flags& ofParts) const
  {
    Flags flags(this->WholeCount(), 0);
    for (std::size_t part = 0; part < ofParts.size(); ++part)
    {
      flags[this->WholeOf(part)] |= ofParts[part];
    }
    return flags;
  }

  /// Of the values of its parts, a vertex of the whole has the largest.
  void TellOfWhole(std::vector<double>& values) const
  {
    for (std::size_t part = this->WholeCount(); part < values.size(); ++part)
    {
      double& value = values[this->WholeOf(part)];
      value = std::max(value, values[part]);
    }
    values.resize(this->WholeCount());
  }

  /// What is rough is worked on in a smooth copy.
  bool TakeSmoothCopy()
  {
    const StopWatch watch;
    this->Result.Rough = MeasureRoughness(this->Input, this->TheConnectivity, this->Scales);
    this->Work.Triangles = this->Input.Triangles;
    this->Work.Points = this->IsRough()
      ? DenoisedPoints(this->Input, this->TheConnectivity, this->Scales, this->Result.Rough,
          this->TheMonitor.Part(0.0, Smooth))
      : this->Input.Points;
    if (this->Together && this->Work.Points.size() == this->Input.Points.size())
    {
      BringTogether(this->Together->Apart, this->WholeCount(), this->Work.Points);
    }
    this->Result.ClassificationSeconds += watch.Seconds();
    return this->Work.Points.size() == this->Input.Points.size();
  }

  bool RunPass(const Monitor& monitor)
  {
    const StopWatch classification;
    const Faces& faces = this->UpdateFaces();
    if (!this->Classify(faces, monitor.Part(0.0, Measured)))
    {
      return false;
    }
    this->SpareMeantBends();
    this->Result.ClassificationSeconds += classification.Seconds();

    const StopWatch thinning;
    const Surroundings around{ this->Work, this->TheConnectivity, faces, this->Scales,
      this->Result.NormalDifferences, this->Result.Rounding, this->Result.Rough, this->Together };
    const std::vector<Apex> apexes = FindApexes(around, this->Region);
    Labelling labelling;
    if (!LabelVertices(around, apexes, this->Stays.Unfitted, monitor.Part(Measured, Fitted),
          this->Region, labelling))
    {
      return false;
    }
    Ridge ridge = this->RidgeBetween(faces, labelling);
    this->Result.ThinningSeconds += thinning.Seconds();

    const StopWatch sharpening;
    if (this->IsLastPass())
    {
      this->TheFaces.reset(); // as what follows takes the most memory
      this->Finder.reset();
    }
    if (this->Together)
    {
      this->SharpenTogether(labelling, apexes, std::move(ridge));
    }
    else
    {
      this->Sharpen({ this->Input, this->Work, this->IsRough() ? this->Input : this->Work,
                      this->TheConnectivity, labelling, this->Scales, this->Region },
        apexes, std::move(ridge));
    }
    this->Result.SharpeningSeconds += sharpening.Seconds();
    return true;
  }

  Ridge RidgeBetween(const Faces& faces, const Labelling& labelling) const
  {
    RightAlready right =
      FindRightAlready(this->Work, this->TheConnectivity, faces, this->Scales, labelling);
    this->MarkJunctions(right.OnRidge);
    return FindRidge(this->Work, this->TheConnectivity, faces, labelling, right);
  }

  /// The faces as they are after the pass before.
  const Faces& UpdateFaces()
  {
    if (this->TheFaces && !this->MayFlip)
    {
      this->TheFaces->Update(this->Work, this->TheConnectivity, this->Moved);
    }
    else
    {
      this->TheFaces.emplace(this->Work, this->TheConnectivity, this->AverageEdgeLength);
    }
    return *this->TheFaces;
  }

  /// Finds the sharp region.
  bool Classify(const Faces& faces, const Monitor& monitor)
  {
    const bool first = !this->Finder;
    if (first)
    {
      this->Finder.emplace(
        this->TheConnectivity, this->Scales, this->Parameters, this->Result.Rough, this->Together);
    }
    Flags before(this->Work.Points.size());
    for (std::size_t v = 0; v < before.size(); ++v)
    {
      before[v] = this->Result.Region[this->WholeOf(v)];
    }
    if (!this->Finder->Find(this->Work, faces, before, this->Moved, monitor))
    {
      return false;
    }
    this->Region = std::move(this->Finder->Region);
    this->MarkJunctions(this->Region);
    if (first)
    {
      this->Result.SharpAngle = this->Finder->Angles.Seed;
      this->Result.Rounding = this->Finder->Rounding;
      this->Finder->TellTurns(this->Result);
    }
    else
    {
      this->SettleWhatStays(before);
    }
    return true;
  }

  /// After the first pass, leaves alone what is far from all vertices that are in the region now
  /// and were not before, or the other way round, or that the pass before has not put in place.
  void SettleWhatStays(const Flags& before)
  {
    Flags open(this->WholeCount(), 0);
    for (std::size_t v = 0; v < before.size(); ++v)
    {
      const Index whole = this->WholeOf(v);
      open[whole] |=
        this->Region[v] != before[v] || IsOutOfPlace(this->Result.Outcomes[whole]) ? 1 : 0;
    }
    const Connectivity& ofWhole =
      this->Together ? this->Together->TheConnectivity : this->TheConnectivity;
    this->Stays = FindSettled(this->Work, ofWhole, this->Scales, Flagged(open));
    this->Stays.Vertices.resize(this->WholeCount()); // which are placed together
    for (std::size_t v = this->WholeCount(); v < this->Work.Points.size(); ++v)
    {
      this->Stays.Unfitted[v] = this->Stays.Unfitted[this->WholeOf(v)];
    }
  }

  /// Of a mesh that seems blurred or rough, leaves bends alone that are meant; unless the user has
  /// said what an edge is.
  void SpareMeantBends()
  {
    if (!this->IsMovedAllOver() || this->Together)
    {
      return;
    }
    this->Result.BendTriangleSize = BendTriangleSize(this->Work, this->Region);
    const bool isSet = this->Parameters.WindowRadius > 0.0 || this->Parameters.SharpAngle > 0.0;
    if (!isSet && this->Result.BendTriangleSize < MeantBendSize)
    {
      this->Region.assign(this->Region.size(), 0);
      this->Result.BendsAreMeant = true;
    }
  }

  void MarkJunctions(Flags& flags) const
  {
    for (std::size_t v = 0; this->Together && v < flags.size(); ++v)
    {
      flags[v] |= this->Together->Apart.Common[v];
    }
  }

  /// For an assembly, whose parts are known.
  void SharpenTogether(const Labelling& ofParts, const std::vector<Apex>& apexes, Ridge ridge)
  {
    const std::size_t count = this->WholeCount();
    const Mesh now{ std::vector<Vec3>(this->Work.Points.begin(), this->Work.Points.begin() + count),
      this->Together->TheMesh.Triangles };
    const std::vector<double> scales(this->Scales.begin(), this->Scales.begin() + count);
    const Flags region = this->FlagsOfWhole(this->Region);
    ridge.OnRidge = this->FlagsOfWhole(ridge.OnRidge);
    const Labelling joined = JoinParts(this->Together->Apart, count, ofParts);
    const Mesh& before = this->Together->TheMesh;
    this->Sharpen({ before, now, this->IsRough() ? before : now, this->Together->TheConnectivity,
                    joined, scales, region },
      apexes, std::move(ridge));
  }

  /// Puts the damaged vertices on the faces around them, as far as nothing folds or cuts.
  void Sharpen(const Labelled& mesh, const std::vector<Apex>& apexes, Ridge ridge)
  {
    Placement placement(
      mesh.Now, mesh.TheConnectivity, mesh.Labels, mesh.Scales, std::move(ridge.FaceLabels));
    placement.SetReach(LongestMoveOf(this->Result.Rounding));
    placement.SetSettled(std::move(this->Stays.Vertices));
    placement.SetJunctions(InsideJunctions(mesh.Now, mesh.TheConnectivity));
    placement.SetWalls(FindWalls(mesh.Before, mesh.TheConnectivity, mesh.Region, mesh.Scales));
    const std::vector<Index> damaged = Flagged(mesh.Region);
    ParallelFor(static_cast<Index>(damaged.size()),
      [&](Index begin, Index end)
      {
        std::for_each(
          damaged.begin() + begin, damaged.begin() + end, [&](Index v) { placement.Place(v); });
      });
    if (!this->IsMovedAllOver())
    {
      LeaveFarFromRidge(mesh.TheConnectivity, ridge.OnRidge, damaged, placement);
    }
    for (const Apex& apex : apexes)
    {
      for (std::size_t i = 0; i < apex.Members.size(); ++i)
      {
        placement.Pin(apex.Members[i], apex.Places[i]);
      }
    }
    const std::vector<Vec3> wanted = Mend(mesh, damaged, this->HowToMend(), placement);
    for (std::size_t v = 0; v < mesh.Region.size(); ++v)
    {
      this->Result.Region[v] |= mesh.Region[v];
    }
    TellRoles(mesh.TheConnectivity, placement, this->Result);
    if (this->IsLastPass())
    {
      TellRounds(mesh.TheConnectivity, this->Result);
    }
    TellOutcomes(mesh.Before.Points, wanted, placement, this->Result);
    this->TakePoints(placement.AllPoints());
  }

  Mending HowToMend()
  {
    Mending mending{ this->IsRough(), this->Parameters.Denoise, this->IsLastPass(), {} };
    if (this->MayFlip)
    {
      mending.FlipEdges = [this](Placement& placement) { this->FlipEdges(placement); };
    }
    return mending;
  }

  void FlipEdges(Placement& placement)
  {
    this->Result.EdgeFlips +=
      arris::FlipEdges(this->Work, this->MayFlip->TheConnectivity, placement);
    this->MayFlip->TheMesh.Triangles = this->Work.Triangles;
  }

  void TakePoints(const std::vector<Vec3>& ofWhole)
  {
    this->Moved.resize(this->Work.Points.size());
    for (std::size_t v = 0; v < this->Work.Points.size(); ++v)
    {
      const Vec3& point = ofWhole[this->WholeOf(v)];
      this->Moved[v] = point != this->Work.Points[v] ? 1 : 0;
      this->Work.Points[v] = point;
    }
  }

  const Mesh& Input;
  const Connectivity& TheConnectivity;
  const Whole* Together; ///< null for one 2-manifold
  double AverageEdgeLength;
  const RobustParameters& Parameters;
  const Monitor& TheMonitor;
  Flippable* MayFlip; ///< input and connectivity where edges may be flipped, else null
  std::vector<double> Scales;
  RobustResult Result;
  int Pass = 0; ///< 0, 1, ...

  // Of the pass.
  Mesh Work; ///< what the passes before have made of the input, or of its smooth copy
  Flags Moved; ///< by the pass before
  std::optional<Faces> TheFaces;
  std::optional<DamageFinder> Finder;
  Settled Stays; ///< empty in the first one
  Flags Region;
};

RobustResult Recover(const Mesh& mesh, const Connectivity& connectivity,
  const RobustParameters& parameters, const Monitor& monitor)
{
  if (connectivity.Common.empty())
  {
    if (parameters.AllowEdgeFlips)
    {
      Flippable copy{ mesh, connectivity };
      RobustResult result =
        Recovery(copy.TheMesh, copy.TheConnectivity, nullptr, parameters, monitor, &copy).Run();
      if (result.EdgeFlips > 0)
      {
        result.Triangles = std::move(copy.TheMesh.Triangles);
      }
      return result;
    }
    return Recovery(mesh, connectivity, nullptr, parameters, monitor).Run();
  }
  const PatchesApart apart = TakeApart(mesh, connectivity);
  const Whole whole{ mesh, connectivity, apart };
  return Recovery(apart.Parts, apart.Adjacency, &whole, parameters, monitor).Run();
}
}

RobustResult RecoverRobustly(const Mesh& mesh, const Connectivity& connectivity,
  const RobustParameters& parameters, const Monitor& monitor)
{
  const StopWatch watch;
  const OwnMesh own(mesh, connectivity);
  const double seconds = watch.Seconds();
  RobustResult result =
    own.Back(Recover(own.TheMesh, own.TheConnectivity, own.Into(parameters), monitor));
  result.ClassificationSeconds += seconds;
  return result;
}
}
