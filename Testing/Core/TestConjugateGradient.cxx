// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Conjugate gradients against a dense solver.

#include "ConjugateGradient.h"
#include "OddThreads.h"
#include "RandomMeshes.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

using namespace SurfaceDenoising;

namespace
{

using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// A random system with diagonal entries of very different sizes.
class DenseSystem : public testing::Test
{
protected:
  static constexpr int Count = 40;

  DenseSystem()
  {
    PortableRandom random(11);
    Eigen::MatrixXd root(Count, Count);
    for (int i = 0; i < Count; ++i)
    {
      for (int j = 0; j < Count; ++j)
      {
        root(i, j) = random.Gaussian() * std::pow(2.0, i % 8);
      }
    }
    this->Matrix = root * root.transpose() / Count;
    for (int i = 0; i < Count; ++i)
    {
      this->Matrix(i, i) += 0.3 * std::pow(4.0, i % 8);
      this->Diagonal.push_back(this->Matrix(i, i));
      this->Rhs.push_back(Vec3(random.Gaussian(), 1e-6 * random.Gaussian(), 1e6 * i));
      this->Start.push_back(random.Direction());
    }
  }

  static Columns AsColumns(const Buffer<Vec3>& v)
  {
    Columns columns(Count, 3);
    for (int i = 0; i < Count; ++i)
    {
      columns.row(i) = v[i].transpose();
    }
    return columns;
  }

  void Multiply(const Buffer<Vec3>& p, Buffer<Vec3>& ap) const
  {
    const Columns product = this->Matrix * AsColumns(p);
    for (int i = 0; i < Count; ++i)
    {
      ap[i] = product.row(i).transpose();
    }
  }

  ConjugateGradientResult Solve(Buffer<Vec3>& x, double tolerance = 1e-12, int iterations = 400,
    Execution&& execution = {}) const
  {
    return SolveConjugateGradient([this](const Buffer<Vec3>& p, Buffer<Vec3>& ap)
      { this->Multiply(p, ap); },
      this->Diagonal, this->Rhs, x, tolerance, iterations, execution, 0.25, 0.75);
  }

  static void ExpectColumnsNear(const Columns& result, const Columns& expected, double tolerance)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_LT((result.col(c) - expected.col(c)).norm(), tolerance * expected.col(c).norm()) << c;
    }
  }

  Eigen::MatrixXd Matrix;
  Buffer<double> Diagonal;
  Buffer<Vec3> Rhs;
  Buffer<Vec3> Start;
};

/// Writes down what it is told, and stops after a number of questions.
class Listener : public Execution
{
public:
  Listener(std::vector<double>& told, std::size_t patience)
    : Told(told)
    , Patience(patience)
  {
  }
  bool Proceed(double fraction) override
  {
    this->Told.push_back(fraction);
    return this->Told.size() <= this->Patience;
  }

private:
  std::vector<double>& Told;
  std::size_t Patience;
};

}

TEST_F(DenseSystem, AgreesWithADenseSolver)
{
  Buffer<Vec3> x(Count, Vec3(0.0, 0.0, 0.0));
  const ConjugateGradientResult result = this->Solve(x);
  EXPECT_TRUE(result.Converged);
  EXPECT_FALSE(result.Stopped);
  EXPECT_LE(result.Residuals.maxCoeff(), 1e-12);
  const Columns expected = this->Matrix.ldlt().solve(AsColumns(this->Rhs));
  ExpectColumnsNear(AsColumns(x), expected, 1e-8);

  // From the solution there is nothing left to do; fewer digits take fewer iterations.
  EXPECT_EQ(this->Solve(x, 1e-9).Iterations, 0);
  Buffer<Vec3> rough(Count, Vec3(0.0, 0.0, 0.0));
  EXPECT_LT(this->Solve(rough, 1e-3).Iterations, result.Iterations);
}

