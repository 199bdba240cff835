// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexUpdate.h"

#include "FlipGuard.h"

#include <cmath>

namespace SurfaceDenoising
{

VertexUpdate::VertexUpdate(const TriangleMesh& topology, const CompressedRows& stars,
  const Buffer<unsigned char>& boundary, double scale, const VertexUpdateSettings& settings)
  : Topology(topology)
  , Stars(stars)
  , Boundary(boundary)
  , Scale(scale)
  , Settings(settings)
  , Relaxation(settings.Relaxation)
{
}

bool VertexUpdate::Run(Buffer<Vec3>& positions, const Buffer<Vec3>& targets, int count,
  Execution& execution, double first, double last)
{
  const bool pull = this->Settings.InputPull > 0.0 && count > 0;
  if ((this->Settings.MaximumDisplacement > 0.0 || pull) && this->Start.empty())
  {
    this->Start = positions;
  }
  Buffer<Vec3> moved(positions.size());
  double firstSquares = 0.0;
  for (int step = 0; step < count; ++step)
  {
    if (!execution.Proceed(first + (last - first) * step / count))
    {
      return false;
    }
    this->Step(positions, targets, moved, execution);
    positions.swap(moved);
    this->Relaxation *= 0.7;
    ++this->Steps;
    if (this->Settings.Rest > 0.0)
    {
      const double squares = OrderedSum(execution, positions.size(), 0.0,
        [&](std::size_t v)
        {
          const double square = (positions[v] - moved[v]).squaredNorm();
          return square > 0.0 ? square : 0.0; // vertices without faces may be anything
        });
      firstSquares = step == 0 ? squares : firstSquares;
      if (squares <= this->Settings.Rest * this->Settings.Rest * firstSquares)
      {
        break;
      }
    }
  }
  if (pull)
  {
    this->PullBack(positions, targets, execution);
  }
  return true;
}

void VertexUpdate::Step(const Buffer<Vec3>& positions, const Buffer<Vec3>& targets,
  Buffer<Vec3>& moved, Execution& execution)
{
  if (this->Settings.Scheme == VertexScheme::IntegralFit)
  {
    this->IntegralFitStep(positions, targets, moved, execution);
  }
  else
  {
    this->OrthogonalityStep(positions, targets, moved, execution);
  }
  if (this->Settings.Boundary == BoundaryHandling::Slide)
  {
    this->SlideBoundary(positions, moved, execution);
  }
  if (this->Settings.MaximumDisplacement > 0.0)
  {
    this->LimitDisplacement(moved, execution);
  }
  if (this->Settings.PreventFlips)
  {
    this->Guarded += SurfaceDenoising::PreventFlips(this->Topology, this->Stars, this->Scale,
      targets, positions, moved, execution);
  }
}

void VertexUpdate::OrthogonalityStep(const Buffer<Vec3>& positions, const Buffer<Vec3>& targets,
  Buffer<Vec3>& moved, Execution& execution)
{
  // m_f . (c_f - p_v) = m_f . c_f - m_f . p_v: one number per face instead of a centroid.
  // Coordinates are centred, so that the difference loses no digits.
  const bool weighted = this->Settings.Scheme == VertexScheme::AreaWeighted;
  const bool constantStep = this->Settings.Scheme == VertexScheme::ConstantStep;
  const bool fixBoundary = this->Settings.Boundary == BoundaryHandling::Fixed;
  const bool relax = this->Settings.Scheme == VertexScheme::EdgeWeighted;
  this->FaceOffset.resize(targets.size());
  if (weighted || relax)
  {
    this->ComputeAreas(positions, execution);
  }
  execution.For(targets.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const Triangle& t = this->Topology.Triangles[f];
        const Vec3& a = positions[t[0]];
        const Vec3& b = positions[t[1]];
        const Vec3& c = positions[t[2]];
        this->FaceOffset[f] = targets[f].dot(a + b + c) / 3.0;
      }
    });

  execution.For(positions.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        const Vec3 p = positions[v];
        moved[v] = p;
        if (fixBoundary && this->Boundary[v])
        {
          continue;
        }
        Vec3 sum(0.0, 0.0, 0.0);
        double total = 0.0;
        for (const Index f : this->Stars.Row(v))
        {
          const Vec3& m = targets[f];
          const double known = m.squaredNorm() > 0.0 ? 1.0 : 0.0;
          const double w = weighted ? known * this->FaceArea[f] : known;
          sum += (w * (this->FaceOffset[f] - m.dot(p))) * m;
          total += w;
        }
        if (total > 0.0)
        {
          moved[v] = p + sum / (constantStep ? 6.0 : total);
        }
        if (relax && !this->Boundary[v])
        {
          moved[v] += this->Relaxation * this->Relaxed(v, positions, targets);
        }
      }
    });
}

void VertexUpdate::ComputeAreas(const Buffer<Vec3>& positions, Execution& execution)
{
  this->FaceArea.resize(this->Topology.NumberOfFaces());
  execution.For(this->FaceArea.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const Triangle& t = this->Topology.Triangles[f];
        const Vec3& a = positions[t[0]];
        this->FaceArea[f] = 0.5 * (positions[t[1]] - a).cross(positions[t[2]] - a).norm();
      }
    });
}

