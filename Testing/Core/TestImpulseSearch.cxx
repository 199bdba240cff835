// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Impulses hit one here and one there. What sticks out in rows or in a pattern is no noise.

#include "Automatic/ImpulseSearch.h"
#include "Automatic/SpikeScores.h"
#include "AutomaticShapes.h"
#include "OneStage/VertexRings.h"
#include "RandomMeshes.h"

#include <gtest/gtest.h>

using namespace SurfaceDenoising;

namespace
{

/// Sites joined as the vertices of a torus of 2 n times n, of which some are high and all others
/// low.
class Sites
{
public:
  explicit Sites(int n)
    : Rows(n)
  {
    const TriangleMesh torus = Torus(n);
    this->Search.Beside = VertexRings(torus, VertexStars(torus), this->Serial);
    this->Search.Nearby = VerticesNearby(this->Search.Beside, this->Serial);
    this->Search.Counted.assign(torus.NumberOfVertices(), 1);
    this->Search.Unit = 1.0;
    this->Heights.assign(torus.NumberOfVertices(), 0.01);
    this->Search.Score = [this](const Buffer<unsigned char>& marks, Execution& execution)
    {
      SpikeScores scores;
      scores.Heights = this->Heights;
      CompareWithUsual(scores, this->Search.Nearby, marks, 1.0, execution);
      return scores;
    };
  }

  int Count() const { return static_cast<int>(this->Heights.size()); }

  /// Places count from 0 along the short way around, then along the long one.
  void Raise(int place) { this->Heights[(place + this->Count()) % this->Count()] = 0.5; }

  /// So many places beside one another along the long way.
  void RaiseRow(int place, int length)
  {
    for (int k = 0; k < length; ++k)
    {
      this->Raise(place + k * this->Rows);
    }
  }

  /// Whether all that is high and nothing else is found.
  bool AreImpulses()
  {
    Buffer<unsigned char> marks;
    const bool found = FindImpulses(this->Search, marks, this->Serial);
    for (std::size_t v = 0; found && v < marks.size(); ++v)
    {
      EXPECT_EQ(marks[v] == 1, this->Heights[v] > 0.1) << v;
    }
    return found;
  }

private:
  int Rows;
  Execution Serial;
  SpikeSites Search;
  Buffer<double> Heights;
};

}

TEST(ImpulseSearch, FindsWhatIsHitAtRandom)
{
  for (const double share : { 0.02, 0.05, 0.1 })
  {
    Sites sites(40);
    PortableRandom random(5);
    for (int v = 0; v < sites.Count(); ++v)
    {
      if (random.Uniform() < share)
      {
        sites.Raise(v);
      }
    }
    EXPECT_TRUE(sites.AreImpulses()) << share;
  }
}

// As high and as many as impulses, and scattered, but not one by one.
TEST(ImpulseSearch, RowsAreNoImpulses)
{
  for (const double share : { 0.02, 0.1 })
  {
    for (const int length : { 2, 3, 5 })
    {
      Sites sites(40);
      PortableRandom random(5);
      for (int v = 0; v < sites.Count(); ++v)
      {
        if (random.Uniform() < share / length)
        {
          sites.RaiseRow(v, length);
        }
      }
      EXPECT_FALSE(sites.AreImpulses()) << share << " " << length;
    }
  }
}

// The teeth of a rack: every second one, none beside another.
TEST(ImpulseSearch, PatternsAreNoImpulses)
{
  Sites sites(40);
  for (int v = 0; v < sites.Count(); v += 40 * 8)
  {
    for (int k = 0; k < 40; k += 2)
    {
      sites.Raise(v + k);
    }
  }
  EXPECT_FALSE(sites.AreImpulses());
}
