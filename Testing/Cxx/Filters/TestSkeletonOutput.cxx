// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include <map>

using namespace arris::testing;

// The second output of the thinning filter.

TEST(SkeletonOutput, IsPolylinesBetweenJointsAndEnds)
{
  vtkNew<vtkSharpThinningFilter> filter;
  Execute(filter, ReadyMesh());
  vtkPolyData* skeleton = filter->GetSkeleton();
  ASSERT_GT(skeleton->GetNumberOfLines(), 0);
  vtkDataArray* roles = skeleton->GetPointData()->GetArray("SkeletonRole");
  ASSERT_NE(roles, nullptr);
  EXPECT_GE(roles->GetRange()[0], 1.0) << "nothing but the skeleton";

  std::map<vtkIdType, int> sharpEdges;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < skeleton->GetNumberOfLines(); ++line)
  {
    skeleton->GetLines()->GetCellAtId(line, ids);
    const vtkIdType last = ids->GetNumberOfIds() - 1;
    ASSERT_GE(last, 1);
    for (vtkIdType i = 0; i < last; ++i)
    {
      ++sharpEdges[ids->GetId(i)];
      ++sharpEdges[ids->GetId(i + 1)];
    }
    for (vtkIdType i = 1; i < last; ++i)
    {
      EXPECT_EQ(roles->GetComponent(ids->GetId(i), 0), 1.0) << "inside a line are branches";
    }
    if (ids->GetId(0) != ids->GetId(last))
    {
      EXPECT_GE(roles->GetComponent(ids->GetId(0), 0), 2.0);
      EXPECT_GE(roles->GetComponent(ids->GetId(last), 0), 2.0);
    }
  }
  for (const auto& point : sharpEdges)
  {
    const int role = static_cast<int>(roles->GetComponent(point.first, 0));
    EXPECT_EQ(role, point.second == 2 ? 1 : (point.second > 2 ? 2 : 3))
      << point.second << " sharp edges";
  }
}

TEST(SkeletonOutput, FollowsTheTrueEdges)
{
  // On the edges of the box or a cell and a half beside them: within the sharp region.
  const int samples = 40;
  const Solid box = BoxSolid();
  vtkNew<vtkUSSODFilter> classify;
  vtkNew<vtkSharpThinningFilter> filter;
  Execute(filter, Execute(classify, Contour(box, samples)));
  const std::vector<Point3> truth = box.SharpEdgePoints(0.5 * CellWidth(samples));
  vtkPolyData* skeleton = filter->GetSkeleton();
  ASSERT_GT(skeleton->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < skeleton->GetNumberOfPoints(); ++i)
  {
    Point3 p;
    skeleton->GetPoint(i, p.data());
    double nearest = 1e9;
    for (const Point3& q : truth)
    {
      nearest = std::min(nearest, (p - q).norm());
    }
    EXPECT_LE(nearest, 1.5 * CellWidth(samples));
  }
}