TEST_F(DenseSystem, RowsWithoutDiagonalKeepTheirValues)
{
  std::vector<int> free;
  for (int i = 0; i < Count; ++i)
  {
    if (i % 3 == 0)
    {
      this->Diagonal[i] = 0.0;
    }
    else
    {
      free.push_back(i);
    }
  }
  Buffer<Vec3> x = this->Start;
  EXPECT_TRUE(this->Solve(x).Converged);
  Columns given = AsColumns(this->Start);
  for (const int i : free)
  {
    given.row(i).setZero();
  }
  const Columns rest = AsColumns(this->Rhs) - this->Matrix * given;
  Columns expected = given;
  const Eigen::MatrixXd inner = this->Matrix(free, free);
  const Columns solved = inner.ldlt().solve(Columns(rest(free, Eigen::all)));
  expected(free, Eigen::all) = solved;
  ExpectColumnsNear(AsColumns(x), expected, 1e-8);
  for (int i = 0; i < Count; i += 3)
  {
    EXPECT_EQ(x[i], this->Start[i]);
  }
}

TEST_F(DenseSystem, ColumnsAreSeparateSolves)
{
  Buffer<Vec3> together = this->Start;
  const ConjugateGradientResult result = this->Solve(together);
  for (Vec3& b : this->Rhs)
  {
    b = Vec3(b[0], 0.0, 0.0);
  }
  Buffer<Vec3> alone = this->Start;
  for (Vec3& p : alone)
  {
    p = Vec3(p[0], 0.0, 0.0);
  }
  EXPECT_LE(this->Solve(alone).Iterations, result.Iterations);
  for (int i = 0; i < Count; ++i)
  {
    EXPECT_EQ(alone[i], Vec3(together[i][0], 0.0, 0.0));
  }
}

TEST_F(DenseSystem, StopsWhenAskedAndReportsProgress)
{
  std::vector<double> told;
  Buffer<Vec3> x = this->Start;
  EXPECT_TRUE(this->Solve(x, 1e-12, 400, Listener(told, 1000)).Converged);
  EXPECT_GE(told.front(), 0.25);
  EXPECT_LE(told.back(), 0.75);
  EXPECT_GT(told.back(), 0.6);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));

  told.clear();
  x = this->Start;
  const ConjugateGradientResult result = this->Solve(x, 1e-12, 400, Listener(told, 3));
  EXPECT_TRUE(result.Stopped);
  EXPECT_FALSE(result.Converged);
  EXPECT_EQ(result.Iterations, 3);

  x = this->Start;
  EXPECT_EQ(this->Solve(x, 1e-12, 5).Iterations, 5);
  x = this->Start;
  EXPECT_EQ(this->Solve(x, 1e-12, 0).Iterations, 0);
  EXPECT_EQ(x, this->Start);
}

TEST_F(DenseSystem, IndefiniteMatricesEndWithFiniteNumbers)
{
  this->Matrix -= 50.0 * Eigen::MatrixXd::Identity(Count, Count);
  Buffer<Vec3> x = this->Start;
  EXPECT_FALSE(this->Solve(x).Converged);
  EXPECT_TRUE(AsColumns(x).allFinite());
  Buffer<Vec3> none;
  this->Rhs.clear();
  this->Diagonal.clear();
  Execution serial;
  EXPECT_TRUE(SolveConjugateGradient([](const Buffer<Vec3>&, Buffer<Vec3>&) {}, this->Diagonal,
    this->Rhs, none, 1e-8, 10, serial, 0.0, 1.0)
                .Converged);
}

// Long enough for many chunks: 1 + the Laplacian of a ring.
TEST(ConjugateGradientThreads, SameBits)
{
  const std::size_t count = 30000;
  PortableRandom random(5);
  Buffer<Vec3> rhs(count);
  for (Vec3& b : rhs)
  {
    b = random.Direction();
  }
  const Buffer<double> diagonal(count, 21.0);
  auto solve = [&](Execution&& execution)
  {
    Buffer<Vec3> x(count, Vec3(0.0, 0.0, 0.0));
    auto apply = [&](const Buffer<Vec3>& p, Buffer<Vec3>& ap)
    {
      execution.For(count,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            ap[i] = 21.0 * p[i] - 10.0 * (p[(i + 1) % count] + p[(i + count - 1) % count]);
          }
        });
    };
    EXPECT_TRUE(
      SolveConjugateGradient(apply, diagonal, rhs, x, 1e-10, 200, execution, 0.0, 1.0).Converged);
    return x;
  };
  const Buffer<Vec3> expected = solve(Execution());
  for (const std::size_t threads : { 2, 3, 7 })
  {
    EXPECT_EQ(solve(OddThreads(threads)), expected);
  }
}
