// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every setting of every filter for point sets changes the result: none is accepted and then
// ignored. TestRobustPointSetters has those of the composer, and ranges.

#include "PointSetters.h"

#include "vtkBilateralPointFilter.h"
#include "vtkFeatureAwarePointFilter.h"
#include "vtkGuidedPointNormalFilter.h"
#include "vtkMovingLeastSquaresFilter.h"
#include "vtkMovingRobustPCAFilter.h"
#include "vtkRobustImplicitMLSFilter.h"
#include "vtkRollingPointNormalFilter.h"
#include "vtkTensorPointFilter.h"
#include "vtkVotingTensorPointFilter.h"

#include <cstdlib>

namespace
{

using namespace PointTest;

void TestSimpleMethods(int& failures)
{
  using Bilateral = vtkBilateralPointFilter;
  TestCommonSettings<Bilateral>(failures);
  TestNeighborhoodSettings<Bilateral>(failures);
  Changes<Bilateral> bilateral(nullptr, Cloud());
  CHECK(bilateral([](Bilateral* f) { f->SetSpatialScale(0.7); }));
  CHECK(bilateral([](Bilateral* f) { f->SetSpatialScale(-1.0); }));
  CHECK(bilateral([](Bilateral* f) { f->SetHeightScale(0.4); }));
  CHECK(bilateral([](Bilateral* f) { f->LocalScaleOn(); }));
  CHECK(bilateral([](Bilateral* f) { f->FitNormalsOff(); }));
  // Planes are fitted whatever the normals are.
  CHECK(!bilateral([](Bilateral* f) { f->SetNormalSourceToPlaneFit(); }));
  Changes<Bilateral> given([](Bilateral* f) { f->FitNormalsOff(); }, Cloud());
  CHECK(given([](Bilateral* f) { f->SetNormalSourceToPlaneFit(); }));

  using Squares = vtkMovingLeastSquaresFilter;
  TestCommonSettings<Squares>(failures);
  TestNeighborhoodSettings<Squares>(failures);
  Changes<Squares> squares([](Squares* f) { f->SetBandwidth(2.0); }, Cloud());
  CHECK(squares([](Squares* f) { f->SetBandwidth(0.0); }));
  CHECK(squares([](Squares* f) { f->SetBandwidth(1.5); }));
  CHECK(squares([](Squares* f) { f->LocalScaleOn(); }));
  CHECK(squares([](Squares* f) { f->SetDegree(0); }));
  CHECK(squares([](Squares* f) { f->SetDegree(1); }));
  CHECK(squares([](Squares* f) { f->SetNumberOfPlaneFits(4); }));

  using Rolling = vtkRollingPointNormalFilter;
  TestCommonSettings<Rolling>(failures);
  TestNormalSettings<Rolling>(failures);
  TestNeighborhoodSettings<Rolling>(failures);
  Changes<Rolling> rolling(nullptr, Cloud());
  CHECK(!rolling([](Rolling* f) { f->SetRangeScale(0.35); }));
  CHECK(rolling([](Rolling* f) { f->SetRangeScale(0.5); }));
  CHECK(rolling([](Rolling* f) { f->SetSpatialScale(2.0); }));
  CHECK(rolling([](Rolling* f) { f->LocalScaleOn(); }));
  CHECK(rolling([](Rolling* f) { f->SetNumberOfRolls(6); }));
  CHECK(rolling([](Rolling* f) { f->SetNumberOfPointIterations(6); }));
  CHECK(rolling([](Rolling* f) { f->SetNumberOfPointIterations(-1); }));
  Changes<Rolling> signs([](Rolling* f) { f->SetNormalOrientationToKeep(); }, CloudWithNormals());
  CHECK(signs([](Rolling* f) { f->UnorientedNormalsOn(); }));
  CHECK(signs([](Rolling* f) { f->SetNormalOrientationToSpanningTree(); }));
  CHECK(signs([](Rolling* f) { f->SetNormalOrientationToAutomatic(); }));
}

void TestRobustMethods(int& failures)
{
  using PCA = vtkMovingRobustPCAFilter;
  TestCommonSettings<PCA>(failures);
  TestNormalSettings<PCA>(failures);
  TestNeighborhoodSettings<PCA>(failures);
  Changes<PCA> pca(nullptr, Cloud());
  CHECK(pca([](PCA* f) { f->SetNormalAngle(30.0); }));
  CHECK(pca([](PCA* f) { f->SetDataFidelity(0.5); }));
  CHECK(pca([](PCA* f) { f->SetNumberOfRobustFits(2); }));

  using Implicit = vtkRobustImplicitMLSFilter;
  TestCommonSettings<Implicit>(failures);
  TestNormalSettings<Implicit>(failures);
  Changes<Implicit> implicit(nullptr, Cloud());
  CHECK(implicit([](Implicit* f) { f->SetFilterScale(2.0); }));
  CHECK(implicit([](Implicit* f) { f->SetNormalScale(1.0); }));
  CHECK(implicit([](Implicit* f) { f->SetResidualScale(0.3); }));
  CHECK(implicit([](Implicit* f) { f->SetResidualScale(0.0); }));
  CHECK(implicit([](Implicit* f) { f->SetMaximumNumberOfFits(1); }));
  CHECK(implicit([](Implicit* f) { f->SetMaximumNumberOfProjections(1); }));
  Changes<Implicit> signs([](Implicit* f) { f->SetNormalOrientationToKeep(); }, CloudWithNormals());
  CHECK(signs([](Implicit* f) { f->UnorientedNormalsOn(); }));

  using Aware = vtkFeatureAwarePointFilter;
  TestCommonSettings<Aware>(failures);
  TestNormalSettings<Aware>(failures);
  TestNeighborhoodSettings<Aware>(failures);
  Changes<Aware> aware(nullptr, Cloud());
  CHECK(aware([](Aware* f) { f->SetFeatureSharpening(0.0); }));
  CHECK(!aware([](Aware* f) { f->LocalScaleOn(); })); // its documentation says so
  CHECK(aware([](Aware* f) { f->SetHeightModeToOwnHeight(); }));
  CHECK(aware([](Aware* f) { f->SetHeightModeToNeighborHeight(); }));
  CHECK(aware([](Aware* f) { f->SetLeastAngle(30.0); }));
  CHECK(aware([](Aware* f) { f->LikelihoodInNormalsOn(); }));

  using Tensor = vtkTensorPointFilter;
  TestCommonSettings<Tensor>(failures);
  TestNormalSettings<Tensor>(failures);
  TestNeighborhoodSettings<Tensor>(failures);
  Changes<Tensor> tensor(nullptr, Cloud());
  CHECK(tensor([](Tensor* f) { f->SetRange(3.0); }));
  CHECK(tensor([](Tensor* f) { f->SetBendFactor(3.0); }));
  CHECK(tensor([](Tensor* f) { f->SetFeatureThreshold(0.3); }));
  CHECK(tensor([](Tensor* f) { f->SetFeatureContrast(0.0); }));
  CHECK(tensor([](Tensor* f) { f->SetFeatureContrast(3.0); }));
  CHECK(tensor([](Tensor* f) { f->SetRegionThreshold(0.8); }));
  CHECK(tensor([](Tensor* f) { f->SetMinimumRegionSize(20); }));
  CHECK(tensor([](Tensor* f) { f->QuadricAtFeaturesOn(); }));
  CHECK(tensor([](Tensor* f) { f->LocalScaleOn(); }));
}

void TestGuided(int& failures)
{
  using Guided = vtkGuidedPointNormalFilter;
  TestCommonSettings<Guided>(failures);
  TestNormalSettings<Guided>(failures);
  TestNeighborhoodSettings<Guided>(failures);
  Changes<Guided> guided(nullptr, Cloud());
  CHECK(guided([](Guided* f) { f->SetRangeScale(0.6); }));
  CHECK(guided([](Guided* f) { f->SetSpatialScale(1.0); }));
  CHECK(guided([](Guided* f) { f->LocalScaleOn(); }));
  CHECK(guided([](Guided* f) { f->SetNumberOfNormalIterations(2); }));
  CHECK(guided([](Guided* f) { f->SetNumberOfPointIterations(2); }));
  CHECK(guided([](Guided* f) { f->SetCandidateThreshold(0.2); }));
  CHECK(guided([](Guided* f) { f->SetCandidateScale(0.6); }));
  CHECK(guided([](Guided* f) { f->UseSkeletonOn(); }));
  CHECK(guided([](Guided* f) { f->SetBundleAngle(60.0); }));
  CHECK(guided([](Guided* f) { f->SetMaximumNumberOfNormals(1); }));
  CHECK(guided([](Guided* f) { f->SetBundleReach(0.3); }));
  CHECK(guided([](Guided* f) { f->SetBundleReach(0.0); }));
  CHECK(guided([](Guided* f) { f->SetFeaturePull(1.0); }));
  CHECK(guided([](Guided* f) { f->SetNumberOfPatchNeighbors(10); }));
  CHECK(guided([](Guided* f) { f->SetPatchAgreement(0.5); }));
  CHECK(guided([](Guided* f) { f->SetMemberAgreement(0.5); }));
  Changes<Guided> skeleton([](Guided* f) { f->UseSkeletonOn(); }, Cloud());
  CHECK(skeleton([](Guided* f) { f->SetSkeletonRadius(1.0); }));
  Changes<Guided> signs([](Guided* f) { f->SetNormalOrientationToKeep(); }, CloudWithNormals());
  CHECK(signs([](Guided* f) { f->UnorientedNormalsOn(); }));
}

void TestVotingTensor(int& failures)
{
  using Voting = vtkVotingTensorPointFilter;
  TestCommonSettings<Voting>(failures);
  TestNormalSettings<Voting>(failures);
  TestNeighborhoodSettings<Voting>(failures);
  Changes<Voting> voting(nullptr, Cloud());
  CHECK(voting([](Voting* f) { f->SetAngleThreshold(40.0); }));
  CHECK(voting([](Voting* f) { f->SetEigenvalueThreshold(0.1); }));
  CHECK(voting([](Voting* f) { f->SetDamping(1.0); }));
  CHECK(voting([](Voting* f) { f->SetStep(0.5); }));
  CHECK(voting([](Voting* f) { f->SetPlaneScale(0.3); }));
  CHECK(voting([](Voting* f) { f->SetPlaneScale(0.0); }));
  CHECK(voting([](Voting* f) { f->SetHeightModeToOwnHeight(); }));
  CHECK(voting([](Voting* f) { f->SetNormalScale(0.6); }));
  CHECK(voting([](Voting* f) { f->SetSpatialScale(3.0); }));
  CHECK(voting([](Voting* f) { f->SetEigenvalueCut(0.5); }));
  CHECK(voting([](Voting* f) { f->LocalScaleOn(); }));
  CHECK(voting([](Voting* f) { f->AsReleasedOn(); }));
  Changes<Voting> signs([](Voting* f) { f->SetNormalOrientationToKeep(); }, CloudWithNormals());
  CHECK(signs([](Voting* f) { f->UnorientedNormalsOn(); }));

  Changes<Voting> released([](Voting* f) { f->AsReleasedOn(); }, Cloud());
  CHECK(released([](Voting* f) { f->SetAngleThreshold(40.0); }));
  CHECK(released([](Voting* f) { f->SetEigenvalueThreshold(0.1); }));
  CHECK(released([](Voting* f) { f->SetDamping(1.0); }));
  CHECK(released([](Voting* f) { f->SetStep(0.5); }));
  CHECK(released([](Voting* f) { f->SetMaximumDisplacement(0.1); }));
  CHECK(released([](Voting* f) { f->SetNumberOfOuterIterations(6); }));
  // Of the others, its documentation says so.
  CHECK(!released([](Voting* f) { f->SetRadius(3.0); }));
  CHECK(!released([](Voting* f) { f->SetPlaneScale(0.0); }));
  CHECK(!released([](Voting* f) { f->SetNormalSourceToPlaneFit(); }));
}

}

int TestPointSetters(int, char*[])
{
  int failures = 0;
  TestSimpleMethods(failures);
  TestRobustMethods(failures);
  TestGuided(failures);
  TestVotingTensor(failures);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