/// The direction of sum_f A_f m_f at a vertex, or zero.
Vec3 VertexUpdate::MeanTarget(std::size_t vertex, const Buffer<Vec3>& targets) const
{
  Vec3 sum(0.0, 0.0, 0.0);
  double area = 0.0;
  for (const Index f : this->Stars.Row(vertex))
  {
    sum += this->FaceArea[f] * targets[f];
    area += this->FaceArea[f];
  }
  const double length = sum.norm();
  return length > 1e-12 * area ? Vec3(sum / length) : Vec3(0.0, 0.0, 0.0);
}

/// D + D_t. The faces of a vertex name each vertex of the ring twice, which a mean does not notice.
Vec3 VertexUpdate::Relaxed(std::size_t vertex, const Buffer<Vec3>& positions,
  const Buffer<Vec3>& targets) const
{
  const Vec3& p = positions[vertex];
  Vec3 sum(0.0, 0.0, 0.0);
  double total = 0.0;
  for (const Index f : this->Stars.Row(vertex))
  {
    for (const Index q : this->Topology.Triangles[f])
    {
      const Vec3 edge = positions[q] - p;
      const double length = edge.norm();
      sum += length * edge;
      total += length;
    }
  }
  if (!(total > 0.0))
  {
    return Vec3(0.0, 0.0, 0.0);
  }
  const Vec3 difference = sum / total;
  const Vec3 normal = this->MeanTarget(vertex, targets);
  return 2.0 * difference - difference.dot(normal) * normal;
}

void VertexUpdate::PullBack(Buffer<Vec3>& positions, const Buffer<Vec3>& targets,
  Execution& execution)
{
  this->ComputeAreas(positions, execution);
  const bool fixBoundary = this->Settings.Boundary == BoundaryHandling::Fixed;
  execution.For(positions.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        if (!(fixBoundary && this->Boundary[v]))
        {
          const Vec3 normal = this->MeanTarget(v, targets);
          const double way = (this->Start[v] - positions[v]).dot(normal);
          positions[v] += this->Settings.InputPull * way * normal;
        }
      }
    });
}

void VertexUpdate::IntegralFitStep(const Buffer<Vec3>& positions, const Buffer<Vec3>& targets,
  Buffer<Vec3>& moved, Execution& execution)
{
  constexpr double step = 0.05; // stable below 0.19 on equilateral meshes
  const bool fixBoundary = this->Settings.Boundary == BoundaryHandling::Fixed;
  this->FaceMisfit.resize(targets.size());
  execution.For(targets.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const Triangle& t = this->Topology.Triangles[f];
        const Vec3& a = positions[t[0]];
        const Vec3 s = (positions[t[1]] - a).cross(positions[t[2]] - a);
        const double length = s.norm();
        const bool ignore = targets[f].squaredNorm() == 0.0 || IsDegenerate(s, this->Scale);
        this->FaceMisfit[f] = ignore ? Vec3(0.0, 0.0, 0.0) : Vec3(s / length - targets[f]);
      }
    });

  execution.For(positions.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        moved[v] = positions[v];
        if (fixBoundary && this->Boundary[v])
        {
          continue;
        }
        Vec3 gradient(0.0, 0.0, 0.0);
        for (const Index f : this->Stars.Row(v))
        {
          const Triangle& t = this->Topology.Triangles[f];
          const int corner = t[0] == v ? 0 : (t[1] == v ? 1 : 2);
          const Vec3& q = positions[t[(corner + 1) % 3]];
          const Vec3& r = positions[t[(corner + 2) % 3]];
          gradient += this->FaceMisfit[f].cross(r - q);
        }
        moved[v] -= step * gradient;
      }
    });
}

void VertexUpdate::SlideBoundary(const Buffer<Vec3>& positions, Buffer<Vec3>& moved,
  Execution& execution)
{
  execution.For(positions.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Spoke> spokes;
      for (std::size_t v = begin; v < end; ++v)
      {
        if (!this->Boundary[v])
        {
          continue;
        }
        CollectSpokes(this->Topology, this->Stars.Row(v), static_cast<Index>(v), spokes);
        Index ends[2] = { NoIndex, NoIndex };
        int count = 0;
        for (const Spoke& spoke : spokes)
        {
          if (spoke.Out + spoke.In == 1 && count++ < 2)
          {
            ends[count - 1] = spoke.Vertex;
          }
        }
        Vec3 normal(0.0, 0.0, 0.0);
        for (const Index f : this->Stars.Row(v))
        {
          const Triangle& t = this->Topology.Triangles[f];
          normal += (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
        }
        // Where borders meet there is no direction along the border.
        const Vec3 inward =
          count == 2 ? Vec3(normal.cross(positions[ends[1]] - positions[ends[0]])) : Vec3(0, 0, 0);
        const double length = inward.norm();
        if (!(length > 0.0))
        {
          moved[v] = positions[v];
          continue;
        }
        const Vec3 direction = inward / length;
        moved[v] -= direction * direction.dot(moved[v] - positions[v]);
      }
    });
}

void VertexUpdate::LimitDisplacement(Buffer<Vec3>& moved, Execution& execution) const
{
  const double limit = this->Settings.MaximumDisplacement;
  execution.For(moved.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        const Vec3 offset = moved[v] - this->Start[v];
        const double length = offset.norm();
        if (length > limit)
        {
          moved[v] = this->Start[v] + offset * (limit / length);
        }
      }
    });
}

}
